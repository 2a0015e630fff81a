// The analytic cases can fail: each wrong line of the shader library breaks the bound of at least one of
// them.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "tests/render/truth.hpp"

namespace sg::truth {
namespace {

struct Mutant {
    std::string name;
    std::string file;  // of the shader library
    std::string text;  // must stand there exactly once, so that this table cannot rot
    std::string wrong;
    std::string case_name;  // whose bound it breaks
};
std::ostream& operator<<(std::ostream& out, const Mutant& m) {
    return out << m.name;
}

const std::vector<Mutant> kMutants = {
    {"bitangent_of_uv_basis_towards_minus_t", "surfgrad/tbn.glsl",
     "det < 0.0 ? -frame.flip_sign : frame.flip_sign", "det < 0.0 ? frame.flip_sign : -frame.flip_sign",
     "plane_uv_xyz_down_float"},
    {"flip_sign_is_forgotten", "surfgrad/tbn.glsl", "det < 0.0 ? -frame.flip_sign : frame.flip_sign",
     "det < 0.0 ? -1.0 : 1.0", "sphere_uv"},
    {"flip_sign_is_that_of_front_faces", "surfgrad/tbn.glsl",
     "det < 0.0 ? -frame.flip_sign : frame.flip_sign", "det < 0.0 ? 1.0 : -1.0", "sphere_uv_inside_flip"},
    {"mirrored_uvs_are_ignored", "surfgrad/tbn.glsl", "float det = uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x;",
     "float det = abs(uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x);", "torus_uv_mirrored"},
    {"w_has_the_other_sign", "surfgrad/resolve.glsl", "vertex_tangent.w < 0.0 ? -lean.y : lean.y",
     "vertex_tangent.w < 0.0 ? lean.y : -lean.y", "plane_vertex_xyz_up"},
    {"w_is_ignored", "surfgrad/resolve.glsl", "vertex_tangent.w < 0.0 ? -lean.y : lean.y", "-lean.y",
     "sphere_vertex_mirrored"},
    {"vertex_frame_not_scaled_by_the_normals_length", "surfgrad/resolve.glsl",
     "vec3 n = facing * vertex_normal;", "vec3 n = facing * normalize(vertex_normal);",
     "cylinder_coarse_vertex"},
    {"bitangent_a_tenth_too_long", "surfgrad/resolve.glsl", "cross(vertex_normal, ",
     "1.1 * cross(vertex_normal, ", "torus_vertex"},
    {"map_leans_the_other_way", "surfgrad/resolve.glsl", "strength * m.xy;", "-strength * m.xy;",
     "sphere_vertex_down"},
    {"map_is_swapped", "surfgrad/resolve.glsl", "strength * m.xy;", "strength * m.yx;",
     "plane_vertex_xyz_up"},
    {"derivative_is_swapped", "surfgrad/tbn.glsl", "d.x * basis.tangent + d.y * basis.bitangent",
     "d.y * basis.tangent + d.x * basis.bitangent", "sphere_uv"},
    {"negative_tiling_keeps_the_tangent", "surfgrad/tbn.glsl", "scale.x < 0.0 ? -basis.tangent",
     "scale.x < 0.0 ? basis.tangent", "torus_vertex_tiling_negative"},
    {"negative_tiling_keeps_the_bitangent", "surfgrad/tbn.glsl", "scale.y < 0.0 ? -basis.bitangent",
     "scale.y < 0.0 ? basis.bitangent", "plane_vertex_tiling_negative"},
    {"green_is_not_flipped", "surfgrad/deriv.glsl", "return vec2(d.x, -d.y);", "return d;",
     "plane_uv_xyz_up_zero127"},
    {"red_is_flipped_for_green", "surfgrad/deriv.glsl", "return vec2(d.x, -d.y);", "return vec2(-d.x, d.y);",
     "plane_uv_xyz_up_zero127"},
    {"slope_of_xyz_has_the_other_sign", "surfgrad/deriv.glsl", "return -m.xy / z", "return m.xy / z",
     "sphere_uv"},
    {"slope_of_xyz_not_divided_by_z", "surfgrad/deriv.glsl", "return -m.xy / z", "return -m.xy", "sphere_uv"},
    {"slope_of_xy_has_the_other_sign", "surfgrad/deriv.glsl", "return -m * inversesqrt(",
     "return m * inversesqrt(", "plane_uv_xy_up_zero128"},
    {"zero_is_always_127_and_a_half", "surfgrad/deriv.glsl",
     "vec3 sg_decode_signed(vec3 texel, float zero) {\n    return",
     "vec3 sg_decode_signed(vec3 texel, float zero) {\n    zero = 127.5;\n    return",
     "plane_uv_xyz_up_zero127"},
    {"reach_is_always_127_and_a_half", "surfgrad/deriv.glsl",
     "vec2 sg_decode_signed(vec2 texel, float zero) {\n    return zero == 127.5 ? 2.0 * texel - 1.0 : "
     "clamp((255.0 * texel - zero) / min(zero, 255.0 - zero)",
     "vec2 sg_decode_signed(vec2 texel, float zero) {\n    return clamp((255.0 * texel - zero) / 127.5",
     "plane_vertex_xy_down_zero127"},
    {"resolve_adds", "surfgrad/resolve.glsl", "n - g;", "n + g;", "torus_two_uv_sets"},
    {"flip_does_nothing", "surfgrad/resolve.glsl", "return facing * resolved;", "return resolved;",
     "plane_vertex_behind_flip"},
    {"mirror_does_nothing", "surfgrad/frame.glsl", "return facing * n;", "return n;",
     "plane_uv_behind_mirror"},
    {"step_along_s_is_not_projected", "surfgrad/tbn.glsl", "step_s - lean * frame.normal", "step_s",
     "cylinder_coarse_uv"},
    {"vertex_normal_points_inward", "stage/vertex.glsl", "normal_from_object) * normal",
     "normal_from_object) * -normal", "plane_vertex_xyz_up"},
    {"normal_goes_through_the_matrix_of_positions", "stage/vertex.glsl",
     "mat3(sg_object_block.normal_from_object) * normal",
     "mat3(sg_object_block.relative_from_object) * normal", "sphere_vertex_squashed"},
    {"mirrored_instance_keeps_w", "stage/vertex.glsl", "tangent.w * sg_object_block.normal_from_object[3][3]",
     "tangent.w", "torus_vertex_mirrored_instance"},
    {"tangent_stays_in_object_space", "stage/vertex.glsl",
     "sg_stage_unit(mat3(sg_object_block.relative_from_object) * tangent.xyz)", "sg_stage_unit(tangent.xyz)",
     "sphere_vertex_turned"},
    {"uv_derivatives_are_swapped", "stage/fragment.glsl", "dFdxFine(st), dFdyFine(st)",
     "dFdyFine(st), dFdxFine(st)", "plane_uv_mirrored"},
    {"facing_is_turned", "stage/fragment.glsl", "gl_FrontFacing ? 1.0 : -1.0", "gl_FrontFacing ? -1.0 : 1.0",
     "sphere_vertex_inside_mirror"},
};

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

class MutantShader : public testing::TestWithParam<Mutant> {};

TEST_P(MutantShader, BreaksItsCase) {
    const Mutant& mutant = GetParam();
    target::ShaderLibrary library = target::embedded_library();
    ASSERT_TRUE(library.files.contains(mutant.file));
    std::string& text = library.files[mutant.file];
    ASSERT_EQ(occurrences(text, mutant.text), 1u) << "the library changed: '" << mutant.text << "'";
    text.replace(text.find(mutant.text), mutant.text.size(), mutant.wrong);
    const Outcome o = run_case(case_named(mutant.case_name), library);
    fmt::print("{:48} breaks {:44} median {:.4f} of {:.4f}, p99 {:.4f} of {:.4f}\n", mutant.name,
               mutant.case_name, o.error.median, o.bound.median(), o.error.p99, o.bound.p99());
    EXPECT_GT(o.error.count, 500u);
    EXPECT_FALSE(o.holds());
}

INSTANTIATE_TEST_SUITE_P(Library, MutantShader, testing::ValuesIn(kMutants),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace sg::truth
