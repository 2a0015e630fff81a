// What lights a point of the surface: one directional light, and the same light from all around.
#ifndef SG_LIGHTING_LIGHTS
#define SG_LIGHTING_LIGHTS

struct SgLights {
    vec3 view;      // unit, towards the viewer, world axes
    vec3 light;     // unit, towards the light, world axes
    vec3 radiance;  // irradiance of the light on a facing surface divided by pi, linear
    vec3 ambient;   // radiance from all around, linear
};

#endif
