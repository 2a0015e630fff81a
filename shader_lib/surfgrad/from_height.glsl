// Scale-dependent surface gradients from heights: the normal of the displaced surface. Tiling and object size count.
// Source: Mikkelsen 2020, section 3.5, Eq 7.
#ifndef SG_FROM_HEIGHT
#define SG_FROM_HEIGHT

#include "surfgrad/frame.glsl"
#include "surfgrad/uv.glsl"

// The surface gradient of a height from its change over the screen.
//   frame: dpdx and dpdy before displacement; dh: (dH/dx, dH/dy), world units per pixel.
// Result: g with dot(g, sigma_x) = dh.x, dot(g, sigma_y) = dh.y and dot(g, n) = 0; linear in dh; 0 where the pixel's
// footprint has no area (sg_frame_inverse_area). Cost: 38 instructions. Source: Listing 6, Eq 7.
vec3 sg_surfgrad_from_screen_height(SgFrame frame, vec2 dh) {
    // dh.x cross(sigma_y, n) + dh.y cross(n, sigma_x) as one product: perpendicular to n, however much the sum cancels.
    vec3 level = dh.x * frame.sigma_y - dh.y * frame.sigma_x;
    return sg_frame_inverse_area(frame) * cross(level, frame.normal);
}

// The change of a height over the screen from its derivative in the texture.
//   uv: the coordinate the derivative was read at; dim: texels of the texture; d: (dH/du, dH/dv) per texel.
// Result: (dH/dx, dH/dy) per pixel, linear in d. Cost: 10 instructions. Source: Listing 6, the chain rule.
vec2 sg_screen_height_from_deriv(SgUv uv, vec2 dim, vec2 d) {
    vec2 per_st = dim * d;
    return vec2(dot(per_st, uv.dx), dot(per_st, uv.dy));
}

// The surface gradient of a height map or normal map as displacement.
//   frame: dpdx and dpdy before displacement; uv, dim: as above; d: (dH/du, dH/dv), world units per texel.
// Result: perpendicular to n; linear in d; independent of resolution and distance. Cost: 47 instructions.
// Source: Listing 6.
vec3 sg_surfgrad_from_height(SgFrame frame, SgUv uv, vec2 dim, vec2 d) {
    return sg_surfgrad_from_screen_height(frame, sg_screen_height_from_deriv(uv, dim, d));
}

// The change of a height map over the screen, from three reads.
//   height: red is the height; uv: with derivatives. Result: (dH/dx, dH/dy) per pixel, in units of the texel value.
// Cost: 15 instructions, 3 texture reads among them. Source: Listing 7.
vec2 sg_screen_height_three_tap(texture2D height, sampler filtering, SgUv uv) {
    float here = textureGrad(sampler2D(height, filtering), uv.st, uv.dx, uv.dy).x;
    float right = textureGrad(sampler2D(height, filtering), uv.st + uv.dx, uv.dx, uv.dy).x;
    float below = textureGrad(sampler2D(height, filtering), uv.st + uv.dy, uv.dx, uv.dy).x;
    return vec2(right - here, below - here);
}

#endif
