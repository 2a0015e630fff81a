#include "tests/render/cases.hpp"

#include <stdexcept>

namespace sg::truth {
namespace {

// No symmetry in either coordinate: a flipped or swapped component gives a wrong slope nearly everywhere.
// Amplitudes for a chart of length 2 on each side; slopes stay near 0.4.
const std::array<std::vector<Wave>, 2> kHeights = {
    {{{0.045, 1, 1, 0.4}, {0.02, 2, -1, 1.1}, {0.012, 1, -3, 2.3}},
     {{0.03, -1, 2, 0.9}, {0.015, 3, 1, 2.0}}}};

double amplitude(Shape shape) {
    switch (shape) {
        case Shape::plane:
            return 1;
        case Shape::sphere:
            return 2;
        case Shape::torus:
            return 1.4;
        case Shape::cylinder:
            return 1.2;
    }
    return 1;
}

std::vector<Case> plane_cases() {
    const Shape plane = Shape::plane;
    const Layer uv{}, vertex{.from_vertex = true};
    // clang-format off
    return {
        {.name = "plane_uv_xyz_down_float", .shape = plane, .layers = {{.green_up = false,
         .float_texels = true}}},
        {.name = "plane_vertex_xyz_up", .shape = plane, .layers = {vertex}},
        {.name = "plane_uv_xy_up_zero128", .shape = plane, .layers = {{.two_channels = true, .zero = 128}}},
        {.name = "plane_vertex_xy_down_zero127", .shape = plane, .layers = {{.from_vertex = true,
         .two_channels = true, .green_up = false, .zero = 127}}},
        {.name = "plane_uv_xyz_up_zero127", .shape = plane, .layers = {{.zero = 127}}},
        {.name = "plane_uv_mirrored", .shape = plane, .layers = {uv}, .unwrap = Unwrap::mirrored},
        {.name = "plane_vertex_mirrored", .shape = plane, .layers = {vertex}, .unwrap = Unwrap::mirrored},
        {.name = "plane_uv_tiling3", .shape = plane, .layers = {{.tiling = {3, 3}}}},
        {.name = "plane_uv_tiling_negative", .shape = plane, .layers = {{.tiling = {-2, 2}}}},
        {.name = "plane_vertex_tiling_negative", .shape = plane, .layers = {{.from_vertex = true,
         .tiling = {2, -2}}}},
        {.name = "plane_uv_strength", .shape = plane, .layers = {{.strength = 1.7}}},
        {.name = "plane_vertex_strength_negative", .shape = plane, .layers = {{.from_vertex = true,
         .strength = -0.6}}},
        {.name = "plane_uv_orthographic", .shape = plane, .layers = {uv}, .orthographic = true},
        {.name = "plane_uv_behind_mirror", .shape = plane, .layers = {uv}, .eye = Eye::behind,
         .two_sided = Side::mirror},
        {.name = "plane_vertex_behind_flip", .shape = plane, .layers = {vertex}, .eye = Eye::behind,
         .two_sided = Side::flip},
        {.name = "plane_vertex_mirrored_instance_behind_mirror", .shape = plane, .layers = {vertex},
         .eye = Eye::behind, .placement = Placement::mirrored, .two_sided = Side::mirror},
        {.name = "plane_uv_mips", .shape = plane, .layers = {{.float_texels = true}}, .eye = Eye::facing,
         .orthographic = true, .mip_level = 2},
        {.name = "plane_vertex_folded_tangents_made", .shape = plane, .layers = {vertex},
         .unwrap = Unwrap::folded, .tangents_made = true},
        {.name = "plane_uv_folded", .shape = plane, .layers = {uv}, .unwrap = Unwrap::folded},
        {.name = "plane_two_uv_sets", .shape = plane, .layers = {vertex, {.uv = 1, .height = 1,
         .strength = 0.8}}},
    };
    // clang-format on
}

std::vector<Case> curved_cases() {
    const Shape sphere = Shape::sphere, torus = Shape::torus, cylinder = Shape::cylinder;
    const Layer uv{}, vertex{.from_vertex = true};
    // clang-format off
    return {
        {.name = "sphere_uv", .shape = sphere, .layers = {uv}},
        {.name = "sphere_vertex_down", .shape = sphere, .layers = {{.from_vertex = true, .green_up = false}}},
        {.name = "sphere_vertex_mirrored", .shape = sphere, .layers = {vertex}, .unwrap = Unwrap::mirrored},
        {.name = "sphere_vertex_mirrored_tangents_made", .shape = sphere, .layers = {vertex},
         .unwrap = Unwrap::mirrored, .tangents_made = true},
        {.name = "torus_vertex_turned_tangents_made", .shape = torus, .layers = {vertex},
         .placement = Placement::turned, .tangents_made = true},
        {.name = "sphere_vertex_squashed", .shape = sphere, .layers = {vertex},
         .placement = Placement::squashed},
        {.name = "torus_uv_squashed", .shape = torus, .layers = {uv}, .placement = Placement::squashed},
        {.name = "sphere_uv_second_set", .shape = sphere, .layers = {{.uv = 1, .height = 1}}},
        {.name = "sphere_vertex_turned", .shape = sphere, .layers = {vertex}, .placement = Placement::turned},
        {.name = "sphere_uv_inside_flip", .shape = sphere, .layers = {uv}, .eye = Eye::inside,
         .two_sided = Side::flip},
        {.name = "sphere_vertex_inside_mirror", .shape = sphere, .layers = {vertex}, .eye = Eye::inside,
         .two_sided = Side::mirror},
        {.name = "sphere_uv_far", .shape = sphere, .layers = {uv}, .eye = Eye::far},
        {.name = "torus_vertex", .shape = torus, .layers = {vertex}},
        {.name = "torus_uv_mirrored", .shape = torus, .layers = {uv}, .unwrap = Unwrap::mirrored},
        {.name = "torus_two_uv_sets", .shape = torus, .layers = {vertex, {.uv = 1, .height = 1,
         .strength = 0.8, .two_channels = true}}},
        {.name = "torus_vertex_mirrored_instance", .shape = torus, .layers = {vertex},
         .placement = Placement::mirrored},
        {.name = "torus_uv_mirrored_instance", .shape = torus, .layers = {uv},
         .placement = Placement::mirrored},
        {.name = "torus_uv_turned_orthographic", .shape = torus, .layers = {uv}, .orthographic = true,
         .placement = Placement::turned},
        {.name = "torus_vertex_tiling_negative", .shape = torus, .layers = {{.from_vertex = true,
         .tiling = {-1, 1}}}},
        {.name = "cylinder_coarse_vertex", .shape = cylinder, .layers = {vertex}},
        {.name = "cylinder_coarse_uv", .shape = cylinder, .layers = {uv}},
    };
    // clang-format on
}

}  // namespace

const std::vector<Case>& all_cases() {
    static const std::vector<Case> kCases = [] {
        std::vector<Case> out = plane_cases();
        for (Case& c : curved_cases()) out.push_back(std::move(c));
        return out;
    }();
    return kCases;
}

const Case& case_named(const std::string& name) {
    for (const Case& c : all_cases()) {
        if (c.name == name) return c;
    }
    throw std::runtime_error("no case '" + name + "'");
}

Bump bump_of(const Case& c, const Layer& layer) {
    Bump bump{{kHeights[static_cast<std::size_t>(layer.height)], -1},
              {layer.uv, c.unwrap},
              layer.tiling,
              layer.strength};
    for (Wave& wave : bump.height.waves) wave.amplitude *= amplitude(c.shape);
    if (c.shape == Shape::sphere) bump.height.taper_axis = layer.uv == 1 ? 0 : 1;
    return bump;
}

}  // namespace sg::truth
