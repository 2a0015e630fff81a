// What a layer's lowering may ask for: values of the surface that all layers share, made once per stage.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ir/ir.hpp"
#include "layers/kind.hpp"

namespace sg::layers {

// How a texture stores what its encoding says.
struct TextureFacts {
    bool green_up = true;
    double zero = 127.5;                               // the 8-bit code that means 0: 127, 127.5 or 128
    double range = 1;                                  // of a derivative map: the slope that 1 means
    std::array<std::uint32_t, 4> swizzle{0, 1, 2, 3};  // which stored channel stands for r, g, b and a
};

// A node of the material's graph with its checked values.
struct NodeInstance {
    const NodeKind* kind = nullptr;
    std::vector<FieldValue> values;
    std::string name;  // "" for one written in place
};

enum class Space : std::uint32_t { object, world };

// How the back of the surface is shaded.
enum class Sides : std::uint32_t { off, mirror, flip };

// What parallax found, seen from the mesh.
struct Found {
    ir::ValueId uv;         // of the mesh: the coordinate that was looked along
    Coordinate coordinate;  // that it was made from
    FieldValue tiling;
    ir::ValueId offset;  // of that coordinate
    ir::ValueId height;  // along the normal of the side that is seen, world units
    bool curved = true;  // whether the normal of the mesh is another one there
};

// Where a map lies: its coordinate, and the vertex basis turned with it; invalid where tangents come from the
// coordinate.
struct MapPlace {
    ir::ValueId uv, vertex_basis;
};

// What becomes of the numbers that a material's author wrote: constants of the shader, or derived parameters
// whose expression is the number, so that materials which differ in numbers alone share a shader.
enum class Numbers { baked, uniforms };

// Where a number stands in the checked material. The same place is handed over once, however often it is
// lowered.
struct NumberPlace {
    const void* at = nullptr;
    std::size_t part = 0;  // one of several that are made from what stands there
};

class LowerContext {
public:
    // `facts` has one entry per texture of the module.
    LowerContext(ir::Builder& builder, std::vector<TextureFacts> facts, std::vector<NodeInstance> nodes,
                 Sides sides, Numbers numbers = Numbers::baked);

    ir::Builder& builder() { return builder_; }
    // Values that are made from here on belong to this layer; shared ones belong to none.
    void set_layer(ir::LayerId layer);
    // The next stage starts from a resolved normal: new frame, new tangents.
    void begin_stage(ir::ValueId resolved_normal);
    // The same where an entry of bump ended, of this id; it may have none.
    void begin_entry(ir::ValueId resolved_normal, std::string_view id);
    // What follows belongs to the surface, not to a stage: behind parallax its coordinates keep the level of
    // detail of the mesh.
    void begin_surface();

    // ---- parallax; before anything else is lowered in its stage ----
    // The view in the space of a coordinate, seen from the side that is shown.
    ir::ValueId texture_view(ir::ValueId uv);
    // A height as that side sees it.
    ir::ValueId height_of_viewed_side(const FieldValue& height);
    // The surface that was found takes the place of the mesh in all that follows.
    void move_surface(const Found& found);
    // Whether what is looked up from here on is: otherwise coordinates and places are the mesh's, and frames
    // have its footprint, with the stage's normal. Gives what held before.
    bool follow_parallax(bool follows) { return std::exchange(follows_, follows); }

    // Of the stage.
    ir::ValueId normal();
    ir::ValueId frame();
    ir::ValueId basis_vertex();
    // That an earlier entry of bump left; that it began with.
    [[nodiscard]] ir::ValueId entry_normal(std::uint32_t entry) const { return entry_normals_[entry]; }
    ir::ValueId surface_normal();
    // Of the surface that is looked up.
    ir::ValueId position();
    ir::ValueId uv(const Coordinate& coordinate);
    ir::ValueId uv(const Coordinate& coordinate, const FieldValue& tiling);
    ir::ValueId volume(Space space);
    // Of the mesh.
    ir::ValueId facing();
    ir::ValueId time();
    ir::ValueId vertex_color();

    // A number of the language's own, always baked.
    ir::ValueId constant(double number);
    // One that was written, or that follows from such.
    ir::ValueId written(ir::Type type, const std::array<double, 4>& number, std::string_view name,
                        NumberPlace place);
    ir::ValueId written(double number, std::string_view name, NumberPlace place) {
        return written(ir::Type::Scalar, {number}, name, place);
    }
    // For numbers that say where something is looked up: where all of them are equal, the lookup is shared.
    const void* same_lookup(std::vector<double> numbers) {
        return &*lookups_.insert(std::move(numbers)).first;
    }
    ir::ValueId number(const FieldValue& value);
    ir::ValueId pair(const FieldValue& value);
    ir::ValueId color(const FieldValue& value);
    // A map on a uv set, with tiling. The basis comes from `basis_of` the place.
    MapPlace place_map(const Coordinate& coordinate, const FieldValue& tiling, bool from_vertex);
    ir::ValueId basis_of(const MapPlace& place);
    // A texture read with its channels in the order that its encoding expects.
    ir::ValueId texel(ir::TextureId texture, ir::ValueId uv, std::string name = "texel");
    // The derivative that a map of tangent normals or derivatives stores at a coordinate, along +s and +t.
    ir::ValueId map_deriv(ir::TextureId texture, ir::ValueId uv);
    [[nodiscard]] const TextureFacts& facts(ir::TextureId texture) const { return facts_[texture.index]; }
    // A user's function with its arguments; `op` is one of the custom operations.
    ir::ValueId call(ir::Op op, std::uint32_t shader, const std::string& function,
                     std::span<const Argument> arguments);
    // A gradient of the lookup's space in world axes, projected.
    ir::ValueId surfgrad_from_local(ir::ValueId local_gradient, Space space);

