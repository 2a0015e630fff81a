#include "asset/gltf_materials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "asset/gltf_parse.hpp"

namespace sg::asset {
namespace {

namespace fs = std::filesystem;

// "a%20b.png" -> "a b.png"; what is no escape stays.
std::string percent_decoded(std::string_view uri) {
    auto hex = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        if (c >= 'a' && c <= 'f') return c - 'a' + 10;
        return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        bool escape = uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0;
        out.push_back(escape ? static_cast<char>(hex(uri[i + 1]) * 16 + hex(uri[i + 2])) : uri[i]);
        if (escape) i += 2;
    }
    return out;
}

GltfWrap wrap_of(int code) {
    if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return GltfWrap::clamp;
    return code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? GltfWrap::mirror : GltfWrap::repeat;
}

class MaterialsReader {
public:
    MaterialsReader(const tinygltf::Model& model, Files& files, const fs::path& path, Diags& diags)
        : model_(model), files_(files), path_(path), diags_(diags) {}

    std::optional<GltfMaterials> read() {
        out_.images.resize(model_.images.size());
        used_.assign(model_.images.size(), false);
        if (model_.materials.empty()) report("it holds no materials");
        for (const tinygltf::Material& material : model_.materials)
            out_.materials.push_back(read_material(material));
        for (std::size_t i = 0; i < used_.size(); ++i)
            if (used_[i]) read_image(i);
        if (failed_) return std::nullopt;
        return std::move(out_);
    }

private:
    void report(std::string_view reason) {
        failed_ = true;
        report_gltf(path_, reason, diags_);
    }
    void error(Code code, std::string message) {
        failed_ = true;
        diags_.error(code, std::move(message));
    }

    GltfMaterial read_material(const tinygltf::Material& from);
    template <class Info>
    std::optional<GltfTexture> texture(const Info& info);
    void transform(const tinygltf::ExtensionMap& extensions, GltfTexture& texture);
    [[nodiscard]] GltfSampler sampler(int index) const;
    double factor(double number, std::string_view what);
    [[nodiscard]] bool has_vertex_color(std::size_t material) const;
    void read_image(std::size_t index);
    std::optional<std::string> image_bytes(const tinygltf::Image& image, std::size_t index);
    std::optional<std::string> bytes_of_view(int view, std::size_t image);
    std::optional<std::string> bytes_of_file(const std::string& uri);

    const tinygltf::Model& model_;
    Files& files_;
    const fs::path& path_;
    Diags& diags_;
    GltfMaterials out_;
    std::vector<bool> used_;  // images
    bool failed_ = false;
};

double MaterialsReader::factor(double number, std::string_view what) {
    if (number >= 0 && number <= 1) return number;
    report(fmt::format("{} is {}, expected 0 to 1", what, number));
    return 1;
}

GltfSampler MaterialsReader::sampler(int index) const {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.samplers.size()) return {};
    const tinygltf::Sampler& from = model_.samplers[static_cast<std::size_t>(index)];
    bool nearest_mip = from.minFilter == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                       from.minFilter == TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST ||
                       from.minFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    return {wrap_of(from.wrapS), wrap_of(from.wrapT), from.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST,
            nearest_mip};
}

// A pair of finite numbers, or what it was.
void read_pair(const tinygltf::Value& object, const char* key, std::array<double, 2>& out) {
    const tinygltf::Value& value = object.Get(key);
    if (!value.IsArray() || value.ArrayLen() != 2) return;
    for (int i = 0; i < 2; ++i)
        if (value.Get(i).IsNumber()) out[static_cast<std::size_t>(i)] = value.Get(i).GetNumberAsDouble();
}

void MaterialsReader::transform(const tinygltf::ExtensionMap& extensions, GltfTexture& texture) {
    auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end() || !found->second.IsObject()) return;
    const tinygltf::Value& object = found->second;
    read_pair(object, "scale", texture.scale);
    read_pair(object, "offset", texture.offset);
    if (object.Get("rotation").IsNumber()) texture.rotation = object.Get("rotation").GetNumberAsDouble();
    if (object.Get("texCoord").IsInt())
        texture.set = static_cast<std::uint32_t>(std::clamp(object.Get("texCoord").GetNumberAsInt(), 0, 99));
}

template <class Info>
std::optional<GltfTexture> MaterialsReader::texture(const Info& info) {
    if (info.index < 0) return std::nullopt;
    if (static_cast<std::size_t>(info.index) >= model_.textures.size()) {
        report(fmt::format("there is no texture {}", info.index));
        return std::nullopt;
    }
    const tinygltf::Texture& from = model_.textures[static_cast<std::size_t>(info.index)];
    if (from.source < 0 || static_cast<std::size_t>(from.source) >= model_.images.size()) {
        report(fmt::format("texture {} names no picture as PNG or JPEG", info.index));
        return std::nullopt;
    }
    GltfTexture out;
    out.image = static_cast<std::size_t>(from.source);
    out.sampler = sampler(from.sampler);
    out.set = static_cast<std::uint32_t>(std::clamp(info.texCoord, 0, 99));
    transform(info.extensions, out);
    if (out.set > 7) report(fmt::format("TEXCOORD_{} is named, expected 0 to 7", out.set));
    used_[out.image] = true;
    return out;
}

bool MaterialsReader::has_vertex_color(std::size_t material) const {
    bool used = false;
    for (const tinygltf::Mesh& mesh : model_.meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            if (primitive.material != static_cast<int>(material)) continue;
            if (!primitive.attributes.count("COLOR_0")) return false;
            used = true;
        }
    }
    return used;
}

