#pragma clang diagnostic ignored "-Wmissing-prototypes"

#include <metal_stdlib>
#include <simd/simd.h>

using namespace metal;

struct SgFrame
{
    float3 position;
    float3 normal;
    float3 dpdx;
    float3 dpdy;
    float3 sigma_x;
    float3 sigma_y;
    float flip_sign;
};

struct SgUv
{
    float2 st;
    float2 dx;
    float2 dy;
};

struct SgBasis
{
    float3 tangent;
    float3 bitangent;
};

struct SgMaterialBlock
{
    float p_pebbles;
    float2 p_grain;
    float3 p_tint;
};

struct main0_out
{
    float4 sg_out_normal [[color(0)]];
};

struct main0_in
{
    float3 sg_in_position [[user(locn0)]];
    float3 sg_in_normal [[user(locn1)]];
    float4 sg_in_tangent [[user(locn2)]];
    float2 sg_in_uv0 [[user(locn4)]];
    float2 sg_in_uv1 [[user(locn5)]];
};

static inline __attribute__((always_inline))
SgBasis sg_basis_vertex(thread const float3& vertex_normal, thread const float4& vertex_tangent)
{
    float square = dot(vertex_normal, vertex_normal);
    float _381;
    if ((square > 1.0000000031710768509710513471353e-30) && (square < 1000000015047466219876688855040.0))
    {
        _381 = rsqrt(square);
    }
    else
    {
        _381 = 0.0;
    }
    float scale = _381;
    float _393;
    if (vertex_tangent.w < 0.0)
    {
        _393 = -scale;
    }
    else
    {
        _393 = scale;
    }
    float side = _393;
    return SgBasis{ vertex_tangent.xyz * scale, cross(vertex_normal, vertex_tangent.xyz) * side };
}

static inline __attribute__((always_inline))
SgUv sg_stage_uv(thread const float2& st)
{
    return SgUv{ st, dfdx(st), dfdy(st) };
}

static inline __attribute__((always_inline))
float4 sg_sample(texture2d<float> image, sampler filtering, thread const SgUv& uv)
{
    return image.sample(filtering, uv.st, gradient2d(uv.dx, uv.dy));
}

static inline __attribute__((always_inline))
float3 sg_decode_signed(thread const float3& texel, thread const float& zero)
{
    float3 _260;
    if (zero == 127.5)
    {
        _260 = (texel * 2.0) - float3(1.0);
    }
    else
    {
        _260 = ((texel * 255.0) - float3(zero)) / float3(fast::min(zero, 255.0 - zero));
    }
    return fast::clamp(_260, float3(-1.0), float3(1.0));
}

static inline __attribute__((always_inline))
float2 sg_deriv_from_normal_xyz(thread const float3& m)
{
    float3 magnitude = abs(m);
    float z = fast::max(fast::max(magnitude.z, fast::max(magnitude.x, magnitude.y) / 128.0), 1.0000000031710768509710513471353e-30);
    return (-m.xy) / float2(z);
}

static inline __attribute__((always_inline))
float2 sg_deriv_green_up(thread const float2& d)
{
    return float2(d.x, -d.y);
}

static inline __attribute__((always_inline))
float3 sg_surfgrad_from_tbn(thread const float2& d, thread const SgBasis& basis)
{
    return (basis.tangent * d.x) + (basis.bitangent * d.y);
}

static inline __attribute__((always_inline))
float3 sg_base_normal(thread const float3& vertex_normal)
{
    float square = dot(vertex_normal, vertex_normal);
    bool usable = (square > 1.0000000031710768509710513471353e-30) && (square < 1000000015047466219876688855040.0);
    float3 _165;
    if (usable)
    {
        _165 = vertex_normal * rsqrt(square);
    }
    else
    {
        _165 = float3(0.0, 0.0, 1.0);
    }
    return _165;
}

static inline __attribute__((always_inline))
float sg_stage_facing(thread bool& gl_FrontFacing)
{
    return gl_FrontFacing ? 1.0 : (-1.0);
}

static inline __attribute__((always_inline))
float3 sg_mirror_normal(thread const float3& n, thread const float& facing)
{
    return n * facing;
}

static inline __attribute__((always_inline))
float3 sg_reject(thread const float3& v, thread const float3& n)
{
    return v - (n * dot(v, n));
}

