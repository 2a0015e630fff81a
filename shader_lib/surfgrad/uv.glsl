// A texture coordinate with its screen derivatives, so that it can be sampled anywhere, also in branches.
#ifndef SG_UV
#define SG_UV

struct SgUv {
    vec2 st;  // normalised, origin at the upper left texel corner, t grows downward
    vec2 dx;  // d(st)/dx per pixel to the right
    vec2 dy;  // d(st)/dy per pixel downward
};

// Tiling: `scale` repeats of the texture per unit; negative values mirror.
SgUv sg_uv_scale(SgUv uv, vec2 scale) { return SgUv(uv.st * scale, uv.dx * scale, uv.dy * scale); }

#endif
