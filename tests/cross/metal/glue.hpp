// Between the texts and the functions of driver.hpp; included by the generated file alone, after
// metal_stdlib.
#pragma once

#include "driver.hpp"

template <typename V, int kCount>
void sg_load(V& out, const float (&from)[kCount]) {
    static_assert(SgSize<V>::value <= kCount);
    for (int i = 0; i < SgSize<V>::value; ++i) out[i] = from[i];
}
template <int kCount>
void sg_load(float& out, const float (&from)[kCount]) {
    out = from[0];
}
inline void sg_load(metal::float4x4& out, const float (&from)[16]) {
    for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = from[i];
}
template <typename V>
void sg_store(const V& value, float (&to)[4]) {
    for (int i = 0; i < SgSize<V>::value; ++i) to[i] = value[i];
}
inline void sg_store(float value, float (&to)[4]) {
    to[0] = value;
}

inline metal::texture2d<float> sg_texture(const SgTextureData& data) {
    return {data.texels, data.width, data.height};
}
inline metal::sampler sg_sampler(const SgSamplerData& data) {
    return {metal::SgWrap(data.wrap_s), metal::SgWrap(data.wrap_t), data.linear != 0};
}

// `shade(pixel)` runs one pixel of the quad.
template <typename Shade>
void sg_run_quad(Shade shade, bool (&discarded)[4]) {
    SgQuad quad;
    std::memset(quad.values, 0, sizeof(quad.values));
    sg_quad = &quad;
    for (quad.pass = 0; quad.pass < 8; ++quad.pass) {
        std::memset(quad.discarded, 0, sizeof(quad.discarded));
        for (quad.pixel = 0; quad.pixel < 4; ++quad.pixel) {
            quad.call = 0;
            shade(quad.pixel);
        }
        if (quad.pass > 0 && std::memcmp(quad.values[0], quad.values[1], sizeof(quad.values[0])) == 0) break;
    }
    std::memcpy(discarded, quad.discarded, sizeof(discarded));
}
