#version 300 es

layout(std140) uniform SgObjectBlock
{
    mat4 relative_from_object;
    mat4 world_from_object;
    mat4 normal_from_object;
} sg_object_block;

layout(std140) uniform SgFrameBlock
{
    mat4 clip_from_relative;
    mat4 relative_from_screen;
    vec4 camera_position;
    vec4 view_direction;
    vec4 light_direction;
    vec4 light_radiance;
    vec4 ambient_radiance;
    vec4 time_view;
} sg_frame_block;

layout(location = 0) in vec3 sg_vertex_position;
out vec3 sg_varying_position;
out vec3 sg_varying_normal;
layout(location = 1) in vec3 sg_vertex_normal;
out vec4 sg_varying_tangent;
layout(location = 2) in vec4 sg_vertex_tangent;
out vec2 sg_varying_uv0;
layout(location = 4) in vec2 sg_vertex_uv0;
out vec2 sg_varying_uv1;
layout(location = 5) in vec2 sg_vertex_uv1;

vec3 sg_stage_position(vec3 position)
{
    return (sg_object_block.relative_from_object * vec4(position, 1.0)).xyz;
}

vec3 sg_stage_unit(vec3 v)
{
    float square = dot(v, v);
    vec3 _38;
    if (square > 0.0)
    {
        _38 = v * inversesqrt(square);
    }
    else
    {
        _38 = v;
    }
    return _38;
}

vec3 sg_stage_normal(vec3 normal)
{
    vec3 param = mat3(sg_object_block.normal_from_object[0].xyz, sg_object_block.normal_from_object[1].xyz, sg_object_block.normal_from_object[2].xyz) * normal;
    return sg_stage_unit(param);
}

vec4 sg_stage_tangent(vec4 tangent)
{
    vec3 param = mat3(sg_object_block.relative_from_object[0].xyz, sg_object_block.relative_from_object[1].xyz, sg_object_block.relative_from_object[2].xyz) * tangent.xyz;
    vec3 direction = sg_stage_unit(param);
    return vec4(direction, tangent.w * sg_object_block.normal_from_object[3].w);
}

vec4 sg_stage_clip(vec3 relative_position)
{
    return sg_frame_block.clip_from_relative * vec4(relative_position, 1.0);
}

void main()
{
    vec3 param = sg_vertex_position;
    vec3 sg_relative_position = sg_stage_position(param);
    sg_varying_position = sg_relative_position;
    vec3 param_1 = sg_vertex_normal;
    sg_varying_normal = sg_stage_normal(param_1);
    vec4 param_2 = sg_vertex_tangent;
    sg_varying_tangent = sg_stage_tangent(param_2);
    sg_varying_uv0 = sg_vertex_uv0;
    sg_varying_uv1 = sg_vertex_uv1;
    vec3 param_3 = sg_relative_position;
    gl_Position = sg_stage_clip(param_3);
    gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
    gl_Position.y = -gl_Position.y;
}

