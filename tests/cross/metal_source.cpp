#include "tests/cross/metal_source.hpp"

#include <fmt/core.h>

#include <regex>
#include <stdexcept>

namespace sg::cross {
namespace {

// SPIRV-Cross overloads its array's operators by address space, which C++ does not have: one of them stays.
std::string without_address_spaces(const std::string& text) {
    static const std::regex kOverload(
        "\\n *(constexpr const )?(device|constant|threadgroup) T& operator \\[\\][^}]*\\}");
    return std::regex_replace(text, kOverload, "");
}

// Guards hold for the whole file, types for their namespace.
std::string forgotten_guards(const std::string& text) {
    static const std::regex kGuard("#define (SG_HAS_\\w+)");
    std::string out;
    for (std::sregex_iterator it(text.begin(), text.end(), kGuard), end; it != end; ++it)
        out += fmt::format("#undef {}\n", (*it)[1].str());
    return out;
}

// "" where there is none: a shader that writes depth alone has no inputs or no outputs.
std::string first(const std::string& text, const std::regex& pattern) {
    std::smatch match;
    return std::regex_search(text, match, pattern) ? match[1].str() : "";
}

// Statements that copy each field of a struct from or to what stands at its number.
std::string field_lines(const std::string& body, const char* format) {
    static const std::regex kField(
        "\\w+ (\\w+) \\[\\[(attribute|user|color|position)(\\((locn)?(\\d+)\\))?\\]\\];");
    std::string out;
    for (std::sregex_iterator it(body.begin(), body.end(), kField), end; it != end; ++it) {
        std::string kind = (*it)[2], number = (*it)[5];
        std::string place = kind == "position" ? "position"
                            : kind == "color"  ? fmt::format("colors[{}][pixel]", number)
                                               : fmt::format("numbers[{}]", number);
        out += fmt::format("    {};\n", fmt::vformat(format, fmt::make_format_args((*it)[1].str(), place)));
    }
    return out;
}

// The arguments of a call, each from the number that its attribute states.
std::string argument_list(const std::string& parameters, const std::string& space) {
    static const std::regex kParameter(
        "(constant )?([\\w<>]+)&? \\w+ \\[\\[(\\w+)(\\((\\d+)\\))?\\]\\](, |$)");
    std::string out;
    std::size_t used = 0;
    for (std::sregex_iterator it(parameters.begin(), parameters.end(), kParameter), end; it != end; ++it) {
        std::string type = (*it)[2], kind = (*it)[3], number = (*it)[5];
        used += static_cast<std::size_t>(it->length());
        if (!out.empty()) out += ", ";
        if (kind == "stage_in") out += "in";
        if (kind == "front_facing") out += "front";
        if (kind == "buffer")
            out += fmt::format("*static_cast<const {}::{}*>(bindings.buffers[{}])", space, type, number);
        if (kind == "texture") out += fmt::format("sg_texture(bindings.textures[{}])", number);
        if (kind == "sampler") out += fmt::format("sg_sampler(bindings.samplers[{}])", number);
    }
    if (used != parameters.size())
        throw std::runtime_error("a Metal signature that the tests cannot read: " + parameters);
    return out;
}

std::string call_function(const std::string& text, std::size_t i) {
    static const std::regex kIn("struct main0_in\n\\{([^}]*)\\}"), kOut("struct main0_out\n\\{([^}]*)\\}");
    static const std::regex kSignature("\n(?:vertex|fragment) (main0_out|void) main0\\(([^\n]*)\\)\n");
    const std::string space = fmt::format("sg_text_{}", i), inputs = first(text, kIn);
    std::smatch signature;
    if (!std::regex_search(text, signature, kSignature))
        throw std::runtime_error("a Metal text without a signature");
    const std::string in = inputs.empty() ? "" : fmt::format("    {}::main0_in in;\n", space);
    const std::string loads = field_lines(inputs, "sg_load(in.{}, {})");
    const std::string stores = field_lines(first(text, kOut), "sg_store(out.{}, {})");
    const std::string call =
        fmt::format("{}{}::main0({});\n", signature[1] == "void" ? "" : "auto out = ", space,
                    argument_list(signature[2], space));
    if (text.find("\nvertex ") != text.npos) {
        return fmt::format(
            "extern \"C\" void sg_call_{}(const SgBindings& bindings, const SgNumbers& attributes, "
            "SgNumbers& varyings, float (&position)[4]) {{\n"
            "{}    {{ auto& numbers = attributes;\n{}    }}\n    {}    auto& numbers = varyings;\n{}}}\n",
            i, in, loads, call, stores);
    }
    return fmt::format(
        "extern \"C\" void sg_call_{}(const SgBindings& bindings, const SgNumbers (&varyings)[4], bool "
        "front, SgColors& colors, bool (&discarded)[4]) {{\n"
        "    sg_run_quad([&](int pixel) {{\n{}    auto& numbers = varyings[pixel];\n{}    {}{}    }}, "
        "discarded);\n}}\n",
        i, in, loads, call, stores);
}

}  // namespace

std::string metal_source(const std::vector<std::string>& texts, bool callable) {
    std::string out = "#include <metal_stdlib>\n#include <simd/simd.h>\n#include \"glue.hpp\"\n";
    for (std::size_t i = 0; i < texts.size(); ++i) {
        out += fmt::format("namespace sg_text_{} {{\n#line 1 \"text{}.metal\"\n{}\n}}\n{}", i, i,
                           without_address_spaces(texts[i]), forgotten_guards(texts[i]));
    }
    out += "#line 1 \"calls\"\n";
    for (std::size_t i = 0; callable && i < texts.size(); ++i) out += call_function(texts[i], i);
    return out;
}

}  // namespace sg::cross