static inline __attribute__((always_inline))
SgFrame sg_frame(thread const float3& position, thread const float3& dpdx, thread const float3& dpdy, thread const float3& n)
{
    float sign_dp = (dot(dpdy, cross(n, dpdx)) < 0.0) ? (-1.0) : 1.0;
    float3 param = dpdx;
    float3 param_1 = n;
    float3 param_2 = dpdy;
    float3 param_3 = n;
    return SgFrame{ position, n, dpdx, dpdy, sg_reject(param, param_1), sg_reject(param_2, param_3), sign_dp };
}

static inline __attribute__((always_inline))
SgFrame sg_stage_frame(thread const float3& position, thread const float3& n)
{
    float3 param = position;
    float3 param_1 = dfdx(position);
    float3 param_2 = dfdy(position);
    float3 param_3 = n;
    return sg_frame(param, param_1, param_2, param_3);
}

static inline __attribute__((always_inline))
SgUv sg_uv_scale(thread const SgUv& uv, thread const float2& scale)
{
    return SgUv{ uv.st * scale, uv.dx * scale, uv.dy * scale };
}

static inline __attribute__((always_inline))
SgBasis sg_basis_uv(thread const SgFrame& frame, thread const SgUv& uv)
{
    float det = (uv.dx.x * uv.dy.y) - (uv.dx.y * uv.dy.x);
    float sign_det = (det < 0.0) ? (-1.0) : 1.0;
    float3 step_s = ((frame.dpdx * uv.dy.y) - (frame.dpdy * uv.dx.y)) * sign_det;
    float3 param = step_s;
    float3 param_1 = frame.normal;
    float3 along_s = sg_reject(param, param_1);
    float square = dot(along_s, along_s);
    bool tangential = (square > fast::max(1.0000000359391298238442905219083e-36, 9.9999999747524270787835121154785e-07 * dot(step_s, step_s))) && (square < 1000000015047466219876688855040.0);
    bool _489;
    if (tangential)
    {
        _489 = abs(det) > (9.9999999747524270787835121154785e-07 * sqrt(dot(uv.dx, uv.dx) * dot(uv.dy, uv.dy)));
    }
    else
    {
        _489 = tangential;
    }
    bool usable = _489;
    float3 _492;
    if (usable)
    {
        _492 = along_s * rsqrt(square);
    }
    else
    {
        _492 = float3(0.0);
    }
    float3 tangent = _492;
    float3 _504;
    if (usable)
    {
        _504 = cross(frame.normal, tangent) * (sign_det * frame.flip_sign);
    }
    else
    {
        _504 = float3(0.0);
    }
    float3 bitangent = _504;
    return SgBasis{ tangent, bitangent };
}

static inline __attribute__((always_inline))
float2 sg_decode_signed(thread const float2& texel, thread const float& zero)
{
    float2 _231;
    if (zero == 127.5)
    {
        _231 = (texel * 2.0) - float2(1.0);
    }
    else
    {
        _231 = ((texel * 255.0) - float2(zero)) / float2(fast::min(zero, 255.0 - zero));
    }
    return fast::clamp(_231, float2(-1.0), float2(1.0));
}

static inline __attribute__((always_inline))
float2 sg_deriv_from_normal_xy(thread const float2& m)
{
    return (-m) * rsqrt(fast::max(1.0 - dot(m, m), 6.103515625e-05));
}

static inline __attribute__((always_inline))
SgBasis sg_basis_mirror(thread const SgBasis& basis, thread const float2& scale)
{
    float3 _527;
    if (scale.x < 0.0)
    {
        _527 = -basis.tangent;
    }
    else
    {
        _527 = basis.tangent;
    }
    float3 _540;
    if (scale.y < 0.0)
    {
        _540 = -basis.bitangent;
    }
    else
    {
        _540 = basis.bitangent;
    }
    return SgBasis{ _527, _540 };
}

static inline __attribute__((always_inline))
float3 sg_resolve(thread const float3& n, thread const float3& g)
{
    float3 bumped = n - g;
    float square = dot(bumped, bumped);
    float3 _346;
    if ((square > 1.0000000031710768509710513471353e-30) && (square < 9.9999996802856924650656260769173e+37))
    {
        _346 = bumped * rsqrt(square);
    }
    else
    {
        _346 = n;
    }
    return _346;
}

