#include "surfgrad/frame.glsl"
#include "surfgrad/uv.glsl"
vec3 dents(SgFrame frame, float depth) { return sg_reject(vec3(depth), frame.normal); }
vec3 dents(SgFrame frame, SgUv uv) { return sg_reject(vec3(uv.st, 0.0), frame.normal); }
vec2 slopes(texture2D map, sampler filtering, inout vec2 st) { return st; }
