// The true normal: that of the surface that a material's heights displace, in double precision.
//
// The smooth surface behind a built-in mesh is moved along its normal by the height of the material's first
// stage (heights.hpp); what results is moved along *its* normal by the second stage's, and so on; a stage is
// what one resolve ends. The truth at a pixel is the last surface's normal over the point that the pixel
// shows. Nothing here knows surface gradients.
//
// Derivatives are central differences in a small square on the tangent plane of that point, whose points
// are carried to the surface, so that poles and seams of the coordinates do not matter. Step h = 1.5e-5 of
// the unit length: for a height of wavelength L the slope is off by (2 pi h / L)^2 / 6, 1e-6 at L = 1/30;
// rounding (1e-16 / h) by 1e-11. Where a shader mirrors a two-sided surface, the displacement goes to the
// visible side.
//
// With parallax a pixel shows another point: that where its ray meets the surface of the parallax's heights
// (relief.hpp). There the stages stand as they do everywhere, and volumes are looked up on that surface.
// Where the ray meets nothing, past a silhouette, there is no normal.
//
// What bump mapping leaves out. A height H over a surface with normal n moves tangents t to t + (grad H . t)
// n
// + H dn(t), of which bump mapping lacks the last: its gradient g is off by the transpose of H dn, at most H
// times the largest curvature times |g|, and n - g by the arcsine of H curvature sin(tilt). A later stage of
// volumes is looked up where the surface was before, but its gradient is taken along the tangents of the
// moved one, which also go along n: by the change of H along n, times the sine of the tilt so far, times the
// cosine of the new one. Each stage adds its own. (A later stage on coordinates, whose pixel is not
// lengthened by the tilt so far, is not counted.)
//
// Everything that depends on the screen (level of detail, footprint of a noise) is that of the pixel and the
// same at all points of the square.
#pragma once

#include <memory>
#include <optional>

#include "runtime/camera.hpp"
#include "runtime/mesh/smooth.hpp"
#include "runtime/proof/relief.hpp"

namespace sg::proof {

// What one pixel shows; world axes.
struct TrueNormal {
    glm::dvec3 normal{0};  // of the displaced surface; 0 where the ray misses it
    glm::dvec3 held{0};    // the same with all weights held constant: without the terms H grad w
    glm::dvec3 base{0};    // of the smooth surface, towards the visible side if two-sided
    double moved = 0;      // how far the surface was displaced there, world units
    // Degrees by which bump mapping with exact gradients can be off `held`, to first order, see below.
    double left_out = 0;
};

class Truth {
public:
    // `module` as lowered, not optimised. All must outlive it.
    Truth(const ir::Module& module, const ir::Bindings& bindings, std::map<std::string, Partner> partners,
          const Sight& sight);
    Truth(const Truth&) = delete;

    // Nothing where every stage has a height; else the first value without one.
    [[nodiscard]] std::optional<NoHeight> missing() const;

    // point: what the pixel (x, y) shows, relative to the camera; sight: from the camera to it, any length.
    // `held` costs as much again.
    TrueNormal at(glm::dvec3 point, glm::dvec2 pixel, glm::dvec3 sight, bool held = false);

    // What the interpreter must be given for a pixel of the smooth surface itself: exact inputs.
    [[nodiscard]] ir::PixelInputs inputs(glm::dvec3 point, glm::dvec2 pixel, glm::dvec3 sight) const;

private:
    struct Square;
    [[nodiscard]] ir::PixelInputs inputs_at(const Square& square, const runtime::Foot& foot) const;
    // The same on the surface that parallax shows.
    [[nodiscard]] ir::PixelInputs lifted_inputs(const Square& square, const runtime::Foot& foot) const;
    // The square under the point that parallax shows; false where it shows none.
    bool look(Square& square, glm::dvec3 point, glm::dvec2 pixel, glm::dvec3 sight);
    [[nodiscard]] Square square_at(glm::dvec3 point, glm::dvec2 pixel, glm::dvec3 sight) const;
    // Fills in all but `normal` and `held`.
    glm::dvec3 displaced_normal(const Square& square, bool held, TrueNormal& out);
    // How the height of each stage changes along the normal of the surface where volumes are looked up.
    std::vector<double> changes_along(const Square& square, glm::dvec3 normal);

    std::map<std::string, Partner> partners_;
    std::optional<ReliefSource> source_;
    const ir::Module module_;  // without its relief
    Heights heights_;
    ir::Evaluator evaluator_;
    Sight sight_;
    std::optional<Relief> relief_;
    glm::dmat3 normal_from_object_;
    glm::dmat4 object_from_world_;
    std::vector<ir::ValueId> stages_;  // the gradients of the resolves, first to last
    bool mirrors_ = false, flips_ = false;
};

}  // namespace sg::proof
