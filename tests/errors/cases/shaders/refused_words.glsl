#version 450
#extension GL_EXT_demote_to_helper_invocation : require
#include "surfgrad/fram.glsl"
#include <surfgrad/frame.glsl>
layout(set = 1, binding = 7) uniform texture2D image;
#define JOIN(a, b) a##b
#define OPEN {
#define SG_FRAME
#pragma optimize(off)
vec3 dents(SgFrame frame) {
    double exact = 1.0;
    float slope = dFdx(frame.position.x) + texture(sampler2D(image, filtering), vec2(0.0)).x;
    float dF\
dy = 0.0; // a comment that \
    goes on
    int m__x = 0;
    if (gl_FragCoord.x > 3.0) discard;
    return vec3(slope, "text", 0.0); /* é is fine here */ é
}
