// Parallax: where on a displaced surface the eye looks. Sources: Mikkelsen 2020, section 4.3, Listings 11 and 12;
// Welsh 2004; Brawley and Tatarchuk 2005; Lengyel 2019, section 7.7. The directions towards the viewer are parameters:
// normalize(-position) for a perspective camera, a constant for an orthographic one.
//
// Heights: a texel v means that the surface lies bias + scale * v along n, in world units: `heights` = (scale, bias),
// where scale = strength and bias = -strength * zero_level (1 carves below the mesh; 1/2 for parallax maps).
#ifndef SG_PARALLAX
#define SG_PARALLAX

#include "surfgrad/frame.glsl"
#include "surfgrad/uv.glsl"

// Below this cosine (1.8 degrees above the horizon) a ray is taken to rise as one of this cosine.
const float SG_PARALLAX_MIN_COSINE = 0.03125;

struct SgParallax {
    vec2 offset;   // of st
    float height;  // of the surface there above the mesh, world units along n
};

// A direction in texture space.
//   frame: of the mesh; uv: its coordinate; direction: shading space, any length (towards the viewer: unit).
// Result: xy: change of st along the direction's part in the plane of (dpdx, dpdy); z: its part along n. Linear in
// direction; true to sheared and stretched coordinates. Edge-on, where dpdx and dpdy span no area, xy = 0.
// Cost: 45 instructions. Source: Listing 11.
vec3 sg_parallax_direction(SgFrame frame, SgUv uv, vec3 direction) {
    vec3 level = cross(frame.normal, direction);
    vec2 screen = sg_frame_inverse_area(frame) * vec2(dot(frame.dpdy, level), -dot(frame.dpdx, level));
    return vec3(uv.dx * screen.x + uv.dy * screen.y, dot(frame.normal, direction));
}

// One step with limited offset.
//   view: of sg_parallax_direction, towards the viewer; height: bias + scale * texel, world units.
// Result: offset of st, at most |height| times the stretch of the coordinate. Cost: 2 instructions.
// Source: Welsh 2004, section 4.3 (no division by view.z).
vec2 sg_parallax_offset(vec3 view, float height) { return height * view.xy; }

// What k steps with a parallax map multiply the unit tangent-space view by.
//   scale: the height of value 1 in texels, as the map was made with; steps: k >= 1; dim: texels of the map.
// Result: s / (2 k r), per axis. Cost: 9 instructions. Source: Lengyel, Eq 7.52.
vec2 sg_parallax_scale(float scale, int steps, vec2 dim) { return scale / (2.0 * float(max(steps, 1)) * dim); }

// k steps with a parallax map, which stores n_z (2h - 1) so that each step goes to the tangent plane of the surface
// found.
//   map: red; decode: signed value = decode.x * texel + decode.y ((1, 0) for signed formats, (2, -1) for unsigned);
//   uv: of the mesh; stride: offset of st for the value 1, per step: view.xy times sg_parallax_scale, or
//   view.xy * strength / (2 k) with view of sg_parallax_direction; steps: k, 0 to 64.
// Result: offset of st, at most steps * |stride|.
// Cost: 29 instructions, one texture read and 4 instructions of them once per step.
// Source: Lengyel, Eq 7.48 to 7.51, Listing 7.9.
vec2 sg_parallax_steps(texture2D map, sampler filtering, vec2 decode, SgUv uv, vec2 stride, int steps) {
    vec2 offset = vec2(0.0);
    for (int i = 0; i < steps; ++i) {
        float texel = textureGrad(sampler2D(map, filtering), uv.st + offset, uv.dx, uv.dy).x;
        offset += (decode.x * texel + decode.y) * stride;
    }
    return offset;
}

// The height above the mesh at a coordinate. heights: (scale, bias); level: of detail.
// Cost: 6 instructions, one texture read among them. Source: section 4.3.
float sg_parallax_height(texture2D map, sampler filtering, vec2 heights, vec2 st, float level) {
    return heights.y + heights.x * textureLod(sampler2D(map, filtering), st, level).x;
}

