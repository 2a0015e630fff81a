#include "custom/user_glsl.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diag.hpp"

namespace sg::custom {
namespace {

using Words = std::span<const std::string_view>;

bool contains(Words words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::string_view kImplicitDerivatives[] = {"dFdx",
                                                     "dFdy",
                                                     "dFdxFine",
                                                     "dFdyFine",
                                                     "dFdxCoarse",
                                                     "dFdyCoarse",
                                                     "fwidth",
                                                     "fwidthFine",
                                                     "fwidthCoarse",
                                                     "texture",
                                                     "textureOffset",
                                                     "textureProj",
                                                     "textureProjOffset",
                                                     "textureQueryLod",
                                                     "textureQueryLOD",
                                                     "texture2D",
                                                     "texture2DProj",
                                                     "interpolateAtCentroid",
                                                     "interpolateAtSample",
                                                     "interpolateAtOffset"};
constexpr std::string_view kInterface[] = {"layout",    "uniform",  "buffer",       "shared", "attribute",
                                           "varying",   "coherent", "subroutine",   "patch",  "precision",
                                           "invariant", "flat",     "noperspective"};
constexpr std::string_view kDirectives[] = {"define", "undef", "if",    "ifdef",   "ifndef",
                                            "else",   "elif",  "endif", "include", "error"};

// "" or why no file may say this word.
std::string word_fault(std::string_view word, bool called) {
    if (contains(kImplicitDerivatives, word)) {
        if (word.starts_with("texture2D") && !called) return "";  // the type
        return fmt::format(
            "'{}' takes derivatives from neighbouring pixels, expected those of the arguments "
            "(sg_sample, textureGrad, textureLod)",
            word);
    }
    if (contains(kInterface, word))
        return fmt::format("'{}' declares what only the generated shader may, expected arguments", word);
    if (word == "discard" || word == "demote" || word == "terminateInvocation")
        return fmt::format("'{}' drops the pixel, expected a value", word);
    if (word == "double" || word.starts_with("dvec") || word.starts_with("dmat"))
        return fmt::format("'{}' needs what few GPUs have, expected 32-bit numbers", word);
    if (word.starts_with("gl_")) return fmt::format("'{}' is built in, expected arguments", word);
    bool predefined = word == "__LINE__" || word == "__VERSION__";
    if (!predefined && word.find("__") != word.npos)
        return fmt::format("'{}' holds two underscores in a row, which GLSL reserves", word);
    return "";
}

std::string declared_fault(std::string_view name) {
    for (std::string_view prefix : {"sg_", "Sg", "SG_"}) {
        if (name.starts_with(prefix))
            return fmt::format("'{}' begins with '{}', which names of the library do", printable(name),
                               prefix);
    }
    if (name.starts_with("GL_"))
        return fmt::format("'{}' begins with 'GL_', which GLSL reserves", printable(name));
    if (name == "main") return "'main' is the generated shader's";
    if (name.size() > 64) return fmt::format("'{}' is longer than 64 characters", printable(name));
    return "";
}

class Scanner {
public:
    Scanner(std::string_view text, Words library) : text_(text), library_(library) {
        Tokens tokens = tokenise(text);
        out_.tokens = std::move(tokens.list);
        out_.faults = std::move(tokens.faults);
    }

    UserGlsl run() {
        words();
        for (std::size_t i = 0; i < out_.tokens.size();) i = directive(i);
        for (const Token& token : out_.tokens) {
            if (token.directive == 0) code_.push_back(&token);
        }
        if (out_.faults.empty()) declarations();
        std::sort(out_.names.begin(), out_.names.end());
        out_.names.erase(std::unique(out_.names.begin(), out_.names.end()), out_.names.end());
        return std::move(out_);
    }

private:
    void fault(const Token& token, std::string message) {
        out_.faults.push_back({token.span, std::move(message)});
    }
    void declare(const Token& name) {
        if (std::string why = declared_fault(name.text); !why.empty()) fault(name, std::move(why));
        out_.names.emplace_back(name.text);
    }
    [[nodiscard]] bool is_macro(std::string_view name) const {
        return std::find(macros_.begin(), macros_.end(), name) != macros_.end();
    }

    void words() {
        for (std::size_t i = 0; i < out_.tokens.size(); ++i) {
            const Token& token = out_.tokens[i];
            if (token.kind != TokenKind::identifier) continue;
            bool called = i + 1 < out_.tokens.size() && out_.tokens[i + 1].text == "(";
            bool member = i > 0 && out_.tokens[i - 1].text == ".";
            if (std::string why = word_fault(token.text, called); !member && !why.empty())
                fault(token, std::move(why));
        }
    }

    // ---- directives ----

    // From the first token of anything to behind it.
    std::size_t directive(std::size_t i) {
        const std::uint32_t number = out_.tokens[i].directive;
        if (number == 0) {
            if (out_.tokens[i].kind == TokenKind::string)
                fault(out_.tokens[i], "a string outside an include");
            return i + 1;
        }
        std::size_t end = i;
        while (end < out_.tokens.size() && out_.tokens[end].directive == number) ++end;
        if (end - i >= 2) one_directive(std::span(out_.tokens).subspan(i + 1, end - i - 1));
        return end;
    }

    void one_directive(std::span<const Token> line) {
        std::string_view name = line[0].text;
        if (!contains(kDirectives, name)) {
            fault(line[0],
                  fmt::format("the directive '#{}', expected {}", printable(name), one_of(kDirectives)));
            return;
        }
        if (name == "include") return include(line);
        for (const Token& token : line) {
            if (token.kind == TokenKind::string) fault(token, "a string outside an include");
        }
        if ((name == "define" || name == "undef") && line.size() > 1) {
            declare(line[1]);
            macros_.emplace_back(line[1].text);
            balance(line.subspan(2));
        }
    }

    void include(std::span<const Token> line) {
        if (line.size() == 1) return fault(line[0], "'#include' of nothing, expected a file of the library");
        bool one_string = line.size() == 2 && line[1].kind == TokenKind::string && line[1].text.size() > 2;
        std::string_view file = one_string ? line[1].text.substr(1, line[1].text.size() - 2) : "";
        if (contains(library_, file)) return;
        const Span whole{line[1].span.begin, line.back().span.end};
        const std::string_view written = text_.substr(whole.begin, whole.end - whole.begin);
        std::string hint = one_string ? did_you_mean(file, library_) : "";
        if (written.size() > 2 && written.starts_with('<') && written.ends_with('>')) {
            const std::string_view named = written.substr(1, written.size() - 2);
            const std::string_view near = contains(library_, named) ? named : nearest(named, library_);
            if (!near.empty()) hint = fmt::format(", expected quotes: \"{}\"", near);
        }
        if (hint.empty()) hint = ", expected a file of the library between quotes";
        out_.faults.push_back({whole, fmt::format("cannot include '{}'{}", printable(written), hint)});
    }

    // A macro must not open what it does not close: else code means something else than it looks like.
    void balance(std::span<const Token> body) {
        int depth = 0;
        for (const Token& token : body) {
            if (token.text == "{" || token.text == "(" || token.text == "[") ++depth;
            if (token.text == "}" || token.text == ")" || token.text == "]") --depth;
            if (depth < 0) break;
        }
        if (depth != 0) fault(body.front(), "a macro whose brackets do not match");
    }

    // ---- declarations outside functions ----

    [[nodiscard]] std::string_view text(std::size_t i) const {
        return i < code_.size() ? code_[i]->text : "";
    }

    // Behind the bracket that closes the one at i; the end of the file if there is none.
    std::size_t behind(std::size_t i) {
        std::vector<std::string_view> open;
        for (std::size_t k = i; k < code_.size(); ++k) {
            std::string_view t = text(k);
            if (t == "(") open.push_back(")");
            if (t == "[") open.push_back("]");
            if (t == "{") open.push_back("}");
            if (t != ")" && t != "]" && t != "}") continue;
            if (open.back() != t) {
                fault(*code_[k], fmt::format("'{}', expected '{}'", t, open.back()));
                return code_.size();
            }
            open.pop_back();
            if (open.empty()) return k + 1;
        }
        fault(*code_[i],
              fmt::format("'{}' that is not closed, also if conditions (#if) leave parts out", text(i)));
        return code_.size();
    }

    void declarations() {
        for (std::size_t i = 0; i < code_.size() && out_.faults.empty();) {
            if (text(i) == ";") {
                ++i;
            } else if (text(i) == "struct") {
                i = structure(i);
            } else if (text(i) == "const") {
                i = constants(i);
            } else {
                i = function(i);
            }
        }
    }

    bool plain_identifier(std::size_t i) {
        bool good = i < code_.size() && code_[i]->kind == TokenKind::identifier && !is_macro(text(i));
        if (good) return true;
        const Token& at = *code_[std::min(i, code_.size() - 1)];
        fault(at, is_macro(at.text)
                      ? fmt::format("the macro '{}' outside functions, expected what it stands for", at.text)
                      : fmt::format("'{}', expected a function, a struct or a constant", printable(at.text)));
        return false;
    }

    std::size_t structure(std::size_t i) {
        if (!plain_identifier(i + 1)) return code_.size();
        declare(*code_[i + 1]);
        if (text(i + 2) != "{") {
            fault(*code_[i + 1], "a struct, expected its members between braces");
            return code_.size();
        }
        std::size_t end = behind(i + 2);
        for (std::size_t k = i + 3; k + 1 < end; ++k) {
            bool named = text(k + 1) == ";" || text(k + 1) == "," || text(k + 1) == "[";
            if (named && code_[k]->kind == TokenKind::identifier && !is_macro(text(k)))
                out_.members.push_back(code_[k]->span.begin);
        }
        if (text(end) == ";") return end + 1;
        if (out_.faults.empty())
            fault(*code_[i + 1], "a variable of a struct, expected ';' behind the braces");
        return code_.size();
    }

    // const TYPE a = ..., b[2] = ...;
    std::size_t constants(std::size_t i) {
        std::size_t at = i + 1;
        while (text(at) == "highp" || text(at) == "mediump" || text(at) == "lowp") ++at;
        if (!plain_identifier(at++)) return code_.size();
        while (text(at) == "[") at = behind(at);
        for (;;) {
            if (!plain_identifier(at)) return code_.size();
            declare(*code_[at++]);
            while (at < code_.size() && text(at) != "," && text(at) != ";") {
                bool opens = text(at) == "(" || text(at) == "[" || text(at) == "{";
                at = opens ? behind(at) : at + 1;
            }
            if (text(at) != ",") return at + 1;
            ++at;
        }
    }

    // TYPE name(parameters) { ... } or ;
    std::size_t function(std::size_t i) {
        std::size_t at = i;
        while (text(at) == "highp" || text(at) == "mediump" || text(at) == "lowp") ++at;
        if (!plain_identifier(at)) return code_.size();
        Declaration found{.name = "", .result = std::string(text(at)), .parameters = {}, .span = {}};
        ++at;
        while (text(at) == "[") at = behind(at);
        if (!plain_identifier(at)) return code_.size();
        const Token& name = *code_[at];
        if (text(at + 1) != "(") {
            fault(name, fmt::format("the variable '{}', expected functions, structs and constants only",
                                    printable(name.text)));
            return code_.size();
        }
        declare(name);
        found.name = name.text;
        found.span = name.span;
        std::size_t end = behind(at + 1);
        parameters(at + 2, end - 1, found);
        if (text(end) == ";") return end + 1;
        if (text(end) != "{") {
            if (out_.faults.empty()) fault(name, fmt::format("'{}' has no body", printable(name.text)));
            return code_.size();
        }
        out_.functions.push_back(std::move(found));
        return behind(end);
    }

    void parameters(std::size_t begin, std::size_t end, Declaration& found) {
        if (begin >= end || (end - begin == 1 && text(begin) == "void")) return;
        for (std::size_t at = begin; at < end;) {
            std::string type;
            for (; text(at) == "in" || text(at) == "const" || text(at) == "out" || text(at) == "inout" ||
                   text(at) == "highp" || text(at) == "mediump" || text(at) == "lowp";
                 ++at) {
                if (text(at) == "out" || text(at) == "inout") type = fmt::format("{} ", text(at));
            }
            type += text(at);
            for (; at < end && text(at) != ","; ++at) {
                if (text(at) == "[") type += "[]";
            }
            found.parameters.push_back(std::move(type));
            ++at;
        }
    }

    std::string_view text_;
    Words library_;
    UserGlsl out_;
    std::vector<std::string> macros_;
    std::vector<const Token*> code_;
};

}  // namespace

std::string signature(std::string_view result, std::string_view name,
                      std::span<const std::string> parameters) {
    return fmt::format("{} {}({})", result, name, fmt::join(parameters, ", "));
}

UserGlsl scan(std::string_view text, std::span<const std::string_view> library) {
    return Scanner(text, library).run();
}

std::string prefixed(std::string_view text, const UserGlsl& scanned, std::span<const std::string> defines,
                     std::string_view prefix, std::span<const std::size_t> breaks) {
    std::string out;
    std::size_t at = 0;
    for (std::size_t i = 0; i < scanned.tokens.size(); ++i) {
        const Token& token = scanned.tokens[i];
        bool own = std::binary_search(scanned.names.begin(), scanned.names.end(), token.text) ||
                   std::find(defines.begin(), defines.end(), token.text) != defines.end();
        bool member = i > 0 && scanned.tokens[i - 1].text == ".";
        bool directive_name = i > 0 && token.directive != 0 && scanned.tokens[i - 1].text == "#";
        member =
            member || std::binary_search(scanned.members.begin(), scanned.members.end(), token.span.begin);
        bool renamed = token.kind == TokenKind::identifier && own && !member && !directive_name;
        bool broken = std::binary_search(breaks.begin(), breaks.end(), i);
        if (!renamed && !broken) continue;
        out += text.substr(at, token.span.begin - at);
        if (broken) out += '\n';
        if (renamed) out += prefix;
        at = token.span.begin;
    }
    return out + std::string(text.substr(at));
}

std::string define_fault(std::string_view name, std::string_view value) {
    Tokens named = tokenise(name), valued = tokenise(value);
    bool identifier = named.faults.empty() && named.list.size() == 1 &&
                      named.list[0].kind == TokenKind::identifier && named.list[0].text == name;
    if (!identifier) return fmt::format("'{}' is no name of a macro", printable(name));
    std::string why = declared_fault(name);
    if (why.empty()) why = word_fault(name, false);
    bool one_line = value.find_first_of("\n\r") == value.npos && value.find("//") == value.npos &&
                    value.find("/*") == value.npos;
    if (why.empty() && (!valued.faults.empty() || !one_line))
        why = fmt::format("'{}' is no value of a macro", printable(value));
    int depth = 0;
    for (std::size_t i = 0; i < valued.list.size() && why.empty(); ++i) {
        const Token& token = valued.list[i];
        bool bad =
            token.text == "#" || token.kind == TokenKind::string || token.text == "{" || token.text == "}";
        if (bad) why = fmt::format("'{}' is no value of a macro", printable(value));
        if (token.kind == TokenKind::identifier) why = word_fault(token.text, true);
        if (token.text == "(") ++depth;
        if (token.text == ")") --depth;
        if (depth < 0) break;
    }
    if (why.empty() && depth != 0) why = fmt::format("'{}' is no value of a macro", printable(value));
    return why;
}

}  // namespace sg::custom
