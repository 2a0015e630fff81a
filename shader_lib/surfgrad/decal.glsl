// Decals: an image thrown into the scene by a projector, as a bump on a volume. Source: Mikkelsen 2020, section 4.5,
// Listing 15. Decals add up as volume gradients, in shading space, and are projected onto the surface once.
//
// The projector's space: a matrix takes positions there.
// Box: -1..1 along each axis, image upright to +x (s) and +y (t),
// thrown along +z. Cone: apex at the origin, axis +z to z = 1, where it has the radius 1. Sphere: radius 1 about the
// origin. Capsule: all within 1 of the z axis between -h and h. Wedge: edge on the y axis, |x| <= z <= 1, |y| <= 1.
#ifndef SG_DECAL
#define SG_DECAL

#include "surfgrad/uv.glsl"

// Where a decal's image is looked up, and how its derivative becomes a gradient.
struct SgDecal {
    vec3 local;   // the position in the projector's space; for a sphere also the direction into a cube map
    SgUv uv;      // st with screen derivatives from the tangent plane: no bright edges at silhouettes
    vec3 grad_s;  // gradient of s, shading space, textures per world unit
    vec3 grad_t;  // gradient of t
};

// The row of a matrix's linear part. Cost: 17 instructions (none where the row is constant). Source: Listing 15.
vec3 sg_decal_row(mat4 projector, int row) { return vec3(projector[0][row], projector[1][row], projector[2][row]); }

// A decal from its coordinate and the gradients of that.
//   local, st, grad_s, grad_t: as in SgDecal; dpdx, dpdy: screen derivatives of the position (of the frame; after
//   parallax the analytic ones).
// Result: uv.dx and uv.dy by the chain rule, with no neighbouring pixel involved. Cost: 18 instructions.
// Source: section 4.5, the chain rule.
SgDecal sg_decal_from_gradients(vec3 local, vec2 st, vec3 grad_s, vec3 grad_t, vec3 dpdx, vec3 dpdy) {
    vec2 dx = vec2(dot(grad_s, dpdx), dot(grad_t, dpdx));
    vec2 dy = vec2(dot(grad_s, dpdy), dot(grad_t, dpdy));
    return SgDecal(local, SgUv(st, dx, dy), grad_s, grad_t);
}

// Parallel projection along the box's z axis (also of capsules and wedges).
//   projector: projector space from shading space, affine; position, dpdx, dpdy: shading space.
// Result: st 0..1 over the box's face. Cost: 40 instructions. Source: section 4.5.
SgDecal sg_decal_box(mat4 projector, vec3 position, vec3 dpdx, vec3 dpdy) {
    vec3 local = (projector * vec4(position, 1.0)).xyz;
    vec3 row_s = sg_decal_row(projector, 0), row_t = sg_decal_row(projector, 1);
    vec2 dx = 0.5 * vec2(dot(row_s, dpdx), dot(row_t, dpdx));
    vec2 dy = 0.5 * vec2(dot(row_s, dpdy), dot(row_t, dpdy));
    return SgDecal(local, SgUv(0.5 + 0.5 * local.xy, dx, dy), 0.5 * row_s, 0.5 * row_t);
}

// Central projection of the plane that lies `ahead` before a point, seen along `ray` from it.
//   local: passed on; ray = (along s, along t, ahead) in projector space, and the gradients of the three.
// Result: st 0..1 over the square |s|, |t| <= ahead; where nothing lies ahead the middle of the image and no gradient.
// Cost: 49 instructions. Source: the quotient rule.
SgDecal sg_decal_central(vec3 local, vec3 ray, vec3 row_s, vec3 row_t, vec3 row_ahead, vec3 dpdx, vec3 dpdy) {
    bool before = ray.z > 1e-6;
    float inverse_ahead = before ? 0.5 / ray.z : 0.0;
    vec2 slope = before ? ray.xy / ray.z : vec2(0.0);
    vec3 grad_s = inverse_ahead * (row_s - slope.x * row_ahead);
    vec3 grad_t = inverse_ahead * (row_t - slope.y * row_ahead);
    return sg_decal_from_gradients(local, 0.5 + 0.5 * slope, grad_s, grad_t, dpdx, dpdy);
}