fragment main0_out main0(main0_in in [[stage_in]], constant SgMaterialBlock& sg_material [[buffer(1)]], texture2d<float> t_ramp [[texture(0)]], texture2d<float> t_pebble [[texture(1)]], texture2d<float> t_weave [[texture(2)]], texture2d<float> t_scratch [[texture(3)]], sampler s_0 [[sampler(0)]], sampler s_1 [[sampler(1)]], bool gl_FrontFacing [[front_facing]])
{
    main0_out out = {};
    float3 param = in.sg_in_normal;
    float4 param_1 = in.sg_in_tangent;
    SgBasis m_basis_vertex = sg_basis_vertex(param, param_1);
    float2 param_2 = in.sg_in_uv0;
    SgUv m_uv0 = sg_stage_uv(param_2);
    SgUv param_3 = m_uv0;
    float3 param_4 = sg_sample(t_ramp, s_0, param_3).xyz;
    float param_5 = 127.5;
    float3 param_6 = sg_decode_signed(param_4, param_5);
    float2 param_7 = sg_deriv_from_normal_xyz(param_6);
    float2 m_ramps_deriv = sg_deriv_green_up(param_7);
    float2 param_8 = m_ramps_deriv * 0.5;
    SgBasis param_9 = m_basis_vertex;
    float3 m_ramps = sg_surfgrad_from_tbn(param_8, param_9);
    float3 param_10 = in.sg_in_normal;
    float3 param_11 = sg_base_normal(param_10);
    float param_12 = sg_stage_facing(gl_FrontFacing);
    float3 m_base_normal = sg_mirror_normal(param_11, param_12);
    float3 param_13 = in.sg_in_position;
    float3 param_14 = m_base_normal;
    SgFrame m_frame = sg_stage_frame(param_13, param_14);
    SgUv param_15 = m_uv0;
    float2 param_16 = float2(3.0);
    SgUv param_17 = sg_uv_scale(param_15, param_16);
    float3 param_18 = sg_sample(t_pebble, s_0, param_17).xyz;
    float param_19 = 127.0;
    float3 param_20 = sg_decode_signed(param_18, param_19);
    float2 m_pebbles_deriv = sg_deriv_from_normal_xyz(param_20);
    float2 param_21 = m_pebbles_deriv;
    SgFrame param_22 = m_frame;
    SgUv param_23 = m_uv0;
    float2 param_24 = sg_deriv_green_up(param_21) * sg_material.p_pebbles;
    SgBasis param_25 = sg_basis_uv(param_22, param_23);
    float3 m_pebbles = sg_surfgrad_from_tbn(param_24, param_25);
    float2 param_26 = in.sg_in_uv1;
    SgUv param_27 = sg_stage_uv(param_26);
    float2 param_28 = sg_material.p_grain;
    SgUv m_grain_uv = sg_uv_scale(param_27, param_28);
    SgUv param_29 = m_grain_uv;
    float3 param_30 = sg_sample(t_weave, s_0, param_29).xyz;
    float param_31 = 128.0;
    float3 param_32 = sg_decode_signed(param_30, param_31);
    float2 m_grain_scale_deriv = sg_deriv_from_normal_xyz(param_32) * (-0.4000000059604644775390625);
    SgFrame param_33 = m_frame;
    SgUv param_34 = m_grain_uv;
    float2 param_35 = m_grain_scale_deriv;
    SgBasis param_36 = sg_basis_uv(param_33, param_34);
    float3 m_grain = sg_surfgrad_from_tbn(param_35, param_36);
    SgUv param_37 = m_uv0;
    float2 param_38 = float2(-4.0, 2.0);
    SgUv param_39 = sg_uv_scale(param_37, param_38);
    float2 param_40 = sg_sample(t_scratch, s_1, param_39).xy;
    float param_41 = 127.5;
    float2 param_42 = sg_decode_signed(param_40, param_41);
    float2 m_scratches_deriv = sg_deriv_from_normal_xy(param_42);
    SgBasis param_43 = m_basis_vertex;
    float2 param_44 = float2(-4.0, 2.0);
    float2 param_45 = m_scratches_deriv * 0.3499999940395355224609375;
    SgBasis param_46 = sg_basis_mirror(param_43, param_44);
    float3 m_scratches = sg_surfgrad_from_tbn(param_45, param_46);
    float3 param_47 = m_base_normal;
    float3 param_48 = ((m_ramps + m_pebbles) + m_grain) + m_scratches;
    out.sg_out_normal = float4(sg_resolve(param_47, param_48), 1.0);
    return out;
}

