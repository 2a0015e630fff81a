// What the compiled texts are called with. The test that calls them reads this file too, so it is plain C++.
#pragma once

struct SgTextureData {
    const float* texels;  // rgba, upper row first
    int width, height;
};
struct SgSamplerData {
    int wrap_s, wrap_t;  // 0 repeat, 1 mirror, 2 clamp
    int linear;
};
// By the numbers of [[buffer(n)]], [[texture(n)]] and [[sampler(n)]].
struct SgBindings {
    const void* buffers[8];
    SgTextureData textures[32];
    SgSamplerData samplers[32];
};

using SgNumbers = float[16][4];  // by location

// One vertex: attributes in, varyings and the clip position out.
using SgVertexFunction = void (*)(const SgBindings& bindings, const SgNumbers& attributes,
                                  SgNumbers& varyings, float (&position)[4]);
// Four pixels, left to right, then down: varyings in; colours out, by attachment and pixel.
using SgColors = float[4][4][4];
using SgFragmentFunction = void (*)(const SgBindings& bindings, const SgNumbers (&varyings)[4], bool front,
                                    SgColors& colors, bool (&discarded)[4]);
