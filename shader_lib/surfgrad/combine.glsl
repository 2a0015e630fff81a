// Putting bumps together: surface gradients of one frame, and tangent-space normals of one uv set.
// Source: Mikkelsen 2020, Eq 13 to 14, Table 1, Eq 18; Lengyel, Foundations of Game Engine Development 2, 7.46 and 7.47.
#ifndef SG_COMBINE
#define SG_COMBINE

#include "surfgrad/deriv.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/resolve.glsl"

// The sum of two bumps.
//   a, b: surface gradients of one frame. Result: commutative, associative up to rounding. Cost: 4 instructions.
//   Source: Eq 14.
vec3 sg_combine_add(vec3 a, vec3 b) { return a + b; }

// A bump of another strength.
//   g: surface gradient; strength: any, negative inverts the bump. Result: linear. Cost: 3 instructions. Source: Eq 14.
vec3 sg_combine_scale(vec3 g, float strength) { return strength * g; }

// A bump under a mask.
//   g: surface gradient; mask: 0..1, values outside count as the nearer end. Result: mask * g; exactly 0 where the mask
//   is 0 (or not a number), even if g is endless or not a number there. Cost: 8 instructions. Source: Eq 13 and 14.
vec3 sg_combine_mask(vec3 g, float mask) { return mask > 0.0 ? min(mask, 1.0) * g : vec3(0.0); }

// From one bump to another.
//   a, b: surface gradients of one frame; t: 0..1, values outside count as the nearer end.
// Result: linear between; exactly a at 0 and b at 1, whatever the other is there. Cost: 17 instructions.
// Source: Eq 13 and 14.
vec3 sg_combine_mix(vec3 a, vec3 b, float t) {
    vec3 between = a * (1.0 - t) + b * t;
    vec3 upper = t < 1.0 ? between : b;
    return t > 0.0 ? upper : a;
}

// Two derivatives, each to be given to its own producer of a surface gradient and the results added.
struct SgDerivPair {
    vec2 first;
    vec2 second;
};

// "Partial derivatives": the sum of the bumps of two tangent-space normals.
//   a, b: any length, z > 0. Result: unit; commutative. Cost: 18 instructions. Source: section 4.2.
vec3 sg_combine_pd(vec3 a, vec3 b) {
    return sg_normal_from_deriv(sg_deriv_from_normal_xyz(a) + sg_deriv_from_normal_xyz(b));
}

// "Whiteout": normalize(a.x + b.x, a.y + b.y, a.z b.z), as two derivatives that may belong to two uv sets.
//   a, b: unit, z > 0. Result: each component within 128. Cost: 17 instructions. Source: Table 1.
SgDerivPair sg_combine_whiteout(vec3 a, vec3 b) {
    float z = a.z * b.z;
    return SgDerivPair(sg_deriv_from_normal_xyz(vec3(a.xy, z)), sg_deriv_from_normal_xyz(vec3(b.xy, z)));
}

// "UDN": normalize(a.x + b.x, a.y + b.y, a.z), as two derivatives that may belong to two uv sets.
//   a, b: unit, z > 0; b flattens where a is steep. Result: each component within 128. Cost: 16 instructions.
//   Source: Table 1.
SgDerivPair sg_combine_udn(vec3 a, vec3 b) {
    return SgDerivPair(sg_deriv_from_normal_xyz(a), sg_deriv_from_normal_xyz(vec3(b.xy, a.z)));
}

// "Reoriented normal mapping": b turned by the rotation that takes (0, 0, 1) to a. Two maps on one uv set.
//   a, b: unit; a.z < 0 counts as |a.z|. Result: unit; may face inward where both are steep. Cost: 11 instructions.
//   Source: Eq 18.
vec3 sg_combine_rnm(vec3 a, vec3 b) {
    vec3 t = vec3(a.xy, abs(a.z) + 1.0);
    vec3 u = vec3(-b.xy, b.z);
    return t * (dot(t, u) / t.z) - u;
}

// "Reoriented normal mapping" of two bumps that share no tangent space: b turned by the shortest rotation that takes n
// to the normal that a resolves to.
//   n: unit base normal; a, b: surface gradients of n, of any uv sets.
// Result: surface gradient, perpendicular to n, |g| <= 128; a where b is 0, b where a is 0; not commutative. A normal
// that the rotation turns inward counts as its mirror image in front, as in sg_surfgrad_from_normal. Cost: 51 instructions.
// Source: Eq 18 (Barre-Brisebois and Hill 2012), with n in place of (0, 0, 1).
vec3 sg_combine_reoriented(vec3 n, vec3 a, vec3 b) {
    vec3 t = n + sg_resolve(n, a);
    vec3 u = n + b;  // n - b turned by half a turn about n
    return sg_surfgrad_from_normal(n, t * (dot(t, u) / max(dot(t, n), 1e-6)) - u);
}

// The normal of the weighted sum of two heights.
//   a, b: any length, z > 0; weights: of a and b, any. Result: unit, z > 0. Cost: 23 instructions.
//   Source: Lengyel 7.46.
vec3 sg_combine_weighted(vec3 a, vec3 b, vec2 weights) {
    return sg_normal_from_deriv(weights.x * sg_deriv_from_normal_xyz(a) + weights.y * sg_deriv_from_normal_xyz(b));
}

// The normal of the sum of two heights, without a division.
//   a, b: any length; z >= 0. Result: unit, z >= 0; (0, 0, 1) where both are exactly level. Cost: 17 instructions.
//   Source: Lengyel 7.47.
vec3 sg_combine_additive(vec3 a, vec3 b) {
    vec3 sum = vec3(b.z * a.xy + a.z * b.xy, a.z * b.z);
    float square = dot(sum, sum);
    return square > 1e-30 ? sum * inversesqrt(square) : vec3(0.0, 0.0, 1.0);
}

#endif
