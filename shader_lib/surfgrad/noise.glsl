// Noise on a volume with analytic gradients: improved Perlin noise, sums of its octaves, and a power of either.
// Sources: Perlin 2002 (the permutation, the twelve gradients, the fade curve); Perlin 1985 (the sums);
// Mikkelsen 2020, sections 3.6 and 4.6. The gradient is a volume gradient: project it before a resolve.
#ifndef SG_NOISE
#define SG_NOISE

struct SgNoise {
    float value;    // a height; scale it together with the gradient
    vec3 gradient;  // d(value)/d(p), in the space of p
};

const float SG_NOISE_MAX_SLOPE = 128.0;  // of f^k near f = 0

// From a word that holds three neighbours of the permutation, P[2j], P[2j + 1], P[2j + 2], lowest byte first: P[i] in
// bits 0-7 and P[i + 1] in bits 8-15, for i = 2j or 2j + 1. Cost: 6 instructions. Source: Perlin 2002, the permutation.
uint sg_perlin_pair(uint word, uint i) { return word >> (8u * (i & 1u)); }

// One corner of a cell: xyz its gradient, w the height of its ramp at `offset` from it.
//   hash: the low four bits choose one of sixteen directions to the edges of a cube, whose x, y and z stand here as
//   two bits each, the first one's topmost: as a float's sign and highest bit of the exponent they are -2, 0 or 2.
// Result: twice the gradient and twice the height. Cost: 13 instructions. Source: Perlin 2002, the twelve gradients.
vec4 sg_perlin_corner(uint hash, vec3 offset) {
    uvec3 directions = uvec3(0x7777004cu, 0x5f007777u, 0x005f5f13u);
    vec3 gradient = uintBitsToFloat(directions << (2u * hash & 31u) & 0xc0000000u);
    return vec4(gradient, dot(gradient, offset));
}

// Improved Perlin noise and its gradient.
//   p: any space, cells of size 1, within 2^31; precise while |p| < 2^23 resolves fractions of a cell.
// Result: value in -1..1, zero at integer p; gradient is the exact derivative, continuous, |gradient| < 4; both repeat
// after 256 cells along each axis; negative p is nothing special. Infinite or NaN p gives NaN, which a resolve rejects.
// Cost: 256 instructions, seven of them table reads. Source: Perlin 2002.
SgNoise sg_noise_perlin(vec3 p) {
    // A local, for a constant global would be copied anew at every lookup by what compiles GLSL.
    uint words[128] = uint[128](
        0x89a097u, 0x5a5b89u, 0x830f5au, 0xc90d83u, 0x605fc9u, 0xc23560u, 0x07e9c2u, 0x8ce107u, 0x67248cu, 0x451e67u,
        0x088e45u, 0x256308u, 0x15f025u, 0x170a15u, 0x06be17u, 0xf79406u, 0xea78f7u, 0x004beau, 0xc51a00u, 0x5e3ec5u,
        0xdbfc5eu, 0x75cbdbu, 0x0b2375u, 0x39200bu, 0x21b139u, 0xed5821u, 0x3895edu, 0xae5738u, 0x7d14aeu, 0xab887du,
        0x44a8abu, 0x4aaf44u, 0x47a54au, 0x8b8647u, 0x1b308bu, 0x4da61bu, 0x9e924du, 0x53e79eu, 0xe56f53u, 0x3c7ae5u,
        0x85d33cu, 0xdce685u, 0x5c69dcu, 0x37295cu, 0xf52e37u, 0xf428f5u, 0x8f66f4u, 0x41368fu, 0x3f1941u, 0x01a13fu,
        0x50d801u, 0xd14950u, 0x844cd1u, 0xd0bb84u, 0x1259d0u, 0xc8a912u, 0x87c4c8u, 0x748287u, 0x9fbc74u, 0xa4569fu,
        0x6d64a4u, 0xadc66du, 0x03baadu, 0x344003u, 0xe2d934u, 0x7cfae2u, 0x057b7cu, 0x26ca05u, 0x769326u, 0xff7e76u,
        0x5552ffu, 0xcfd455u, 0x3bcecfu, 0x2fe33bu, 0x3a102fu, 0xb6113au, 0x1cbdb6u, 0xdf2a1cu, 0xaab7dfu, 0x77d5aau,
        0x98f877u, 0x2c0298u, 0xa39a2cu, 0xdd46a3u, 0x6599ddu, 0xa79b65u, 0xac2ba7u, 0x8109acu, 0x271681u, 0x13fd27u,
        0x6c6213u, 0x4f6e6cu, 0xe0714fu, 0xb2e8e0u, 0x70b9b2u, 0xda6870u, 0x61f6dau, 0xfbe461u, 0xf222fbu, 0xeec1f2u,
        0x90d2eeu, 0xbf0c90u, 0xa2b3bfu, 0x51f1a2u, 0x913351u, 0xf9eb91u, 0xef0ef9u, 0x316befu, 0xd6c031u, 0xb51fd6u,
        0x6ac7b5u, 0xb89d6au, 0xcc54b8u, 0x73b0ccu, 0x327973u, 0x7f2d32u, 0x96047fu, 0x8afe96u, 0xcdec8au, 0xde5dcdu,
        0x4372deu, 0x181d43u, 0xf34818u, 0x808df3u, 0x4ec380u, 0xd7424eu, 0x9c3dd7u, 0x97b49cu);
    vec3 cell = floor(p);
    vec3 f = p - cell, g = f - 1.0;
    uvec3 i = uvec3(ivec3(cell)) & 255u;
    uint h = sg_perlin_pair(words[i.x >> 1u & 127u], i.x);
    uvec2 y = uvec2(h, h >> 8u) + i.y & 255u;
    uint h0 = sg_perlin_pair(words[y.x >> 1u], y.x), h1 = sg_perlin_pair(words[y.y >> 1u], y.y);
    uvec4 z = uvec4(h0, h0 >> 8u, h1, h1 >> 8u) + i.z & 255u;
    uint h00 = sg_perlin_pair(words[z.x >> 1u], z.x), h01 = sg_perlin_pair(words[z.y >> 1u], z.y);
    uint h10 = sg_perlin_pair(words[z.z >> 1u], z.z), h11 = sg_perlin_pair(words[z.w >> 1u], z.w);
    // Along z (a pair is two corners), then y, then x; w carries the value, xyz the interpolated gradient.
    vec3 fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec4 c00 = sg_perlin_corner(h00, f), dz00 = sg_perlin_corner(h00 >> 8u, vec3(f.xy, g.z)) - c00;
    vec4 c01 = sg_perlin_corner(h01, vec3(f.x, g.y, f.z)), dz01 = sg_perlin_corner(h01 >> 8u, vec3(f.x, g.yz)) - c01;
    vec4 c10 = sg_perlin_corner(h10, vec3(g.x, f.yz)), dz10 = sg_perlin_corner(h10 >> 8u, vec3(g.x, f.y, g.z)) - c10;
    vec4 c11 = sg_perlin_corner(h11, vec3(g.xy, f.z)), dz11 = sg_perlin_corner(h11 >> 8u, g) - c11;
    vec4 c0 = c00 + fade.z * dz00, dy0 = c01 + fade.z * dz01 - c0;
    vec4 c1 = c10 + fade.z * dz10, dy1 = c11 + fade.z * dz11 - c1;
    vec4 c = c0 + fade.y * dy0, dx = c1 + fade.y * dy1 - c;
    vec4 sum = c + fade.x * dx;
    // The change of the weights adds to the change of the ramps.
    float dz0 = dz00.w + fade.y * (dz01.w - dz00.w), dz1 = dz10.w + fade.y * (dz11.w - dz10.w);
    vec3 across = vec3(dx.w, dy0.w + fade.x * (dy1.w - dy0.w), dz0 + fade.x * (dz1 - dz0));
    vec3 slope = f * g;
    // Half of all, for the corners are twice what they stand for.
    return SgNoise(0.5 * sum.w, 0.5 * sum.xyz + 15.0 * slope * slope * across);
}

