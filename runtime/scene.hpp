// What is drawn and from where.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string_view>

#include "asset/mesh.hpp"
#include "base/diag.hpp"
#include "base/files.hpp"
#include "runtime/camera.hpp"

namespace sg::runtime {

struct Light {
    glm::dvec3 direction{-0.5, 0.8, 0.6};  // from the surface towards the light, world axes; any length but 0
    glm::dvec3 radiance{1.1};              // irradiance on a facing surface divided by pi, linear
    glm::dvec3 ambient{0.09};              // radiance from all around, linear
};

struct Scene {
    asset::Scene content;
    Camera camera;
    Light light;
};

// A built-in shape by its name (`detail` times as fine as usual), or the scene of a .gltf or .glb file; where
// `material` is not "", only the parts of the scene that have the glTF material of that name. Fails with
// bad_argument (neither a shape nor a file, with the nearest shape; no such material), or with what read_gltf
// reports.
std::optional<asset::Scene> load_content(Files& files, std::string_view shape_or_file,
                                         std::string_view material, Diags& diags, int detail = 1);

}  // namespace sg::runtime
