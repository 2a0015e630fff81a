#include "emit/glsl.hpp"

namespace sg::emit {

std::span<const EntryPoint> all_entry_points() {
    using enum ir::Output;
    static const EntryPoint kRows[] = {
        {"forward",
         "the lit picture: linear radiance",
         "color",
         {normal, base_color, metallic, roughness, occlusion, emission, opacity, cutoff},
         {"stage/forward.glsl"},
         true},
        {"normal", "the resolved unit normal, world axes", "normal", {normal, opacity, cutoff}, {}, false},
        {"debug",
         "one of the values inside the shader, chosen by a uniform",
         "value",
         {frame, normal, gradient, basis_vertex, vertex_color, uv, volume, opacity, cutoff},
         {"stage/debug.glsl"},
         true},
    };
    return kRows;
}

const EntryPoint* find_entry_point(std::string_view name) {
    for (const EntryPoint& entry : all_entry_points()) {
        if (entry.name == name) return &entry;
    }
    return nullptr;
}

}  // namespace sg::emit
