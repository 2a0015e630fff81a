#include "emit/function.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "emit/body.hpp"
#include "emit/names.hpp"
#include "emit/wrap.hpp"

namespace sg::emit {
namespace {

using ir::Op;
using ir::Output;

#define SG_OBJECT_MATRIX "mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z)"
#define SG_VOLUME_OF(NAME) "SgVolume(sg_inputs." NAME ", sg_inputs." NAME "_dx, sg_inputs." NAME "_dy)"

constexpr FunctionWording kWordings[] = {
    {Op::position, "sg_inputs.position", ""},
    {Op::vertex_normal, "sg_inputs.normal", ""},
    {Op::vertex_tangent, "sg_inputs.tangent", ""},
    {Op::vertex_color, "sg_inputs.color", ""},
    {Op::uv_set, "SgUv(sg_inputs.uv{a}, sg_inputs.uv{a}_dx, sg_inputs.uv{a}_dy)", "surfgrad/uv.glsl"},
    {Op::volume_object, SG_VOLUME_OF("object_position"), "surfgrad/volume.glsl"},
    {Op::volume_world, SG_VOLUME_OF("world_position"), "surfgrad/volume.glsl"},
    {Op::time, "sg_inputs.time", ""},
    {Op::facing, "sg_inputs.facing", ""},
    {Op::frame, "sg_frame({0}, sg_inputs.position_dx, sg_inputs.position_dy, {1})", "surfgrad/frame.glsl"},
    {Op::normal_derivatives, "SgNormalDerivatives(sg_inputs.base_normal_dx, sg_inputs.base_normal_dy)",
     "surfgrad/frame.glsl"},
    {Op::view, "sg_function_view(sg_inputs.to_viewer, {0})", "function/moved.glsl"},
    {Op::frame_rebuilt,
     "sg_function_frame_rebuilt({0}, {1}, {2}, sg_inputs.to_viewer, sg_inputs.screen_x, sg_inputs.screen_y, "
     "sg_inputs.clip_w)",
     "function/moved.glsl"},
    {Op::volume_object_at, "sg_function_object_volume(" SG_OBJECT_MATRIX ", sg_inputs.object_origin, {0})",
     "function/moved.glsl"},
    {Op::volume_world_at, "sg_function_world_volume(sg_inputs.camera_position, {0})", "function/moved.glsl"},
    {Op::object_normal, "sg_function_object_normal(" SG_OBJECT_MATRIX ", {0})", "function/spaces.glsl"},
    {Op::normal_from_object, "sg_function_normal_from_object(" SG_OBJECT_MATRIX ", {0})",
     "function/spaces.glsl"},
    {Op::gradient_from_object, "sg_gradient_to_world(" SG_OBJECT_MATRIX ", {0})",
     "surfgrad/volume_space.glsl"},
};

// A value and its change per pixel to the right and downward.
void add_with_derivatives(std::vector<FunctionField>& out, const std::string& name, std::string_view type,
                          std::string meaning) {
    out.push_back({name, type, std::move(meaning)});
    out.push_back({name + "_dx", type, "its change per pixel to the right"});
    out.push_back({name + "_dy", type, "its change per pixel downward"});
}

std::vector<FunctionField> make_inputs() {
    std::vector<FunctionField> out;
    add_with_derivatives(out, "position", "vec3", "relative world space (origin at the camera), world units");
    out.push_back({"normal", "vec3", "interpolated vertex normal, world axes, any length"});
    out.push_back({"tangent", "vec4",
                   "interpolated vertex tangent: xyz world axes; w * cross(normal, tangent) points to +t"});
    out.push_back({"color", "vec4", "interpolated vertex colour, linear"});
    out.push_back({"facing", "float", "+1 on front faces, -1 on back faces"});
    out.push_back({"time", "float", "seconds"});
    add_with_derivatives(out, "object_position", "vec3", "object space, object units");
    add_with_derivatives(out, "world_position", "vec3", "absolute world space, world units");
    for (const char* axis : {"x", "y", "z"}) {
        out.push_back(
            {fmt::format("object_{}", axis), "vec3",
             fmt::format("the object's {} axis in world axes: a unit of object space, world units", axis)});
    }
    out.push_back({"object_origin", "vec3", "the object's origin, relative world space"});
    out.push_back({"base_normal_dx", "vec3", "change of the unit vertex normal per pixel to the right"});
    out.push_back({"base_normal_dy", "vec3", "its change per pixel downward"});
    out.push_back({"camera_position", "vec3", "absolute world space"});
    out.push_back({"to_viewer", "vec4",
                   "of a perspective 0, 0, 0, 1; else the unit direction to the viewer, world axes, and 0"});
    out.push_back({"screen_x", "vec4",
                   "first column of the matrix (x px, y px, depth, 1) -> homogeneous relative world space"});
    out.push_back({"screen_y", "vec4", "its second column"});
    out.push_back({"clip_w", "vec4", "last row of the matrix from relative world space to clip space"});
    for (std::uint32_t set = 0; set < 8; ++set) {
        add_with_derivatives(out, fmt::format("uv{}", set), "vec2",
                             fmt::format("texture coordinate {}, t downward", set));
    }
    return out;
}

const std::vector<std::pair<Output, FunctionField>>& results() {
    static const std::vector<std::pair<Output, FunctionField>> kRows = {
        {Output::normal, {"normal", "vec3", "resolved unit normal, world axes"}},
        {Output::base_color, {"base_color", "vec3", "linear"}},
        {Output::metallic, {"metallic", "float", "0 to 1"}},
        {Output::roughness, {"roughness", "float", "0 to 1, perceptual: squared it is GGX's alpha"}},
        {Output::occlusion, {"occlusion", "float", "1: open"}},
        {Output::emission, {"emission", "vec3", "linear radiance"}},
        {Output::opacity, {"opacity", "float", "0 to 1"}},
        {Output::cutoff,
         {"cutoff", "float", "alpha test: drop the pixel where opacity is less; 0 without one"}},
    };
    return kRows;
}

std::string fields_text(std::string_view name, std::span<const FunctionField> fields) {
    std::string out = fmt::format("struct {} {{\n", name);
    for (const FunctionField& field : fields)
        out +=
            fmt::format("    {:<24}  // {}\n", fmt::format("{} {};", field.type, field.name), field.meaning);
    return out + "};\n";
}

// Alike in the functions of all materials, so that a shader may hold many.
std::string shared_types() {
    return "#ifndef SG_MATERIAL_TYPES\n#define SG_MATERIAL_TYPES\n\n" +
           fields_text("SgMaterialInputs", function_inputs()) + "\n" +
           fields_text("SgMaterialResult", function_results()) + "\n#endif\n\n";
}

Wording function_wording(Op op) {
    for (const FunctionWording& row : kWordings) {
        if (row.op == op) return {row.glsl, row.include};
    }
    return stage_wording(op);
}

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Whether `sg_inputs.<name>` stands in the text.
bool reads(std::string_view text, const std::string& name) {
    const std::string read = "sg_inputs." + name;
    for (std::size_t at = text.find(read); at != text.npos; at = text.find(read, at + 1)) {
        std::size_t end = at + read.size();
        if (end == text.size() || !is_word(text[end])) return true;
    }
    return false;
}

std::vector<FunctionResource> resources_of(const ir::Module& module, const MaterialInterface& material) {
    std::vector<bool> sampled(module.textures.size(), false), filtering(material.samplers.size(), false);
    for (const ir::Value& value : module.values) {
        for (std::uint32_t texture : ir::textures_of(module, value)) sampled[texture] = true;
    }
    std::vector<FunctionResource> out;
    for (const TextureSlot& slot : material.textures) {
        if (!sampled[slot.texture]) continue;
        filtering[slot.sampler] = true;
        out.push_back(
            {BindingKind::texture, slot.variable, slot.binding, material.samplers[slot.sampler].binding});
    }
    for (std::size_t i = 0; i < filtering.size(); ++i) {
        if (filtering[i])
            out.push_back(
                {BindingKind::sampler, material.samplers[i].variable, material.samplers[i].binding, 0});
    }
    return out;
}

bool reads_parameters(const ir::Module& module) {
    return std::any_of(module.values.begin(), module.values.end(),
                       [](const ir::Value& value) { return reads_block(ir::info(value.op).attribute); });
}

std::string parameters_text(const MaterialInterface& material, const std::string& type) {
    if (type.empty()) return "";
    std::string out = fmt::format("struct {} {{\n", type);
    for (const ParameterSlot& slot : material.parameters)
        out += fmt::format("    {} {};\n", ir::info(slot.type).glsl, slot.member);
    return out + "};\n\n";
}

std::string comment_of(const ir::Module& module, const MaterialFunction& function) {
    std::string out = fmt::format(
        "// {0}: the material as a function, made by surfgradc.\n"
        "// It takes no derivatives and reads nothing but its arguments, so it may be called anywhere.\n"
        "// Of SgMaterialInputs it reads these; the others need no value:\n",
        comment_text(module.name));
    for (const FunctionField& field : function_inputs()) {
        if (std::find(function.inputs.begin(), function.inputs.end(), field.name) != function.inputs.end())
            out += fmt::format("//   {:<18} {}\n", field.name, field.meaning);
    }
    return out;
}

std::string resource_type(BindingKind kind) {
    return kind == BindingKind::texture ? "texture2D" : "sampler";
}

// The arguments as they are declared, or as `caller_of` hands them over.
std::string arguments(const MaterialFunction& function, bool declared) {
    std::string out = declared ? "SgMaterialInputs sg_inputs" : "sg_inputs";
    if (!function.parameters_type.empty())
        out += declared ? fmt::format(", {} sg_material", function.parameters_type) : ", sg_material";
    for (const FunctionResource& r : function.resources)
        out +=
            declared ? fmt::format(", {} {}", resource_type(r.kind), r.argument) : ", sg_given_" + r.argument;
    return out;
}

// Inputs without values do: nothing is ever drawn with it.
std::string caller_of(const MaterialFunction& function) {
    std::string out;
    for (const FunctionResource& r : function.resources)
        out += fmt::format("layout(set = 1, binding = {}) uniform {} sg_given_{};\n", r.binding,
                           resource_type(r.kind), r.argument);
    out += "\nvoid main() {\n    SgMaterialInputs sg_inputs;\n";
    if (!function.parameters_type.empty())
        out += fmt::format("    {} sg_material;\n", function.parameters_type);
    return out + fmt::format("    SgMaterialResult sg_result = {}({});\n}}\n", function.name,
                             arguments(function, false));
}

// The user's GLSL that the module calls. Other than the library's its names are this material's alone.
std::string user_glsl(const ir::Module& module, std::vector<std::string>& names) {
    std::vector<bool> called(module.shaders.size(), false);
    for (const ir::Value& value : module.values) {
        if (ir::info(value.op).attribute == ir::Attribute::Function)
            called[module.functions[value.index].shader] = true;
    }
    std::string out;
    for (std::size_t i = 0; i < called.size(); ++i) {
        if (!called[i]) continue;
        const ir::Shader& shader = module.shaders[i];
        out += fmt::format("// {}\n{}\n", comment_text(shader.file), shader.text);
        names.insert(names.end(), shader.names.begin(), shader.names.end());
    }
    return out;
}

// The text with a suffix behind each of these words.
std::string with_suffix(const std::string& text, const std::vector<std::string>& names,
                        const std::string& suffix) {
    if (names.empty()) return text;
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_word(text[end])) ++end;
        std::string word = text.substr(at, std::max<std::size_t>(end - at, 1));
        bool known = std::find(names.begin(), names.end(), word) != names.end();
        out += known ? word + suffix : word;
        at += word.size();
    }
    return out;
}

}  // namespace

