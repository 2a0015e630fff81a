// THE table of layer kinds. A new kind is one line in each list and one file beside this one.
#include "layers/layer_kind.hpp"

namespace sg::layers {

const LayerKind& normal_map();

std::span<const LayerKind* const> all_kinds() {
    static const LayerKind* const kKinds[] = {
        &normal_map(),
    };
    return kKinds;
}

const LayerKind* find_kind(std::string_view name) {
    for (const LayerKind* kind : all_kinds()) {
        if (kind->name == name) return kind;
    }
    return nullptr;
}

}  // namespace sg::layers
