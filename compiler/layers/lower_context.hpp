// What a layer's lowering may ask for: values of the surface that all layers share, made once.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ir/ir.hpp"
#include "layers/layer_kind.hpp"

namespace sg::layers {

// How a texture stores what its encoding says.
struct TextureFacts {
    bool green_up = true;
    double zero = 127.5;  // the 8-bit code that means 0: 127, 127.5 or 128
};

class LowerContext {
public:
    // `facts` has one entry per texture of the module. `mirror`: the base normal turns to the visible side.
    LowerContext(ir::Builder& builder, std::vector<TextureFacts> facts, bool mirror)
        : builder_(builder), facts_(std::move(facts)), mirror_(mirror) {}

    ir::Builder& builder() { return builder_; }
    // Values that are made from here on belong to this layer; shared ones belong to none.
    void set_layer(ir::LayerId layer) {
        layer_ = layer;
        builder_.set_layer(layer);
    }

    ir::ValueId normal();
    ir::ValueId frame();
    ir::ValueId facing();
    ir::ValueId basis_vertex();
    ir::ValueId uv(std::uint32_t set);
    ir::ValueId number(const FieldValue& value);
    ir::ValueId pair(const FieldValue& value);
    // The derivative that a normal map of any encoding stores at a coordinate.
    ir::ValueId normal_map_deriv(ir::TextureId texture, ir::ValueId uv);

    [[nodiscard]] bool has_basis_vertex() const { return basis_vertex_.valid(); }
    [[nodiscard]] const std::map<std::uint32_t, ir::ValueId>& uvs() const { return uvs_; }

private:
    template <class Make>
    ir::ValueId shared(ir::ValueId& slot, Make make);

    ir::Builder& builder_;
    std::vector<TextureFacts> facts_;
    bool mirror_;
    ir::LayerId layer_;
    ir::ValueId vertex_normal_, normal_, frame_, facing_, basis_vertex_;
    ir::ValueId vertex_normal();
    std::map<std::uint32_t, ir::ValueId> uvs_;
};

}  // namespace sg::layers
