// The older methods of the figures, as layers: each makes a whole normal, which becomes the surface gradient that leads
// to it. Object space and world space have the same axes in these scenes.
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/legacy.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/volume.glsl"

const float kZero = 127.5;  // the code of the figures' maps that means 0; their green points up

// Perlin's perturbation by a fractal sum: the whole gradient of the noise is taken from the normal.
vec3 perlin(vec3 normal, SgVolume object, float frequency, float height) {
    SgNoise noise = sg_volume_fractal_sum(sg_volume_scale(object, frequency), 4);
    return sg_surfgrad_from_normal(normal, sg_legacy_perlin_normal(normal, height * frequency * noise.gradient));
}

vec3 tangent_normal(texture2D map, sampler map_sampler, SgUv uv) {
    vec3 m = sg_decode_signed(sg_sample(map, map_sampler, uv).xyz, kZero);
    return vec3(m.x, -m.y, m.z);
}

// Geiss' triplanar projection: x and y of the tangent-space normals, added to the normal.
vec3 triplanar_geiss(vec3 normal, SgVolume object, texture2D map, sampler map_sampler, float tiling, float exponent) {
    SgTriplanarUv uv = sg_volume_triplanar_uv(sg_volume_scale(object, tiling), SG_RIGHT_HAND, SG_UPPER_LEFT);
    vec3 bumped = sg_legacy_triplanar_normal(normal, sg_triplanar_weights(normal, exponent),
                                             tangent_normal(map, map_sampler, uv.x), tangent_normal(map, map_sampler, uv.y),
                                             tangent_normal(map, map_sampler, uv.z), SG_RIGHT_HAND, SG_UPPER_LEFT);
    return sg_surfgrad_from_normal(normal, bumped);
}

// Derivatives instead, but still Perlin's perturbation.
vec3 triplanar_perlin(vec3 normal, SgVolume object, texture2D map, sampler map_sampler, float tiling, float exponent) {
    SgTriplanarUv uv = sg_volume_triplanar_uv(sg_volume_scale(object, tiling), SG_RIGHT_HAND, SG_UPPER_LEFT);
    vec2 d_x = sg_deriv_from_normal_xyz(tangent_normal(map, map_sampler, uv.x));
    vec2 d_y = sg_deriv_from_normal_xyz(tangent_normal(map, map_sampler, uv.y));
    vec2 d_z = sg_deriv_from_normal_xyz(tangent_normal(map, map_sampler, uv.z));
    vec3 weights = sg_triplanar_weights(normal, exponent);
    vec3 gradient = sg_triplanar_gradient(weights, d_x, d_y, d_z, SG_RIGHT_HAND, SG_UPPER_LEFT);
    return sg_surfgrad_from_normal(normal, sg_legacy_perlin_normal(normal, gradient));
}

// A decal of half the size `half_size` that bumps the way back to its projector and is then blended with the normal.
//   right, up, back: unit axes of the projector; edge: of its falloff.
vec3 decal_as_normal(vec3 normal, SgVolume object, texture2D map, sampler map_sampler, vec3 position, vec3 right, vec3 up, vec3 half_size, float edge) {
    vec3 back = cross(right, up);
    mat3 axes = transpose(mat3(right / half_size.x, -up / half_size.y, -back / half_size.z));
    mat4 projector = mat4(mat4x3(axes[0], axes[1], axes[2], -(axes * position)));
    SgDecal decal = sg_decal_box(projector, object.p, object.dx, object.dy);
    vec2 d = sg_deriv_from_normal_xyz(tangent_normal(map, map_sampler, decal.uv));
    float alpha = sg_decal_falloff_box(decal.local, edge);
    return sg_surfgrad_from_normal(normal, sg_legacy_decal_normal(normal, right, -up, back, d, alpha));
}

// A tangent-space normal through the matrix of tangent, bitangent and normal.
vec3 tbn_matrix(vec3 normal, SgBasis basis, texture2D map, sampler map_sampler, SgUv uv) {
    vec3 m = tangent_normal(map, map_sampler, uv);
    return sg_surfgrad_from_normal(normal, m.x * basis.tangent + m.y * basis.bitangent + m.z * normal);
}
