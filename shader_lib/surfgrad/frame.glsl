// The surface frame: what every producer of a surface gradient needs to know about the surface under a pixel.
// Source: Mikkelsen 2020, section 3.7. A frame is a value: a later resolve makes a new one, never changes one.
#ifndef SG_FRAME
#define SG_FRAME

struct SgFrame {
    vec3 position;    // shading space (world axes, relative to the camera), world units
    vec3 normal;      // unit base normal n, towards the side that is shaded
    vec3 dpdx;        // dP/dx: change of position per pixel to the right
    vec3 dpdy;        // dP/dy: change of position per pixel downward
    vec3 sigma_x;     // dpdx without its part along n
    vec3 sigma_y;     // dpdy without its part along n
    float flip_sign;  // +1 if (dpdx, dpdy, n) is right-handed, else -1
};

struct SgNormalDerivatives {
    vec3 dndx;  // change of the unit base normal per pixel to the right
    vec3 dndy;  // per pixel downward
};

// The part of v perpendicular to n.
//   v: any; n: unit, same space. Result: |dot(result, n)| within rounding of |v|. Cost: 7 instructions. Source: Eq 6.
vec3 sg_reject(vec3 v, vec3 n) { return v - dot(v, n) * n; }

// A whole frame from the position, any two screen derivatives of it and the unit normal.
//   position, dpdx, dpdy: one shading space, world units, of the surface before displacement; n: unit.
// Result: sigma_x and sigma_y are perpendicular to n; flip_sign is -1 or +1, also for NaN.
// Cost: 34 instructions. Source: Listing 9.
SgFrame sg_frame(vec3 position, vec3 dpdx, vec3 dpdy, vec3 n) {
    float sign_dp = dot(n, cross(dpdx, dpdy)) < 0.0 ? -1.0 : 1.0;
    return SgFrame(position, n, dpdx, dpdy, sg_reject(dpdx, n), sg_reject(dpdy, n), sign_dp);
}

// One over the signed area of the tangent plane that a pixel covers.
//   frame: dpdx and dpdy before displacement. Result: 1 / dot(n, cross(dpdx, dpdy)); 0 where the pixel's footprint has
//   no area (|area| <= 1e-5 times the largest components of both). Cost: 20 instructions. Source: Listing 6.
float sg_frame_inverse_area(SgFrame frame) {
    float area = dot(frame.normal, cross(frame.dpdx, frame.dpdy));
    vec3 across = abs(frame.dpdx), down = abs(frame.dpdy);
    float largest = max(max(across.x, across.y), across.z) * max(max(down.x, down.y), down.z);
    return abs(area) > 1e-5 * largest ? 1.0 / area : 0.0;
}

// The frame for bump mapping on top of a resolved normal, where the surface did not move (no parallax).
//   frame: of the surface that was resolved; n: the resolved normal, unit.
// Result: a new frame with the same position, dpdx, dpdy and geometric flip_sign; sigma is perpendicular to n.
// Cost: 21 instructions. Source: sections 3.7 and 4.6.
SgFrame sg_frame_resolved(SgFrame frame, vec3 n) {
    return SgFrame(frame.position, n, frame.dpdx, frame.dpdy, sg_reject(frame.dpdx, n), sg_reject(frame.dpdy, n),
                   frame.flip_sign);
}

// The unit base normal from the interpolated, unnormalised vertex normal.
//   vertex_normal: any length from 1e-15 to 1e15.
// Result: unit for every input: a zero, endless or not-a-number vector gives (0, 0, 1). Cost: 15 instructions.
// Source: Listing 9.
vec3 sg_base_normal(vec3 vertex_normal) {
    float square = dot(vertex_normal, vertex_normal);
    bool usable = square > 1e-30 && square < 1e30;
    return usable ? vertex_normal * inversesqrt(square) : vec3(0.0, 0.0, 1.0);
}

// The base normal of a two-sided surface in "mirror" mode: n alone is negated on the back, after T and B were formed.
//   n: unit; facing: +1 on the front, -1 on the back. Result: unit. Cost: 3 instructions. Source: Listing 9.
vec3 sg_mirror_normal(vec3 n, float facing) { return facing * n; }

#endif
