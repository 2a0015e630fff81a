#version 450
#extension GL_GOOGLE_include_directive : require
#include "sample_blocks.glsl"
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec2 in_uv0;
layout(location = 0) out vec4 value;

void main() {
    int view = int(frame.time_view.y + 0.5);
    value = vec4(0.0, 0.0, 0.0, 1.0);
    if (view == 0) value.rgb = in_position;
    if (view == 1) value.rgb = normalize(in_normal);
    if (view == 2) value.rg = in_uv0;
    if (view == 3) value = vec4(dFdx(in_uv0), dFdy(in_uv0));
    if (view == 4) value.rgb = in_tangent.xyz;
    if (view == 5) {  // the position again, from the pixel's place and depth
        vec4 p = frame.relative_from_screen * vec4(gl_FragCoord.xyz, 1.0);
        value.rgb = p.xyz / p.w;
    }
    if (view == 6) value.rgb = gl_FrontFacing ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
}
