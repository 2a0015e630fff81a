#include "surfgrad/frame.glsl"
#include "surfgrad/uv.glsl"
vec3 creases(SgFrame frame, SgUv uv, texture2D map, sampler filtering) {
    vec2 along = vec2(dFdx(uv.st.x), dFdyFine(uv.st.y)) + fwidth(frame.position.xy);
    return sg_reject(texture(sampler2D(map, filtering), along).xyz, frame.normal);
}
