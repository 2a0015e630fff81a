// A texture coordinate with its screen derivatives, so that it can be sampled anywhere, also in branches.
// Source: Mikkelsen 2020, section 3.7 (derivatives taken once, passed on).
#ifndef SG_UV
#define SG_UV

struct SgUv {
    vec2 st;  // normalised, origin at the upper left texel corner, t grows downward
    vec2 dx;  // d(st)/dx per pixel to the right
    vec2 dy;  // d(st)/dy per pixel downward
};

// Tiling.
//   uv: any; scale: repeats of the texture per unit; negative values mirror. Result: derivatives scale alike.
// Cost: 9 instructions. Source: section 3.7.
SgUv sg_uv_scale(SgUv uv, vec2 scale) { return SgUv(uv.st * scale, uv.dx * scale, uv.dy * scale); }

// Tiling, then a turn about the origin, then an offset: st' = R (scale st) + offset.
//   scale: as in sg_uv_scale; rotation: radians, turns +s towards +t; offset: in units of the new coordinate.
// Result: derivatives follow by the chain rule. Cost: 30 instructions. Source: glTF KHR_texture_transform.
SgUv sg_uv_transform(SgUv uv, vec2 scale, float rotation, vec2 offset) {
    float c = cos(rotation);
    float s = sin(rotation);
    mat2 turn = mat2(c, s, -s, c);
    SgUv tiled = sg_uv_scale(uv, scale);
    return SgUv(turn * tiled.st + offset, turn * tiled.dx, turn * tiled.dy);
}

// The isotropic level of detail at which a pixel is one texel large.
//   uv: with derivatives; dim: texels per unit at level 0. Result: below 0 under magnification, -40 where the
//   coordinate does not change. Cost: 13 instructions. Source: the level rule of Vulkan and OpenGL.
float sg_uv_level(SgUv uv, vec2 dim) {
    vec2 across = dim * uv.dx;
    vec2 down = dim * uv.dy;
    return 0.5 * log2(max(max(dot(across, across), dot(down, down)), 1e-24));
}

// Texels of a texture at level 0.
//   image, filtering: any. Result: the dim of the functions that ask for one.
//   Cost: 16 instructions, one query among them. Source: Listing 6 (dim).
vec2 sg_texture_size(texture2D image, sampler filtering) { return vec2(textureSize(sampler2D(image, filtering), 0)); }

#endif
