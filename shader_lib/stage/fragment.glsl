// The fragment stage: the only file with screen derivatives and with gl_FrontFacing. Call these in uniform control
// flow, before any branch; everything else takes the results as parameters.
#ifndef SG_STAGE_FRAGMENT
#define SG_STAGE_FRAGMENT

#include "surfgrad/frame.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

// A texture coordinate with its derivatives over the screen.
SgUv sg_stage_uv(vec2 st) { return SgUv(st, dFdxFine(st), dFdyFine(st)); }

// The filtered texel at uv, whose derivatives are those of the neighbouring pixels: the hardware finds the level of
// detail itself, which is sg_sample's and costs less.
vec4 sg_stage_sample(texture2D image, sampler filtering, SgUv uv) {
    return texture(sampler2D(image, filtering), uv.st);
}

// A place in the space of a lookup with its derivatives over the screen.
SgVolume sg_stage_volume(vec3 p) { return SgVolume(p, dFdxFine(p), dFdyFine(p)); }

// The derivatives of the base normal over the screen. vertex_normal: as interpolated.
SgNormalDerivatives sg_stage_normal_derivatives(vec3 vertex_normal) {
    vec3 n = sg_base_normal(vertex_normal);
    return SgNormalDerivatives(dFdxFine(n), dFdyFine(n));
}

// The frame of the surface under this pixel. position: relative world space; n: unit.
SgFrame sg_stage_frame(vec3 position, vec3 n) {
    return sg_frame(position, dFdxFine(position), dFdyFine(position), n);
}

// +1 on front faces, -1 on back faces.
float sg_stage_facing() { return gl_FrontFacing ? 1.0 : -1.0; }

#endif
