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

cbuffer SgMaterialBlock : register(b0, space1)
{
    float sg_material_p_pebbles : packoffset(c0);
    float2 sg_material_p_grain : packoffset(c0.z);
    float3 sg_material_p_tint : packoffset(c1);
};

Texture2D<float4> t_ramp : register(t1, space1);
SamplerState s_0 : register(s5, space1);
Texture2D<float4> t_pebble : register(t2, space1);
Texture2D<float4> t_weave : register(t3, space1);
Texture2D<float4> t_scratch : register(t4, space1);
SamplerState s_1 : register(s6, space1);

static bool gl_FrontFacing;
static float3 sg_in_normal;
static float4 sg_in_tangent;
static float2 sg_in_uv0;
static float3 sg_in_position;
static float2 sg_in_uv1;
static float4 sg_out_normal;

struct SPIRV_Cross_Input
{
    float3 sg_in_position : TEXCOORD0;
    float3 sg_in_normal : TEXCOORD1;
    float4 sg_in_tangent : TEXCOORD2;
    float2 sg_in_uv0 : TEXCOORD4;
    float2 sg_in_uv1 : TEXCOORD5;
    bool gl_FrontFacing : SV_IsFrontFace;
};

struct SPIRV_Cross_Output
{
    float4 sg_out_normal : SV_Target0;
};

SgBasis sg_basis_vertex(float3 vertex_normal, float4 vertex_tangent)
{
    float square = dot(vertex_normal, vertex_normal);
    float _381;
    if ((square > 1.0000000031710768509710513471353e-30f) && (square < 1000000015047466219876688855040.0f))
    {
        _381 = rsqrt(square);
    }
    else
    {
        _381 = 0.0f;
    }
    float scale = _381;
    float _393;
    if (vertex_tangent.w < 0.0f)
    {
        _393 = -scale;
    }
    else
    {
        _393 = scale;
    }
    float side = _393;
    SgBasis _411 = { vertex_tangent.xyz * scale, cross(vertex_normal, vertex_tangent.xyz) * side };
    return _411;
}

SgUv sg_stage_uv(float2 st)
{
    SgUv _206 = { st, ddx_fine(st), ddy_fine(st) };
    return _206;
}

float4 sg_sample(Texture2D<float4> image, SamplerState filtering, SgUv uv)
{
    return image.SampleGrad(filtering, uv.st, uv.dx, uv.dy);
}

float3 sg_decode_signed(float3 texel, float zero)
{
    float3 _260;
    if (zero == 127.5f)
    {
        _260 = (texel * 2.0f) - 1.0f.xxx;
    }
    else
    {
        _260 = ((texel * 255.0f) - zero.xxx) / min(zero, 255.0f - zero).xxx;
    }
    return clamp(_260, (-1.0f).xxx, 1.0f.xxx);
}

float2 sg_deriv_from_normal_xyz(float3 m)
{
    float3 magnitude = abs(m);
    float z = max(max(magnitude.z, max(magnitude.x, magnitude.y) / 128.0f), 1.0000000031710768509710513471353e-30f);
    return (-m.xy) / z.xx;
}

float2 sg_deriv_green_up(float2 d)
{
    return float2(d.x, -d.y);
}

float3 sg_surfgrad_from_tbn(float2 d, SgBasis basis)
{
    return (basis.tangent * d.x) + (basis.bitangent * d.y);
}

float3 sg_base_normal(float3 vertex_normal)
{
    float square = dot(vertex_normal, vertex_normal);
    bool usable = (square > 1.0000000031710768509710513471353e-30f) && (square < 1000000015047466219876688855040.0f);
    float3 _165;
    if (usable)
    {
        _165 = vertex_normal * rsqrt(square);
    }
    else
    {
        _165 = float3(0.0f, 0.0f, 1.0f);
    }
    return _165;
}

float sg_stage_facing()
{
    return gl_FrontFacing ? 1.0f : (-1.0f);
}

float3 sg_mirror_normal(float3 n, float facing)
{
    return n * facing;
}

float3 sg_reject(float3 v, float3 n)
{
    return v - (n * dot(v, n));
}

