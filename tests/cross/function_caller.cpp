#include "tests/cross/function_caller.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

namespace sg::cross {
namespace {

using target::Language;

// How a language names what `forward` has declared.
struct Dialect {
    const char* main;                       // where the entry function begins
    const char *input, *dx, *dy;            // {}: name, or what is derived
    const char *time, *column, *parameter;  // {}: number, or name
    std::string frame(std::string_view member) const {
        return std::string(time).substr(0, std::string_view(time).find("time_view")) + std::string(member);
    }
    const char *assign, *discard, *leave;
};

// Downward: GL's y points up.
Dialect dialect_of(const target::Target& target) {
    constexpr const char *kTime = "sg_frame_block.time_view.x",
                         *kColumn = "sg_object_block.relative_from_object[{}].xyz",
                         *kColor = "sg_out_color = vec4({}, 1.0);";
    switch (target.language) {
        case Language::spirv:
            return {"\nvoid main() {", "sg_in_{}",       "dFdxFine({})", "dFdyFine({})", kTime,
                    kColumn,           "sg_material.{}", kColor,         "discard",      ""};
        case Language::glsl:
            return {"\nvoid main()\n{",
                    "sg_varying_{}",
                    "dFdxFine({})",
                    "-dFdyFine({})",
                    kTime,
                    kColumn,
                    "sg_material.{}",
                    kColor,
                    "discard",
                    ""};
        case Language::essl:
            return {"\nvoid main()\n{", "sg_varying_{}", "dFdx({})", "-dFdy({})", kTime, kColumn,
                    "sg_material.{}",   kColor,          "discard",  ""};
        case Language::hlsl:
            return {"\nvoid frag_main()\n{",
                    "sg_in_{}",
                    "ddx_fine({})",
                    "ddy_fine({})",
                    "sg_frame_block_time_view.x",
                    "sg_object_block_relative_from_object[{}].xyz",
                    "sg_material_{}",
                    "sg_out_color = float4({}, 1.0f);",
                    "discard",
                    ""};
        case Language::msl:
            return {"\nfragment main0_out main0(",
                    "in.sg_in_{}",
                    "dfdx({})",
                    "dfdy({})",
                    kTime,
                    kColumn,
                    "sg_material.{}",
                    "main0_out out = {{}};\n    out.sg_out_color = float4({}, 1.0);",
                    "discard_fragment()",
                    "\n    return out;"};
    }
    return {};
}

std::string with(const char* pattern, std::string_view value) {
    return fmt::vformat(pattern, fmt::make_format_args(value));
}

// What only parallax asks for; "" for other inputs.
std::string camera_value(const std::string& name, const Dialect& dialect, const std::string& vector) {
    const std::string unit = "normalize(" + with(dialect.input, "normal") + ")";
    if (name == "object_origin") return with(dialect.column, "3");
    if (name == "base_normal_dx") return with(dialect.dx, unit);
    if (name == "base_normal_dy") return with(dialect.dy, unit);
    if (name == "camera_position") return dialect.frame("camera_position") + ".xyz";
    if (name == "to_viewer")
        return vector + "(-" + dialect.frame("view_direction") + ".xyz, " + dialect.frame("camera_position") +
               ".w)";
    const std::string screen = dialect.frame("relative_from_screen"),
                      clip = dialect.frame("clip_from_relative");
    if (name == "screen_x") return screen + "[0]";
    if (name == "screen_y") return screen + "[1]";
    if (name != "clip_w") return "";
    return fmt::format("{0}({1}[0].w, {1}[1].w, {1}[2].w, {1}[3].w)", vector, clip);
}

std::string input_value(const std::string& name, const Dialect& dialect, const std::string& vector) {
    if (std::string value = camera_value(name, dialect, vector); !value.empty()) return value;
    if (name == "facing") return "gl_FrontFacing ? 1.0 : -1.0";
    if (name == "time") return dialect.time;
    if (name.size() == 8 && name.starts_with("object_"))
        return with(dialect.column, std::to_string(name.back() - 'x'));
    const bool along_x = name.ends_with("_dx"), along_y = name.ends_with("_dy");
    std::string source = name.substr(0, name.size() - (along_x || along_y ? 3 : 0));
    const bool world = source == "world_position";
    if (world) source = "position";
    const std::string value = with(dialect.input, source);
    if (along_x) return with(dialect.dx, value);
    if (along_y) return with(dialect.dy, value);
    return world ? value + " + " + dialect.frame("camera_position") + ".xyz" : value;
}

std::string body_of(const nlohmann::json& function, const target::Target& target, const Dialect& dialect) {
    std::string out = "    SgMaterialInputs given;\n", arguments = "given";
    const bool glsl = target.language != Language::hlsl && target.language != Language::msl;
    const std::string vector = glsl ? "vec4" : "float4";
    for (const auto& input : function.at("inputs")) {
        const std::string name = input.at("name");
        out += fmt::format("    given.{} = {};\n", name, input_value(name, dialect, vector));
    }
    if (function.contains("parameters")) {
        out += fmt::format("    {} set;\n", function["parameters"].at("type").get<std::string>());
        for (const auto& member : function["parameters"].at("members")) {
            const std::string name = member.at("name");
            out += fmt::format("    set.{} = {};\n", name, with(dialect.parameter, name));
        }
        arguments += ", set";
    }
    const bool joined = target.language == Language::glsl || target.language == Language::essl;
    for (const auto& resource : function.at("resources")) {
        if (!joined || resource.at("kind") == "texture")
            arguments += ", " + resource.at("argument").get<std::string>();
    }
    out += fmt::format("    SgMaterialResult made = {}({});\n", function.at("name").get<std::string>(),
                       arguments);
    out += fmt::format("    if (made.opacity < made.cutoff) {{ {}; }}\n", dialect.discard);
    // Nothing is below zero, but no compiler knows: all results stay in use, and what the vertex stage hands
    // over.
    out += fmt::format(
        "    float sum = made.base_color.x + made.base_color.y + made.base_color.z + made.emission.x + "
        "made.metallic + made.roughness + made.occlusion;\n"
        "    if (sum + dot({0}, {0}) < -1.0) {{ {1}; }}\n",
        with(dialect.input, "position"), dialect.discard);
    return out + "    " + with(dialect.assign, "made.normal") + dialect.leave + "\n";
}

// What SPIRV-Cross adds to its texts would stand in both: the function's guards say that it is there.
std::string without_helpers_of(const std::string& text, const std::string& function) {
    static const std::regex kGuard("#ifndef (SG_HAS_(spv[A-Za-z]+)\\w*)\n");
    std::string out;
    for (std::sregex_iterator it(function.begin(), function.end(), kGuard), end; it != end; ++it) {
        if (text.find(" " + (*it)[2].str()) != text.npos) out += fmt::format("#define {}\n", (*it)[1].str());
    }
    return out + function;
}

}  // namespace

const std::string& function_text(const Sample& sample, const target::Target& target) {
    const auto manifest = nlohmann::json::parse(sample.manifest);
    for (const auto& text : manifest.at("function").at("texts")) {
        if (text.at("target") == target.name) return sample.texts.at(text.at("file"));
    }
    throw std::runtime_error(sample.name + ": no function for " + std::string(target.name));
}

void call_function(std::string& text, const Sample& sample, const target::Target& target) {
    const Dialect dialect = dialect_of(target);
    const std::size_t at = text.find(dialect.main);
    if (at == text.npos) throw std::runtime_error("no entry function in\n" + text);
    const std::size_t begin = text.find("{\n", at) + 2, end = text.find("\n}\n", begin) + 1;
    text.replace(begin, end - begin,
                 body_of(nlohmann::json::parse(sample.manifest).at("function"), target, dialect));
    // In Vulkan's GLSL the library of the function stands first, so that it is that one which is used.
    const std::size_t place = target.language == Language::spirv ? text.find("#include") : at + 1;
    text.insert(place, without_helpers_of(text, function_text(sample, target)) + "\n");
}

}  // namespace sg::cross
