#include "custom_shaders.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "custom/pieces.hpp"
#include "ir/ir.hpp"
#include "target/spirv.hpp"

namespace sg {
namespace {

constexpr std::string_view kLibrary = "the library", kMacros = "-D", kCaller = "the layer's call";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kFirstCall = 2;         // a line
constexpr std::size_t kLongestMessage = 400;  // glslang's; one that compares types has more than 100 letters

// A text without the prefix of a shader's names, for people.
std::string unprefixed(std::string text, const std::string& prefix, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        std::string whole = prefix + name;
        for (std::size_t at = text.find(whole); at != text.npos; at = text.find(whole, at + name.size()))
            text.replace(at, whole.size(), name);
    }
    return text;
}

// The types of arguments and the files of the library that declare them.
constexpr std::pair<std::string_view, std::string_view> kDeclares[] = {{"SgFrame", "surfgrad/frame.glsl"},
                                                                       {"SgBasis", "surfgrad/tbn.glsl"},
                                                                       {"SgUv", "surfgrad/uv.glsl"},
                                                                       {"SgVolume", "surfgrad/volume.glsl"}};

class Verifier {
public:
    Verifier(material::CheckedMaterial& material, std::size_t shader, const Defines& defines,
             const target::ShaderLibrary& library, const SourcePtr& json, Diags& diags)
        : material_(material),
          shader_(material.shaders[shader]),
          number_(shader),
          prefix_(ir::shader_prefix(shader)),
          defines_(defines),
          library_(library),
          json_(json),
          diags_(diags) {}

    void run() {
        std::vector<std::string_view> includable;
        for (const auto& [name, text] : library_.files) {
            if (name.starts_with("surfgrad/")) includable.push_back(name);
        }
        skip_byte_order_mark();
        const std::string& text = shader_.source->text;
        scanned_ = custom::scan(text, includable);
        for (const custom::Fault& fault : scanned_.faults)
            error(Code::glsl_refused, fault.span, fault.message);
        if (!scanned_.faults.empty()) return;
        define();
        text_ = custom::prefixed(text, scanned_, defined_, prefix_);
        all_names_ = scanned_.names;
        all_names_.insert(all_names_.end(), defined_.begin(), defined_.end());
        if (!signatures()) return;
        if (!compiles("") || !compiles(everything(includable))) return;
        shader_.text = macros_ + text_;
        for (const std::string& name : all_names_) shader_.names.push_back(prefix_ + name);
    }

private:
    // Editors put one there and show none: columns begin behind it.
    void skip_byte_order_mark() {
        const Source& read = *shader_.source;
        if (read.text.starts_with(kByteOrderMark))
            shader_.source =
                std::make_shared<Source>(Source{read.name, read.text.substr(kByteOrderMark.size())});
    }

    // The macros of the command line; of several values of one name the last counts.
    void define() {
        for (auto it = defines_.begin(); it != defines_.end(); ++it) {
            const auto& [name, value] = *it;
            bool again =
                std::any_of(it + 1, defines_.end(), [&](const auto& later) { return later.first == name; });
            if (again) continue;
            defined_.push_back(name);
            bool read = std::any_of(scanned_.tokens.begin(), scanned_.tokens.end(),
                                    [&](const custom::Token& t) { return t.text == name; });
            if (read) macros_ += fmt::format("#define {}{} {}\n", prefix_, name, value);
        }
    }

    void error(Code code, Span span, std::string message) {
        diags_.error(code, {shader_.source, span, ""}, std::move(message));
    }
    void error_at(const material::At& at, std::string message, std::vector<Note> notes) {
        diags_.error(Code::glsl_signature, {json_, at.span, at.pointer}, std::move(message),
                     std::move(notes));
    }

    // Each call needs a function of exactly its types.
    bool signatures() {
        bool good = true;
        for (const material::ShaderCall& call : material_.calls) {
            if (call.shader == number_) good = signature(call) && good;
        }
        return good;
    }

    bool signature(const material::ShaderCall& call) {
        std::string wanted = custom::signature(call.result, call.function, call.arguments);
        std::vector<std::string_view> names;
        for (const custom::Declaration& f : scanned_.functions) {
            names.push_back(f.name);
            if (f.name == call.function && f.result == call.result && f.parameters == call.arguments)
                return true;
        }
        std::vector<Note> near = functions_called(call.function);
        std::string hint = near.empty() ? did_you_mean(call.function, names) : "";
        if (near.empty() && hint.empty())
            hint = names.empty() ? ", it has none" : fmt::format(", it has {}", one_of(names));
        std::string message = near.empty()
                                  ? fmt::format("'{}' has no function '{}'{}", printable(shader_.file),
                                                printable(call.function), hint)
                                  : fmt::format("the layer calls '{}', which '{}' does not have", wanted,
                                                printable(shader_.file));
        error_at(call.function_at, std::move(message), std::move(near));
        return false;
    }

