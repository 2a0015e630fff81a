#version 310 es
precision highp float;
precision highp int;

struct SgFrame
{
    vec3 position;
    vec3 normal;
    vec3 dpdx;
    vec3 dpdy;
    vec3 sigma_x;
    vec3 sigma_y;
    float flip_sign;
};

struct SgUv
{
    vec2 st;
    vec2 dx;
    vec2 dy;
};

struct SgBasis
{
    vec3 tangent;
    vec3 bitangent;
};

layout(binding = 1, std140) uniform SgMaterialBlock
{
    float p_pebbles;
    vec2 p_grain;
    vec3 p_tint;
} sg_material;

layout(binding = 0) uniform highp sampler2D t_ramp;
layout(binding = 1) uniform highp sampler2D t_pebble;
layout(binding = 2) uniform highp sampler2D t_weave;
layout(binding = 3) uniform highp sampler2D t_scratch;

layout(location = 1) in vec3 sg_varying_normal;
layout(location = 2) in vec4 sg_varying_tangent;
layout(location = 4) in vec2 sg_varying_uv0;
layout(location = 0) in vec3 sg_varying_position;
layout(location = 5) in vec2 sg_varying_uv1;
layout(location = 0) out vec4 sg_out_normal;

SgBasis sg_basis_vertex(vec3 vertex_normal, vec4 vertex_tangent)
{
    float square = dot(vertex_normal, vertex_normal);
    float _383;
    if ((square > 1.0000000031710768509710513471353e-30) && (square < 1000000015047466219876688855040.0))
    {
        _383 = inversesqrt(square);
    }
    else
    {
        _383 = 0.0;
    }
    float scale = _383;
    float _395;
    if (vertex_tangent.w < 0.0)
    {
        _395 = -scale;
    }
    else
    {
        _395 = scale;
    }
    float side = _395;
    return SgBasis(vertex_tangent.xyz * scale, cross(vertex_normal, vertex_tangent.xyz) * side);
}

SgUv sg_stage_uv(vec2 st)
{
    return SgUv(st, dFdx(st), -dFdy(st));
}

vec4 sg_sample(SgUv uv, highp sampler2D image)
{
    return textureGrad(image, uv.st, uv.dx, uv.dy);
}

vec3 sg_decode_signed(vec3 texel, float zero)
{
    vec3 _262;
    if (zero == 127.5)
    {
        _262 = (texel * 2.0) - vec3(1.0);
    }
    else
    {
        _262 = ((texel * 255.0) - vec3(zero)) / vec3(min(zero, 255.0 - zero));
    }
    return clamp(_262, vec3(-1.0), vec3(1.0));
}

vec2 sg_deriv_from_normal_xyz(vec3 m)
{
    vec3 magnitude = abs(m);
    float z = max(max(magnitude.z, max(magnitude.x, magnitude.y) / 128.0), 1.0000000031710768509710513471353e-30);
    return (-m.xy) / vec2(z);
}

vec2 sg_deriv_green_up(vec2 d)
{
    return vec2(d.x, -d.y);
}

vec3 sg_surfgrad_from_tbn(vec2 d, SgBasis basis)
{
    return (basis.tangent * d.x) + (basis.bitangent * d.y);
}

vec3 sg_base_normal(vec3 vertex_normal)
{
    float square = dot(vertex_normal, vertex_normal);
    bool usable = (square > 1.0000000031710768509710513471353e-30) && (square < 1000000015047466219876688855040.0);
    vec3 _165;
    if (usable)
    {
        _165 = vertex_normal * inversesqrt(square);
    }
    else
    {
        _165 = vec3(0.0, 0.0, 1.0);
    }
    return _165;
}

float sg_stage_facing()
{
    return gl_FrontFacing ? 1.0 : (-1.0);
}

vec3 sg_mirror_normal(vec3 n, float facing)
{
    return n * facing;
}

vec3 sg_reject(vec3 v, vec3 n)
{
    return v - (n * dot(v, n));
}

