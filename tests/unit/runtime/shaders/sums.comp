#version 450
// Of each pair of inputs: sum, difference, product.
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Inputs { float inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { float outputs[]; };
layout(set = 0, binding = 2, std140) uniform Control { uint count; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    float a = inputs[2u * i], b = inputs[2u * i + 1u];
    outputs[3u * i] = a + b;
    outputs[3u * i + 1u] = a - b;
    outputs[3u * i + 2u] = a * b;
}