    [[nodiscard]] std::vector<Note> functions_called(const std::string& name) const {
        std::vector<Note> out;
        for (const custom::Declaration& f : scanned_.functions) {
            if (f.name == name)
                out.push_back({fmt::format("'{}' is here", custom::signature(f.result, f.name, f.parameters)),
                               {shader_.source, f.span, ""}});
        }
        return out;
    }

    static std::string everything(const std::vector<std::string_view>& files) {
        std::string out;
        for (std::string_view file : files) out += fmt::format("#include \"{}\"\n", file);
        return out;
    }

    // The calls as the generated shader makes them, each on a line of its own from kFirstCall on, and a main
    // that makes them all: what it reaches must have a body.
    [[nodiscard]] std::string calls() const {
        std::string out = "\n", made;
        std::size_t number = 0;
        for (const material::ShaderCall& call : material_.calls) {
            if (call.shader != number_) continue;
            std::string parameters, arguments, given;
            for (std::size_t i = 0; i < call.arguments.size(); ++i) {
                const std::string& type = call.arguments[i];
                const char* comma = i > 0 ? ", " : "";
                parameters += fmt::format("{}{} sg_a{}", comma, type, i);
                arguments += fmt::format("{}sg_a{}", comma, i);
                bool global = type == "texture2D" || type == "sampler";
                std::string value = global ? "sg_any_" + type : fmt::format("sg_b{}_{}", number, i);
                if (!global) made += fmt::format("    {} {};\n", type, value);
                given += comma + value;
            }
            out += fmt::format("{} sg_call{}({}) {{ return {}{}({}); }}\n", call.result, number, parameters,
                               prefix_, call.function, arguments);
            made += fmt::format("    sg_call{}({});\n", number++, given);
        }
        return out +
               "layout(set = 0, binding = 0) uniform texture2D sg_any_texture2D;\n"
               "layout(set = 0, binding = 1) uniform sampler sg_any_sampler;\n"
               "void main() {\n" +
               made + "}\n";
    }

    // What declares the types of the arguments: all that a generated shader is sure to bring.
    [[nodiscard]] std::string of_arguments() const {
        std::vector<std::string_view> files;
        for (const auto& [type, file] : kDeclares) {
            for (const material::ShaderCall& call : material_.calls) {
                if (call.shader == number_ && std::count(call.arguments.begin(), call.arguments.end(), type))
                    files.push_back(file);
            }
        }
        return everything(files);
    }

    // The first fault of a version of the text, with these includes in front of it.
    [[nodiscard]] std::optional<target::GlslFault> fault_of(const std::string& includes,
                                                            const std::string& text) const {
        std::string before =
            "#version 450\n#extension GL_GOOGLE_include_directive : require\n" + of_arguments() + includes;
        std::string behind = calls();
        // glslang is a token ahead: without its line break the last token would stand in the next part.
        const std::string whole = text + "\n";
        const target::GlslPart parts[] = {
            {kLibrary, before}, {kMacros, macros_}, {shader_.file, whole}, {kCaller, behind}};
        return target::check_glsl(parts, target::Stage::fragment, library_);
    }

    bool compiles(const std::string& includes) {
        auto fault = fault_of(includes, text_);
        if (!fault) return true;
        const bool syntax = fault->what.find("syntax error") != fault->what.npos;
        if (fault->part == kCaller && !syntax && not_there(fault->line)) return false;
        std::string what = words(*fault);
        std::optional<Span> span = place(*fault, includes);
        if (!span && fault->part == kCaller && syntax && !scanned_.tokens.empty()) {
            what += " (behind the end of the file)";
            span = scanned_.tokens.back().span;
        } else if (!span && fault->line > 0) {
            what += fmt::format(" (in {}, line {})", printable(fault->part), fault->line);
        }
        error(Code::glsl_fault, span.value_or(Span{0, 1}), std::move(what));
        return false;
    }

    // glslang's words under the user's names, with what else is known.
    [[nodiscard]] std::string words(const target::GlslFault& fault) const {
        std::string what = unprefixed(fault.what, prefix_, all_names_);
        for (std::string_view start : {"'' : ", " ", "Linking fragment stage: "}) {
            if (what.starts_with(start)) what.erase(0, start.size());
        }
        while (what.ends_with(' ')) what.pop_back();
        if (auto [from, to] = linked(fault); !to.empty()) {
            what += from == to ? fmt::format(" '{}' calls itself", from)
                               : fmt::format(" '{}' calls '{}' in a circle", from, to);
        } else if (!from.empty()) {
            what += fmt::format(" '{}'", from);
        }
        for (const auto& [type, file] : kDeclares) {
            if (what.find(fmt::format("'{}'", type)) != what.npos)
                what += fmt::format("; #include \"{}\" declares it", file);
        }
        return printable(what, kLongestMessage);
    }

