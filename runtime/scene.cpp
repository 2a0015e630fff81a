#include "runtime/scene.hpp"

#include <fmt/core.h>

#include "runtime/mesh/shapes.hpp"

namespace sg::runtime {

std::optional<asset::Scene> load_content(Files& files, std::string_view shape_or_file, Diags& diags) {
    if (auto shape = make_shape(shape_or_file)) {
        asset::Scene scene;
        scene.meshes.push_back(std::move(*shape));
        scene.instances.push_back({std::string(shape_or_file), 0});
        return scene;
    }
    std::filesystem::path path(shape_or_file);
    if (path.has_extension() || files.exists(path)) return asset::read_gltf(files, path, diags);
    diags.error(Code::bad_argument,
                fmt::format("'{}' is neither a built-in shape ({}) nor a file{}", printable(shape_or_file),
                            one_of(shape_names()), did_you_mean(shape_or_file, shape_names())));
    return std::nullopt;
}

}  // namespace sg::runtime
