#include "target/function_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "base/files.hpp"
#include "base/ice.hpp"

namespace sg::target {
namespace {

// ---- GLSL without includes ----

constexpr std::string_view kInclude = "#include \"";

class Flattener {
public:
    explicit Flattener(const ShaderLibrary& library) : library_(library) {}

    std::string run(std::string_view text) {
        std::string rest = add_includes_of(text);
        return files_ + rest;
    }

private:
    // The lines that are no includes; what the others name goes into files_.
    std::string add_includes_of(std::string_view text) {
        std::string out;
        for (std::size_t at = 0; at < text.size();) {
            std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
            std::string_view line = text.substr(at, end - at);
            at = end;
            if (!line.starts_with(kInclude)) {
                out += line;
                continue;
            }
            std::string name(line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size()));
            if (!added_.insert(name).second) continue;
            auto file = library_.files.find(name);
            SG_ASSERT(file != library_.files.end());
            std::string own = add_includes_of(file->second);
            files_ += own + "\n";
        }
        return out;
    }

    const ShaderLibrary& library_;
    std::set<std::string> added_;
    std::string files_;
};

// ---- the declarations of a cross-compiled text ----

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

// Where the declaration that begins at `at` ends: behind a `;`, or behind the `}` of a function.
std::size_t end_of_declaration(std::string_view text, std::size_t at) {
    int depth = 0;
    for (; at < text.size(); ++at) {
        if (text[at] == '{' || text[at] == '(') ++depth;
        if (text[at] == ')') --depth;
        if (text[at] == ';' && depth == 0) return at + 1;
        if (text[at] == '}' && --depth == 0) {
            std::size_t next = text.find_first_not_of(" \n", at + 1);
            if (next == text.npos || text[next] != ';') return at + 1;
        }
    }
    return text.size();
}

// Lines of the preprocessor stand alone.
std::vector<std::string_view> declarations(std::string_view text) {
    std::vector<std::string_view> out;
    for (std::size_t at = text.find_first_not_of(" \n"); at != text.npos;) {
        std::size_t end =
            text[at] == '#' ? std::min(text.find('\n', at), text.size()) : end_of_declaration(text, at);
        out.push_back(trimmed(text.substr(at, end - at)));
        at = text.find_first_not_of(" \n", end);
    }
    return out;
}

std::string_view last_word(std::string_view text) {
    std::size_t end = text.size();
    while (end > 0 && !is_word(text[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && is_word(text[begin - 1])) --begin;
    return text.substr(begin, end - begin);
}

// The opening parenthesis that belongs to the last closing one; npos without one.
std::size_t last_parenthesis(std::string_view head) {
    int depth = 0;
    for (std::size_t i = head.size(); i-- > 0;) {
        if (head[i] == ')') ++depth;
        if (head[i] == '(' && --depth == 0) return i;
    }
    return head.npos;
}

enum class Sort { structure, constant, function, line, none };
struct Declaration {
    Sort sort = Sort::none;  // none: not for inclusion
    std::string_view name;
};

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.starts_with(word); });
}

Declaration read_declaration(std::string_view text) {
    if (starts_with_any(text, {"#include", "using ", "precision "})) return {Sort::line, ""};
    std::string_view head = text.substr(0, text.find('{'));
    if (text.starts_with("struct ") || text.starts_with("template")) {
        std::string_view name = last_word(head);
        bool of_stage = name.starts_with("main0_") || name.starts_with("SPIRV_Cross_");
        return {of_stage ? Sort::none : Sort::structure, name};
    }
    if (starts_with_any(text, {"const ", "static const ", "constant "})) {
        std::string_view declared = text.substr(0, text.find('='));
        return {Sort::constant, last_word(declared.substr(0, declared.find('[')))};
    }
    std::size_t parenthesis = last_parenthesis(head);
    if (text[0] == '#' || head.size() == text.size() || parenthesis == head.npos) return {};
    std::string_view name = last_word(head.substr(0, parenthesis));
    bool entry = name == "main" || name == "frag_main" || name == "main0";
    return {entry ? Sort::none : Sort::function, name};
}

// Helpers may be overloaded, and differ from text to text: theirs tells what they say.
std::string guard_of(const Declaration& declaration, std::string_view text) {
    std::string out = fmt::format("SG_HAS_{}", declaration.name);
    if (declaration.sort != Sort::structure) {
        std::string hash = content_hash(text);
        out += "_" + hash.substr(hash.find(':') + 1, 8);
    }
    return out;
}

}  // namespace

std::string without_includes(std::string_view text, const ShaderLibrary& library) {
    return Flattener(library).run(text);
}

std::string declarations_for_inclusion(std::string_view text, std::string_view suffix) {
    std::string out;
    bool after_line = false;
    for (std::string_view part : declarations(text)) {
        Declaration declaration = read_declaration(part);
        if (declaration.sort == Sort::none) continue;
        bool line = declaration.sort == Sort::line;
        if (!out.empty() && !(line && after_line)) out += "\n";
        after_line = line;
        if (line || declaration.name.ends_with(suffix)) {
            out += fmt::format("{}\n", part);
            continue;
        }
        std::string guard = guard_of(declaration, part);
        out += fmt::format("#ifndef {0}\n#define {0}\n{1}\n#endif\n", guard, part);
    }
    return out;
}

std::string signature_of(std::string_view text, std::string_view function) {
    for (std::string_view part : declarations(text)) {
        Declaration declaration = read_declaration(part);
        if (declaration.sort != Sort::function || declaration.name != function) continue;
        std::size_t begin = part.rfind('\n', part.find(function));  // attributes stand on lines of their own
        std::string out;
        for (char c : trimmed(part.substr(begin == part.npos ? 0 : begin,
                                          part.find('{') - (begin == part.npos ? 0 : begin)))) {
            bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
            if (!blank || out.back() != ' ') out += blank ? ' ' : c;
        }
        return out;
    }
    return "";
}

}  // namespace sg::target
