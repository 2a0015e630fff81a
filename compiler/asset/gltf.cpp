#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "asset/gltf_accessor.hpp"
#include "asset/gltf_mesh.hpp"
#include "asset/gltf_parse.hpp"
#include "asset/mesh.hpp"

namespace sg::asset {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostInstances = 1u << 20;

// Extensions that change only what this reader ignores, and quantisation, which it understands.
bool harmless_extension(std::string_view name) {
    return name.starts_with("KHR_materials_") || name.starts_with("KHR_texture_") ||
           name.starts_with("EXT_texture_") || name == "KHR_lights_punctual" ||
           name == "KHR_mesh_quantization" || name == "KHR_animation_pointer" || name == "KHR_xmp_json_ld";
}

class SceneReader {
public:
    SceneReader(const tinygltf::Model& model, Scene& scene)
        : model_(model), scene_(scene), accessors_(model) {}

    bool read() { return check_extensions() && read_meshes() && read_nodes(); }
    std::string reason;

private:
    bool check_extensions();
    bool read_meshes();
    bool read_nodes();
    bool visit(int node, const glm::mat4& world_from_parent, std::vector<std::pair<int, glm::mat4>>& pending);
    bool local_matrix(int index, glm::mat4& out);
    std::vector<int> root_nodes() const;
    bool fail(std::string text);

    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    const tinygltf::Model& model_;
    Scene& scene_;
    AccessorReader accessors_;
    std::vector<Range> meshes_;  // of each glTF mesh in scene_.meshes
    std::vector<bool> visited_;
};

bool SceneReader::fail(std::string text) {
    reason = std::move(text);
    return false;
}

bool SceneReader::check_extensions() {
    for (const std::string& name : model_.extensionsRequired)
        if (!harmless_extension(name))
            return fail(fmt::format("it requires extension '{}'", printable(name)));
    return true;
}

bool SceneReader::read_meshes() {
    for (std::size_t m = 0; m < model_.meshes.size(); ++m) {
        const tinygltf::Mesh& from = model_.meshes[m];
        Range range{scene_.meshes.size(), scene_.meshes.size()};
        for (std::size_t p = 0; p < from.primitives.size(); ++p) {
            std::optional<Mesh> mesh = read_primitive(accessors_, from.primitives[p]);
            if (!mesh) return fail(fmt::format("mesh {}, primitive {}: {}", m, p, accessors_.reason));
            if (mesh->indices.empty()) continue;
            mesh->name = from.name;
            const auto material = static_cast<std::size_t>(from.primitives[p].material);  // -1: none
            if (material < model_.materials.size()) mesh->material = model_.materials[material].name;
            scene_.meshes.push_back(std::move(*mesh));
        }
        range.end = scene_.meshes.size();
        meshes_.push_back(range);
    }
    return true;
}

// The default scene's, else the first scene's; without scenes every node that is nobody's child.
std::vector<int> SceneReader::root_nodes() const {
    if (!model_.scenes.empty()) {
        const bool valid =
            model_.defaultScene >= 0 && static_cast<std::size_t>(model_.defaultScene) < model_.scenes.size();
        return model_.scenes[valid ? static_cast<std::size_t>(model_.defaultScene) : 0].nodes;
    }
    std::vector<bool> is_child(model_.nodes.size());
    for (const tinygltf::Node& node : model_.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

bool all_finite(const glm::mat4& m) {
    const float* numbers = glm::value_ptr(m);
    return std::all_of(numbers, numbers + 16, [](float f) { return std::isfinite(f); });
}

bool SceneReader::local_matrix(int index, glm::mat4& out) {
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    auto has_size = [](const std::vector<double>& v, std::size_t n) { return v.empty() || v.size() == n; };
    if (!has_size(node.matrix, 16) || !has_size(node.translation, 3) || !has_size(node.rotation, 4) ||
        !has_size(node.scale, 3))
        return fail(fmt::format("node {} has a transform of a wrong size", index));
    out = glm::mat4(1.0f);
    if (!node.matrix.empty()) {
        out = glm::mat4(glm::make_mat4(node.matrix.data()));
        return true;
    }
    glm::dmat4 local(1.0);
    if (!node.rotation.empty()) {
        const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        if (!(glm::length(q) > 0.0)) return fail(fmt::format("node {} has a rotation of length 0", index));
        local = glm::mat4_cast(glm::normalize(q));
    }
    for (std::size_t axis = 0; axis < 3 && !node.scale.empty(); ++axis)
        local[static_cast<int>(axis)] *= node.scale[axis];
    if (!node.translation.empty()) local[3] = glm::dvec4(glm::make_vec3(node.translation.data()), 1.0);
    out = glm::mat4(local);
    return true;
}

bool SceneReader::visit(int index, const glm::mat4& world_from_parent,
                        std::vector<std::pair<int, glm::mat4>>& pending) {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
        return fail(fmt::format("there is no node {}", index));
    if (visited_[static_cast<std::size_t>(index)])
        return fail(fmt::format("node {} has two parents or is its own", index));
    visited_[static_cast<std::size_t>(index)] = true;
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    glm::mat4 local;
    if (!local_matrix(index, local)) return false;
    const glm::mat4 world = world_from_parent * local;
    if (!all_finite(world)) return fail(fmt::format("node {} has a transform that is not finite", index));
    if (node.mesh >= 0) {
        if (static_cast<std::size_t>(node.mesh) >= meshes_.size())
            return fail(fmt::format("there is no mesh {}", node.mesh));
        const Range range = meshes_[static_cast<std::size_t>(node.mesh)];
        for (std::size_t m = range.begin; m < range.end; ++m)
            scene_.instances.push_back({node.name, m, world});
        if (scene_.instances.size() > kMostInstances) return fail("too many instances");
    }
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        pending.emplace_back(*child, world);
    return true;
}

bool SceneReader::read_nodes() {
    visited_.assign(model_.nodes.size(), false);
    std::vector<std::pair<int, glm::mat4>> pending;
    const std::vector<int> roots = root_nodes();
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        pending.emplace_back(*root, glm::mat4(1.0f));
    while (!pending.empty()) {
        const auto [index, world_from_parent] = pending.back();
        pending.pop_back();
        if (!visit(index, world_from_parent, pending)) return false;
    }
    if (!model_.nodes.empty()) return true;
    for (std::size_t m = 0; m < scene_.meshes.size(); ++m)
        scene_.instances.push_back({scene_.meshes[m].name, m, glm::mat4(1.0f)});
    return true;
}

}  // namespace

std::optional<Scene> read_gltf(Files& files, const fs::path& path, Diags& diags) {
    const std::optional<tinygltf::Model> model = parse_gltf(files, path, diags);
    if (!model) return std::nullopt;
    Scene scene;
    SceneReader reader(*model, scene);
    if (!reader.read()) {
        report_gltf(path, reader.reason, diags);
        return std::nullopt;
    }
    if (scene.instances.empty()) {
        diags.error(Code::mesh_empty, fmt::format("'{}' draws no triangles", printable(path.string())));
        return std::nullopt;
    }
    return scene;
}

}  // namespace sg::asset