std::span<const Output> function_outputs() {
    static const std::vector<Output> kOutputs = [] {
        std::vector<Output> out;
        for (const auto& [output, field] : results()) out.push_back(output);
        return out;
    }();
    return kOutputs;
}

std::span<const FunctionWording> function_wordings() {
    return kWordings;
}

std::span<const FunctionField> function_inputs() {
    static const std::vector<FunctionField> kFields = make_inputs();
    return kFields;
}

std::span<const FunctionField> function_results() {
    static const std::vector<FunctionField> kFields = [] {
        std::vector<FunctionField> out;
        for (const auto& [output, field] : results()) out.push_back(field);
        return out;
    }();
    return kFields;
}

MaterialFunction emit_function(const ir::Module& module, const MaterialInterface& material,
                               std::string_view stem) {
    Body body(module, material, function_wording);
    MaterialFunction out;
    out.name = Names().unique("sg_material_", stem);
    out.suffix = out.name.substr(std::string_view("sg_material").size());
    if (reads_parameters(module)) out.parameters_type = "SgMaterialParameters" + out.suffix;
    out.resources = resources_of(module, material);
    std::string returned;
    for (const auto& [output, field] : results()) {
        ir::ValueId value = module.output(output);
        returned += (returned.empty() ? "" : ", ") + (value.valid() ? body.operand(value) : "0.0");
    }
    std::vector<std::string> names;
    const std::string user = user_glsl(module, names);
    out.has_user_glsl = !user.empty();
    const std::string lines =
        wrapped(with_suffix(fmt::format("{}{}    return SgMaterialResult({});\n", body.text(),
                                        body.text().empty() ? "" : "\n", returned),
                            names, out.suffix));
    for (const FunctionField& field : function_inputs()) {
        if (reads(lines, field.name)) out.inputs.push_back(field.name);
    }
    out.comment = comment_of(module, out);
    for (std::string_view include : body.includes()) out.text += fmt::format("#include \"{}\"\n", include);
    out.text += "\n" + with_suffix(user, names, out.suffix) + shared_types() +
                parameters_text(material, out.parameters_type);
    out.text +=
        wrapped(fmt::format("SgMaterialResult {}({}) {{\n", out.name, arguments(out, true))) + lines + "}\n";
    out.caller = caller_of(out);
    return out;
}

}  // namespace sg::emit