SgFrame sg_frame(float3 position, float3 dpdx, float3 dpdy, float3 n)
{
    float sign_dp = (dot(dpdy, cross(n, dpdx)) < 0.0f) ? (-1.0f) : 1.0f;
    float3 param = dpdx;
    float3 param_1 = n;
    float3 param_2 = dpdy;
    float3 param_3 = n;
    SgFrame _148 = { position, n, dpdx, dpdy, sg_reject(param, param_1), sg_reject(param_2, param_3), sign_dp };
    return _148;
}

SgFrame sg_stage_frame(float3 position, float3 n)
{
    float3 param = position;
    float3 param_1 = ddx_fine(position);
    float3 param_2 = ddy_fine(position);
    float3 param_3 = n;
    return sg_frame(param, param_1, param_2, param_3);
}

SgUv sg_uv_scale(SgUv uv, float2 scale)
{
    SgUv _198 = { uv.st * scale, uv.dx * scale, uv.dy * scale };
    return _198;
}

SgBasis sg_basis_uv(SgFrame frame, SgUv uv)
{
    float det = (uv.dx.x * uv.dy.y) - (uv.dx.y * uv.dy.x);
    float sign_det = (det < 0.0f) ? (-1.0f) : 1.0f;
    float3 step_s = ((frame.dpdx * uv.dy.y) - (frame.dpdy * uv.dx.y)) * sign_det;
    float3 param = step_s;
    float3 param_1 = frame.normal;
    float3 along_s = sg_reject(param, param_1);
    float square = dot(along_s, along_s);
    bool tangential = (square > max(1.0000000359391298238442905219083e-36f, 9.9999999747524270787835121154785e-07f * dot(step_s, step_s))) && (square < 1000000015047466219876688855040.0f);
    bool _489;
    if (tangential)
    {
        _489 = abs(det) > (9.9999999747524270787835121154785e-07f * sqrt(dot(uv.dx, uv.dx) * dot(uv.dy, uv.dy)));
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
        _492 = 0.0f.xxx;
    }
    float3 tangent = _492;
    float3 _504;
    if (usable)
    {
        _504 = cross(frame.normal, tangent) * (sign_det * frame.flip_sign);
    }
    else
    {
        _504 = 0.0f.xxx;
    }
    float3 bitangent = _504;
    SgBasis _521 = { tangent, bitangent };
    return _521;
}

float2 sg_decode_signed(float2 texel, float zero)
{
    float2 _231;
    if (zero == 127.5f)
    {
        _231 = (texel * 2.0f) - 1.0f.xx;
    }
    else
    {
        _231 = ((texel * 255.0f) - zero.xx) / min(zero, 255.0f - zero).xx;
    }
    return clamp(_231, (-1.0f).xx, 1.0f.xx);
}

float2 sg_deriv_from_normal_xy(float2 m)
{
    return (-m) * rsqrt(max(1.0f - dot(m, m), 6.103515625e-05f));
}

SgBasis sg_basis_mirror(SgBasis basis, float2 scale)
{
    float3 _527;
    if (scale.x < 0.0f)
    {
        _527 = -basis.tangent;
    }
    else
    {
        _527 = basis.tangent;
    }
    float3 _540;
    if (scale.y < 0.0f)
    {
        _540 = -basis.bitangent;
    }
    else
    {
        _540 = basis.bitangent;
    }
    SgBasis _550 = { _527, _540 };
    return _550;
}

float3 sg_resolve(float3 n, float3 g)
{
    float3 bumped = n - g;
    float square = dot(bumped, bumped);
    float3 _346;
    if ((square > 1.0000000031710768509710513471353e-30f) && (square < 9.9999996802856924650656260769173e+37f))
    {
        _346 = bumped * rsqrt(square);
    }
    else
    {
        _346 = n;
    }
    return _346;
}

