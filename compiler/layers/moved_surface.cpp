// The part of the lowering's context that parallax changes: where the mesh is left, and what stands for it.
#include <fmt/core.h>

#include "layers/lower_context.hpp"

namespace sg::layers {

using ir::Op;
using ir::ValueId;

namespace {

std::string_view name_of(Space space) {
    return space == Space::object ? "object" : "world";
}

}  // namespace

// The frame of the mesh with the normal of the side that is seen. (Of a "flip" surface the base normal is
// that of the front.)
ValueId LowerContext::viewed_frame() {
    if (sides_ != Sides::flip) return first_frame();
    return shared(viewed_frame_, [&] {
        ValueId mesh = first_frame();
        ValueId viewed = builder_.add(Op::mirror_normal, {normals_.front(), facing()}, "viewed_normal");
        return builder_.add(Op::frame_resolved, {mesh, viewed}, "viewed_frame");
    });
}

ValueId LowerContext::texture_view(ValueId uv) {
    ValueId frame = viewed_frame();
    ValueId view = builder_.add(Op::view, {mesh_position()}, "to_viewer");
    return builder_.add(Op::parallax_direction, {frame, uv, view}, "view");
}

ValueId LowerContext::height_of_viewed_side(const FieldValue& height) {
    ValueId along_front = number(height);
    return sides_ == Sides::flip ? builder_.add(Op::multiply, {along_front, facing()}) : along_front;
}

void LowerContext::move_surface(const Found& found) {
    found_ = found;
    stage_surface_ = "moved";
    ValueId mesh = viewed_frame(),
            there = builder_.add(Op::parallax_pixels, {found.uv, found.offset}, "pixels");
    pixels_ = there;
    moved_position_ = builder_.add(Op::parallax_position, {mesh, there, found.height}, "position");
    if (found.curved) {
        ValueId base = builder_.add(Op::base_normal, {vertex_normal()}, "base_normal");
        shared(normal_derivatives_,
               [&] { return builder_.add(Op::normal_derivatives, {vertex_normal()}, "normal_derivatives"); });
        ValueId n = builder_.add(Op::parallax_normal, {base, normal_derivatives_, there}, "moved_normal");
        if (sides_ == Sides::mirror) n = builder_.add(Op::mirror_normal, {n, facing()}, "moved_normal");
        begin_stage(n);
    } else {
        forget_stage();
    }
    moved_in_ = normals_.size();
}

ValueId LowerContext::position() {
    return looks_at_moved() ? moved_position_ : mesh_position();
}

// What was looked along goes straight to what is seen; other coordinates go as many pixels.
ValueId LowerContext::moved_uv(std::uint32_t set) {
    ValueId mesh = uv_set(set);
    return shared(moved_uvs_[set], [&] {
        ValueId offset =
            found_.uv == mesh ? found_.offset : builder_.add(Op::pixels_offset, {mesh, pixels_}, "offset");
        return builder_.add(Op::parallax_uv, {mesh, offset}, fmt::format("moved_uv{}", set));
    });
}

bool LowerContext::looked_along(const Coordinate& coordinate, const FieldValue& tiling) const {
    return looks_at_moved() && (!on_detail() || surface_) && coordinate == found_.coordinate &&
           tiling.parameter == found_.tiling.parameter && tiling.number == found_.tiling.number;
}

ValueId LowerContext::seen_uv() {
    return shared(found_uv_, [&] {
        return builder_.add(Op::parallax_uv, {found_.uv, found_.offset}, "seen_uv");
    });
}

ValueId LowerContext::base_uv(std::uint32_t set) {
    if (!looks_at_moved()) return uv_set(set);
    if (!on_detail() || surface_) return moved_uv(set);
    ValueId mesh = uv_set(set), detail = rebuilt_frame();
    return shared(detail_uvs_[set], [&] {
        return builder_.add(Op::parallax_detail_uv, {first_frame(), mesh, pixels_, detail},
                            fmt::format("detail_uv{}", set));
    });
}

// The plane of the surface that is seen, with the pixel's footprint on it.
ValueId LowerContext::rebuilt_frame() {
    return shared(rebuilt_frames_[on_detail() ? 1 : 0], [&] {
        ValueId n = on_detail() ? normals_[moved_in_] : normal();
        ValueId side = sides_ == Sides::flip ? facing() : constant(1);
        return builder_.add(Op::frame_rebuilt, {moved_position_, n, side}, "moved_frame");
    });
}

// Of a stage behind a resolve. The surface does not move again, so what a later stage adds leaves the
// footprint as it is.
ValueId LowerContext::detail_frame() {
    ValueId plane = rebuilt_frame();
    if (normals_.size() == moved_in_ + 1) return plane;
    return shared(detail_frame_, [&] {
        return builder_.add(Op::frame_resolved, {plane, normal()}, of_stage("frame"));
    });
}

// The surface's inputs take the footprint of the layers that asked for one: a frame of their own would be the
// same point on a plane a little more bumped.
ValueId LowerContext::volume(Space space) {
    if (!looks_at_moved()) return mesh_volume(space);
    const auto which = static_cast<std::size_t>(space);
    if (surface_ && !moved_volumes_[1][which].valid() && moved_volumes_[0][which].valid())
        return moved_volumes_[0][which];
    ValueId plane = rebuilt_frame();
    return shared(moved_volumes_[on_detail() ? 1 : 0][which], [&] {
        return builder_.add(space == Space::object ? Op::volume_object_at : Op::volume_world_at, {plane},
                            "moved_" + std::string(name_of(space)));
    });
}

}  // namespace sg::layers
