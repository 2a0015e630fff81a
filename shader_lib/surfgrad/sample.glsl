// Reading a texture with explicit gradients: legal in branches, loops and every shader stage.
// Source: Mikkelsen 2020, section 4.3 (the level of detail is chosen by the caller).
#ifndef SG_SAMPLE
#define SG_SAMPLE

#include "surfgrad/uv.glsl"

// The filtered texel at uv; the level of detail follows from uv.dx and uv.dy.
//   image, filtering: any; uv: with derivatives. Result: the four channels as stored.
//   Cost: 8 instructions, one texture read among them. Source: section 4.3.
vec4 sg_sample(texture2D image, sampler filtering, SgUv uv) {
    return textureGrad(sampler2D(image, filtering), uv.st, uv.dx, uv.dy);
}

#endif
