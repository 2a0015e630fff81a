// Phong's lighting: a Lambert base and a highlight around the mirrored light, as in the shader workshop. The workshop
// turns view and light into tangent space; their cosines with the normal are the same in world axes.
#ifndef SG_LIGHTING_PHONG
#define SG_LIGHTING_PHONG

#include "lighting/lights.glsl"
#include "surfgrad/legacy.glsl"

struct SgPhongSurface {
    vec3 base_color;  // linear, 0..1
    vec3 specular;    // colour of the highlight, linear, 0..1; the workshop's is the base colour
    float shininess;  // exponent of the highlight, 1..1000
    float occlusion;  // 0..1, of the ambient light
    vec3 emission;    // linear radiance
};

// Radiance towards the viewer.
//   n: unit, world axes.
// Result: at least the emission; the highlight does not ask whether the light is behind the surface, as in the source.
// Cost: 42 instructions. Source: shader workshop 4, after Phong 1975, whose highlight is white under any light.
vec3 sg_phong_radiance(SgPhongSurface surface, vec3 n, SgLights lights) {
    SgPhong share = sg_legacy_phong(n, lights.light, lights.view, surface.shininess);
    vec3 direct = (share.diffuse * surface.base_color + share.specular * surface.specular) * lights.radiance;
    return direct + surface.occlusion * surface.base_color * lights.ambient + surface.emission;
}

#endif
