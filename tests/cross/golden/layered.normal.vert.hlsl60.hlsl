cbuffer SgObjectBlock : register(b0, space2)
{
    row_major float4x4 sg_object_block_relative_from_object : packoffset(c0);
    row_major float4x4 sg_object_block_world_from_object : packoffset(c4);
    row_major float4x4 sg_object_block_normal_from_object : packoffset(c8);
};

cbuffer SgFrameBlock : register(b0, space0)
{
    row_major float4x4 sg_frame_block_clip_from_relative : packoffset(c0);
    row_major float4x4 sg_frame_block_relative_from_screen : packoffset(c4);
    float4 sg_frame_block_camera_position : packoffset(c8);
    float4 sg_frame_block_view_direction : packoffset(c9);
    float4 sg_frame_block_light_direction : packoffset(c10);
    float4 sg_frame_block_light_radiance : packoffset(c11);
    float4 sg_frame_block_ambient_radiance : packoffset(c12);
    float4 sg_frame_block_time_view : packoffset(c13);
};


static float4 gl_Position;
static float3 sg_vertex_position;
static float3 sg_out_position;
static float3 sg_out_normal;
static float3 sg_vertex_normal;
static float4 sg_out_tangent;
static float4 sg_vertex_tangent;
static float2 sg_out_uv0;
static float2 sg_vertex_uv0;
static float2 sg_out_uv1;
static float2 sg_vertex_uv1;

struct SPIRV_Cross_Input
{
    float3 sg_vertex_position : TEXCOORD0;
    float3 sg_vertex_normal : TEXCOORD1;
    float4 sg_vertex_tangent : TEXCOORD2;
    float2 sg_vertex_uv0 : TEXCOORD4;
    float2 sg_vertex_uv1 : TEXCOORD5;
};

struct SPIRV_Cross_Output
{
    float3 sg_out_position : TEXCOORD0;
    float3 sg_out_normal : TEXCOORD1;
    float4 sg_out_tangent : TEXCOORD2;
    float2 sg_out_uv0 : TEXCOORD4;
    float2 sg_out_uv1 : TEXCOORD5;
    float4 gl_Position : SV_Position;
};

float3 sg_stage_position(float3 position)
{
    return mul(float4(position, 1.0f), sg_object_block_relative_from_object).xyz;
}

float3 sg_stage_unit(float3 v)
{
    float square = dot(v, v);
    float3 _38;
    if (square > 0.0f)
    {
        _38 = v * rsqrt(square);
    }
    else
    {
        _38 = v;
    }
    return _38;
}

float3 sg_stage_normal(float3 normal)
{
    float3 param = mul(normal, float3x3(sg_object_block_normal_from_object[0].xyz, sg_object_block_normal_from_object[1].xyz, sg_object_block_normal_from_object[2].xyz));
    return sg_stage_unit(param);
}

float4 sg_stage_tangent(float4 tangent)
{
    float3 param = mul(tangent.xyz, float3x3(sg_object_block_relative_from_object[0].xyz, sg_object_block_relative_from_object[1].xyz, sg_object_block_relative_from_object[2].xyz));
    float3 direction = sg_stage_unit(param);
    return float4(direction, tangent.w * sg_object_block_normal_from_object[3].w);
}

float4 sg_stage_clip(float3 relative_position)
{
    return mul(float4(relative_position, 1.0f), sg_frame_block_clip_from_relative);
}

void vert_main()
{
    float3 param = sg_vertex_position;
    float3 sg_relative_position = sg_stage_position(param);
    sg_out_position = sg_relative_position;
    float3 param_1 = sg_vertex_normal;
    sg_out_normal = sg_stage_normal(param_1);
    float4 param_2 = sg_vertex_tangent;
    sg_out_tangent = sg_stage_tangent(param_2);
    sg_out_uv0 = sg_vertex_uv0;
    sg_out_uv1 = sg_vertex_uv1;
    float3 param_3 = sg_relative_position;
    gl_Position = sg_stage_clip(param_3);
    gl_Position.y = -gl_Position.y;
}

SPIRV_Cross_Output main(SPIRV_Cross_Input stage_input)
{
    sg_vertex_position = stage_input.sg_vertex_position;
    sg_vertex_normal = stage_input.sg_vertex_normal;
    sg_vertex_tangent = stage_input.sg_vertex_tangent;
    sg_vertex_uv0 = stage_input.sg_vertex_uv0;
    sg_vertex_uv1 = stage_input.sg_vertex_uv1;
    vert_main();
    SPIRV_Cross_Output stage_output;
    stage_output.gl_Position = gl_Position;
    stage_output.sg_out_position = sg_out_position;
    stage_output.sg_out_normal = sg_out_normal;
    stage_output.sg_out_tangent = sg_out_tangent;
    stage_output.sg_out_uv0 = sg_out_uv0;
    stage_output.sg_out_uv1 = sg_out_uv1;
    return stage_output;
}
