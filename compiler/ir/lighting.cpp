#include "ir/lighting.hpp"

#include <algorithm>

namespace sg::ir {
namespace {

bool lists(const LightingModel& model, Output input) {
    return std::find(model.inputs.begin(), model.inputs.end(), input) != model.inputs.end();
}

}  // namespace

std::span<const LightingModel> all_lighting_models() {
    using enum Output;
    static const LightingModel kRows[] = {
        {"ggx",
         "SgGgxSurface",
         "microfacets (Trowbridge and Reitz, Smith, Schlick) over a Lambert base, as in glTF",
         {base_color, metallic, roughness, occlusion, emission}},
        {"phong",
         "SgPhongSurface",
         "a Lambert base and a highlight around the mirrored light, as in older shaders",
         {base_color, specular, shininess, occlusion, emission}},
    };
    return kRows;
}

std::optional<std::uint32_t> find_lighting_model(std::string_view name) {
    const std::span<const LightingModel> all = all_lighting_models();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (all[i].name == name) return i;
    }
    return std::nullopt;
}

bool has_input(const LightingModel& model, Output input) {
    const std::span<const LightingModel> all = all_lighting_models();
    return lists(model, input) ||
           std::none_of(all.begin(), all.end(), [&](const LightingModel& m) { return lists(m, input); });
}

}  // namespace sg::ir
