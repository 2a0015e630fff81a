// Tangent-space normals and derivatives. The derivative d = (dH/du, dH/dv) is always taken along +s and +t (t grows
// downward), u and v in texels. Source: Mikkelsen 2020, section 3.1.
#ifndef SG_DERIV
#define SG_DERIV

const float SG_MAX_SLOPE = 128.0;  // 89.55 degrees; every derivative stays within it (Listing 2)

// A stored texel to a signed value.
//   texel: 0..1 as sampled; zero: the 8-bit code that means 0 (127.5, 128 or 127).
// Result: -1..1, clamped where the zero does not lie in the middle: 127.5: v/127.5 - 1; 128: (v - 128)/127;
// 127: (v - 127)/127. A texel outside 0..1 is not clamped at 127.5. Cost: 16 instructions. Source: section 3.1.
vec2 sg_decode_signed(vec2 texel, float zero) {
    return zero == 127.5 ? 2.0 * texel - 1.0 : clamp((255.0 * texel - zero) / min(zero, 255.0 - zero), -1.0, 1.0);
}
vec3 sg_decode_signed(vec3 texel, float zero) {
    return zero == 127.5 ? 2.0 * texel - 1.0 : clamp((255.0 * texel - zero) / min(zero, 255.0 - zero), -1.0, 1.0);
}

// The derivative of a tangent-space normal (x, y, z), green down.
//   m: any length, in -1..1; a negative z counts as |z|; (0, 0, 0) is flat.
// Result: each component within SG_MAX_SLOPE. Cost: 6 instructions. Source: Eq 15, Listing 2.
vec2 sg_deriv_from_normal_xyz(vec3 m) {
    vec3 magnitude = abs(m);
    float z = max(max(magnitude.z, max(magnitude.x, magnitude.y) / SG_MAX_SLOPE), 1e-30);
    return -m.xy / z;
}

// The derivative of a tangent-space normal of which x and y are stored (BC5), green down.
//   m: in -1..1 after the remap; over-long vectors are taken as steepest.
// Result: each component within SG_MAX_SLOPE. Cost: 8 instructions. Source: Eq 16, with the guard at 1/128^2.
vec2 sg_deriv_from_normal_xy(vec2 m) {
    return -m * inversesqrt(max(1.0 - dot(m, m), 1.0 / (SG_MAX_SLOPE * SG_MAX_SLOPE)));
}

// From green up to green down: the only place where the vertical direction is turned.
//   d: a derivative. Result: d with its second component negated. Cost: 2 instructions. Source: section 3.1.
vec2 sg_deriv_green_up(vec2 d) { return vec2(d.x, -d.y); }

// The tangent-space normal of a derivative, green down: the inverse of sg_deriv_from_normal_xyz.
//   d: each component within SG_MAX_SLOPE. Result: unit, z > 0. Cost: 4 instructions. Source: Eq 12.
vec3 sg_normal_from_deriv(vec2 d) { return normalize(vec3(-d, 1.0)); }

// A derivative that any later step can bear, as before it is stored in 16 bits.
//   d: anything. Result: each component within SG_MAX_SLOPE; what is not a number counts as flat.
// Cost: 8 instructions. Source: Listing 2's limit.
vec2 sg_deriv_clamped(vec2 d) {
    // The comparison is false for not-a-number, and only then (0 takes the other branch).
    bvec2 number = greaterThanEqual(abs(d), vec2(0.0));
    return vec2(number.x ? clamp(d.x, -SG_MAX_SLOPE, SG_MAX_SLOPE) : 0.0,
                number.y ? clamp(d.y, -SG_MAX_SLOPE, SG_MAX_SLOPE) : 0.0);
}

// The derivative that a derivative map holds.
//   value: the decoded texel, -1..1; range: the slope that 1 stands for, above 0.
// Result: each component within SG_MAX_SLOPE. Cost: 9 instructions. Source: section 3.1 (a map of Eq 15).
vec2 sg_deriv_from_map(vec2 value, float range) { return sg_deriv_clamped(value * range); }

// What a derivative map holds for a derivative: the inverse of sg_deriv_from_map within its range.
//   d: a derivative; range: the slope that 1 stands for, above 0. Result: -1..1. Cost: 5 instructions.
//   Source: section 3.1 (a map of Eq 15).
vec2 sg_map_from_deriv(vec2 d, float range) { return clamp(d / range, -1.0, 1.0); }

#endif
