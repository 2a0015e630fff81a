#include "runtime/scene.hpp"

#include <fmt/core.h>

#include <set>

#include "runtime/mesh/shapes.hpp"

namespace sg::runtime {
namespace {

// Drops the instances of other materials; meshes stay, so that indices hold.
bool keep_material(asset::Scene& scene, std::string_view file, std::string_view material, Diags& diags) {
    std::set<std::string_view> names;
    for (const asset::Instance& instance : scene.instances)
        names.insert(scene.meshes[instance.mesh].material);
    if (!names.count(material)) {
        std::vector<std::string_view> known(names.begin(), names.end());
        diags.error(Code::bad_argument,
                    fmt::format("--mesh-material: '{}' has no material '{}', expected {}{}", printable(file),
                                printable(material), one_of(known), did_you_mean(material, known)));
        return false;
    }
    std::erase_if(scene.instances, [&](const asset::Instance& instance) {
        return scene.meshes[instance.mesh].material != material;
    });
    return true;
}

}  // namespace

std::optional<asset::Scene> load_content(Files& files, std::string_view shape_or_file,
                                         std::string_view material, Diags& diags, int detail) {
    if (auto shape = make_shape(shape_or_file, detail)) {
        if (!material.empty()) {
            diags.error(Code::bad_argument,
                        fmt::format("--mesh-material: the shape '{}' has no materials, expected a --mesh "
                                    "FILE.gltf or FILE.glb",
                                    shape_or_file));
            return std::nullopt;
        }
        asset::Scene scene;
        scene.meshes.push_back(std::move(*shape));
        scene.instances.push_back({std::string(shape_or_file), 0});
        return scene;
    }
    std::filesystem::path path(shape_or_file);
    if (path.has_extension() || files.exists(path)) {
        auto scene = asset::read_gltf(files, path, diags);
        if (!scene || material.empty()) return scene;
        return keep_material(*scene, shape_or_file, material, diags) ? std::move(scene) : std::nullopt;
    }
    diags.error(Code::bad_argument,
                fmt::format("'{}' is neither a built-in shape ({}) nor a file{}", printable(shape_or_file),
                            one_of(shape_names()), did_you_mean(shape_or_file, shape_names())));
    return std::nullopt;
}

}  // namespace sg::runtime
