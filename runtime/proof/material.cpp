#include "runtime/proof/material.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ir/text.hpp"

namespace sg::proof {
namespace {

ir::Sampled::Wrap wrap_of(runtime::gpu::Wrap wrap) {
    using From = runtime::gpu::Wrap;
    if (wrap == From::mirror) return ir::Sampled::Wrap::mirror;
    return wrap == From::clamp ? ir::Sampled::Wrap::clamp : ir::Sampled::Wrap::repeat;
}

ir::Sampled sampled_of(const runtime::gpu::SamplerState& state) {
    using From = runtime::gpu::MipFilter;
    ir::Sampled out{.wrap_s = wrap_of(state.wrap_s), .wrap_t = wrap_of(state.wrap_t), .linear = state.linear};
    out.mips = state.mip_filter == From::linear    ? ir::Sampled::Mips::linear
               : state.mip_filter == From::nearest ? ir::Sampled::Mips::nearest
                                                   : ir::Sampled::Mips::none;
    return out;
}

// How a texture's sampler reads it, without its texels.
ir::Sampled sampler_of(const runtime::Artefact& artefact, const runtime::TextureSlot& slot) {
    for (const runtime::SamplerSlot& sampler : artefact.samplers) {
        if (sampler.binding == slot.sampler_binding) return sampled_of(sampler.state);
    }
    return {};
}

void bind_textures(const runtime::Artefact& artefact, const runtime::TextureSet& textures, Material& out) {
    for (const ir::Texture& texture : out.module.textures) {
        ir::Sampled sampled;
        ref::MemoryTexture texels;
        texels.chain.push_back({{1, 1}, {ref::dvec4(0.0)}});
        for (std::size_t i = 0; i < artefact.textures.size(); ++i) {
            if (artefact.textures[i].name != texture.name) continue;
            sampled = sampler_of(artefact, artefact.textures[i]);
            texels = texels_of(textures.chains[i], artefact.textures[i].srgb);
        }
        out.texels.push_back(std::move(texels));
        sampled.texels = &out.texels.back();
        out.bindings.textures.push_back(sampled);
    }
}

bool bind_parameters(const runtime::Artefact& artefact, std::span<const std::byte> block, Material& out) {
    for (const ir::Parameter& parameter : out.module.parameters) {
        std::array<double, 16> number{};
        if (artefact.parameters) {
            for (const runtime::Parameter& p : artefact.parameters->parameters) {
                if (p.name != parameter.name) continue;
                for (std::size_t i = 0; i < p.initial.size(); ++i) {
                    float value = 0;
                    const std::size_t at = p.offset + i * sizeof value;
                    if (at + sizeof value > block.size()) return false;
                    std::memcpy(&value, block.data() + at, sizeof value);
                    number[i] = static_cast<double>(value);
                }
            }
        }
        out.bindings.parameters.push_back(ir::datum_of(parameter.type, number));
    }
    return true;
}

}  // namespace

ref::MemoryTexture texels_of(const std::vector<asset::Image>& chain, bool srgb) {
    ref::MemoryTexture out;
    auto linear = [srgb](double c) {
        if (!srgb) return c;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    for (const asset::Image& image : chain) {
        ref::MemoryTexture::Level level{{image.width, image.height}, {}};
        level.texels.reserve(std::size_t{image.width} * image.height);
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x)
                level.texels.emplace_back(linear(image.at(x, y, 0)), linear(image.at(x, y, 1)),
                                          linear(image.at(x, y, 2)), image.at(x, y, 3));
        }
        out.chain.push_back(std::move(level));
    }
    return out;
}

std::unique_ptr<Material> load_material(std::string_view text, std::string_view file,
                                        const runtime::Artefact& artefact,
                                        const runtime::TextureSet& textures,
                                        std::span<const std::byte> parameters, Diags& diags) {
    auto out = std::make_unique<Material>();
    auto module = ir::read(std::make_shared<Source>(Source{std::string(file), std::string(text)}), diags);
    if (!module) return nullptr;
    out->module = std::move(*module);
    bind_textures(artefact, textures, *out);
    if (bind_parameters(artefact, parameters, *out)) return out;
    diags.error(
        Code::manifest_mismatch,
        fmt::format("'{}' is not the module of this artefact: its parameters are not those of the manifest",
                    printable(file)));
    return nullptr;
}

}  // namespace sg::proof
