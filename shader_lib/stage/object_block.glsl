// Set 2, binding 0: what is constant over one drawn instance. Field by field in compiler/artefacts.md.
#ifndef SG_STAGE_OBJECT_BLOCK
#define SG_STAGE_OBJECT_BLOCK

layout(set = 2, binding = 0, std140) uniform SgObjectBlock {
    mat4 relative_from_object;
    mat4 normal_from_object;
} sg_object_block;

#endif
