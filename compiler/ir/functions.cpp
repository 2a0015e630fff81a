#include "ir/functions.hpp"

#include <algorithm>
#include <type_traits>
#include <vector>

#include "ir/evaluate.hpp"
#include "ir/reference/analytic_derivatives.hpp"
#include "ir/reference/deriv.hpp"
#include "ir/reference/from_height.hpp"
#include "ir/reference/from_normal.hpp"
#include "ir/reference/from_volume.hpp"
#include "ir/reference/height_map.hpp"
#include "ir/reference/legacy.hpp"
#include "ir/reference/lighting.hpp"
#include "ir/reference/number.hpp"
#include "ir/reference/parallax.hpp"
#include "ir/reference/resolve.hpp"
#include "ir/reference/volume_space.hpp"

namespace sg::ir {
namespace {

using glm::dmat3;
using glm::dmat4;
using ref::dvec2;
using ref::dvec3;
using ref::dvec4;
using ref::Hand;
using ref::Origin;
using ref::Sampler;
using ref::TextureSource;
using ref::Uv;

template <class T>
constexpr std::string_view kName = "?";
template <>
constexpr std::string_view kName<double> = "float";
template <>
constexpr std::string_view kName<int> = "int";
template <>
constexpr std::string_view kName<unsigned> = "uint";
template <>
constexpr std::string_view kName<dvec2> = "vec2";
template <>
constexpr std::string_view kName<dvec3> = "vec3";
template <>
constexpr std::string_view kName<dvec4> = "vec4";
template <>
constexpr std::string_view kName<dmat3> = "mat3";
template <>
constexpr std::string_view kName<dmat4> = "mat4";
template <>
constexpr std::string_view kName<Hand> = "float";
template <>
constexpr std::string_view kName<Origin> = "float";
template <>
constexpr std::string_view kName<TextureSource> = "texture2D";
template <>
constexpr std::string_view kName<Sampler> = "sampler";
template <>
constexpr std::string_view kName<ref::Frame> = "SgFrame";
template <>
constexpr std::string_view kName<Uv> = "SgUv";
template <>
constexpr std::string_view kName<ref::Basis> = "SgBasis";
template <>
constexpr std::string_view kName<ref::Decal> = "SgDecal";
template <>
constexpr std::string_view kName<ref::DerivPair> = "SgDerivPair";
template <>
constexpr std::string_view kName<ref::Noise> = "SgNoise";
template <>
constexpr std::string_view kName<ref::Parallax> = "SgParallax";
template <>
constexpr std::string_view kName<ref::GgxSurface> = "SgGgxSurface";
template <>
constexpr std::string_view kName<ref::Lights> = "SgLights";
template <>
constexpr std::string_view kName<ref::Phong> = "SgPhong";
template <>
constexpr std::string_view kName<ref::PhongSurface> = "SgPhongSurface";
template <>
constexpr std::string_view kName<ref::ScreenDerivatives> = "SgScreenDerivatives";
template <>
constexpr std::string_view kName<ref::TangentVectors> = "SgTangentVectors";
template <>
constexpr std::string_view kName<ref::TriplanarUv> = "SgTriplanarUv";
template <>
constexpr std::string_view kName<Volume> = "SgVolume";

struct Row : LibraryFunction {
    template <class R, class... A>
    Row(std::string_view name, R (*function)(A...)) {
        glsl = name;
        ((signature += (signature.empty() ? "" : ", ") + std::string(kName<std::remove_cvref_t<A>>)), ...);
        signature = std::string(kName<std::remove_cvref_t<R>>) + "(" + signature + ")";
        pointer = function;
    }
    template <class Lambda>
    Row(std::string_view name, Lambda lambda) : Row(name, +lambda) {}
};
using Rows = std::vector<LibraryFunction>;

// (1 + s/ahead) / 2 and its change with the position, by the quotient rule.
ref::Decal decal_central(dvec3 local, dvec3 ray, dvec3 row_s, dvec3 row_t, dvec3 row_ahead, dvec3 dpdx,
                         dvec3 dpdy) {
    if (!(ray.z > 1e-6)) return {local, {dvec2(0.5), dvec2(0.0), dvec2(0.0)}, dvec3(0.0), dvec3(0.0)};
    auto half_quotient = [&](double part, dvec3 row) {
        return (row * ray.z - part * row_ahead) / (2.0 * ray.z * ray.z);
    };
    const dvec3 grad_s = half_quotient(ray.x, row_s), grad_t = half_quotient(ray.y, row_t);
    auto change = [&](dvec3 step) { return dvec2(glm::dot(grad_s, step), glm::dot(grad_t, step)); };
    const dvec2 st((ray.x + ray.z) / (2.0 * ray.z), (ray.y + ray.z) / (2.0 * ray.z));
    return {local, {st, change(dpdx), change(dpdy)}, grad_s, grad_t};
}

// Twice Perlin's grad(): u and v are two of the three parts, each with a sign, by the low four bits.
dvec4 perlin_corner(unsigned hash, dvec3 offset) {
    auto ramp = [h = hash % 16](dvec3 p) {
        const double u = h < 8 ? p.x : p.y;
        const double v = h < 4 ? p.y : (h == 12 || h == 14 ? p.x : p.z);
        return (h % 2 == 0 ? u : -u) + ((h / 2) % 2 == 0 ? v : -v);
    };
    return 2.0 * dvec4(ramp({1, 0, 0}), ramp({0, 1, 0}), ramp({0, 0, 1}), ramp(offset));
}

Rows surface_rows() {
    return {
        Row{"sg_facing_normal", ref::facing_normal},
        // From the matrix alone: neighbouring pixels meet the plane. Neither view nor clip w is needed.
        Row{"sg_analytic_derivatives", [](dvec3 p, dvec3 n, dvec3, dmat4 screen,
                                          double) { return ref::analytic_derivatives(p, n, screen); }},
        Row{"sg_frame_rebuilt", [](dvec3 p, dvec3 n, double facing, dvec3 view, dmat4 screen,
                                   dmat4) { return ref::frame_rebuilt(p, n, facing, view, screen); }},
        Row{"sg_reject", ref::reject},
        Row{"sg_frame", ref::frame},
        Row{"sg_frame_inverse_area", ref::frame_inverse_area},
        Row{"sg_frame_resolved", ref::frame_resolved},
        Row{"sg_base_normal", ref::base_normal},
        Row{"sg_mirror_normal", ref::mirror_normal},
        Row{"sg_resolve", ref::resolve},
        Row{"sg_resolve_vertex_map", ref::resolve_vertex_map},
        Row{"sg_resolve_volume", ref::resolve_volume},
        Row{"sg_resolve_towards", ref::resolve_towards},
        Row{"sg_flip", ref::flip},
        Row{"sg_invert", ref::invert},
        Row{"sg_basis_vertex", ref::basis_vertex},
        Row{"sg_basis_uv", ref::basis_uv},
        Row{"sg_basis_resolved", ref::basis_resolved},
        Row{"sg_basis_mirror", ref::basis_mirror},
        Row{"sg_surfgrad_from_tbn", ref::surfgrad_from_tbn},
        Row{"sg_surfgrad_from_normal", ref::surfgrad_from_normal},
        Row{"sg_normal_from_object", ref::normal_from_object},
        Row{"sg_surfgrad_from_volume", ref::surfgrad_from_volume},
        Row{"sg_surfgrad_from_screen_height", ref::surfgrad_from_screen_height},
        Row{"sg_screen_height_from_deriv", ref::screen_height_from_deriv},
        Row{"sg_surfgrad_from_height", ref::surfgrad_from_height},
        Row{"sg_screen_height_three_tap", ref::screen_height_three_tap},
    };
}

Rows texture_rows() {
    return {
        Row{"sg_decode_signed",
            [](dvec2 v, double zero) {
                return dvec2(ref::decode_signed(v.x, zero), ref::decode_signed(v.y, zero));
            }},
        Row{"sg_deriv_from_normal_xyz", ref::deriv_from_normal_xyz},
        Row{"sg_deriv_from_normal_xy", ref::deriv_from_normal_xy},
        Row{"sg_deriv_green_up", ref::deriv_green_up},
        Row{"sg_normal_from_deriv", ref::normal_from_deriv},
        Row{"sg_deriv_clamped", ref::deriv_clamped},
        Row{"sg_deriv_from_map", ref::deriv_from_map},
        Row{"sg_map_from_deriv", ref::map_from_deriv},
        Row{"sg_deriv_from_height_level", ref::deriv_from_height_level},
        Row{"sg_deriv_from_height", ref::deriv_from_height},
        Row{"sg_deriv_from_heights_4x4",
            [](dvec4 a, dvec4 b, dvec4 c, dvec4 d, dvec2 t) {
                return ref::deriv_from_heights_4x4({{{a.x, a.y, a.z, a.w},
                                                     {b.x, b.y, b.z, b.w},
                                                     {c.x, c.y, c.z, c.w},
                                                     {d.x, d.y, d.z, d.w}}},
                                                   t);
            }},
        Row{"sg_deriv_from_height_smooth", ref::deriv_from_height_smooth},
        Row{"sg_height_smooth_weight", ref::height_smooth_weight},
        Row{"sg_deriv_from_height_hq", ref::deriv_from_height_hq},
        Row{"sg_sample", [](const TextureSource& image, const Sampler& sampler,
                            const Uv& uv) { return ref::sample_grad(image, sampler, uv.st, uv.dx, uv.dy); }},
        Row{"sg_texture_size",
            [](const TextureSource& image, const Sampler&) { return dvec2(image.size(0)); }},
        Row{"sg_uv_scale", ref::uv_scale},
        Row{"sg_uv_transform", ref::uv_transform},
        Row{"sg_uv_level", ref::uv_level},
        Row{"sg_combine_add", ref::combine_add},
        Row{"sg_combine_scale", ref::combine_scale},
        Row{"sg_combine_mask", ref::combine_mask},
        Row{"sg_combine_mix", ref::combine_mix},
        Row{"sg_combine_pd", ref::combine_pd},
        Row{"sg_combine_whiteout", ref::combine_whiteout},
        Row{"sg_combine_udn", ref::combine_udn},
        Row{"sg_combine_rnm", ref::combine_rnm},
        Row{"sg_combine_reoriented", ref::combine_reoriented},
        Row{"sg_combine_weighted", ref::combine_weighted},
        Row{"sg_combine_additive", ref::combine_additive},
    };
}

Rows noise_rows() {
    return {
        Row{"sg_perlin_pair", [](unsigned word, unsigned i) { return i % 2 == 0 ? word : word / 256; }},
        Row{"sg_perlin_corner", perlin_corner},
        Row{"sg_noise_perlin", ref::noise_perlin},
        Row{"sg_octave_weight", ref::octave_weight},
        Row{"sg_noise_fractal_sum", ref::noise_fractal_sum},
        Row{"sg_noise_turbulence", ref::noise_turbulence},
        Row{"sg_noise_power", ref::noise_power},
        Row{"sg_volume_scale",
            [](Volume v, double f) {
                return Volume{v.p * f, v.dx * f, v.dy * f};
            }},
        Row{"sg_volume_perlin",
            [](Volume v) { return ref::noise_fractal_sum(v.p, ref::footprint(v.dx, v.dy), 1); }},
        Row{"sg_volume_fractal_sum",
            [](Volume v, int octaves) {
                return ref::noise_fractal_sum(v.p, ref::footprint(v.dx, v.dy), octaves);
            }},
        Row{"sg_volume_turbulence",
            [](Volume v, int octaves) {
                return ref::noise_turbulence(v.p, ref::footprint(v.dx, v.dy), octaves);
            }},
        Row{"sg_volume_triplanar_uv",
            [](Volume v, Hand hand, Origin origin) {
                return ref::triplanar_uv(v.p, v.dx, v.dy, hand, origin);
            }},
        Row{"sg_axis_x", [] { return dvec3(1, 0, 0); }},
        Row{"sg_axis_y", [] { return dvec3(0, 1, 0); }},
        Row{"sg_axis_z", [] { return dvec3(0, 0, 1); }},
        Row{"sg_gradient_to_world", ref::gradient_to_world},
        Row{"sg_footprint", ref::footprint},
        Row{"sg_triplanar_weights", ref::triplanar_weights},
        Row{"sg_triplanar_uv", ref::triplanar_uv},
        Row{"sg_triplanar_gradient", ref::triplanar_gradient},
        Row{"sg_planar_uv", ref::planar_uv},
        Row{"sg_planar_gradient", ref::planar_gradient},
        Row{"sg_divide", ref::divide},
        Row{"sg_power", ref::positive_power},
        Row{"sg_smoothstep", ref::smoothstep},
    };
}

Rows decal_rows() {
    return {
        Row{"sg_decal_row", [](dmat4 m, int row) { return dvec3(glm::transpose(m)[row]); }},
        Row{"sg_decal_from_gradients",
            [](dvec3 local, dvec2 st, dvec3 s, dvec3 t, dvec3 dpdx, dvec3 dpdy) {
                const glm::dmat2x3 gradients(s, t);
                return ref::Decal{local, {st, dpdx * gradients, dpdy * gradients}, s, t};
            }},
        Row{"sg_decal_box", ref::decal_box},
        Row{"sg_decal_central", decal_central},
        Row{"sg_decal_cone", ref::decal_cone},
        Row{"sg_decal_sphere", ref::decal_sphere},
        Row{"sg_decal_fade", ref::decal_fade},
        Row{"sg_decal_falloff_box", ref::decal_falloff_box},
        Row{"sg_decal_falloff_cone", ref::decal_falloff_cone},
        Row{"sg_decal_falloff_sphere", ref::decal_falloff_sphere},
        Row{"sg_decal_falloff_capsule", ref::decal_falloff_capsule},
        Row{"sg_decal_falloff_wedge", ref::decal_falloff_wedge},
        Row{"sg_decal_angle_fade", ref::decal_angle_fade},
        Row{"sg_decal_gradient_scaled", ref::decal_gradient_scaled},
        Row{"sg_decal_gradient", ref::decal_gradient},
        Row{"sg_decal_gradient_along", ref::decal_gradient_along},
        Row{"sg_decal_add", ref::decal_add},
        Row{"sg_decal_mask", ref::decal_mask},
    };
}

Rows parallax_and_legacy_rows() {
    return {
        Row{"sg_parallax_direction", ref::parallax_direction},
        Row{"sg_parallax_offset", ref::parallax_offset},
        Row{"sg_parallax_scale", ref::parallax_scale},
        Row{"sg_parallax_steps", ref::parallax_steps},
        Row{"sg_parallax_height", ref::parallax_height},
        Row{"sg_parallax_occlusion",
            [](const TextureSource& map, const Sampler& sampler, dvec2 heights, dvec2 st, dvec3 view,
               double level,
               int steps) { return ref::parallax_march(map, sampler, heights, st, view, level, steps).hit; }},
        Row{"sg_parallax_pixels", ref::parallax_pixels},
        Row{"sg_parallax_position", ref::parallax_position},
        Row{"sg_parallax_normal", ref::parallax_normal},
        Row{"sg_parallax_uv", ref::parallax_uv},
        Row{"sg_parallax_detail_uv", ref::parallax_detail_uv},
        Row{"sg_legacy_perlin_normal", ref::legacy_perlin_normal},
        Row{"sg_legacy_triplanar_normal", ref::legacy_triplanar_normal},
        Row{"sg_legacy_decal_normal", ref::legacy_decal_normal},
        Row{"sg_legacy_tbn", ref::legacy_tbn},
        Row{"sg_legacy_tangent_vectors", ref::legacy_tangent_vectors},
        Row{"sg_legacy_object_normal", ref::legacy_object_normal},
        Row{"sg_legacy_phong", ref::legacy_phong},
    };
}

Rows lighting_rows() {
    return {
        Row{"sg_sin2_between", ref::sin2_between},
        Row{"sg_ggx_distribution", ref::ggx_distribution},
        Row{"sg_ggx_visibility", ref::ggx_visibility},
        Row{"sg_fresnel", ref::fresnel},
        Row{"sg_ggx", ref::ggx},
        Row{"sg_ggx_radiance", ref::ggx_radiance},
        Row{"sg_phong_radiance", ref::phong_radiance},
    };
}

}  // namespace

std::span<const LibraryFunction> library_functions() {
    static const Rows all = [] {
        Rows rows;
        for (const Rows& part : {surface_rows(), texture_rows(), noise_rows(), decal_rows(),
                                 parallax_and_legacy_rows(), lighting_rows()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return all;
}

const LibraryFunction* library_function(std::string_view glsl) {
    const auto all = library_functions();
    auto found =
        std::find_if(all.begin(), all.end(), [&](const LibraryFunction& row) { return row.glsl == glsl; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace sg::ir
