// A Metal engine's shaders that ask a material for its surface.
//   surfgradc compile materials/layered.json -o out --entry function --target msl23
//   xcrun metal -I out compiler/examples/metal.metal
#include <metal_stdlib>
#include "layered.function.msl23.metal"

using namespace metal;

struct Camera {
    float4x4 clip_from_relative;
};

struct Object {
    float4x4 relative_from_object;
    float4x4 normal_from_object;  // inverse transpose of the first; [3][3]: the sign of its determinant
};

struct Vertex {
    float3 position [[attribute(0)]];
    float3 normal [[attribute(1)]];
    float4 tangent [[attribute(2)]];
    float2 uv0 [[attribute(4)]];
    float2 uv1 [[attribute(5)]];
};

struct Varyings {
    float4 clip [[position]];
    float3 position [[user(locn0)]];
    float3 normal [[user(locn1)]];
    float4 tangent [[user(locn2)]];
    float2 uv0 [[user(locn3)]];
    float2 uv1 [[user(locn4)]];
};

vertex Varyings vertex_main(Vertex in [[stage_in]], constant Camera& camera [[buffer(0)]],
                            constant Object& object [[buffer(2)]]) {
    Varyings out;
    out.position = (object.relative_from_object * float4(in.position, 1.0)).xyz;
    out.normal = normalize((object.normal_from_object * float4(in.normal, 0.0)).xyz);
    float3 tangent = normalize((object.relative_from_object * float4(in.tangent.xyz, 0.0)).xyz);
    out.tangent = float4(tangent, in.tangent.w * object.normal_from_object[3].w);  // mirrored: bitangents turn
    out.uv0 = in.uv0;
    out.uv1 = in.uv1;
    out.clip = camera.clip_from_relative * float4(out.position, 1.0);
    return out;
}

// The engine fills SgMaterialParameters_layered by its members: Metal aligns a float3 to 16 bytes and makes it as
// long, which std140, and so the manifest's offsets, does not.
fragment float4 fragment_main(Varyings in [[stage_in]], constant SgMaterialParameters_layered& layered [[buffer(1)]],
                              texture2d<float> ramp [[texture(0)]], texture2d<float> pebble [[texture(1)]],
                              texture2d<float> weave [[texture(2)]], texture2d<float> scratch [[texture(3)]],
                              sampler linear_repeat [[sampler(0)]], sampler scratch_sampler [[sampler(1)]],
                              bool front [[front_facing]]) {
    // Screen derivatives in uniform control flow, before anything else; dfdy points downward in Metal.
    SgMaterialInputs inputs = {};
    inputs.position = in.position;
    inputs.position_dx = dfdx(in.position);
    inputs.position_dy = dfdy(in.position);
    inputs.normal = in.normal;
    inputs.tangent = in.tangent;
    inputs.facing = front ? 1.0 : -1.0;
    inputs.uv0 = in.uv0;
    inputs.uv0_dx = dfdx(in.uv0);
    inputs.uv0_dy = dfdy(in.uv0);
    inputs.uv1 = in.uv1;
    inputs.uv1_dx = dfdx(in.uv1);
    inputs.uv1_dy = dfdy(in.uv1);

    SgMaterialParameters_layered parameters = layered;  // from the constant address space to the thread's
    SgMaterialResult surface = sg_material_layered(inputs, parameters, ramp, pebble, weave, scratch,
                                                   linear_repeat, scratch_sampler);
    if (surface.opacity < surface.cutoff) discard_fragment();

    // The engine's own lighting would stand here, with surface.base_color, .roughness and the rest.
    return float4(surface.normal, 1.0);
}
