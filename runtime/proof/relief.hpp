// The surface that parallax shows: the smooth one, moved along its normal by the heights of the material's
// parallax, and where a ray from the eye really meets it. In double precision, by marching and bisection over
// the smooth surface itself; nothing here knows tangent space, derivatives or the steps of a shader.
#pragma once

#include <optional>

#include "runtime/mesh/smooth.hpp"
#include "runtime/proof/heights.hpp"

namespace sg::proof {

// How a surface is seen.
struct Sight {
    runtime::SmoothShape shape = runtime::SmoothShape::sphere;
    glm::dmat4 world_from_object{1};
    glm::dvec3 camera{0};                // world space
    glm::dmat4 relative_from_screen{1};  // of camera_matrices
    double time = 0;
};

// Which values of a module say what its parallax displaces.
struct ReliefSource {
    ir::ValueId op;
    ir::ValueId uv;       // of the mesh, where the texture is placed
    ir::ValueId heights;  // scale and bias of a texel, world units; invalid: a partner knows
    std::uint32_t texture = 0;
};
std::optional<ReliefSource> relief_source(const ir::Module& module);

// The same material on a surface that is where the relief is: its parallax finds height 0 everywhere. All
// values move by kFlatShift.
inline constexpr std::uint32_t kFlatShift = 2;
ir::Module without_relief(const ir::Module& module);

class Relief {
public:
    // `flat`: without_relief of the material. All must outlive it.
    Relief(const ir::Module& flat, const ReliefSource& source, const ir::Bindings& bindings,
           const std::map<std::string, Partner>& partners, const Sight& sight);

    // Why no truth is known; the value is of `flat`.
    [[nodiscard]] std::optional<NoHeight> missing() const;

    // How the coordinate is placed and what a texel means, from values at three places of the chart: (0, 0),
    // (1, 0) and (0, 1). Once, before the rest.
    void place(const std::vector<ir::Datum>& origin, const std::vector<ir::Datum>& along_s,
               const std::vector<ir::Datum>& along_t);
    [[nodiscard]] bool placed() const { return placed_; }

    // For height and seen: the mesh's coordinate changes by so much per pixel (the level of detail); outward:
    // -1 where the surface is displaced to its inner side.
    void focus(glm::dvec2 st_dx, glm::dvec2 st_dy, double outward);
    // Of the surface above the smooth one, along its normal, world units.
    [[nodiscard]] double height(const runtime::Foot& foot) const;
    [[nodiscard]] double bias() const { return bias_; }  // the height of a texel 0
    // Under which point of the smooth surface the ray first meets the displaced one. from: a point of the
    // smooth surface that it passes, absolute world space; along: unit; near: the foot of from.
    [[nodiscard]] std::optional<runtime::Foot> seen(glm::dvec3 from, glm::dvec3 along,
                                                    const runtime::Foot& near) const;

private:
    struct Above;
    [[nodiscard]] Above above(glm::dvec3 point, const runtime::Foot& near) const;

    const ir::Module& flat_;
    const ReliefSource source_;
    const Partner* partner_ = nullptr;
    ir::Sampled texels_;
    runtime::SmoothShape shape_;
    glm::dmat4 world_from_object_, object_from_world_;
    glm::dmat3 normal_from_object_;
    bool placed_ = false;
    double scale_ = 0, bias_ = 0;
    glm::dvec2 origin_{0};
    glm::dmat2 from_st_{1};
    ref::Uv footprint_{};
    double outward_ = 1;
};

}  // namespace sg::proof
