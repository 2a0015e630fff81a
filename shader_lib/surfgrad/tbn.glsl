// Surface gradients from a tangent frame ("TBN style": the strength does not depend on tiling or object size).
// Source: Mikkelsen 2020, sections 3.2 and 3.3.
#ifndef SG_TBN
#define SG_TBN

#include "surfgrad/frame.glsl"
#include "surfgrad/uv.glsl"

struct SgBasis {
    vec3 tangent;    // towards +s
    vec3 bitangent;  // towards +t
};

// T and B from vertex attributes, mikkTSpace-compliant: raw interpolated vectors, all scaled by 1/|N|, so that the
// resolve equals normalize(m.x T + m.y B + m.z N).
//   vertex_normal: interpolated, not normalised; vertex_tangent: interpolated xyz, w > 0 means B = +cross(N, T).
// Result: T and B need not be unit nor perpendicular to n. A zero or not-a-number normal, and one longer than
// 1e15, gives T = B = 0; an endless one what is not a number.
// Cost: 26 instructions. Source: Listing 9.
SgBasis sg_basis_vertex(vec3 vertex_normal, vec4 vertex_tangent) {
    float square = dot(vertex_normal, vertex_normal);
    float scale = square > 1e-30 && square < 1e30 ? inversesqrt(square) : 0.0;
    float side = vertex_tangent.w < 0.0 ? -scale : scale;
    return SgBasis(scale * vertex_tangent.xyz, side * cross(vertex_normal, vertex_tangent.xyz));
}

// T and B from the screen derivatives of any texture coordinate.
//   frame: of the surface; uv: st with derivatives.
// Result: orthonormal, perpendicular to frame.normal, T towards +s and B towards +t whatever the mirroring; T = B = 0
// (no bump) where the coordinates are degenerate, |det| <= 1e-6 times the largest components of dx and dy, or the step
// along s is: without length, or within 0.06 degrees of the normal, where rounding would decide its direction.
// Cost: 51 instructions. Source: Listing 4.
SgBasis sg_basis_uv(SgFrame frame, SgUv uv) {
    float det = uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x;
    // The inverse Jacobian's first column (dx/ds, dy/ds), times det. Projected last: it may be the rest of a large
    // difference, and T has to be perpendicular to n.
    vec3 step_s = uv.dy.y * frame.dpdx - uv.dx.y * frame.dpdy;
    float lean = dot(step_s, frame.normal);
    vec3 along_s = step_s - lean * frame.normal;
    float square = dot(along_s, along_s);
    float largest = max(abs(uv.dx.x), abs(uv.dx.y)) * max(abs(uv.dy.x), abs(uv.dy.y));
    bool usable = square > 1e-6 * lean * lean + 1e-36 && abs(det) > 1e-6 * largest;
    float scale = usable ? inversesqrt(square) : 0.0;
    vec3 tangent = (det < 0.0 ? -scale : scale) * along_s;
    vec3 bitangent = (det < 0.0 ? -frame.flip_sign : frame.flip_sign) * cross(frame.normal, tangent);
    return SgBasis(tangent, bitangent);
}

// A basis that is tangent to a new normal: vertex T and B after a resolve.
//   basis: of the surface before; n: the resolved normal, unit.
// Result: orthonormal and perpendicular to n; T keeps its direction on the surface, B its side; T = B = 0 where T is 0
// or within 0.06 degrees of n. Cost: 44 instructions. Source: section 4.6; Listing 4's last line.
SgBasis sg_basis_resolved(SgBasis basis, vec3 n) {
    vec3 along_s = sg_reject(basis.tangent, n);
    float square = dot(along_s, along_s);
    bool usable = square > 1e-6 * dot(basis.tangent, basis.tangent) && square > 1e-30 && square < 1e30;
    vec3 tangent = usable ? along_s * inversesqrt(square) : vec3(0.0);
    vec3 across = cross(n, tangent);
    vec3 bitangent = dot(across, basis.bitangent) < 0.0 ? -across : across;
    return SgBasis(tangent, usable ? bitangent : vec3(0.0));
}

// The basis of a coordinate that is scaled by `scale`: positive factors change nothing, negative ones turn a vector.
//   basis: of the unscaled coordinate. Result: vectors of the same length. Cost: 17 instructions.
//   Source: Listing 4's signs.
SgBasis sg_basis_mirror(SgBasis basis, vec2 scale) {
    return SgBasis(scale.x < 0.0 ? -basis.tangent : basis.tangent,
                   scale.y < 0.0 ? -basis.bitangent : basis.bitangent);
}

// The surface gradient of a derivative in a tangent frame.
//   d: within 128; basis: T towards +s, B towards +t.
// Result: linear in d; |dot(result, n)| <= |d| |dot(T, n)|, so within rounding of 0 for all but vertex bases.
// Cost: 10 instructions. Source: Eq 17, Listing 3.
vec3 sg_surfgrad_from_tbn(vec2 d, SgBasis basis) { return d.x * basis.tangent + d.y * basis.bitangent; }

#endif
