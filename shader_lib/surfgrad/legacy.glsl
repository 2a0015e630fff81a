// What the method replaces, for comparison pictures and for porting old shaders. Sources: Perlin 1985; Geiss 2007;
// Mikkelsen 2020, Figures 4 to 6; Lengyel 2019, section 7.6; the shader workshop's fourth part.
#ifndef SG_LEGACY
#define SG_LEGACY

#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/triplanar.glsl"

// Perlin's perturbation: the whole volume gradient is taken from the normal, also the part along it.
//   n: unit; gradient: shading space. Result: unit, n where nothing is left; may point inward: the black spots of
//   Figure 4. Cost: 16 instructions. Source: Perlin 1985, with the sign that raises bumps.
vec3 sg_legacy_perlin_normal(vec3 n, vec3 gradient) { return sg_resolve(n, gradient); }

// Geiss' triplanar normal: the x and y of tangent-space normals instead of derivatives, and Perlin's perturbation.
//   n: unit; weights: of sg_triplanar_weights; m_x, m_y, m_z: tangent-space normals of the planes, green down; hand,
//   origin: as in the lookup. Result: unit; slopes end at 45 degrees: the flat hemispheres of Figure 5.
//   Cost: 28 instructions. Source: Geiss 2007; Figure 5, left.
vec3 sg_legacy_triplanar_normal(vec3 n, vec3 weights, vec3 m_x, vec3 m_y, vec3 m_z, float hand, float origin) {
    return sg_legacy_perlin_normal(n, sg_triplanar_gradient(weights, -m_x.xy, -m_y.xy, -m_z.xy, hand, origin));
}

// A decal that bumps its own direction, blended with the normal of the surface.
//   n: unit normal of the surface; axis_s, axis_t: unit, towards +s and +t; towards: unit, to the projector; d:
//   derivative, green down; alpha: 0..1. Result: unit, n for alpha = 0; ignores the surface for alpha = 1 (Figure 6,
//   middle).
//   Cost: 45 instructions. Source: section 4.5.
vec3 sg_legacy_decal_normal(vec3 n, vec3 axis_s, vec3 axis_t, vec3 towards, vec2 d, float alpha) {
    vec3 projected = sg_resolve(towards, d.x * axis_s + d.y * axis_t);
    return sg_resolve(n, alpha * (n - projected));
}

// The orthonormal matrix from tangent space: columns T, B, N.
//   normal, tangent.xyz: interpolated, any length; tangent.w < 0: B = -cross(N, T).
// Result: T and B are 0 where tangent is along normal; else orthonormal, determinant +-1. Cost: 43 instructions.
// Source: Lengyel, Eq 7.31, 7.38 and 7.40; Mikkelsen 2020, Eq 8.
mat3 sg_legacy_tbn(vec3 normal, vec4 tangent) {
    float square_n = dot(normal, normal);
    vec3 n = square_n > 1e-30 ? normal * inversesqrt(square_n) : vec3(0.0, 0.0, 1.0);
    vec3 along = sg_reject(tangent.xyz, n);
    float square_t = dot(along, along);
    vec3 t = square_t > 1e-12 * dot(tangent.xyz, tangent.xyz) ? along * inversesqrt(square_t) : vec3(0.0);
    return mat3(t, (tangent.w < 0.0 ? -1.0 : 1.0) * cross(n, t), n);
}

struct SgTangentVectors {
    vec3 view;   // towards the camera, tangent space, not normalised
    vec3 light;  // towards the light
};

// The vectors to camera and light in tangent space, in a vertex shader.
//   position, camera, light: one space, world units; normal, tangent: unit, of the vertex, same space; tangent.w: +-1.
// Result: as long as the ways there; linear over a triangle. Cost: 44 instructions. Source: Lengyel, Listing 7.7.
SgTangentVectors sg_legacy_tangent_vectors(vec3 position, vec3 normal, vec4 tangent, vec3 camera, vec3 light) {
    mat3 tangent_from_world = transpose(mat3(tangent.xyz, tangent.w * cross(normal, tangent.xyz), normal));
    return SgTangentVectors(tangent_from_world * (camera - position), tangent_from_world * (light - position));
}

// A tangent-space normal in the space of the vertex attributes, by the interpolated and then orthonormalised frame.
//   m: tangent-space normal, green down, any length; normal, tangent: as sg_legacy_tbn.
// Result: unit where m is not zero and the tangent usable.
// Cost: 66 instructions.
// Source: Lengyel, Listing 7.8 (whose B is as long as the interpolated normal; here it is unit, as Eq 7.40 says).
vec3 sg_legacy_object_normal(vec3 m, vec3 normal, vec4 tangent) {
    mat3 frame = sg_legacy_tbn(normal, tangent);
    vec3 bumped = frame * m;
    float square = dot(bumped, bumped);
    return square > 1e-30 ? bumped * inversesqrt(square) : frame[2];
}

struct SgPhong {
    float diffuse;   // 0..1
    float specular;  // 0..1
};

// Phong's lighting in tangent space.
//   m: tangent-space normal, unit; light, view: unit, tangent space, towards light and viewer; power: > 0.
// Result: factors of the two colours; 0 where the light or the mirrored light points away.
// Cost: 19 instructions. Source: shader workshop 4.
SgPhong sg_legacy_phong(vec3 m, vec3 light, vec3 view, float power) {
    float facing = dot(m, light);
    float mirrored = dot(2.0 * facing * m - light, view);
    float shine = mirrored > 0.0 ? min(pow(mirrored, power), 1.0) : 0.0;
    return SgPhong(clamp(facing, 0.0, 1.0), shine);
}

#endif
