// A Direct3D engine's shaders that ask a material for its surface.
//   surfgradc compile materials/layered.json -o out --entry function --target hlsl60
//   dxc -T ps_6_0 -E pixel_main -I out compiler/examples/direct3d.hlsl
// For Direct3D 11 take hlsl50, and registers without spaces.
#include "layered.function.hlsl60.hlsl"

cbuffer Camera : register(b0, space0) { float4x4 clip_from_relative; };
cbuffer Object : register(b0, space2) {
    float4x4 relative_from_object;
    float4x4 normal_from_object;  // inverse transpose of the first; _44: the sign of its determinant
};

// Offsets as in the manifest's parameter_block. HLSL would pack the struct more tightly than that.
cbuffer Material : register(b0, space1) {
    float pebbles : packoffset(c0.x);
    float2 grain : packoffset(c0.z);
    float3 tint : packoffset(c1.x);
};
Texture2D<float4> ramp : register(t1, space1);
Texture2D<float4> pebble : register(t2, space1);
Texture2D<float4> weave : register(t3, space1);
Texture2D<float4> scratch : register(t4, space1);
SamplerState linear_repeat : register(s5, space1);
SamplerState scratch_sampler : register(s6, space1);

struct Vertex {
    float3 position : POSITION;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float2 uv0 : TEXCOORD0;
    float2 uv1 : TEXCOORD1;
};

struct Varyings {
    float4 clip : SV_Position;
    float3 position : RELATIVE_POSITION;
    float3 normal : WORLD_NORMAL;
    float4 tangent : WORLD_TANGENT;
    float2 uv0 : UV0;
    float2 uv1 : UV1;
};

Varyings vertex_main(Vertex v) {
    Varyings o;
    o.position = mul(relative_from_object, float4(v.position, 1.0)).xyz;
    o.normal = normalize(mul((float3x3)normal_from_object, v.normal));
    o.tangent.xyz = normalize(mul((float3x3)relative_from_object, v.tangent.xyz));
    o.tangent.w = v.tangent.w * normal_from_object._44;  // a mirrored object turns its bitangents
    o.uv0 = v.uv0;
    o.uv1 = v.uv1;
    o.clip = mul(clip_from_relative, float4(o.position, 1.0));
    return o;
}

float4 pixel_main(Varyings v, bool front : SV_IsFrontFace) : SV_Target {
    // Screen derivatives in uniform control flow, before anything else; ddy points downward in Direct3D.
    SgMaterialInputs inputs = (SgMaterialInputs)0;
    inputs.position = v.position;
    inputs.position_dx = ddx_fine(v.position);
    inputs.position_dy = ddy_fine(v.position);
    inputs.normal = v.normal;
    inputs.tangent = v.tangent;
    inputs.facing = front ? 1.0 : -1.0;
    inputs.uv0 = v.uv0;
    inputs.uv0_dx = ddx_fine(v.uv0);
    inputs.uv0_dy = ddy_fine(v.uv0);
    inputs.uv1 = v.uv1;
    inputs.uv1_dx = ddx_fine(v.uv1);
    inputs.uv1_dy = ddy_fine(v.uv1);

    SgMaterialParameters_layered parameters;
    parameters.p_pebbles = pebbles;
    parameters.p_grain = grain;
    parameters.p_tint = tint;

    SgMaterialResult surface =
        sg_material_layered(inputs, parameters, ramp, pebble, weave, scratch, linear_repeat, scratch_sampler);
    if (surface.opacity < surface.cutoff) discard;

    // The engine's own lighting would stand here, with surface.base_color, .roughness and the rest.
    return float4(surface.normal, 1.0);
}
