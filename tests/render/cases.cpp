#include "tests/render/cases.hpp"

#include <stdexcept>

namespace sg::truth {
namespace {

// No symmetry in either coordinate: a flipped or swapped component gives a wrong slope nearly everywhere.
// Amplitudes for a chart of length 2 on each side; slopes stay near 0.4.
const std::array<std::vector<Wave>, 2> kHeights = {{{{0.045, 1, 1, 0.4}, {0.02, 2, -1, 1.1}, {0.012, 1, -3, 2.3}},
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
    return {
        {"plane_uv_xyz_down_float", plane, {{.green_up = false, .float_texels = true}}},
        {"plane_vertex_xyz_up", plane, {vertex}},
        {"plane_uv_xy_up_zero128", plane, {{.two_channels = true, .zero = 128}}},
        {"plane_vertex_xy_down_zero127", plane, {{.from_vertex = true, .two_channels = true, .green_up = false, .zero = 127}}},
        {"plane_uv_xyz_up_zero127", plane, {{.zero = 127}}},
        {"plane_uv_mirrored", plane, {uv}, Unwrap::mirrored},
        {"plane_vertex_mirrored", plane, {vertex}, Unwrap::mirrored},
        {"plane_uv_tiling3", plane, {{.tiling = {3, 3}}}},
        {"plane_uv_tiling_negative", plane, {{.tiling = {-2, 2}}}},
        {"plane_vertex_tiling_negative", plane, {{.from_vertex = true, .tiling = {2, -2}}}},
        {"plane_uv_strength", plane, {{.strength = 1.7}}},
        {"plane_vertex_strength_negative", plane, {{.from_vertex = true, .strength = -0.6}}},
        {"plane_uv_orthographic", plane, {uv}, Unwrap::straight, Eye::front, true},
        {"plane_uv_behind_mirror", plane, {uv}, Unwrap::straight, Eye::behind, false, Placement::none, Side::mirror},
        {"plane_vertex_behind_flip", plane, {vertex}, Unwrap::straight, Eye::behind, false, Placement::none, Side::flip},
        {"plane_vertex_mirrored_instance_behind_mirror", plane, {vertex}, Unwrap::straight, Eye::behind, false, Placement::mirrored, Side::mirror},
        {"plane_uv_mips", plane, {{.float_texels = true}}, Unwrap::straight, Eye::facing, true, Placement::none, Side::front, false, 2},
        {"plane_vertex_folded_tangents_made", plane, {vertex}, Unwrap::folded, Eye::front, false, Placement::none, Side::front, true},
        {"plane_uv_folded", plane, {uv}, Unwrap::folded},
        {"plane_two_uv_sets", plane, {vertex, {.uv = 1, .height = 1, .strength = 0.8}}},
    };
}

std::vector<Case> curved_cases() {
    const Shape sphere = Shape::sphere, torus = Shape::torus, cylinder = Shape::cylinder;
    const Layer uv{}, vertex{.from_vertex = true};
    return {
        {"sphere_uv", sphere, {uv}},
        {"sphere_vertex_down", sphere, {{.from_vertex = true, .green_up = false}}},
        {"sphere_vertex_mirrored", sphere, {vertex}, Unwrap::mirrored},
        {"sphere_vertex_mirrored_tangents_made", sphere, {vertex}, Unwrap::mirrored, Eye::front, false, Placement::none, Side::front, true},
        {"torus_vertex_turned_tangents_made", torus, {vertex}, Unwrap::straight, Eye::front, false, Placement::turned, Side::front, true},
        {"sphere_vertex_squashed", sphere, {vertex}, Unwrap::straight, Eye::front, false, Placement::squashed},
        {"torus_uv_squashed", torus, {uv}, Unwrap::straight, Eye::front, false, Placement::squashed},
        {"sphere_uv_second_set", sphere, {{.uv = 1, .height = 1}}},
        {"sphere_vertex_turned", sphere, {vertex}, Unwrap::straight, Eye::front, false, Placement::turned},
        {"sphere_uv_inside_flip", sphere, {uv}, Unwrap::straight, Eye::inside, false, Placement::none, Side::flip},
        {"sphere_vertex_inside_mirror", sphere, {vertex}, Unwrap::straight, Eye::inside, false, Placement::none, Side::mirror},
        {"sphere_uv_far", sphere, {uv}, Unwrap::straight, Eye::far},
        {"torus_vertex", torus, {vertex}},
        {"torus_uv_mirrored", torus, {uv}, Unwrap::mirrored},
        {"torus_two_uv_sets", torus, {vertex, {.uv = 1, .height = 1, .strength = 0.8, .two_channels = true}}},
        {"torus_vertex_mirrored_instance", torus, {vertex}, Unwrap::straight, Eye::front, false, Placement::mirrored},
        {"torus_uv_mirrored_instance", torus, {uv}, Unwrap::straight, Eye::front, false, Placement::mirrored},
        {"torus_uv_turned_orthographic", torus, {uv}, Unwrap::straight, Eye::front, true, Placement::turned},
        {"torus_vertex_tiling_negative", torus, {{.from_vertex = true, .tiling = {-1, 1}}}},
        {"cylinder_coarse_vertex", cylinder, {vertex}},
        {"cylinder_coarse_uv", cylinder, {uv}},
    };
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
    Bump bump{{kHeights[static_cast<std::size_t>(layer.height)], -1}, {layer.uv, c.unwrap}, layer.tiling, layer.strength};
    for (Wave& wave : bump.height.waves) wave.amplitude *= amplitude(c.shape);
    if (c.shape == Shape::sphere) bump.height.taper_axis = layer.uv == 1 ? 0 : 1;
    return bump;
}

}  // namespace sg::truth
