// Derivatives straight from a height map. Source: Mikkelsen 2020, section 4.7.
#ifndef SG_HEIGHT_MAP
#define SG_HEIGHT_MAP

#include "surfgrad/uv.glsl"

// Where the smooth form under magnification fades into the mip chain: all of it at the first level, none at the second.
const float SG_HEIGHT_FADE_BEGIN = 0.05;
const float SG_HEIGHT_FADE_END = 0.5;

// Forward difference over one texel of a level of detail.
//   height: red is the height; st: normalised; level: of detail, values below 0 count as 0 (a step is never smaller
//   than a texel, so that magnification shows no facets).
// Result: (dH/du, dH/dv) per texel of level 0. Cost: 41 instructions, 3 texture reads among them. Source: Listing 16.
vec2 sg_deriv_from_height_level(texture2D height, sampler filtering, vec2 st, float level) {
    float used = max(level, 0.0);
    float texels = exp2(used);
    vec2 size = texels / vec2(textureSize(sampler2D(height, filtering), 0));
    float here = textureLod(sampler2D(height, filtering), st, used).x;
    float right = textureLod(sampler2D(height, filtering), st + vec2(size.x, 0.0), used).x;
    float below = textureLod(sampler2D(height, filtering), st + vec2(0.0, size.y), used).x;
    return vec2(right - here, below - here) / texels;
}

// The same at the level of detail that uv's derivatives ask for. Cost: 50 instructions, 3 texture reads among them.
// Source: Listing 16.
vec2 sg_deriv_from_height(texture2D height, sampler filtering, SgUv uv) {
    vec2 dim = vec2(textureSize(sampler2D(height, filtering), 0));
    return sg_deriv_from_height_level(height, filtering, uv.st, sg_uv_level(uv, dim));
}

// Sobel derivatives at the inner four of 4 x 4 heights, interpolated bilinearly.
//   row_0 to row_3: heights from the top, each from the left; t: 0..1 within the inner four, x right, y down.
// Result: (dH/du, dH/dv) per texel; exact for a height that is quadratic in u and in v; continuous across texels.
// Cost: 55 instructions. Source: Eq 20 and its counterpart for v.
vec2 sg_deriv_from_heights_4x4(vec4 row_0, vec4 row_1, vec4 row_2, vec4 row_3, vec2 t) {
    vec2 s = 1.0 - t;
    // The interpolated Sobel kernels, four times smoothing (1 2 1)/4 and twice difference (-1 0 1)/2; rows first.
    vec4 smooth_u = vec4(s.x, 1.0 + s.x, 1.0 + t.x, t.x);
    vec4 smooth_v = vec4(s.y, 1.0 + s.y, 1.0 + t.y, t.y);
    vec4 smoothed = smooth_v.x * row_0 + smooth_v.y * row_1 + smooth_v.z * row_2 + smooth_v.w * row_3;
    vec4 stepped = s.y * (row_2 - row_0) + t.y * (row_3 - row_1);
    return 0.125 * vec2(s.x * (smoothed.z - smoothed.x) + t.x * (smoothed.w - smoothed.y), dot(smooth_u, stepped));
}

// The smooth derivative under magnification, from 4 x 4 texels of level 0.
//   height: red is the height; st: normalised.
// Result: as above. Every gather aims at the middle of its four texels, half a texel from any choice of them, so that
// rounding of st cannot move it. Cost: 95 instructions, 4 gathers among them. Source: Listing 16, second half.
vec2 sg_deriv_from_height_smooth(texture2D height, sampler filtering, vec2 st) {
    vec2 dim = vec2(textureSize(sampler2D(height, filtering), 0));
    vec2 position = st * dim - 0.5;
    vec2 corner = floor(position);
    vec2 far_corner = (corner + 2.0) / dim;
    vec2 near_corner = corner / dim;
    vec4 upper_left = textureGather(sampler2D(height, filtering), near_corner);
    vec4 upper_right = textureGather(sampler2D(height, filtering), vec2(far_corner.x, near_corner.y));
    vec4 lower_left = textureGather(sampler2D(height, filtering), vec2(near_corner.x, far_corner.y));
    vec4 lower_right = textureGather(sampler2D(height, filtering), far_corner);
    // A gather holds its texels from the lower left counter-clockwise: w z above, x y below.
    return sg_deriv_from_heights_4x4(vec4(upper_left.wz, upper_right.wz), vec4(upper_left.xy, upper_right.xy),
                                     vec4(lower_left.wz, lower_right.wz), vec4(lower_left.xy, lower_right.xy),
                                     position - corner);
}

// How much of the smooth form a level of detail takes: 1 up to SG_HEIGHT_FADE_BEGIN, 0 from SG_HEIGHT_FADE_END.
//   level: not clamped. Result: 0..1, continuous. Cost: 2 instructions. Source: Listing 16.
float sg_height_smooth_weight(float level) {
    return clamp((SG_HEIGHT_FADE_END - level) / (SG_HEIGHT_FADE_END - SG_HEIGHT_FADE_BEGIN), 0.0, 1.0);
}

// The derivative of a height map in high quality: smooth under magnification, by mip levels else.
//   height: red is the height; uv: with derivatives.
// Result: (dH/du, dH/dv) per texel of level 0, continuous in st and in the footprint.
// Cost: 131 instructions, 3 texture reads and up to 4 gathers among them. Source: Listing 16.
vec2 sg_deriv_from_height_hq(texture2D height, sampler filtering, SgUv uv) {
    vec2 dim = vec2(textureSize(sampler2D(height, filtering), 0));
    float level = sg_uv_level(uv, dim);
    float weight = sg_height_smooth_weight(level);
    vec2 d = sg_deriv_from_height_level(height, filtering, uv.st, level);
    if (weight > 0.0) d = mix(d, sg_deriv_from_height_smooth(height, filtering, uv.st), weight);
    return d;
}

#endif
