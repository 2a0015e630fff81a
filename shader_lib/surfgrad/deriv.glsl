// Tangent-space normals and derivatives. The derivative d = (dH/du, dH/dv) is always taken along +s and +t (t grows
// downward), u and v in texels. Source: Mikkelsen 2020, section 3.1.
#ifndef SG_DERIV
#define SG_DERIV

const float SG_MAX_SLOPE = 128.0;  // 89.55 degrees; every derivative stays within it (Listing 2)

// A stored texel to a signed value.
//   texel: 0..1 as sampled; zero: the 8-bit code that means 0 (127.5, 128 or 127).
// Result: -1..1, clamped. 127.5: v/127.5 - 1; 128: (v - 128)/127; 127: (v - 127)/127.
vec2 sg_decode_signed(vec2 texel, float zero) {
    return clamp((255.0 * texel - zero) / min(zero, 255.0 - zero), -1.0, 1.0);
}
vec3 sg_decode_signed(vec3 texel, float zero) {
    return clamp((255.0 * texel - zero) / min(zero, 255.0 - zero), -1.0, 1.0);
}

// The derivative of a tangent-space normal (x, y, z), green down.
//   m: any length, in -1..1; a negative z counts as |z|; (0, 0, 0) is flat.
// Result: each component within SG_MAX_SLOPE. Cost: about 8 instructions. Source: Eq 15, Listing 2.
vec2 sg_deriv_from_normal_xyz(vec3 m) {
    vec3 magnitude = abs(m);
    float z = max(magnitude.z, max(magnitude.x, magnitude.y) / SG_MAX_SLOPE);
    return z > 0.0 ? -m.xy / z : vec2(0.0);
}

// The derivative of a tangent-space normal of which x and y are stored (BC5), green down.
//   m: in -1..1 after the remap; over-long vectors are taken as steepest.
// Result: each component within SG_MAX_SLOPE. Source: Eq 16, with the guard at 1/128^2.
vec2 sg_deriv_from_normal_xy(vec2 m) {
    return -m * inversesqrt(max(1.0 - dot(m, m), 1.0 / (SG_MAX_SLOPE * SG_MAX_SLOPE)));
}

// From green up to green down: the only place where the vertical direction is turned.
vec2 sg_deriv_green_up(vec2 d) { return vec2(d.x, -d.y); }

// The unit tangent-space normal of a derivative, green down: the inverse of sg_deriv_from_normal_xyz. Source: Eq 12.
vec3 sg_normal_from_deriv(vec2 d) { return normalize(vec3(-d, 1.0)); }

#endif