void frag_main()
{
    float3 param = sg_in_normal;
    float4 param_1 = sg_in_tangent;
    SgBasis m_basis_vertex = sg_basis_vertex(param, param_1);
    float2 param_2 = sg_in_uv0;
    SgUv m_uv0 = sg_stage_uv(param_2);
    SgUv param_3 = m_uv0;
    float3 param_4 = sg_sample(t_ramp, s_0, param_3).xyz;
    float param_5 = 127.5f;
    float3 param_6 = sg_decode_signed(param_4, param_5);
    float2 param_7 = sg_deriv_from_normal_xyz(param_6);
    float2 m_ramps_deriv = sg_deriv_green_up(param_7);
    float2 param_8 = m_ramps_deriv * 0.5f;
    SgBasis param_9 = m_basis_vertex;
    float3 m_ramps = sg_surfgrad_from_tbn(param_8, param_9);
    float3 param_10 = sg_in_normal;
    float3 param_11 = sg_base_normal(param_10);
    float param_12 = sg_stage_facing();
    float3 m_base_normal = sg_mirror_normal(param_11, param_12);
    float3 param_13 = sg_in_position;
    float3 param_14 = m_base_normal;
    SgFrame m_frame = sg_stage_frame(param_13, param_14);
    SgUv param_15 = m_uv0;
    float2 param_16 = 3.0f.xx;
    SgUv param_17 = sg_uv_scale(param_15, param_16);
    float3 param_18 = sg_sample(t_pebble, s_0, param_17).xyz;
    float param_19 = 127.0f;
    float3 param_20 = sg_decode_signed(param_18, param_19);
    float2 m_pebbles_deriv = sg_deriv_from_normal_xyz(param_20);
    float2 param_21 = m_pebbles_deriv;
    SgFrame param_22 = m_frame;
    SgUv param_23 = m_uv0;
    float2 param_24 = sg_deriv_green_up(param_21) * sg_material_p_pebbles;
    SgBasis param_25 = sg_basis_uv(param_22, param_23);
    float3 m_pebbles = sg_surfgrad_from_tbn(param_24, param_25);
    float2 param_26 = sg_in_uv1;
    SgUv param_27 = sg_stage_uv(param_26);
    float2 param_28 = sg_material_p_grain;
    SgUv m_grain_uv = sg_uv_scale(param_27, param_28);
    SgUv param_29 = m_grain_uv;
    float3 param_30 = sg_sample(t_weave, s_0, param_29).xyz;
    float param_31 = 128.0f;
    float3 param_32 = sg_decode_signed(param_30, param_31);
    float2 m_grain_scale_deriv = sg_deriv_from_normal_xyz(param_32) * (-0.4000000059604644775390625f);
    SgFrame param_33 = m_frame;
    SgUv param_34 = m_grain_uv;
    float2 param_35 = m_grain_scale_deriv;
    SgBasis param_36 = sg_basis_uv(param_33, param_34);
    float3 m_grain = sg_surfgrad_from_tbn(param_35, param_36);
    SgUv param_37 = m_uv0;
    float2 param_38 = float2(-4.0f, 2.0f);
    SgUv param_39 = sg_uv_scale(param_37, param_38);
    float2 param_40 = sg_sample(t_scratch, s_1, param_39).xy;
    float param_41 = 127.5f;
    float2 param_42 = sg_decode_signed(param_40, param_41);
    float2 m_scratches_deriv = sg_deriv_from_normal_xy(param_42);
    SgBasis param_43 = m_basis_vertex;
    float2 param_44 = float2(-4.0f, 2.0f);
    float2 param_45 = m_scratches_deriv * 0.3499999940395355224609375f;
    SgBasis param_46 = sg_basis_mirror(param_43, param_44);
    float3 m_scratches = sg_surfgrad_from_tbn(param_45, param_46);
    float3 param_47 = m_base_normal;
    float3 param_48 = ((m_ramps + m_pebbles) + m_grain) + m_scratches;
    sg_out_normal = float4(sg_resolve(param_47, param_48), 1.0f);
}

SPIRV_Cross_Output main(SPIRV_Cross_Input stage_input)
{
    gl_FrontFacing = stage_input.gl_FrontFacing;
    sg_in_normal = stage_input.sg_in_normal;
    sg_in_tangent = stage_input.sg_in_tangent;
    sg_in_uv0 = stage_input.sg_in_uv0;
    sg_in_position = stage_input.sg_in_position;
    sg_in_uv1 = stage_input.sg_in_uv1;
    frag_main();
    SPIRV_Cross_Output stage_output;
    stage_output.sg_out_normal = sg_out_normal;
    return stage_output;
}
