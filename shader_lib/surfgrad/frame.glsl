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

// The part of v perpendicular to the unit vector n.
vec3 sg_reject(vec3 v, vec3 n) { return v - dot(v, n) * n; }

// A whole frame from the position, any two screen derivatives of it and the unit normal.
//   position, dpdx, dpdy: one shading space, world units; n: unit.
// Result: sigma_x and sigma_y are perpendicular to n; flip_sign is -1 or +1, also for NaN.
// Cost: about 20 instructions. Source: Listing 9.
SgFrame sg_frame(vec3 position, vec3 dpdx, vec3 dpdy, vec3 n) {
    float sign_dp = dot(dpdy, cross(n, dpdx)) < 0.0 ? -1.0 : 1.0;
    return SgFrame(position, n, dpdx, dpdy, sg_reject(dpdx, n), sg_reject(dpdy, n), sign_dp);
}

// The unit base normal from the interpolated, unnormalised vertex normal.
//   vertex_normal: any length; a zero (or NaN) vector gives (0, 0, 1), so that the result is always unit.
vec3 sg_base_normal(vec3 vertex_normal) {
    float square = dot(vertex_normal, vertex_normal);
    return square > 1e-30 ? vertex_normal * inversesqrt(square) : vec3(0.0, 0.0, 1.0);
}

// The frame of a two-sided surface in "mirror" mode: n alone is negated on the back, after T and B were formed.
//   facing: +1 on the front, -1 on the back.
vec3 sg_mirror_normal(vec3 n, float facing) { return facing * n; }

#endif
