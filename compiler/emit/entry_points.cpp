#include "emit/glsl.hpp"

#include "ir/lighting.hpp"

namespace sg::emit {

std::span<const EntryPoint> all_entry_points() {
    using enum ir::Output;
    static const EntryPoint kRows[] = {
        {"forward",
         "the lit picture: linear radiance",
         {{"color", "", "linear radiance; opacity"}},
         {normal, opacity, cutoff},
         {"stage/forward.glsl"},
         true,
         true,
         true},
        {"gbuffer",
         "what a deferred renderer lights later, in four attachments",
         {{"base_color", "rgba8_srgb", "linear base colour; opacity"},
          {"normal", "rgba16_float", "unit normal, world axes; perceptual roughness"},
          {"surface", "rgba8_unorm", "metallic, occlusion, 0; 1"},
          {"emission", "rgba16_float", "linear radiance; 1"}},
         {normal, base_color, metallic, roughness, occlusion, emission, opacity, cutoff},
         {},
         false,
         false,
         true},
        {"normal",
         "the resolved unit normal, world axes",
         {{"normal", "", "unit normal, world axes; 1"}},
         {normal, opacity, cutoff},
         {},
         false,
         false,
         false},
        {"depth",
         "nothing but the depth: shadows and depth passes",
         {},
         {opacity, cutoff},
         {},
         false,
         false,
         false},
        {"debug",
         "one of the values inside the shader, chosen by a uniform",
         {{"value", "", "the view's numbers"}},
         {frame, normal, gradient, basis_vertex, vertex_color, uv, volume, normal_derivatives, moved_position,
          moved_uv, layer, opacity, cutoff},
         {"stage/debug.glsl"},
         false,
         true,
         false},
    };
    return kRows;
}

const EntryPoint* find_entry_point(std::string_view name) {
    for (const EntryPoint& entry : all_entry_points()) {
        if (entry.name == name) return &entry;
    }
    return nullptr;
}

namespace {

// What is written as no less than the written cutoff is never dropped, as of a material without an opacity.
bool tests_alpha(const ir::Module& module) {
    const ir::ValueId cutoff = module.output(ir::Output::cutoff),
                      opacity = module.output(ir::Output::opacity);
    if (!cutoff.valid()) return false;
    const ir::Value &least = module.at(cutoff), &given = module.at(opacity);
    const bool written = least.op == ir::Op::constant && given.op == ir::Op::constant;
    return !written || given.number[0] < least.number[0];
}

}  // namespace

std::vector<ir::Output> needed_outputs(const EntryPoint& entry, const ir::Module& module) {
    std::vector<ir::Output> out = entry.outputs;
    if (entry.lit) {
        const std::vector<ir::Output>& inputs = ir::all_lighting_models()[module.lighting].inputs;
        out.insert(out.end(), inputs.begin(), inputs.end());
    }
    if (tests_alpha(module)) return out;
    std::erase(out, ir::Output::cutoff);
    if (!entry.shows_opacity) std::erase(out, ir::Output::opacity);
    return out;
}

}  // namespace sg::emit