SgFrame sg_frame(vec3 position, vec3 dpdx, vec3 dpdy, vec3 n)
{
    float sign_dp = (dot(dpdy, cross(n, dpdx)) < 0.0) ? (-1.0) : 1.0;
    vec3 param = dpdx;
    vec3 param_1 = n;
    vec3 param_2 = dpdy;
    vec3 param_3 = n;
    return SgFrame(position, n, dpdx, dpdy, sg_reject(param, param_1), sg_reject(param_2, param_3), sign_dp);
}

SgFrame sg_stage_frame(vec3 position, vec3 n)
{
    vec3 param = position;
    vec3 param_1 = dFdx(position);
    vec3 param_2 = -dFdy(position);
    vec3 param_3 = n;
    return sg_frame(param, param_1, param_2, param_3);
}

SgUv sg_uv_scale(SgUv uv, vec2 scale)
{
    return SgUv(uv.st * scale, uv.dx * scale, uv.dy * scale);
}

SgBasis sg_basis_uv(SgFrame frame, SgUv uv)
{
    float det = (uv.dx.x * uv.dy.y) - (uv.dx.y * uv.dy.x);
    float sign_det = (det < 0.0) ? (-1.0) : 1.0;
    vec3 step_s = ((frame.dpdx * uv.dy.y) - (frame.dpdy * uv.dx.y)) * sign_det;
    vec3 param = step_s;
    vec3 param_1 = frame.normal;
    vec3 along_s = sg_reject(param, param_1);
    float square = dot(along_s, along_s);
    bool tangential = (square > max(1.0000000359391298238442905219083e-36, 9.9999999747524270787835121154785e-07 * dot(step_s, step_s))) && (square < 1000000015047466219876688855040.0);
    bool _491;
    if (tangential)
    {
        _491 = abs(det) > (9.9999999747524270787835121154785e-07 * sqrt(dot(uv.dx, uv.dx) * dot(uv.dy, uv.dy)));
    }
    else
    {
        _491 = tangential;
    }
    bool usable = _491;
    vec3 _494;
    if (usable)
    {
        _494 = along_s * inversesqrt(square);
    }
    else
    {
        _494 = vec3(0.0);
    }
    vec3 tangent = _494;
    vec3 _506;
    if (usable)
    {
        _506 = cross(frame.normal, tangent) * (sign_det * frame.flip_sign);
    }
    else
    {
        _506 = vec3(0.0);
    }
    vec3 bitangent = _506;
    return SgBasis(tangent, bitangent);
}

vec2 sg_decode_signed(vec2 texel, float zero)
{
    vec2 _233;
    if (zero == 127.5)
    {
        _233 = (texel * 2.0) - vec2(1.0);
    }
    else
    {
        _233 = ((texel * 255.0) - vec2(zero)) / vec2(min(zero, 255.0 - zero));
    }
    return clamp(_233, vec2(-1.0), vec2(1.0));
}

vec2 sg_deriv_from_normal_xy(vec2 m)
{
    return (-m) * inversesqrt(max(1.0 - dot(m, m), 6.103515625e-05));
}

SgBasis sg_basis_mirror(SgBasis basis, vec2 scale)
{
    vec3 _529;
    if (scale.x < 0.0)
    {
        _529 = -basis.tangent;
    }
    else
    {
        _529 = basis.tangent;
    }
    vec3 _542;
    if (scale.y < 0.0)
    {
        _542 = -basis.bitangent;
    }
    else
    {
        _542 = basis.bitangent;
    }
    return SgBasis(_529, _542);
}

vec3 sg_resolve(vec3 n, vec3 g)
{
    vec3 bumped = n - g;
    float square = dot(bumped, bumped);
    vec3 _348;
    if ((square > 1.0000000031710768509710513471353e-30) && (square < 9.9999996802856924650656260769173e+37))
    {
        _348 = bumped * inversesqrt(square);
    }
    else
    {
        _348 = n;
    }
    return _348;
}

