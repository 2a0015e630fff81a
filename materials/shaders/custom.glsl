// Functions that materials/custom.json calls as layers. A function sees what it is handed and nothing else.
#include "surfgrad/deriv.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/volume.glsl"

#ifndef OCTAVES
#define OCTAVES 4
#endif

const float kZero = 128.0;  // the code of the woven map that means 0

// A volume gradient: dents where a turbulence is low. The chain rule brings the frequency.
vec3 dents(SgVolume object, float frequency, float power) {
    SgNoise noise = sg_volume_turbulence(sg_volume_scale(object, frequency), OCTAVES);
    return frequency * sg_noise_power(noise, power).gradient;
}

// A derivative along +s and +t: the slopes of a map that was painted with green down.
vec2 slopes(texture2D map, sampler map_sampler, SgUv uv) {
    return sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(map, map_sampler, uv).xyz, kZero));
}

// A surface gradient: stones whose height is measured in world units.
vec3 stones(SgFrame frame, texture2D heights, sampler heights_sampler, SgUv uv, vec2 tiling) {
    SgUv place = sg_uv_scale(uv, tiling);
    vec2 deriv = sg_deriv_from_height_hq(heights, heights_sampler, place);
    return sg_surfgrad_from_height(frame, place, sg_texture_size(heights, heights_sampler), deriv);
}
