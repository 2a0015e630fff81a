// A compiled material as the interpreter sees it: its module with the artefact's textures and parameters.
#pragma once

#include <deque>
#include <memory>

#include "runtime/artefact.hpp"
#include "runtime/proof/heights.hpp"
#include "runtime/textures.hpp"

namespace sg::proof {

// Not movable: the bindings point at the texels.
struct Material {
    Material() = default;
    Material(const Material&) = delete;

    ir::Module module;  // as lowered
    std::deque<ref::MemoryTexture> texels;
    ir::Bindings bindings;
};

// srgb: the colours of the texels are decoded to linear ones.
ref::MemoryTexture texels_of(const std::vector<asset::Image>& chain, bool srgb = false);

// `text`: of the artefact's <stem>.ir; `file` stands in messages. `parameters`: from pack_parameters. A
// texture that the optimiser dropped reads as zero. Fails with manifest_mismatch where the text is no module,
// or none of this artefact.
std::unique_ptr<Material> load_material(std::string_view text, std::string_view file,
                                        const runtime::Artefact& artefact,
                                        const runtime::TextureSet& textures,
                                        std::span<const std::byte> parameters, Diags& diags);

}  // namespace sg::proof