// Central projection from the cone's apex along +z. Arguments as sg_decal_box.
// Result: st 0..1 over the square around the cone; at and behind the apex st = 0.5 and no gradient, finite.
// Cost: 58 instructions. Source: section 4.5, with the quotient rule.
SgDecal sg_decal_cone(mat4 projector, vec3 position, vec3 dpdx, vec3 dpdy) {
    vec3 local = (projector * vec4(position, 1.0)).xyz;
    return sg_decal_central(local, local, sg_decal_row(projector, 0), sg_decal_row(projector, 1),
                            sg_decal_row(projector, 2), dpdx, dpdy);
}

// Central projection from a sphere's centre onto the faces of a cube around it.
//   Arguments as sg_decal_box.
// Result: local is the direction for a cube map (its derivatives are the matrix's linear part times dpdx, dpdy); uv,
// grad_s and grad_t are those of the face that Vulkan's cube map rules choose, t downward; at the centre no gradient,
// finite.
// Cost: 106 instructions. Source: section 4.5; Vulkan 1.1, cube map face selection.
SgDecal sg_decal_sphere(mat4 projector, vec3 position, vec3 dpdx, vec3 dpdy) {
    vec3 local = (projector * vec4(position, 1.0)).xyz;
    vec3 size = abs(local);
    bool on_z = size.z >= size.x && size.z >= size.y;
    bool on_y = !on_z && size.y >= size.x;
    float side = (on_z ? local.z : (on_y ? local.y : local.x)) < 0.0 ? -1.0 : 1.0;
    vec3 x = sg_decal_row(projector, 0), y = sg_decal_row(projector, 1), z = sg_decal_row(projector, 2);
    // +x: (-z, -y), -x: (z, -y), +y: (x, z), -y: (x, -z), +z: (x, -y), -z: (-x, -y).
    vec3 ray = on_z ? vec3(side * local.x, -local.y, size.z)
                    : (on_y ? vec3(local.x, side * local.z, size.y) : vec3(-side * local.z, -local.y, size.x));
    vec3 row_s = on_z ? side * x : (on_y ? x : -side * z);
    vec3 row_t = on_y ? side * z : -y;
    vec3 row_ahead = side * (on_z ? z : (on_y ? y : x));
    return sg_decal_central(local, ray, row_s, row_t, row_ahead, dpdx, dpdy);
}

