// A function that materials/weathered_globe.json calls as a layer: it is handed all that a function may be.
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/volume.glsl"

// A surface gradient: the slopes of a map (green down, 128 means 0) along the vertex tangents, where the coordinate
// lies in a window, from window.xy to window.zw, and the places within reach: from the camera, from the middle of
// the object, from the middle of the world. A vertex whose alpha is below 0, or a time before `start`, hides it.
vec3 cloth(SgFrame frame, vec3 normal, SgBasis tangents, vec3 position, SgVolume object,
           SgVolume world, vec4 color, float time, float facing, texture2D map, sampler map_sampler,
           SgUv uv, vec4 window, vec3 reach, float start) {
    vec2 slopes = sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(map, map_sampler, uv).xyz, 128.0));
    bool in_window = all(greaterThanEqual(uv.st, window.xy)) && all(lessThanEqual(uv.st, window.zw));
    vec3 far = vec3(length(position), length(object.p), length(world.p));
    bool in_reach = all(lessThanEqual(far, reach));
    bool outside = facing * dot(normal, frame.normal) > 0.0;
    bool shown = in_window && in_reach && outside && color.a >= 0.0 && time >= start;
    return shown ? sg_surfgrad_from_tbn(slopes, tangents) : vec3(0.0);
}