    [[nodiscard]] bool has_basis_vertex() const { return vertex_tangents_.valid(); }
    ir::ValueId first_frame();  // of the mesh, before any resolve
    ir::ValueId vertex_tangents() const { return vertex_tangents_; }
    // Invalid where no layer asked for it.
    [[nodiscard]] ir::ValueId made_vertex_color() const { return vertex_color_; }
    [[nodiscard]] ir::ValueId made_volume(Space space) const {
        return volumes_[static_cast<std::size_t>(space)];
    }
    [[nodiscard]] const std::map<std::uint32_t, ir::ValueId>& uv_sets() const { return uv_sets_; }
    // Behind parallax alone.
    [[nodiscard]] ir::ValueId made_normal_derivatives() const { return normal_derivatives_; }
    [[nodiscard]] ir::ValueId moved_position() const { return moved_position_; }
    [[nodiscard]] const std::map<std::uint32_t, ir::ValueId>& moved_uvs() const { return moved_uvs_; }

private:
    template <class Make>
    ir::ValueId shared(ir::ValueId& slot, Make make);
    const void* lookup_of(const Coordinate& coordinate);
    ir::ValueId scale_of(const Coordinate& coordinate);
    ir::ValueId node(NodeId id, ir::Type wanted);
    ir::ValueId lowered(NodeId id);
    void lower_operands(NodeId id);
    ir::ValueId vertex_normal();
    ir::ValueId mesh_position();
    ir::ValueId uv_set(std::uint32_t set);
    ir::ValueId base_uv(std::uint32_t set);
    ir::ValueId moved_uv(std::uint32_t set);
    ir::ValueId seen_uv();
    [[nodiscard]] bool looked_along(const Coordinate& coordinate, const FieldValue& tiling) const;
    ir::ValueId mesh_volume(Space space);
    ir::ValueId viewed_frame();
    ir::ValueId rebuilt_frame();
    ir::ValueId detail_frame();
    [[nodiscard]] bool moved() const { return found_.offset.valid(); }
    [[nodiscard]] bool looks_at_moved() const { return moved() && follows_; }
    // Whether a resolve stands between parallax and what is lowered.
    [[nodiscard]] bool on_detail() const { return moved() && normals_.size() > moved_in_; }
    void forget_stage();
    // A hint for values of the current stage, after the surface that it stands on.
    [[nodiscard]] std::string of_stage(std::string_view hint) const;

    ir::Builder& builder_;
    std::vector<TextureFacts> facts_;
    std::vector<NodeInstance> nodes_;
    std::vector<ir::ValueId> node_values_;
    std::size_t depth_ = 0;  // of nodes that are being lowered
    Sides sides_;
    Numbers numbers_;
    std::map<std::pair<const void*, std::size_t>, std::uint32_t> slots_;
    std::set<std::vector<double>> lookups_;
    std::string_view node_;  // that is being lowered
    ir::LayerId layer_;
    ir::ValueId vertex_normal_, position_, facing_, time_, vertex_color_, vertex_tangents_;
    std::array<ir::ValueId, 2> volumes_;
    std::map<std::uint32_t, ir::ValueId> uv_sets_;
    // Of the surface that parallax found.
    Found found_;
    std::size_t moved_in_ = 0;  // normals_.size() of its stage
    bool surface_ = false;      // see begin_surface
    bool follows_ = true;       // see follow_parallax
    ir::ValueId viewed_frame_, normal_derivatives_, pixels_, moved_position_;
    std::map<std::uint32_t, ir::ValueId> moved_uvs_;
    ir::ValueId found_uv_;
    // Of its plane: by the base normal, and behind a resolve by that normal.
    std::array<ir::ValueId, 2> rebuilt_frames_;
    std::array<std::array<ir::ValueId, 2>, 2> moved_volumes_;  // of those, by space
    std::map<std::uint32_t, ir::ValueId> detail_uvs_;
    ir::ValueId detail_frame_;  // of the current stage
    std::vector<ir::ValueId> entry_normals_;
    std::string stage_surface_;  // "" of the mesh
    // By stage; the last is the current one.
    std::vector<ir::ValueId> normals_{1}, frames_{1}, bases_{1};
};

// Makes a value outside any layer, once. Calls nest: the layer comes back when the outermost is done.
template <class Make>
ir::ValueId LowerContext::shared(ir::ValueId& slot, Make make) {
    if (slot.valid()) return slot;
    ir::LayerId before = std::exchange(layer_, ir::LayerId{});
    builder_.set_layer(layer_);
    ir::ValueId made =
        make();  // may move `slot`'s container, but never the slot of a container that is filled here
    slot = made;
    set_layer(before);
    return made;
}

}  // namespace sg::layers
