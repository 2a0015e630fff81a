#include "emit/glsl.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/ice.hpp"
#include "emit/body.hpp"
#include "emit/wrap.hpp"
#include "ir/lighting.hpp"

namespace sg::emit {
namespace {

using ir::Op;
using ir::Output;

std::vector<Varying> varyings_of(const ir::Module& module) {
    std::vector<Varying> out;
    for (const ir::Value& value : module.values) {
        // A place in the world is the position and the camera's.
        const Op source = value.op == Op::volume_world ? Op::position : value.op;
        if (is_varying(source)) out.push_back({source, source == Op::uv_set ? value.index : 0});
    }
    std::sort(out.begin(), out.end(),
              [](const Varying& a, const Varying& b) { return varying_location(a) < varying_location(b); });
    auto same = [](const Varying& a, const Varying& b) { return varying_location(a) == varying_location(b); };
    out.erase(std::unique(out.begin(), out.end(), same), out.end());
    return out;
}

std::string head(const ir::Module& module, std::string_view stage, std::string_view entry) {
    return fmt::format(
        "#version 450\n#extension GL_GOOGLE_include_directive : require\n"
        "// {}: {} shader of the entry point '{}', made by surfgradc.\n\n",
        comment_text(module.name), stage, entry);
}

std::string include_lines(const std::set<std::string_view>& includes) {
    std::string out;
    for (std::string_view include : includes) out += fmt::format("#include \"{}\"\n", include);
    return out + "\n";
}

// ---- vertex ----

// What the vertex stage computes for a varying.
std::string vertex_value(const Varying& v) {
    if (v.source == Op::position) return "sg_relative_position";
    std::string attribute = fmt::format("sg_vertex_{}", vertex_input(v).name);
    bool as_it_is = v.source == Op::uv_set || v.source == Op::vertex_color || v.source == Op::volume_object;
    return as_it_is ? attribute : fmt::format("sg_stage_{}({})", vertex_input(v).name, attribute);
}

// ---- fragment ----

// `used_parameters`: whether the block is read at all.
std::string material_declarations(const MaterialInterface& material, bool used_parameters,
                                  const std::vector<bool>& sampled) {
    std::string out;
    if (used_parameters) {
        out += "layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {\n";
        for (const ParameterSlot& slot : material.parameters)
            out += fmt::format("    {} {};\n", ir::info(slot.type).glsl, slot.member);
        out += "} sg_material;\n";
    }
    std::vector<bool> samplers(material.samplers.size(), false);
    for (const TextureSlot& slot : material.textures) {
        if (!sampled[slot.texture]) continue;
        samplers[slot.sampler] = true;
        out +=
            fmt::format("layout(set = 1, binding = {}) uniform texture2D {};\n", slot.binding, slot.variable);
    }
    for (std::size_t i = 0; i < samplers.size(); ++i) {
        if (!samplers[i]) continue;
        out += fmt::format("layout(set = 1, binding = {}) uniform sampler {};\n",
                           material.samplers[i].binding, material.samplers[i].variable);
    }
    return out;
}

void debug_view(std::string& out, EntryInterface& interface, std::string name, std::uint32_t components,
                std::string_view kind, const std::string& value) {
    auto number = static_cast<std::uint32_t>(interface.views.size());
    out += fmt::format("    sg_shown = sg_stage_select(sg_shown, {}.0, {});  // {}\n", number, value,
                       comment_text(name));
    interface.views.push_back({std::move(name), number, components, kind});
}

std::string debug_tail(const ir::Module& module, const Body& body, EntryInterface& interface) {
    std::string out = "    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);\n";
    std::string frame = body.operand(module.output(Output::frame));
    debug_view(out, interface, "position", 3, "position", frame + ".position");
    debug_view(out, interface, "base-normal", 3, "direction", frame + ".normal");
    debug_view(out, interface, "dpdx", 3, "vector", frame + ".dpdx");
    debug_view(out, interface, "dpdy", 3, "vector", frame + ".dpdy");
    debug_view(out, interface, "gradient", 3, "vector", body.operand(module.output(Output::gradient)));
    debug_view(out, interface, "normal", 3, "direction", body.operand(module.output(Output::normal)));
    for (const ir::OutputBinding& output : module.outputs) {
        std::string value = body.operand(output.value);
        if (output.output == Output::basis_vertex) {
            debug_view(out, interface, "tangent", 3, "vector", value + ".tangent");
            debug_view(out, interface, "bitangent", 3, "vector", value + ".bitangent");
        } else if (output.output == Output::uv) {
            debug_view(out, interface, fmt::format("uv{}", output.set), 2, "uv",
                       fmt::format("vec3({}.st, 0.0)", value));
            debug_view(out, interface, fmt::format("uv{}-derivatives", output.set), 4, "vector",
                       fmt::format("vec4({0}.dx, {0}.dy)", value));
        } else if (output.output == Output::vertex_color) {
            debug_view(out, interface, "vertex-color", 4, "vector", value);
        } else if (output.output == Output::volume) {
            std::string space = output.set == 0 ? "object-position" : "world-position";
            debug_view(out, interface, space, 3, "position", value + ".p");
            debug_view(out, interface, space + "-dx", 3, "vector", value + ".dx");
            debug_view(out, interface, space + "-dy", 3, "vector", value + ".dy");
        } else if (output.output == Output::normal_derivatives) {
            debug_view(out, interface, "base-normal-dx", 3, "vector", value + ".dndx");
            debug_view(out, interface, "base-normal-dy", 3, "vector", value + ".dndy");
        } else if (output.output == Output::moved_position) {
            debug_view(out, interface, "moved-position", 3, "position", value);
        } else if (output.output == Output::moved_uv) {
            debug_view(out, interface, fmt::format("moved-uv{}", output.set), 2, "uv",
                       fmt::format("vec3({}.st, 0.0)", value));
        } else if (output.output == Output::layer) {
            debug_view(out, interface, "layer:" + module.layers[output.set].id, 3, "vector", value);
        }
    }
    return out + "    sg_out_value = sg_shown;\n";
}

// The line that drops pixels of an alpha-tested material, behind all derivatives.
std::string alpha_test(const ir::Module& module, const Body& body) {
    ir::ValueId cutoff = module.output(Output::cutoff);
    if (!cutoff.valid()) return "";
    return fmt::format("    if ({} < {}) discard;\n", body.operand(module.output(Output::opacity)),
                       body.operand(cutoff));
}

const ir::LightingModel& lighting_of(const ir::Module& module) {
    return ir::all_lighting_models()[module.lighting];
}

std::string lit_tail(const ir::Module& module, const Body& body) {
    const ir::LightingModel& model = lighting_of(module);
    std::string out = fmt::format("    {} sg_surface;\n", model.surface);
    for (Output input : model.inputs)
        out += fmt::format("    sg_surface.{} = {};\n", ir::output_name(input),
                           body.operand(module.output(input)));
    return out + fmt::format(
                     "    sg_out_color = vec4(sg_{}_radiance(sg_surface, {}, "
                     "sg_stage_lights(sg_in_position)), {});\n",
                     model.name, body.operand(module.output(Output::normal)),
                     body.operand(module.output(Output::opacity)));
}

std::string tail(const ir::Module& module, const EntryPoint& entry, const Body& body,
                 EntryInterface& interface) {
    auto operand = [&](Output output) { return body.operand(module.output(output)); };
    std::string out = alpha_test(module, body);
    if (entry.name == "depth") return out;
    if (!out.empty()) out += "\n";
    if (entry.name == "debug") return out + debug_tail(module, body, interface);
    if (entry.name == "normal")
        return out + fmt::format("    sg_out_normal = vec4({}, 1.0);\n", operand(Output::normal));
    if (entry.name == "gbuffer") {
        return out +
               fmt::format(
                   "    sg_out_base_color = vec4({}, {});\n    sg_out_normal = vec4({}, {});\n"
                   "    sg_out_surface = vec4({}, {}, 0.0, 1.0);\n    sg_out_emission = vec4({}, 1.0);\n",
                   operand(Output::base_color), operand(Output::opacity), operand(Output::normal),
                   operand(Output::roughness), operand(Output::metallic), operand(Output::occlusion),
                   operand(Output::emission));
    }
    SG_ASSERT(entry.lit);
    return out + lit_tail(module, body);
}

struct Used {
    bool parameters = false;
    bool frame_block = false;
    bool object_block = false;
    std::vector<bool> textures;
    std::set<std::uint32_t> shaders;
};
Used used_by(const ir::Module& module) {
    Used used;
    used.textures.assign(module.textures.size(), false);
    for (const ir::Value& value : module.values) {
        ir::Attribute attribute = ir::info(value.op).attribute;
        used.parameters |= reads_block(attribute);
        std::string_view include = ir::info(value.op).include;
        bool moved = include == "stage/moved.glsl";
        used.frame_block |=
            value.op == Op::time || include == "stage/view.glsl" || include == "stage/world.glsl" || moved;
        used.object_block |= (value.op != Op::time && include == "stage/object.glsl") || moved;
        if (attribute == ir::Attribute::Function) used.shaders.insert(module.functions[value.index].shader);
        for (std::uint32_t texture : ir::textures_of(module, value)) used.textures[texture] = true;
    }
    return used;
}

std::vector<Binding> bindings_of(const EntryPoint& entry, const ir::Module& module,
                                 const MaterialInterface& material, const Used& used) {
    std::vector<Binding> out{{0, 0, BindingKind::uniform_buffer, "SgFrameBlock", true,
                              entry.reads_frame_block || used.frame_block}};
    if (used.parameters) out.push_back({1, 0, BindingKind::uniform_buffer, "SgMaterialBlock", false, true});
    std::vector<bool> samplers(material.samplers.size(), false);
    for (const TextureSlot& slot : material.textures) {
        if (!used.textures[slot.texture]) continue;
        samplers[slot.sampler] = true;
        out.push_back(
            {1, slot.binding, BindingKind::texture, module.textures[slot.texture].name, false, true});
    }
    for (std::size_t i = 0; i < samplers.size(); ++i) {
        if (samplers[i])
            out.push_back({1, material.samplers[i].binding, BindingKind::sampler,
                           material.samplers[i].variable, false, true});
    }
    out.push_back({2, 0, BindingKind::uniform_buffer, "SgObjectBlock", true, used.object_block});
    return out;
}

}  // namespace

std::string emit_vertex(const ir::Module& module, const EntryPoint& entry,
                        const std::vector<Varying>& varyings) {
    std::string out = head(module, "vertex", entry.name) + "#include \"stage/vertex.glsl\"\n\n";
    for (const VertexInput& input : vertex_inputs(varyings)) {
        out += fmt::format("layout(location = {}) in {} sg_vertex_{};\n", input.location, input.glsl_type,
                           input.name);
    }
    for (const Varying& v : varyings) {
        out += fmt::format("layout(location = {}) out {} sg_out_{};\n", varying_location(v),
                           vertex_input(v).glsl_type, varying_name(v));
    }
    out += "\nvoid main() {\n";
    std::string position = "sg_stage_position(sg_vertex_position)";
    if (std::any_of(varyings.begin(), varyings.end(),
                    [](const Varying& v) { return v.source == Op::position; })) {
        out += fmt::format("    vec3 sg_relative_position = {};\n", position);
        position = "sg_relative_position";
    }
    for (const Varying& v : varyings)
        out += fmt::format("    sg_out_{} = {};\n", varying_name(v), vertex_value(v));
    return out + fmt::format("    gl_Position = sg_stage_clip({});\n}}\n", position);
}

Shaders emit_glsl(const ir::Module& module, const EntryPoint& entry, const MaterialInterface& material) {
    Shaders out;
    Body body(module, material);
    Used used = used_by(module);
    out.interface.varyings = varyings_of(module);
    if (entry.lit && std::none_of(out.interface.varyings.begin(), out.interface.varyings.end(),
                                  [](const Varying& v) { return v.source == Op::position; })) {
        out.interface.varyings.insert(out.interface.varyings.begin(),
                                      {Op::position, 0});  // lighting needs it
    }
    out.interface.bindings = bindings_of(entry, module, material, used);
    out.has_user_glsl = !used.shaders.empty();
    std::string last = tail(module, entry, body, out.interface);

    std::set<std::string_view> includes = body.includes();
    includes.insert(entry.includes.begin(), entry.includes.end());
    const std::string lighting = fmt::format("lighting/{}.glsl", lighting_of(module).name);
    if (entry.lit) includes.insert(lighting);
    std::string text = head(module, "fragment", entry.name) + include_lines(includes);
    for (std::uint32_t shader : used.shaders) {
        const ir::Shader& file = module.shaders[shader];
        text += fmt::format("// {}\n{}\n", comment_text(file.file), file.text);
    }
    std::string declarations = material_declarations(material, used.parameters, used.textures);
    if (!declarations.empty()) text += declarations + "\n";
    for (const Varying& v : out.interface.varyings) {
        text += fmt::format("layout(location = {}) in {} sg_in_{};\n", varying_location(v),
                            vertex_input(v).glsl_type, varying_name(v));
    }
    for (std::size_t i = 0; i < entry.attachments.size(); ++i)
        text += fmt::format("layout(location = {}) out vec4 sg_out_{};\n", i, entry.attachments[i].name);
    const char* gap = body.text().empty() || last.empty() ? "" : "\n";
    text += fmt::format("\nvoid main() {{\n{}{}{}}}\n", wrapped(body.text()), gap, wrapped(last));
    out.fragment = std::move(text);
    out.vertex = emit_vertex(module, entry, out.interface.varyings);
    return out;
}

}  // namespace sg::emit
