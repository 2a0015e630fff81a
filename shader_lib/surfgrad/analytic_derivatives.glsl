// Screen derivatives of the position without derivative instructions: after parallax and in deferred passes, where
// neighbouring pixels do not lie on one surface. Source: Mikkelsen 2020, Listing 10. Derived anew as follows:
//
// A pixel's step to the right at constant depth moves the point by M[0].xyz - M[0].w P over the homogeneous weight (M
// from screen to space; P the point). Sliding that along the view ray back onto the tangent plane gives dP/dx. The
// weight is one over clip w, so nothing is divided by a small square, at any distance; and as P itself is given, the
// pixel's coordinates are not needed.
#ifndef SG_ANALYTIC_DERIVATIVES
#define SG_ANALYTIC_DERIVATIVES

#include "surfgrad/frame.glsl"

// Below this cosine between normal and ray the angle is the rounding of two unit vectors (1e-7) to a percent.
const float SG_EDGE_ON_COSINE = 1e-5;

struct SgScreenDerivatives {
    vec3 dpdx;  // change of position per pixel to the right, world units
    vec3 dpdy;  // change of position per pixel downward, world units
};

// The normal of the plane that the pixel shows: n itself, or, where interpolation made n face away, its mirror image
// that faces the viewer.
//   n: unit; view: unit, towards the viewer. Result: unit, dot(result, view) >= 0. Cost: 8 instructions.
//   Source: section 3.7.
vec3 sg_facing_normal(vec3 n, vec3 view) { return n - 2.0 * min(dot(n, view), 0.0) * view; }

// dP/dx and dP/dy of the tangent plane under a pixel.
//   position: relative world space; n: unit normal of the plane, facing the viewer (sg_facing_normal);
//   view: unit, towards the viewer: normalize(-position), or constant for an orthographic camera;
//   relative_from_screen: (x px, y px, depth, 1) to homogeneous relative world space; clip_w: of `position`, from the
//   matrix whose inverse relative_from_screen holds (orthographic: 1).
// Result: perpendicular to n within rounding of their length; finite for every finite input (edge-on: at most 1e5 times
// the pixel's size). Any depth range, infinite or reversed, either direction of y. Cost: 41 instructions.
// Source: Listing 10.
SgScreenDerivatives sg_analytic_derivatives(vec3 position, vec3 n, vec3 view, mat4 relative_from_screen, float clip_w) {
    vec3 across = clip_w * (relative_from_screen[0].xyz - relative_from_screen[0].w * position);
    vec3 down = clip_w * (relative_from_screen[1].xyz - relative_from_screen[1].w * position);
    vec3 slide = view / max(dot(n, view), SG_EDGE_ON_COSINE);
    return SgScreenDerivatives(across - dot(n, across) * slide, down - dot(n, down) * slide);
}

// The frame of a surface that parallax moved.
//   position: the moved point, relative world space; n: its unit normal; facing: +1, or -1 where n points away because
//   the back of a "flip" surface is seen; view: unit, towards the viewer; relative_from_screen: as above;
//   clip_from_relative: its inverse up to the viewport.
// Result: a whole frame; dpdx and dpdy analytic; flip_sign of n, however far that faces away. Cost: 82 instructions.
// Source: sections 3.7 and 4.6.
SgFrame sg_frame_rebuilt(vec3 position, vec3 n, float facing, vec3 view, mat4 relative_from_screen,
                         mat4 clip_from_relative) {
    float clip_w = (clip_from_relative * vec4(position, 1.0)).w;
    vec3 plane = sg_facing_normal(facing * n, view);
    SgScreenDerivatives d = sg_analytic_derivatives(position, plane, view, relative_from_screen, clip_w);
    float sign_dp = dot(n, cross(d.dpdx, d.dpdy)) < 0.0 ? -1.0 : 1.0;
    return SgFrame(position, n, d.dpdx, d.dpdy, sg_reject(d.dpdx, n), sg_reject(d.dpdy, n), sign_dp);
}

#endif