void main()
{
    vec3 param = sg_varying_normal;
    vec4 param_1 = sg_varying_tangent;
    SgBasis m_basis_vertex = sg_basis_vertex(param, param_1);
    vec2 param_2 = sg_varying_uv0;
    SgUv m_uv0 = sg_stage_uv(param_2);
    SgUv param_3 = m_uv0;
    vec3 param_4 = sg_sample(param_3, t_ramp).xyz;
    float param_5 = 127.5;
    vec3 param_6 = sg_decode_signed(param_4, param_5);
    vec2 param_7 = sg_deriv_from_normal_xyz(param_6);
    vec2 m_ramps_deriv = sg_deriv_green_up(param_7);
    vec2 param_8 = m_ramps_deriv * 0.5;
    SgBasis param_9 = m_basis_vertex;
    vec3 m_ramps = sg_surfgrad_from_tbn(param_8, param_9);
    vec3 param_10 = sg_varying_normal;
    vec3 param_11 = sg_base_normal(param_10);
    float param_12 = sg_stage_facing();
    vec3 m_base_normal = sg_mirror_normal(param_11, param_12);
    vec3 param_13 = sg_varying_position;
    vec3 param_14 = m_base_normal;
    SgFrame m_frame = sg_stage_frame(param_13, param_14);
    SgUv param_15 = m_uv0;
    vec2 param_16 = vec2(3.0);
    SgUv param_17 = sg_uv_scale(param_15, param_16);
    vec3 param_18 = sg_sample(param_17, t_pebble).xyz;
    float param_19 = 127.0;
    vec3 param_20 = sg_decode_signed(param_18, param_19);
    vec2 m_pebbles_deriv = sg_deriv_from_normal_xyz(param_20);
    vec2 param_21 = m_pebbles_deriv;
    SgFrame param_22 = m_frame;
    SgUv param_23 = m_uv0;
    vec2 param_24 = sg_deriv_green_up(param_21) * sg_material.p_pebbles;
    SgBasis param_25 = sg_basis_uv(param_22, param_23);
    vec3 m_pebbles = sg_surfgrad_from_tbn(param_24, param_25);
    vec2 param_26 = sg_varying_uv1;
    SgUv param_27 = sg_stage_uv(param_26);
    vec2 param_28 = sg_material.p_grain;
    SgUv m_grain_uv = sg_uv_scale(param_27, param_28);
    SgUv param_29 = m_grain_uv;
    vec3 param_30 = sg_sample(param_29, t_weave).xyz;
    float param_31 = 128.0;
    vec3 param_32 = sg_decode_signed(param_30, param_31);
    vec2 m_grain_scale_deriv = sg_deriv_from_normal_xyz(param_32) * (-0.4000000059604644775390625);
    SgFrame param_33 = m_frame;
    SgUv param_34 = m_grain_uv;
    vec2 param_35 = m_grain_scale_deriv;
    SgBasis param_36 = sg_basis_uv(param_33, param_34);
    vec3 m_grain = sg_surfgrad_from_tbn(param_35, param_36);
    SgUv param_37 = m_uv0;
    vec2 param_38 = vec2(-4.0, 2.0);
    SgUv param_39 = sg_uv_scale(param_37, param_38);
    vec2 param_40 = sg_sample(param_39, t_scratch).xy;
    float param_41 = 127.5;
    vec2 param_42 = sg_decode_signed(param_40, param_41);
    vec2 m_scratches_deriv = sg_deriv_from_normal_xy(param_42);
    SgBasis param_43 = m_basis_vertex;
    vec2 param_44 = vec2(-4.0, 2.0);
    vec2 param_45 = m_scratches_deriv * 0.3499999940395355224609375;
    SgBasis param_46 = sg_basis_mirror(param_43, param_44);
    vec3 m_scratches = sg_surfgrad_from_tbn(param_45, param_46);
    vec3 param_47 = m_base_normal;
    vec3 param_48 = ((m_ramps + m_pebbles) + m_grain) + m_scratches;
    sg_out_normal = vec4(sg_resolve(param_47, param_48), 1.0);
}

