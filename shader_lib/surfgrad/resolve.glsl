// From the sum of surface gradients to the bumped normal. Source: Mikkelsen 2020, Eq 5.
#ifndef SG_RESOLVE
#define SG_RESOLVE

#include "surfgrad/deriv.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/from_volume.glsl"

// n' = normalize(n - g).
//   n: unit; g: the sum of all surface gradients, perpendicular to n but for vertex tangents.
// Result: unit for every g but n itself, which gives 0; n where g is not a number or longer than 1e19;
// dot(result, n) >= 0 within rounding.
// Cost: 16 instructions. Source: Listing 1.
vec3 sg_resolve(vec3 n, vec3 g) {
    vec3 bumped = n - g;
    float square = dot(bumped, bumped);
    // False for not-a-number: then n.
    return square < 1e38 ? bumped * inversesqrt(max(square, 1e-37)) : n;
}

// The bumped normal of one tangent-space map on vertex tangents, at once: normalize(s m.x T + t m.y B + m.z
// N).
//   vertex_normal, vertex_tangent: as in sg_basis_vertex, the normal 1e-3 to 1e3 long; facing: +1, or -1 on
//   the back of a "mirror" surface; m: as in sg_deriv_from_normal_xyz; strength: of the bump along s and
//   along t, each within 1e6 (a negative t turns green up to green down).
// Result: sg_resolve of that map's surface gradient, with no division; facing * vertex_normal where m is not
// a number. Cost: 41 instructions. Source: section 3.2.
vec3 sg_resolve_vertex_map(vec3 vertex_normal, vec4 vertex_tangent, float facing, vec3 m, vec2 strength) {
    vec3 magnitude = abs(m);
    float z = max(max(magnitude.z, max(magnitude.x, magnitude.y) / SG_MAX_SLOPE), 1e-15);
    vec3 n = facing * vertex_normal;
    vec2 lean = strength * m.xy;
    vec3 bumped = z * n + lean.x * vertex_tangent.xyz +
                  (vertex_tangent.w < 0.0 ? -lean.y : lean.y) * cross(vertex_normal, vertex_tangent.xyz);
    float square = dot(bumped, bumped);
    bool number = square < 1e38;
    return number ? bumped * inversesqrt(max(square, 1e-37)) : n;
}

// n' of a volume bump at once: normalize((1 + dot(n, v)) n - v).
//   n: unit; gradient: v, as in sg_surfgrad_from_volume.
// Result: sg_resolve of that surface gradient; n where v is not a number or longer than 1e17. Cost: 21 instructions.
// Source: Listing 1, Listing 8.
vec3 sg_resolve_volume(vec3 n, vec3 gradient) {
    float largest = max(max(abs(gradient.x), abs(gradient.y)), abs(gradient.z));
    // Beyond the largest gradient n grows, instead of the gradient being cut.
    float rise = max(largest / SG_MAX_VOLUME_GRADIENT, 1.0);
    vec3 bumped = (rise + dot(n, gradient)) * n - gradient;
    float square = dot(bumped, bumped);  // at least rise^2
    // False for not-a-number: then n.
    return square < 1e38 ? bumped * inversesqrt(square) : n;
}

// Part of the way from one normal to another, measured along the surface gradient that leads there.
//   n, wanted: unit; part: 0 gives n, 1 gives wanted, any number.
// Result: sg_resolve of part times sg_surfgrad_from_normal(n, wanted). Cost: 23 instructions.
// Source: Listing 1, Listing 5.
vec3 sg_resolve_towards(vec3 n, vec3 wanted, float part) {
    float along = dot(n, wanted);
    // The length of the tilt, sqrt(1 - along^2), where the gradient is cut: there |along| < 1/128.
    float rise = max(abs(along), (1.0 - 0.5 * along * along) / SG_MAX_SURFGRAD);
    vec3 bumped = (rise - part * along) * n + part * wanted;
    return bumped * inversesqrt(dot(bumped, bumped));  // at least rise long
}

// "flip": the whole resolved normal turns with the side (glTF's rule).
//   resolved: unit; facing: +1 front, -1 back. Result: unit. Cost: 3 instructions.
//   Source: glTF 2.0, section 3.9.5 (double sided).
vec3 sg_flip(vec3 resolved, float facing) {
    return facing * resolved;
}

// The normal of the inverted bump -H, from the normal of H: its mirror image about n.
//   n, resolved: unit. Result: unit. Cost: 7 instructions. Source: end of section 3.
vec3 sg_invert(vec3 n, vec3 resolved) {
    return 2.0 * dot(n, resolved) * n - resolved;
}

#endif
