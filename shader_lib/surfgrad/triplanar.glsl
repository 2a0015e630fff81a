// Three images projected along the axes, as one bump on a volume; one image along one axis is its special case.
// Source: Mikkelsen 2020, section 4.4, Eq 19, Listings 13 and 14. The gradients are volume gradients: project once.
//
// hand and origin choose the coordinates that are looked up, as texture tools know them:
//   hand: SG_RIGHT_HAND looks up x (-z, y), y (x, -z), z (x, y); SG_LEFT_HAND looks up x (z, y), y (x, z), z (x, y).
//   origin: SG_UPPER_LEFT turns each second coordinate round, so that images stand upright where t grows downward;
//   SG_LOWER_LEFT leaves it.
// Nothing is mirrored by the sign of the normal. The derivative d is always along +s and +t of the image.
#ifndef SG_TRIPLANAR
#define SG_TRIPLANAR

#include "surfgrad/uv.glsl"

const float SG_RIGHT_HAND = -1.0;  // the sign of z in the coordinates
const float SG_LEFT_HAND = 1.0;
const float SG_UPPER_LEFT = -1.0;  // the sign of the second coordinate
const float SG_LOWER_LEFT = 1.0;

struct SgTriplanarUv {
    SgUv x;  // looked up along the x axis, and so on
    SgUv y;
    SgUv z;
};

// How much of each plane's image shows.
//   n: unit normal in the space of the lookup (of a later stage: the resolved one); k: >= 0, the sharpness of the
//   transition, 0 shares equally among the planes within 78 degrees of facing.
// Result: 0..1 each, sum 1, continuous in n for k > 0; never 0/0, also for huge k, and (0, 0, 1) where n is
// zero. Cost: 29 instructions, three powers among them. Source: Listing 14.
vec3 sg_triplanar_weights(vec3 n, float k) {
    vec3 facing = max(abs(n) - 0.2, 0.0);
    // The largest becomes 1, which no power takes below the smallest number; a power above 0 leaves 0 as it is.
    vec3 ratio = facing / max(max(facing.x, facing.y), max(facing.z, 1e-30));
    vec3 w = pow(ratio, vec3(max(k, 1e-9)));
    w.z = max(w.z, 1e-30);
    return w / (w.x + w.y + w.z);
}

// The coordinates of the three lookups and their screen derivatives.
//   p, dpdx, dpdy: position in the space of the lookup and its screen derivatives, times the tiling; hand, origin:
//   above.
// Result: linear in p; nothing implicit, so that it is legal in branches.
// Cost: 18 instructions (8 where hand and origin are constant). Source: Eq 19.
SgTriplanarUv sg_triplanar_uv(vec3 p, vec3 dpdx, vec3 dpdy, float hand, float origin) {
    vec3 turn = vec3(1.0, origin, hand);
    vec2 along_y = vec2(1.0, origin * hand);
    vec3 q = turn * p, qx = turn * dpdx, qy = turn * dpdy;
    return SgTriplanarUv(SgUv(q.zy, qx.zy, qy.zy), SgUv(along_y * p.xz, along_y * dpdx.xz, along_y * dpdy.xz),
                         SgUv(q.xy, qx.xy, qy.xy));
}

// The volume gradient of the three images together.
//   weights: of sg_triplanar_weights; d_x, d_y, d_z: what each image's derivative is, per unit of p's space; hand,
//   origin: as in the lookup. A lookup with negative tiling needs d negated.
// Result: linear in every d; the same for all four hands and origins of one bump in space. Weights count as constant.
// Cost: 13 instructions (7 where hand and origin are constant). Source: Listing 13.
vec3 sg_triplanar_gradient(vec3 weights, vec2 d_x, vec2 d_y, vec2 d_z, float hand, float origin) {
    float wx = weights.x, wy = weights.y, wz = weights.z;
    return vec3(wz * d_z.x + wy * d_y.x, origin * (wz * d_z.y + wx * d_x.y), hand * (wx * d_x.x + origin * wy * d_y.y));
}

// One image projected along one axis: its coordinate.
//   axis: 0, 1 or 2; the rest as in sg_triplanar_uv. Result: the coordinate of that plane alone.
//   Cost: 27 instructions (5 where axis, hand and origin are constant). Source: Eq 19 with one weight.
SgUv sg_planar_uv(vec3 p, vec3 dpdx, vec3 dpdy, int axis, float hand, float origin) {
    SgTriplanarUv planes = sg_triplanar_uv(p, dpdx, dpdy, hand, origin);
    SgUv chosen = planes.z;
    if (axis == 0) chosen = planes.x;
    if (axis == 1) chosen = planes.y;
    return chosen;
}

// One image projected along one axis: its volume gradient.
//   d: of the image; axis, hand, origin: as in the lookup. Result: sg_triplanar_gradient with all weight on the axis.
//   Cost: 16 instructions (1 where axis, hand and origin are constant). Source: Listing 13.
vec3 sg_planar_gradient(vec2 d, int axis, float hand, float origin) {
    vec3 only = vec3(axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0);
    return sg_triplanar_gradient(only, d, d, d, hand, origin);
}

#endif
