// A material of a test with its truth: compiled in this process, seen by a virtual camera of very fine
// pixels.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "runtime/proof/material.hpp"
#include "runtime/proof/truth.hpp"
#include "tests/render/workshop.hpp"

namespace sg::proof {

// A texture given by a function of its coordinate, as fine as wanted; one level.
struct FunctionTexture : ref::TextureSource {
    int side = 1 << 18;
    std::function<ref::dvec4(ref::dvec2)> texel;

    explicit FunctionTexture(std::function<ref::dvec4(ref::dvec2)> f) : texel(std::move(f)) {}
    ref::dvec4 fetch(glm::ivec2 at, int) const override {
        return texel((ref::dvec2(at) + 0.5) / double(side));
    }
    glm::ivec2 size(int) const override { return glm::ivec2(side); }
    int levels() const override { return 1; }
};

class Subject {
public:
    // `json`: a material whose pictures may be any; those that `textures` names are replaced by functions.
    explicit Subject(const std::string& json,
                     const std::map<std::string, std::function<ref::dvec4(ref::dvec2)>>& textures = {});

    [[nodiscard]] const ir::Module& module() const { return material_->module; }
    ir::Bindings& bindings() { return material_->bindings; }
    // The heights of a map of slopes.
    void give_partner(const std::string& texture, std::function<double(ref::dvec2)> height, double length);

    // The truth for a view of a shape; uses the bindings as they are now.
    [[nodiscard]] Truth truth(runtime::SmoothShape shape,
                              const glm::dmat4& world_from_object = glm::dmat4(1));
    [[nodiscard]] Truth truth(const Sight& sight) const;
    // The interpreter's normal for exact inputs.
    [[nodiscard]] glm::dvec3 shaded(const ir::PixelInputs& inputs);

private:
    std::unique_ptr<Material> material_;
    std::deque<FunctionTexture> functions_;
    std::map<std::string, Partner> partners_;
};

// A view of the virtual camera, 65,536 pixels wide and high, from (1, 1.1, 2.4) * 2 to the middle.
struct Glance {
    glm::dvec3 point;  // relative to the camera
    glm::dvec2 pixel;
};
runtime::Camera glance_camera();
runtime::CameraMatrices glance_matrices();
// Points of the shape that face the camera at 20 degrees or more, drawn with a seed. keep: object space.
std::vector<Glance> glances(runtime::SmoothShape shape, std::size_t count, unsigned seed,
                            const std::function<bool(const runtime::Foot&)>& keep = {});

}  // namespace sg::proof