// How much of an octave remains: 1 while a pixel covers at most half a cell, 0 from one cell on, smooth between.
//   footprint: of the pixel, in cells of the octave, >= 0. Cost: 4 instructions.
//   Source: Perlin 1985, octaves end at the size of a pixel.
float sg_octave_weight(float footprint) { return 1.0 - smoothstep(0.5, 1.0, footprint); }

// Perlin's fractal sum: the octaves n(2^i p) / 2^i.
//   p: cells of size 1 in the first octave; footprint: of the pixel in the space of p, >= 0 (sg_footprint);
//   octaves: 0 to 20.
// Result: |value| < 2; gradient exact (every octave adds as much slope as the first); octaves smaller than the
// footprint are gone, and for a footprint of one cell or NaN the sum is 0.
// Cost: 293 instructions, nearly all of them once per visible octave. Source: Perlin 1985, fractal sum; section 3.6.
SgNoise sg_noise_fractal_sum(vec3 p, float footprint, int octaves) {
    SgNoise sum = SgNoise(0.0, vec3(0.0));
    float frequency = 1.0;
    for (int i = 0; i < octaves && frequency * footprint < 1.0; ++i) {
        float weight = sg_octave_weight(frequency * footprint);
        SgNoise octave = sg_noise_perlin(frequency * p);
        sum.value += weight / frequency * octave.value;
        sum.gradient += weight * octave.gradient;
        frequency *= 2.0;
    }
    return sum;
}

// Perlin's turbulence: the octaves |n(2^i p)| / 2^i. Arguments as sg_noise_fractal_sum.
// Cost: 297 instructions, nearly all of them once per visible octave. Source: Perlin 1985, turbulence; section 4.6.
// Result: 0 <= value < 2; the gradient is exact but on the zeros of an octave, where the value has a corner and that
// octave adds nothing. One evaluation: differences would take four and drown in rounding at fine steps.
SgNoise sg_noise_turbulence(vec3 p, float footprint, int octaves) {
    SgNoise sum = SgNoise(0.0, vec3(0.0));
    float frequency = 1.0;
    for (int i = 0; i < octaves && frequency * footprint < 1.0; ++i) {
        float weight = sg_octave_weight(frequency * footprint);
        SgNoise octave = sg_noise_perlin(frequency * p);
        sum.value += weight / frequency * abs(octave.value);
        sum.gradient += weight * sign(octave.value) * octave.gradient;
        frequency *= 2.0;
    }
    return sum;
}

// f^k of a noise f ("dented"), by the chain rule k f^(k-1) grad f.
//   f: clamped at 0 from below; k: >= 0 (1 changes nothing but the clamp).
// Result: value >= 0; where f <= 0 all is 0; the slope k f^(k-1), infinite at 0 for k < 1, stays within
// SG_NOISE_MAX_SLOPE.
// Cost: 17 instructions, one power among them. Source: Mikkelsen 2020, section 4.6 (Upstill's dented shader).
SgNoise sg_noise_power(SgNoise f, float k) {
    bool positive = f.value > 0.0;
    float base = max(f.value, 1e-30);
    float below = pow(base, k - 1.0);
    float slope = positive ? min(k * below, SG_NOISE_MAX_SLOPE) : 0.0;
    return SgNoise(positive ? base * below : 0.0, slope * f.gradient);
}

#endif
