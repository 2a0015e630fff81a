// Operation -> function in double precision: ONE table, one row per operation of ops.def.
//
// To add a row: {Op::name, function}. The function is one of sg::ref, or a lambda without captures around it;
// operands are unpacked by its parameter types. If its first parameter is `const Call&` it also sees the
// pixel's inputs, the attribute (c.texture(), c.zero(), c.value.index, c.value.number) and the bindings. A
// new struct type becomes one more alternative of Datum, one name of kDatumGlsl and one line of components().
// tests/oracle walks ops.def and fails naming an operation without a row, or one whose widths differ from
// types.def.
#include "ir/evaluate_ops.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

#include "base/ice.hpp"
#include "ir/reference/analytic_derivatives.hpp"
#include "ir/reference/combine.hpp"
#include "ir/reference/deriv.hpp"
#include "ir/reference/from_height.hpp"
#include "ir/reference/from_normal.hpp"
#include "ir/reference/from_volume.hpp"
#include "ir/reference/height_map.hpp"
#include "ir/reference/number.hpp"
#include "ir/reference/resolve.hpp"
#include "ir/reference/volume_space.hpp"

namespace sg::ir {
namespace {

using ref::Basis;
using ref::dvec2;
using ref::dvec3;
using ref::dvec4;
using ref::Frame;
using ref::Uv;

// The GLSL name of an alternative of Datum.
template <class T, std::size_t I = 0>
constexpr std::string_view glsl_of() {
    if constexpr (std::is_same_v<T, Datum>) {
        return "Datum";
    } else if constexpr (std::is_same_v<T, std::variant_alternative_t<I, Datum>>) {
        return kDatumGlsl[I];
    } else {
        return glsl_of<T, I + 1>();
    }
}

template <class T>
const std::remove_cvref_t<T>& operand(const Call& call, std::size_t index) {
    return std::get<std::remove_cvref_t<T>>(call.before[call.value.operands[index].index]);
}

template <class Result, class... Operands, class Invoke, std::size_t... I>
EvaluateRow make_row(Op op, Invoke invoke, std::index_sequence<I...>) {
    return {op,
            {glsl_of<std::remove_cvref_t<Operands>>()...},
            glsl_of<Result>(),
            [invoke](const Call& call) -> Datum { return invoke(call, operand<Operands>(call, I)...); }};
}

struct Row : EvaluateRow {
    template <class R, class... A>
    Row(Op row_op, R (*function)(A...))
        : EvaluateRow(make_row<R, A...>(
              row_op, [function](const Call&, const auto&... args) { return function(args...); },
              std::index_sequence_for<A...>{})) {}
    template <class R, class... A>
    Row(Op row_op, R (*function)(const Call&, A...))
        : EvaluateRow(make_row<R, A...>(row_op, function, std::index_sequence_for<A...>{})) {}
    template <class Lambda>
    Row(Op row_op, Lambda lambda) : Row(row_op, +lambda) {}
};

dvec3 decode_xyz(const Call& c, dvec4 t) {
    return {ref::decode_signed(t.x, c.zero()), ref::decode_signed(t.y, c.zero()),
            ref::decode_signed(t.z, c.zero())};
}

// Attribute Corner: hand and origin of a triplanar lookup. Attribute Count.
ref::Hand hand(const Call& c) {
    return c.value.index < 2 ? ref::Hand::right : ref::Hand::left;
}
ref::Origin origin(const Call& c) {
    return c.value.index % 2 == 0 ? ref::Origin::upper_left : ref::Origin::lower_left;
}
int count(const Call& c) {
    return static_cast<int>(c.value.index);
}

ref::Sampler sampler(const Call& c) {
    auto wrap = [](Sampled::Wrap w) {
        if (w == Sampled::Wrap::mirror) return ref::Wrap::mirror;
        return w == Sampled::Wrap::clamp ? ref::Wrap::clamp : ref::Wrap::repeat;
    };
    return {wrap(c.texture().wrap_s), wrap(c.texture().wrap_t)};
}

using Rows = std::vector<EvaluateRow>;

// What the vertex stage hands over
Rows inputs_rows() {
    return {
        Row{Op::position, [](const Call& c) { return c.pixel.position; }},
        Row{Op::vertex_normal, [](const Call& c) { return c.pixel.vertex_normal; }},
        Row{Op::vertex_tangent, [](const Call& c) { return c.pixel.vertex_tangent; }},
        Row{Op::uv_set, [](const Call& c) { return c.pixel.uvs[c.value.index]; }},
        Row{Op::volume_object, [](const Call& c) { return c.pixel.object; }},
        Row{Op::volume_world, [](const Call& c) { return c.pixel.world; }},
        Row{Op::vertex_color, [](const Call& c) { return c.pixel.vertex_color; }},
        Row{Op::time, [](const Call& c) { return c.pixel.time; }},
        Row{Op::facing, [](const Call& c) { return c.pixel.facing; }},
        // numbers
        Row{Op::constant, [](const Call& c) { return datum_of(c.value.type, c.value.number); }},
        Row{Op::parameter, [](const Call& c) { return c.bindings.parameters[c.value.index]; }},
        Row{Op::derived, [](const Call& c) { return c.derived[c.value.index]; }},
        Row{Op::splat, [](double x) { return dvec2(x, x); }},
        Row{Op::color, [](dvec3 rgb) { return rgb; }},
    };
}

// Numbers and colours of the graph
Rows graph_rows() {
    return {
        Row{Op::pair, [](double x, double y) { return dvec2(x, y); }},
        Row{Op::drift, [](dvec2 start, dvec2 speed, double t) { return start + t * speed; }},
        Row{Op::travel, [](double t, dvec2 speed) { return t * speed; }},
        Row{Op::swizzle,
            [](const Call& c, dvec4 texel) {
                const auto from = swizzle_channels(c.value.index);
                dvec4 out(0.0);
                for (int i = 0; i < 4; ++i)
                    out[i] = texel[static_cast<int>(from[static_cast<std::size_t>(i)])];
                return out;
            }},
        Row{Op::channel, [](const Call& c, dvec4 texel) { return texel[static_cast<int>(c.value.index)]; }},
        Row{Op::channel_of,
            [](const Call& c, dvec4 color) { return color[static_cast<int>(c.value.index)]; }},
        Row{Op::rgb, [](dvec4 texel) { return dvec3(texel); }},
        Row{Op::rgb_of, [](dvec4 color) { return dvec3(color); }},
        Row{Op::grey, [](double x) { return dvec3(x); }},
        Row{Op::add, [](double a, double b) { return a + b; }},
        Row{Op::subtract, [](double a, double b) { return a - b; }},
        Row{Op::multiply, [](double a, double b) { return a * b; }},
        Row{Op::divide, ref::divide},
        Row{Op::minimum, [](double a, double b) { return b < a ? b : a; }},
        Row{Op::maximum, [](double a, double b) { return a < b ? b : a; }},
        Row{Op::mix, [](double a, double b, double t) { return a + t * (b - a); }},
        Row{Op::clamp, [](double x, double low, double high) { return std::min(std::max(x, low), high); }},
        Row{Op::smoothstep, ref::smoothstep},
        Row{Op::power, ref::positive_power},
        Row{Op::add_color, [](dvec3 a, dvec3 b) { return a + b; }},
        Row{Op::multiply_color, [](dvec3 a, dvec3 b) { return a * b; }},
        Row{Op::mix_color, [](dvec3 a, dvec3 b, double t) { return a + t * (b - a); }},
        Row{Op::slope, [](dvec3 n, dvec3 up) { return n.x * up.x + n.y * up.y + n.z * up.z; }},
        Row{Op::height, [](const Volume& v) { return v.p.y; }},
        Row{Op::view_distance, [](dvec3 p) { return std::hypot(p.x, p.y, p.z); }},
        Row{Op::noise_value, [](const ref::Noise& n) { return n.value; }},
    };
}

// Frame
Rows frames_rows() {
    return {
        Row{Op::frame_resolved, ref::frame_resolved},
        Row{Op::object_normal,
            [](const Call& c, dvec3 n) {
                return glm::normalize(glm::transpose(c.pixel.world_from_object) * n);
            }},
        Row{Op::basis_resolved, ref::basis_resolved},
        Row{Op::base_normal, ref::base_normal},
        Row{Op::mirror_normal, ref::mirror_normal},
        Row{Op::frame,
            [](const Call& c, dvec3 p, dvec3 n) { return ref::frame(p, c.pixel.dpdx, c.pixel.dpdy, n); }},
        Row{Op::basis_vertex, ref::basis_vertex},
        Row{Op::basis_uv, ref::basis_uv},
        Row{Op::basis_mirror, ref::basis_mirror},
    };
}

// Coordinates and textures
Rows lookups_rows() {
    return {
        Row{Op::uv_scale, ref::uv_scale},
        Row{Op::uv_transform, ref::uv_transform},
        Row{Op::volume_scale,
            [](const Volume& v, double f) {
                return Volume{f * v.p, f * v.dx, f * v.dy};
            }},
        Row{Op::triplanar_uv,
            [](const Call& c, const Volume& v) {
                return ref::triplanar_uv(v.p, v.dx, v.dy, hand(c), origin(c));
            }},
        Row{Op::triplanar_axis,
            [](const Call& c, const ref::TriplanarUv& uv) {
                return c.value.index == 0 ? uv.x : c.value.index == 1 ? uv.y : uv.z;
            }},
        Row{Op::triplanar_weights, ref::triplanar_weights},
        Row{Op::planar_weights,
            [](const Call& c) {
                dvec3 w(0.0);
                w[static_cast<int>(c.value.index)] = 1.0;
                return w;
            }},
        Row{Op::sample, [](const Call& c, const Uv& uv) { return c.texture().at(uv); }},
        Row{Op::decode_normal_xyz, decode_xyz},
        Row{Op::decode_normal_xy,
            [](const Call& c, dvec4 t) {
                return dvec2(ref::decode_signed(t.x, c.zero()), ref::decode_signed(t.y, c.zero()));
            }},
        Row{Op::decode_object_normal, decode_xyz},
        Row{Op::decode_world_normal, decode_xyz},
        Row{Op::direction_of, [](const Call&, dvec3 n) { return n; }},
        Row{Op::normal_from_object,
            [](const Call& c, dvec3 v) { return ref::normal_from_object(c.pixel.normal_from_object, v); }},
        Row{Op::noise_perlin,
            [](const Volume& v) { return ref::noise_fractal_sum(v.p, ref::footprint(v.dx, v.dy), 1); }},
        Row{Op::noise_fractal_sum,
            [](const Call& c, const Volume& v) {
                return ref::noise_fractal_sum(v.p, ref::footprint(v.dx, v.dy), count(c));
            }},
        Row{Op::noise_turbulence,
            [](const Call& c, const Volume& v) {
                return ref::noise_turbulence(v.p, ref::footprint(v.dx, v.dy), count(c));
            }},
        Row{Op::noise_power, ref::noise_power},
    };
}

// Decals
Rows decals_rows() {
    return {
        Row{Op::projector,
            [](dvec3 x, dvec3 y, dvec3 z, dvec3 origin) {
                return glm::dmat4(dvec4(x, 0.0), dvec4(y, 0.0), dvec4(z, 0.0), dvec4(origin, 1.0));
            }},
        Row{Op::projector_axis,
            [](const Call& c, const glm::dmat4& m) {
                return dvec3(glm::transpose(m)[static_cast<int>(c.value.index)]);
            }},
        Row{Op::unit, ref::unit_or_shorter},
        Row{Op::decal_box,
            [](const glm::dmat4& m, const Volume& v) { return ref::decal_box(m, v.p, v.dx, v.dy); }},
        Row{Op::decal_cone,
            [](const glm::dmat4& m, const Volume& v) { return ref::decal_cone(m, v.p, v.dx, v.dy); }},
        Row{Op::decal_sphere,
            [](const glm::dmat4& m, const Volume& v) { return ref::decal_sphere(m, v.p, v.dx, v.dy); }},
        Row{Op::decal_uv, [](const ref::Decal& d) { return d.uv; }},
        Row{Op::decal_falloff_box,
            [](const ref::Decal& d, double edge) { return ref::decal_falloff_box(d.local, edge); }},
        Row{Op::decal_falloff_cone,
            [](const ref::Decal& d, double edge) { return ref::decal_falloff_cone(d.local, edge); }},
        Row{Op::decal_falloff_sphere,
            [](const ref::Decal& d, double edge) { return ref::decal_falloff_sphere(d.local, edge); }},
        Row{Op::decal_falloff_capsule,
            [](const ref::Decal& d, double half, double edge) {
                return ref::decal_falloff_capsule(d.local, half, edge);
            }},
        Row{Op::decal_falloff_wedge,
            [](const ref::Decal& d, double edge) { return ref::decal_falloff_wedge(d.local, edge); }},
        Row{Op::decal_angle_fade, ref::decal_angle_fade},
        Row{Op::decal_gradient, ref::decal_gradient},
        Row{Op::decal_gradient_along, ref::decal_gradient_along},
    };
}

dvec3 view_of(const PixelCamera& camera, dvec3 position) {
    return camera.perspective ? -glm::normalize(position) : -camera.direction;
}

// The level of detail that the shader computes from a coordinate of the mesh.
double level_of(const Call& c, const Uv& uv) {
    return ref::uv_level(uv, dvec2(c.texture().texels->size(0)));
}

dvec2 steps(const Call& c, dvec3 view, const Uv& uv, double per_step, dvec2 decode, double count) {
    dvec2 offset(0.0);
    const int steps = static_cast<int>(std::clamp(count, 0.0, 64.0));
    for (int i = 0; i < steps; ++i) {
        const double texel = c.texture().at({uv.st + offset, uv.dx, uv.dy}).x;
        offset += per_step * (decode.x * texel + decode.y) * dvec2(view);
    }
    return offset;
}

ref::March occlusion(const Call& c, const Uv& uv, dvec3 view, dvec2 heights, double count) {
    const double level = level_of(c, uv);
    return ref::parallax_march([&](dvec2 st) { return c.texture().at_level(st, level).x; }, heights, uv.st,
                               view, static_cast<int>(std::clamp(count, 1.0, 256.0)));
}

// Parallax
Rows parallax_rows() {
    return {
        Row{Op::normal_derivatives,
            [](const Call& c, dvec3) {
                return NormalDerivatives{c.pixel.dndx, c.pixel.dndy};
            }},
        Row{Op::view, [](const Call& c, dvec3 position) { return view_of(c.pixel.camera, position); }},
        Row{Op::parallax_direction, ref::parallax_direction},
        Row{Op::parallax_height,
            [](const Call& c, const Uv& uv, dvec2 heights) {
                return heights.y + heights.x * c.texture().at_level(uv.st, level_of(c, uv)).x;
            }},
        Row{Op::parallax_offset, ref::parallax_offset},
        Row{Op::parallax_steps, steps},
        Row{Op::parallax_step_count,
            [](dvec3 view, double straight, double grazing) {
                return grazing + (straight - grazing) * std::clamp(view.z, 0.0, 1.0);
            }},
        Row{Op::parallax_occlusion, occlusion},
        Row{Op::hit_offset, [](const ref::March& march) { return march.hit.offset; }},
        Row{Op::hit_height, [](const ref::March& march) { return march.hit.height; }},
        Row{Op::parallax_pixels, ref::parallax_pixels},
        Row{Op::pixels_offset, [](const Uv& uv, dvec2 pixels) { return glm::dmat2(uv.dx, uv.dy) * pixels; }},
        Row{Op::parallax_uv, ref::parallax_uv},
        Row{Op::parallax_detail_uv,
            [](const Frame& mesh, const Uv& uv, dvec2 pixels, const Frame& moved) {
                return ref::parallax_detail_uv(mesh, uv, pixels, moved.dpdx, moved.dpdy);
            }},
        Row{Op::parallax_position, ref::parallax_position},
        Row{Op::parallax_normal,
            [](dvec3 n, const NormalDerivatives& d, dvec2 pixels) {
                return ref::parallax_normal(n, d.dndx, d.dndy, pixels);
            }},
        Row{Op::frame_rebuilt,
            [](const Call& c, dvec3 position, dvec3 n, double facing) {
                return ref::frame_rebuilt(position, n, facing < 0.0 ? -1.0 : 1.0,
                                          view_of(c.pixel.camera, position),
                                          c.pixel.camera.relative_from_screen);
            }},
        Row{Op::volume_object_at,
            [](const Call& c, const Frame& f) {
                const glm::dmat3 inverse = glm::inverse(c.pixel.world_from_object);
                return Volume{inverse * (f.position - c.pixel.object_origin), inverse * f.dpdx,
                              inverse * f.dpdy};
            }},
        Row{Op::volume_world_at,
            [](const Call& c, const Frame& f) {
                return Volume{f.position + c.pixel.camera.position, f.dpdx, f.dpdy};
            }},
    };
}

// Derivatives
Rows gradients_rows() {
    return {
        Row{Op::decode_derivative,
            [](const Call& c, dvec4 t, double range) {
                return ref::deriv_from_map(
                    dvec2(ref::decode_signed(t.x, c.zero()), ref::decode_signed(t.y, c.zero())), range);
            }},
        Row{Op::deriv_from_height,
            [](const Call& c, const Uv& uv) {
                return ref::deriv_from_height(*c.texture().texels, sampler(c), uv);
            }},
        Row{Op::deriv_from_height_hq,
            [](const Call& c, const Uv& uv) {
                return ref::deriv_from_height_hq(*c.texture().texels, sampler(c), uv);
            }},
        Row{Op::deriv_from_normal_xyz, ref::deriv_from_normal_xyz},
        Row{Op::deriv_from_normal_xy, ref::deriv_from_normal_xy},
        Row{Op::deriv_green_up, ref::deriv_green_up},
        Row{Op::normal_from_deriv, ref::normal_from_deriv},
        Row{Op::deriv_from_map_normal, ref::deriv_from_normal_xyz},
        Row{Op::combine_whiteout, ref::combine_whiteout},
        Row{Op::combine_udn, ref::combine_udn},
        Row{Op::combine_rnm, ref::combine_rnm},
        Row{Op::pair_first, [](const ref::DerivPair& pair) { return pair.first; }},
        Row{Op::pair_second, [](const ref::DerivPair& pair) { return pair.second; }},
        Row{Op::scale_deriv, [](double s, dvec2 d) { return s * d; }},
        Row{Op::add_deriv, [](dvec2 a, dvec2 b) { return a + b; }},
        // volume gradients
        Row{Op::triplanar_gradient,
            [](const Call& c, dvec3 w, dvec2 x, dvec2 y, dvec2 z) {
                return ref::triplanar_gradient(w, x, y, z, hand(c), origin(c));
            }},
        Row{Op::noise_gradient, [](double frequency, const ref::Noise& n) { return frequency * n.gradient; }},
        Row{Op::gradient_from_object,
            [](const Call& c, dvec3 g) { return ref::gradient_to_world(c.pixel.world_from_object, g); }},
        Row{Op::gradient_from_world, [](dvec3 g) { return g; }},
        Row{Op::scale_volgrad, [](double s, dvec3 g) { return s * g; }},
        Row{Op::add_volgrad, [](dvec3 a, dvec3 b) { return a + b; }},
        Row{Op::mix_volgrad, ref::combine_mix},
        // surface gradients
        Row{Op::surfgrad_from_height,
            [](const Call& c, const ref::Frame& f, const Uv& uv, dvec2 d) {
                return ref::surfgrad_from_height(f, uv, dvec2(c.texture().texels->size(0)), d);
            }},
        Row{Op::surfgrad_from_three_taps,
            [](const Call& c, const ref::Frame& f, const Uv& uv) {
                auto height = [&](dvec2 step) { return c.texture().at({uv.st + step, uv.dx, uv.dy}).x; };
                const double here = height(dvec2(0.0));
                return ref::surfgrad_from_screen_height(f, dvec2(height(uv.dx) - here, height(uv.dy) - here));
            }},
        Row{Op::surfgrad_from_normal, ref::surfgrad_from_normal},
        Row{Op::surfgrad_from_volume, ref::surfgrad_from_volume},
        Row{Op::combine_reoriented, ref::combine_reoriented},
        Row{Op::mask_surfgrad, ref::combine_mask},
        Row{Op::mix_surfgrad, ref::combine_mix},
        Row{Op::zero_surfgrad, [] { return dvec3(0.0); }},
        Row{Op::surfgrad_from_tbn, ref::surfgrad_from_tbn},
        Row{Op::scale_surfgrad, [](double s, dvec3 g) { return ref::combine_scale(g, s); }},
        Row{Op::add_surfgrad, ref::combine_add},
        // a user's functions: the module with their equivalents is what can be run
        Row{Op::custom_deriv, [](const Call&) -> dvec2 { SG_UNREACHABLE("a user's GLSL has no reference"); }},
        Row{Op::custom_gradient,
            [](const Call&) -> dvec3 { SG_UNREACHABLE("a user's GLSL has no reference"); }},
        Row{Op::custom_surfgrad,
            [](const Call&) -> dvec3 { SG_UNREACHABLE("a user's GLSL has no reference"); }},
        // normals
        Row{Op::resolve, ref::resolve},
        Row{Op::resolve_vertex_map, ref::resolve_vertex_map},
        Row{Op::resolve_volume, ref::resolve_volume},
        Row{Op::resolve_towards, ref::resolve_towards},
        Row{Op::flip, ref::flip},
    };
}

const Rows& rows() {
    static const Rows table = [] {
        Rows all;
        for (Rows part : {inputs_rows(), graph_rows(), frames_rows(), lookups_rows(), decals_rows(),
                          parallax_rows(), gradients_rows()}) {
            all.insert(all.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
        }
        return all;
    }();
    return table;
}

}  // namespace

std::span<const EvaluateRow> all_evaluate_rows() {
    return rows();
}

const EvaluateRow* evaluate_row(Op op) {
    static const std::vector<const EvaluateRow*> by_op = [] {
        std::vector<const EvaluateRow*> out(all_ops().size(), nullptr);
        for (const EvaluateRow& row : rows()) {
            const EvaluateRow*& slot = out[static_cast<std::size_t>(row.op)];
            SG_ASSERT(slot == nullptr);
            slot = &row;
        }
        return out;
    }();
    return by_op[static_cast<std::size_t>(op)];
}

}  // namespace sg::ir