GltfMaterial MaterialsReader::read_material(const tinygltf::Material& from) {
    GltfMaterial out;
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    out.name = from.name;
    for (std::size_t i = 0; i < 4 && i < pbr.baseColorFactor.size(); ++i)
        out.base_color[i] = factor(pbr.baseColorFactor[i], "a baseColorFactor");
    out.metallic = factor(pbr.metallicFactor, "a metallicFactor");
    out.roughness = factor(pbr.roughnessFactor, "a roughnessFactor");
    out.occlusion_strength = factor(from.occlusionTexture.strength, "an occlusionTexture's strength");
    out.normal_scale = from.normalTexture.scale;
    if (!(std::abs(out.normal_scale) <= 1000))
        report(fmt::format("a normalTexture's scale is {}, expected -1000 to 1000", out.normal_scale));
    double strength = 1;
    for (const auto& [name, value] : from.extensions) {
        if (name == "KHR_materials_emissive_strength") {
            if (value.Get("emissiveStrength").IsNumber())
                strength = value.Get("emissiveStrength").GetNumberAsDouble();
        } else {
            out.left_out.push_back(name);
        }
    }
    if (!(strength >= 0 && strength <= 10000)) {
        report(fmt::format("an emissiveStrength is {}, expected 0 to 10000", strength));
        strength = 1;
    }
    for (std::size_t i = 0; i < 3 && i < from.emissiveFactor.size(); ++i)
        out.emission[i] = strength * factor(from.emissiveFactor[i], "an emissiveFactor");
    out.base_color_texture = texture(pbr.baseColorTexture);
    out.metallic_roughness_texture = texture(pbr.metallicRoughnessTexture);
    out.normal_texture = texture(from.normalTexture);
    out.occlusion_texture = texture(from.occlusionTexture);
    out.emission_texture = texture(from.emissiveTexture);
    out.alpha = from.alphaMode == "MASK"    ? GltfAlpha::mask
                : from.alphaMode == "BLEND" ? GltfAlpha::blend
                                            : GltfAlpha::opaque;
    out.alpha_cutoff = std::clamp(from.alphaCutoff, 0.0, 1.0);
    out.double_sided = from.doubleSided;
    out.vertex_color = has_vertex_color(out_.materials.size());
    return out;
}

std::optional<std::string> MaterialsReader::bytes_of_view(int view, std::size_t image) {
    const bool exists = view >= 0 && static_cast<std::size_t>(view) < model_.bufferViews.size();
    const tinygltf::BufferView* from = exists ? &model_.bufferViews[static_cast<std::size_t>(view)] : nullptr;
    const bool has_buffer =
        from && from->buffer >= 0 && static_cast<std::size_t>(from->buffer) < model_.buffers.size();
    if (has_buffer) {
        const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(from->buffer)].data;
        if (from->byteOffset <= data.size() && from->byteLength <= data.size() - from->byteOffset)
            return std::string(reinterpret_cast<const char*>(data.data()) + from->byteOffset,
                               from->byteLength);
    }
    report(fmt::format("image {} lies outside of its buffer", image));
    return std::nullopt;
}

std::optional<std::string> MaterialsReader::bytes_of_file(const std::string& uri) {
    const fs::path relative = fs::path(percent_decoded(uri)).lexically_normal();
    const fs::path folder = path_.parent_path();
    const fs::path inside = files_.canonical(folder / relative).lexically_relative(files_.canonical(folder));
    if (relative.is_absolute() || relative.empty() || inside.empty() || *inside.begin() == "..") {
        error(Code::path_escapes, fmt::format("'{}' names the picture '{}', which leaves its folder",
                                              printable(path_.string()), printable(uri)));
        return std::nullopt;
    }
    Files::ReadResult result = files_.read(folder / relative);
    if (result.status == Files::Status::ok) return std::move(result.bytes);
    const bool missing = result.status == Files::Status::missing;
    error(missing ? Code::file_missing : Code::file_unreadable,
          fmt::format("'{}' names the picture '{}', {}", printable(path_.string()), printable(uri),
                      missing ? "which does not exist" : "which cannot be read: " + result.reason));
    return std::nullopt;
}

std::optional<std::string> MaterialsReader::image_bytes(const tinygltf::Image& image, std::size_t index) {
    if (image.bufferView >= 0) return bytes_of_view(image.bufferView, index);
    if (!image.image.empty())  // of a data URI
        return std::string(image.image.begin(), image.image.end());
    return bytes_of_file(image.uri);
}

void MaterialsReader::read_image(std::size_t index) {
    const tinygltf::Image& from = model_.images[index];
    std::optional<std::string> bytes = image_bytes(from, index);
    if (!bytes) return;
    const bool png = bytes->starts_with("\x89PNG");
    const bool jpeg = bytes->starts_with("\xFF\xD8\xFF");
    const bool in_file = from.bufferView < 0 && from.image.empty();
    std::string name = in_file ? fs::path(percent_decoded(from.uri)).stem().string() : from.name;
    if (!png && !jpeg) {
        error(Code::image_format, fmt::format("'{}': image {} ('{}') is neither PNG nor JPEG",
                                              printable(path_.string()), index, printable(name)));
        return;
    }
    out_.images[index] = {std::move(name), std::move(*bytes), jpeg};
}

}  // namespace

std::optional<GltfMaterials> read_gltf_materials(Files& files, const fs::path& path, Diags& diags) {
    const std::optional<tinygltf::Model> model = parse_gltf(files, path, diags);
    if (!model) return std::nullopt;
    return MaterialsReader(*model, files, path, diags).read();
}

}  // namespace sg::asset
