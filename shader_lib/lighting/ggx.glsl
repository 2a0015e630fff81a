// GGX: microfacet reflection with Smith's height-correlated shadowing and a Lambert base.
#ifndef SG_LIGHTING_GGX
#define SG_LIGHTING_GGX

#include "lighting/lights.glsl"

struct SgGgxSurface {
    vec3 base_color;  // linear, 0..1
    float metallic;   // 0..1
    float roughness;  // perceptual, 0..1; alpha = roughness^2
    float occlusion;  // 0..1, of the ambient light
    vec3 emission;    // linear radiance
};

// The squared sine of the angle between two unit vectors by their chord: small angles keep their digits,
// which 1 - cos^2 loses. A sharp highlight is made of them.
//   Result: 0..1; 1 from 90 degrees on.
//   Cost: 11 instructions. Source: the cosine rule, |a - b|^2 = 2 - 2 cos.
float sg_sin2_between(vec3 a, vec3 b) {
    vec3 chord = a - b;
    float c2 = min(dot(chord, chord), 2.0);
    return c2 - 0.25 * c2 * c2;
}

// How many microfacets face a direction, per cosine to the normal.
//   sin2_h: 0..1, squared sine of the angle between normal and half vector; alpha: 2e-3..1.
//   Result: > 0; 1 / pi for alpha = 1.
//   Cost: 7 instructions. Source: Trowbridge and Reitz 1975; Walter 2007, Eq 33.
float sg_ggx_distribution(float sin2_h, float alpha) {
    float a2 = alpha * alpha;
    float f = (sin2_h - a2 * sin2_h) + a2;
    return a2 / (3.14159265 * f * f);
}

// Smith's height-correlated visibility, G / (4 cos_l cos_v).
//   cos_l, cos_v: 0..1, of the normal with light and view; alpha: 2e-3..1. Result: > 0, finite where both are 0.
//   Cost: 12 instructions. Source: Heitz 2014, Eq 99.
float sg_ggx_visibility(float cos_l, float cos_v, float alpha) {
    float a2 = alpha * alpha;
    float l = cos_v * sqrt((cos_l - a2 * cos_l) * cos_l + a2);
    float v = cos_l * sqrt((cos_v - a2 * cos_v) * cos_v + a2);
    return 0.5 / max(l + v, 1e-6);
}

// The share of light that is mirrored.
//   f0: 0..1, straight on; cos_d: of half vector and light. Result: f0 for 1, white for 0 and below.
//   Cost: 9 instructions. Source: Schlick 1994, Eq 15.
vec3 sg_fresnel(vec3 f0, float cos_d) {
    float m = clamp(1.0 - cos_d, 0.0, 1.0);
    float m2 = m * m;
    float m5 = m2 * m2 * m;
    return (1.0 - m5) * f0 + m5;
}

// Radiance towards the viewer from one directional light.
//   n, view, light: unit, world axes, view towards the viewer, light towards the light;
//   radiance: irradiance of the light on a facing surface divided by pi.
// Result: at least 0; 0 where the light is behind the surface.
// Cost: 82 instructions. Source: Walter 2007, Eq 20; the Lambert base takes what the microfacets leave.
vec3 sg_ggx(SgGgxSurface surface, vec3 n, vec3 view, vec3 light, vec3 radiance) {
    vec3 sum = view + light;
    float length2 = dot(sum, sum), per_length = inversesqrt(max(length2, 1e-12));
    float cos_l = clamp(dot(n, light), 0.0, 1.0);
    float cos_v = abs(dot(n, view)) + 1e-4;  // bumped normals may face away from the viewer
    float sin2_h = sg_sin2_between(n, sum * per_length);
    float alpha = max(surface.roughness * surface.roughness, 2e-3);
    float lobe = 3.14159265 * sg_ggx_distribution(sin2_h, alpha) * sg_ggx_visibility(cos_l, cos_v, alpha);
    vec3 base = (1.0 - surface.metallic) * surface.base_color;
    vec3 f0 = mix(vec3(0.04), surface.base_color, surface.metallic);
    vec3 fresnel = sg_fresnel(f0, 0.5 * length2 * per_length);  // a rhombus: half its diagonal is cos_d
    return mix(base, vec3(lobe), fresnel) * radiance * cos_l;
}

// Radiance towards the viewer: the light, what comes from all around, and what the surface emits.
//   n: unit, world axes. Result: at least the emission.
// Cost: 92 instructions. Source: Walter 2007, Eq 20; ambient light meets the base colour, which a metal
// reflects and anything else scatters.
vec3 sg_ggx_radiance(SgGgxSurface surface, vec3 n, SgLights lights) {
    vec3 direct = sg_ggx(surface, n, lights.view, lights.light, lights.radiance);
    return direct + surface.occlusion * surface.base_color * lights.ambient + surface.emission;
}

#endif