    // The function that the linker names, and one that it calls: "c_a(f1; calling c_b(vf3;".
    [[nodiscard]] std::pair<std::string, std::string> linked(const target::GlslFault& fault) const {
        if (fault.details.empty()) return {};
        constexpr std::string_view kCalling = " calling ";
        const std::string detail = unprefixed(fault.details[0], prefix_, all_names_);
        const std::size_t calling = detail.find(kCalling);
        auto name = [](const std::string& text) { return text.substr(0, text.find('(')); };
        return {name(detail), calling == detail.npos ? "" : name(detail.substr(calling + kCalling.size()))};
    }

    // A call that finds no function though there is one: a condition leaves it out, or a macro changes it.
    bool not_there(std::size_t line) {
        std::size_t number = kFirstCall;
        for (const material::ShaderCall& call : material_.calls) {
            if (call.shader != number_ || number++ != line) continue;
            error_at(call.function_at,
                     fmt::format("the layer calls '{}', which '{}' does not have under its conditions and "
                                 "macros (#if, #define)",
                                 custom::signature(call.result, call.function, call.arguments),
                                 printable(shader_.file)),
                     functions_called(call.function));
            return true;
        }
        return false;
    }

    // Where in the user's file a fault is; nothing if it is elsewhere.
    [[nodiscard]] std::optional<Span> place(const target::GlslFault& fault,
                                            const std::string& includes) const {
        const std::vector<custom::Token>& tokens = scanned_.tokens;
        if (fault.what.find("missing #endif") != fault.what.npos) {
            custom::Piece open = custom::open_condition(tokens);
            if (open.end > open.begin) return custom::span_of(tokens, open);
        }
        if (std::string name = linked(fault).first; !name.empty()) {
            for (const custom::Declaration& f : scanned_.functions) {
                if (f.name == name) return f.span;
            }
            for (const custom::Token& token : tokens) {
                if (token.directive == 0 && token.text == name) return token.span;
            }
        }
        if (fault.part != shader_.file || fault.line == 0) return std::nullopt;
        custom::Piece line = custom::tokens_of_line(shader_.source->text, tokens, fault.line);
        if (line.begin == line.end) return Span{0, 1};
        return place_in_line(fault, line, includes);
    }

    // glslang tells the line and often the token, between quotes. Where on the line is asked by compiling
    // once more, with each piece of it on a line of its own.
    [[nodiscard]] Span place_in_line(const target::GlslFault& fault, const custom::Piece& line,
                                     const std::string& includes) const {
        const std::vector<custom::Token>& tokens = scanned_.tokens;
        std::string named;
        if (std::size_t begin = fault.what.find('\''); begin != fault.what.npos) {
            std::size_t end = fault.what.find('\'', begin + 1);
            named = unprefixed(fault.what.substr(begin + 1, end - begin - 1), prefix_, all_names_);
        }
        std::vector<custom::Piece> pieces = custom::pieces(tokens, line);
        std::vector<std::size_t> breaks;
        for (std::size_t i = 1; i < pieces.size(); ++i) breaks.push_back(pieces[i].begin);
        std::optional<target::GlslFault> again;
        if (!breaks.empty())
            again = fault_of(includes,
                             custom::prefixed(shader_.source->text, scanned_, defined_, prefix_, breaks));
        if (again && again->part == fault.part && again->what == fault.what && again->line >= fault.line &&
            again->line - fault.line < pieces.size())
            return custom::named_at(tokens, pieces[again->line - fault.line], named);
        std::optional<Span> found;
        for (std::size_t i = line.begin; i < line.end; ++i) {
            if (tokens[i].text != named) continue;
            if (found) return custom::span_of(tokens, line);  // which of them nobody knows
            found = tokens[i].span;
        }
        return found.value_or(custom::span_of(tokens, line));
    }

    material::CheckedMaterial& material_;
    material::CheckedShader& shader_;
    std::size_t number_;
    std::string prefix_;
    const Defines& defines_;
    const target::ShaderLibrary& library_;
    const SourcePtr& json_;
    Diags& diags_;
    custom::UserGlsl scanned_;
    std::vector<std::string> defined_, all_names_;
    std::string macros_, text_;
};

}  // namespace

bool verify_shaders(material::CheckedMaterial& material, const Defines& defines,
                    const target::ShaderLibrary& library, const SourcePtr& json, Diags& diags) {
    std::size_t before = diags.error_count();
    for (std::size_t i = 0; i < material.shaders.size(); ++i)
        Verifier(material, i, defines, library, json, diags).run();
    return diags.error_count() == before;
}

}  // namespace sg
