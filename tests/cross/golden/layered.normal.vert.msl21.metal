#pragma clang diagnostic ignored "-Wmissing-prototypes"

#include <metal_stdlib>
#include <simd/simd.h>

using namespace metal;

struct SgObjectBlock
{
    float4x4 relative_from_object;
    float4x4 world_from_object;
    float4x4 normal_from_object;
};

struct SgFrameBlock
{
    float4x4 clip_from_relative;
    float4x4 relative_from_screen;
    float4 camera_position;
    float4 view_direction;
    float4 light_direction;
    float4 light_radiance;
    float4 ambient_radiance;
    float4 time_view;
};

struct main0_out
{
    float3 sg_out_position [[user(locn0)]];
    float3 sg_out_normal [[user(locn1)]];
    float4 sg_out_tangent [[user(locn2)]];
    float2 sg_out_uv0 [[user(locn4)]];
    float2 sg_out_uv1 [[user(locn5)]];
    float4 gl_Position [[position]];
};

struct main0_in
{
    float3 sg_vertex_position [[attribute(0)]];
    float3 sg_vertex_normal [[attribute(1)]];
    float4 sg_vertex_tangent [[attribute(2)]];
    float2 sg_vertex_uv0 [[attribute(4)]];
    float2 sg_vertex_uv1 [[attribute(5)]];
};

static inline __attribute__((always_inline))
float3 sg_stage_position(thread const float3& position, constant SgObjectBlock& sg_object_block)
{
    return (sg_object_block.relative_from_object * float4(position, 1.0)).xyz;
}

static inline __attribute__((always_inline))
float3 sg_stage_unit(thread const float3& v)
{
    float square = dot(v, v);
    float3 _38;
    if (square > 0.0)
    {
        _38 = v * rsqrt(square);
    }
    else
    {
        _38 = v;
    }
    return _38;
}

static inline __attribute__((always_inline))
float3 sg_stage_normal(thread const float3& normal, constant SgObjectBlock& sg_object_block)
{
    float3 param = float3x3(sg_object_block.normal_from_object[0].xyz, sg_object_block.normal_from_object[1].xyz, sg_object_block.normal_from_object[2].xyz) * normal;
    return sg_stage_unit(param);
}

static inline __attribute__((always_inline))
float4 sg_stage_tangent(thread const float4& tangent, constant SgObjectBlock& sg_object_block)
{
    float3 param = float3x3(sg_object_block.relative_from_object[0].xyz, sg_object_block.relative_from_object[1].xyz, sg_object_block.relative_from_object[2].xyz) * tangent.xyz;
    float3 direction = sg_stage_unit(param);
    return float4(direction, tangent.w * sg_object_block.normal_from_object[3].w);
}

static inline __attribute__((always_inline))
float4 sg_stage_clip(thread const float3& relative_position, constant SgFrameBlock& sg_frame_block)
{
    return sg_frame_block.clip_from_relative * float4(relative_position, 1.0);
}

vertex main0_out main0(main0_in in [[stage_in]], constant SgFrameBlock& sg_frame_block [[buffer(0)]], constant SgObjectBlock& sg_object_block [[buffer(2)]])
{
    main0_out out = {};
    float3 param = in.sg_vertex_position;
    float3 sg_relative_position = sg_stage_position(param, sg_object_block);
    out.sg_out_position = sg_relative_position;
    float3 param_1 = in.sg_vertex_normal;
    out.sg_out_normal = sg_stage_normal(param_1, sg_object_block);
    float4 param_2 = in.sg_vertex_tangent;
    out.sg_out_tangent = sg_stage_tangent(param_2, sg_object_block);
    out.sg_out_uv0 = in.sg_vertex_uv0;
    out.sg_out_uv1 = in.sg_vertex_uv1;
    float3 param_3 = sg_relative_position;
    out.gl_Position = sg_stage_clip(param_3, sg_frame_block);
    out.gl_Position.y = -(out.gl_Position.y);    // Invert Y-axis for Metal
    return out;
}

