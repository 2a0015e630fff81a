// A plain Vulkan engine's fragment shader that asks a material for its surface.
//   surfgradc compile materials/layered.json -o out --entry function --target spirv
//   glslangValidator -V -Iout compiler/examples/vulkan.frag
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layered.function.spirv.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 0) out vec4 out_normal;

// In std140 the members lie as the manifest's parameter_block says. Bindings are the engine's own affair.
layout(set = 1, binding = 0) uniform Material { SgMaterialParameters_layered layered; } material;
layout(set = 1, binding = 1) uniform texture2D ramp;
layout(set = 1, binding = 2) uniform texture2D pebble;
layout(set = 1, binding = 3) uniform texture2D weave;
layout(set = 1, binding = 4) uniform texture2D scratch;
layout(set = 1, binding = 5) uniform sampler linear_repeat;
layout(set = 1, binding = 6) uniform sampler scratch_sampler;

void main() {
    // Screen derivatives in uniform control flow, before anything else. What the material does not read stays unset.
    SgMaterialInputs inputs;
    inputs.position = position;
    inputs.position_dx = dFdxFine(position);
    inputs.position_dy = dFdyFine(position);
    inputs.normal = normal;
    inputs.tangent = tangent;
    inputs.facing = gl_FrontFacing ? 1.0 : -1.0;
    inputs.uv0 = uv0;
    inputs.uv0_dx = dFdxFine(uv0);
    inputs.uv0_dy = dFdyFine(uv0);
    inputs.uv1 = uv1;
    inputs.uv1_dx = dFdxFine(uv1);
    inputs.uv1_dy = dFdyFine(uv1);

    SgMaterialResult surface = sg_material_layered(inputs, material.layered, ramp, pebble, weave, scratch,
                                                   linear_repeat, scratch_sampler);
    if (surface.opacity < surface.cutoff) discard;

    // The engine's own lighting would stand here, with surface.base_color, .roughness and the rest.
    out_normal = vec4(surface.normal, 1.0);
}