// The part of a decal's strength at a distance from the middle of its shape.
//   reach: 0 in the middle, 1 on the surface of the shape; edge: 0..1, the share over which it fades.
// Result: 0..1, smooth, 0 from the surface outward. Cost: 7 instructions. Source: section 4.5, note 2.
float sg_decal_fade(float reach, float edge) {
    float t = clamp((1.0 - reach) / max(edge, 1e-6), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// The strengths of the shapes in projector space. local: of SgDecal, numbers; edge: 0..1.
// Result of each: 0..1, 0 outside the shape. Cost: 9 instructions. Source: section 4.5, note 2.
float sg_decal_falloff_box(vec3 local, float edge) {
    vec3 size = abs(local);
    return sg_decal_fade(max(max(size.x, size.y), size.z), edge);
}
// As above; 0 at and behind the apex. Cost: 21 instructions. Source: section 4.5, note 2.
float sg_decal_falloff_cone(vec3 local, float edge) {
    bool before = local.z > 1e-6;
    float side = before ? length(local.xy) / local.z : 1.0;
    return side < 1.0 ? sg_decal_fade(max(side, local.z), edge) : 0.0;
}
// As above; 1 in the centre. Cost: 12 instructions. Source: section 4.5, note 2.
float sg_decal_falloff_sphere(vec3 local, float edge) { return sg_decal_fade(length(local), edge); }
// As above; half_length: of the capsule's axis, >= 0, in projector space. Cost: 15 instructions.
// Source: section 4.5, note 2.
float sg_decal_falloff_capsule(vec3 local, float half_length, float edge) {
    float beyond = abs(local.z) < half_length ? 0.0 : abs(local.z) - half_length;
    return sg_decal_fade(length(vec3(local.xy, beyond)), edge);
}
// As above; 0 at and behind the edge. Cost: 20 instructions. Source: section 4.5, note 2.
float sg_decal_falloff_wedge(vec3 local, float edge) {
    bool before = local.z > 1e-6;
    float side = before ? abs(local.x) / local.z : 1.0;
    bool inside = side < 1.0 && abs(local.y) < 1.0;
    return inside ? sg_decal_fade(max(max(side, abs(local.y)), local.z), edge) : 0.0;
}

// Fading by the angle between the surface and the projector.
//   n: unit normal; towards: unit, from the surface to the projector; cos_full, cos_none: cosines of the angles up to
//   which all and from which nothing shows, cos_full >= cos_none.
// Result: 0..1; 0 for NaN. Cost: 13 instructions. Source: section 4.5.
float sg_decal_angle_fade(vec3 n, vec3 towards, float cos_full, float cos_none) {
    float facing = dot(n, towards);
    float t = clamp((facing - cos_none) / max(cos_full - cos_none, 1e-6), 0.0, 1.0);
    return facing > cos_none ? t : 0.0;
}

// The volume gradient of a decal's bump in true size.
//   d: derivative of the image per texel, green down; decal: of the lookup; dim: texels of the image; height: world
//   units that one texel's height means.
// Result: shading space; linear in d; perpendicular to the ray of projection. Cost: 16 instructions.
// Source: Listing 15.
vec3 sg_decal_gradient_scaled(vec2 d, SgDecal decal, vec2 dim, float height) {
    vec2 per_texture = height * dim * d;
    return per_texture.x * decal.grad_s + per_texture.y * decal.grad_t;
}

// The volume gradient of a decal's bump with a strength that does not depend on the projector's size ("TBN style").
//   d: derivative of the image, green down; decal: of the lookup.
// Result: shading space; linear in d; d along unit directions; 0 where the decal has no gradient.
// Cost: 22 instructions. Source: Listing 15.
vec3 sg_decal_gradient(vec2 d, SgDecal decal) {
    vec2 per_unit = d * inversesqrt(max(vec2(dot(decal.grad_s, decal.grad_s), dot(decal.grad_t, decal.grad_t)), 1e-30));
    return per_unit.x * decal.grad_s + per_unit.y * decal.grad_t;
}

// The same where the directions are known: of a box, the rows of its matrix at unit length, the same for every pixel.
//   d: as above; axis_s, axis_t: unit, shading space, the directions of the gradients of s and t.
// Result: shading space; linear in d. Cost: 10 instructions. Source: Listing 15.
vec3 sg_decal_gradient_along(vec2 d, vec3 axis_s, vec3 axis_t) { return d.x * axis_s + d.y * axis_t; }

// One more decal on top of a sum of volume gradients: both bumps show.
//   sum, gradient: shading space; alpha: >= 0 (the image's times the falloff).
// Result: independent of the order; sum itself for alpha = 0, whatever gradient holds. Cost: 9 instructions.
// Source: section 4.5.
vec3 sg_decal_add(vec3 sum, vec3 gradient, float alpha) { return alpha > 0.0 ? sum + alpha * gradient : sum; }

// One more decal that covers what is below it. Arguments as sg_decal_add, alpha 0..1.
// Result: sum for alpha = 0, gradient for alpha = 1 (whatever the other holds), mixed between. Cost: 16 instructions.
// Source: section 4.5.
vec3 sg_decal_mask(vec3 sum, vec3 gradient, float alpha) {
    vec3 mixed = alpha > 0.0 ? mix(sum, gradient, alpha) : sum;
    return alpha >= 1.0 ? gradient : mixed;
}

#endif