// The first point of the displaced surface along the ray from the eye.
//   map: red is the height; heights: above; st: of the mesh; view: of sg_parallax_direction, towards the viewer;
//   level: of detail, taken before the offset (sg_uv_level of the mesh's coordinate); steps: 1 to 256.
// Result: offset of st and height of the hit, refined linearly between the last two steps; a view at or below the
// horizon counts as SG_PARALLAX_MIN_COSINE above it; without a hit (NaN texels) the bottom. Finite for finite
// arguments.
// Cost: 50 instructions, one texture read and about 8 instructions of them once per step.
// Source: Brawley and Tatarchuk 2005; Listing 11.
SgParallax sg_parallax_occlusion(texture2D map, sampler filtering, vec2 heights, vec2 st, vec3 view, float level,
                                 int steps) {
    vec2 per_height = view.xy / max(view.z, SG_PARALLAX_MIN_COSINE);
    float top = heights.y + max(heights.x, 0.0);
    float drop = abs(heights.x) / float(max(steps, 1));
    float ray = top;
    float gap = 1e30;  // before the first look: what lies above the top is taken at the top
    float gap_before = gap;
    // Written so that a height that is not a number counts as not yet reached.
    for (int i = 0; i <= steps && !(gap <= 0.0); ++i) {
        gap_before = gap;
        ray = top - float(i) * drop;
        gap = ray - sg_parallax_height(map, filtering, heights, st + ray * per_height, level);
    }
    // The gap is taken as linear over the last step: it ends `back` of a step before ray.
    float back = gap < 0.0 ? clamp(gap / (gap - gap_before), 0.0, 1.0) : 0.0;
    float height = ray + back * drop;
    return SgParallax(height * per_height, height);
}

// How many pixels away the mesh has the coordinate that an offset leads to.
//   uv: of the mesh; offset: of st.
//   Result: (right, down) in pixels; linear in offset; 0 where the coordinate is degenerate
//   (|det| <= 1e-6 times the largest components of dx and dy). Cost: 17 instructions. Source: Listing 12, first half.
vec2 sg_parallax_pixels(SgUv uv, vec2 offset) {
    float det = uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x;
    float largest = max(abs(uv.dx.x), abs(uv.dx.y)) * max(abs(uv.dy.x), abs(uv.dy.y));
    float scale = abs(det) > 1e-6 * largest ? 1.0 / det : 0.0;
    return scale * vec2(uv.dy.y * offset.x - uv.dy.x * offset.y, uv.dx.x * offset.y - uv.dx.y * offset.x);
}

// The corrected position.
//   frame: of the mesh; pixels: of sg_parallax_pixels; height: along n, world units.
// Result: shading space; moving by st along the mesh and by height along n. Cost: 16 instructions. Source: Listing 12.
vec3 sg_parallax_position(SgFrame frame, vec2 pixels, float height) {
    return frame.position + pixels.x * frame.sigma_x + pixels.y * frame.sigma_y + height * frame.normal;
}

// The base normal at the corrected position of a curved mesh.
//   n: unit; dndx, dndy: its screen derivatives; pixels: of sg_parallax_pixels.
// Result: unit; n itself where the correction leaves nothing to normalise.
// Cost: 23 instructions. Source: section 4.3.
vec3 sg_parallax_normal(vec3 n, vec3 dndx, vec3 dndy, vec2 pixels) {
    vec3 moved = n + pixels.x * dndx + pixels.y * dndy;
    float square = dot(moved, moved);
    bool usable = square > 1e-6 && square < 1e30;
    return usable ? moved * inversesqrt(square) : n;
}

// The coordinate for the mesh's other images: moved, its derivatives as they were.
//   uv: of the mesh; offset: of st. Result: neighbouring pixels' hits take no part.
//   Cost: 5 instructions. Source: section 4.3.
SgUv sg_parallax_uv(SgUv uv, vec2 offset) { return SgUv(uv.st + offset, uv.dx, uv.dy); }

// The coordinate for detail on the moved surface: any uv set, with the level of detail that the surface has there.
//   frame, uv: of the mesh, uv of the wanted set; pixels: of sg_parallax_pixels (of the set that was marched);
//   dpdx, dpdy: of the moved surface, analytic, its steps measured along the mesh.
// Result: st by the same way over the mesh, dx and dy by the chain rule. Cost: 68 instructions.
// Source: sections 3.7 and 4.6.
SgUv sg_parallax_detail_uv(SgFrame frame, SgUv uv, vec2 pixels, vec3 dpdx, vec3 dpdy) {
    vec2 st = uv.st + pixels.x * uv.dx + pixels.y * uv.dy;
    return SgUv(st, sg_parallax_direction(frame, uv, dpdx).xy, sg_parallax_direction(frame, uv, dpdy).xy);
}

#endif
