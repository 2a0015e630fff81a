#include "import/gltf_import.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "asset/gltf_materials.hpp"

namespace sg::import {
namespace {

using asset::GltfAlpha;
using asset::GltfMaterial;
using asset::GltfTexture;
using asset::GltfWrap;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestName = 64;

// A word for a file from a name from anywhere: letters, digits, "-", "_" and "." that does not lead; never
// taken twice, also where the file system does not tell "A" from "a".
class FileNames {
public:
    std::string make(std::string_view wanted, std::string_view otherwise) {
        std::string word;
        for (char c : wanted.substr(0, 48)) {
            bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                         c == '-' || (c == '.' && !word.empty());
            word.push_back(plain ? c : '_');
        }
        if (word.find_first_not_of("_.") == word.npos) word = otherwise;
        std::string name = word;
        for (int i = 2; !taken_.insert(lower(name)).second; ++i) name = fmt::format("{}_{}", word, i);
        return name;
    }

private:
    static std::string lower(std::string text) {
        for (char& c : text)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return text;
    }
    std::set<std::string> taken_;
};

// Numbers of float files, as a person would write them.
double short_number(double number) {
    return std::stod(fmt::format("{:.7g}", number)) + 0.0;
}
template <std::size_t N>
Json numbers(const std::array<double, N>& from) {
    Json out = Json::array();
    for (double number : from) out.push_back(short_number(number));
    return out;
}

bool is_name(std::string_view text) {
    return !text.empty() && text.size() <= kLongestName &&
           text.find_first_of(
               std::string_view("\0\x01\x02\x03\x04\x05\x06\a\b\t\n\v\f\r\x0e\x0f\x10\x11\x12\x13\x14"
                                "\x15\x16\x17\x18\x19\x1a\x1b\x1c\x1d\x1e\x1f\x7f",
                                33)) == text.npos;
}

std::string_view wrap_word(GltfWrap wrap) {
    return wrap == GltfWrap::repeat ? "repeat" : wrap == GltfWrap::clamp ? "clamp" : "mirror";
}

// Indented text with arrays of numbers on one line.
std::string pretty(const Json& json) {
    // Names may hold bytes that are not UTF-8.
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        out.push_back(text[i]);
        if (text[i] == '"') {  // strings stay as they are
            while (text[++i] != '"') {
                out.push_back(text[i]);
                if (text[i] == '\\') out.push_back(text[++i]);
            }
            out.push_back('"');
            continue;
        }
        const std::size_t end = text[i] == '[' ? text.find_first_of("[]{\"", i + 1) : text.npos;
        if (end == text.npos || text[end] != ']') continue;
        for (++i; i <= end; ++i) {
            if (text[i] == '\n' || text[i] == ' ') continue;
            out.push_back(text[i]);
            if (text[i] == ',') out.push_back(' ');
        }
        --i;
    }
    return out + "\n";
}

// The JSON of one material.
class Writer {
public:
    Writer(const GltfMaterial& from, const std::vector<std::string>& image_files)
        : from_(from), image_files_(image_files) {}

    Json write() {
        Json out;
        out["version"] = 1;
        if (is_name(from_.name)) out["name"] = from_.name;
        Json bump = normal_layer(), surface = surface_of();
        if (!textures_.empty()) out["textures"] = textures_;
        if (!bump.is_null()) out["bump"] = Json::array({{{"layers", Json::array({bump})}}});
        out["surface"] = surface;
        return out;
    }

private:
    // The texture's name, declared when it is met first; one picture may be declared for several uses.
    std::string declare(const GltfTexture& texture, std::string_view encoding, std::string_view name) {
        Json declaration;
        declaration["file"] = "textures/" + image_files_[texture.image];
        declaration["encoding"] = encoding;
        const asset::GltfSampler& sampler = texture.sampler;
        if (sampler != asset::GltfSampler{}) {
            Json& out = declaration["sampler"] = Json::object();
            if (sampler.wrap_s == sampler.wrap_t) {
                out["wrap"] = wrap_word(sampler.wrap_s);
            } else {
                out["wrap_s"] = wrap_word(sampler.wrap_s);
                out["wrap_t"] = wrap_word(sampler.wrap_t);
            }
            if (sampler.nearest) out["filter"] = "nearest";
            if (sampler.nearest_mip) out["mip_filter"] = "nearest";
        }
        for (const auto& [known, value] : textures_.items())
            if (value == declaration) return known;
        textures_[std::string(name)] = declaration;
        return std::string(name);
    }

    // A number for a set that is taken as it is.
    static Json coordinate(const GltfTexture& texture) {
        const double degrees = short_number(-texture.rotation * 180 / std::numbers::pi);
        const bool plain =
            texture.scale == std::array{1.0, 1.0} && texture.offset == std::array{0.0, 0.0} && degrees == 0;
        if (plain) return texture.set;
        Json out;
        out["set"] = texture.set;
        if (texture.scale != std::array{1.0, 1.0}) out["scale"] = numbers(texture.scale);
        if (degrees != 0) out["rotation"] = degrees;
        if (texture.offset != std::array{0.0, 0.0}) out["offset"] = numbers(texture.offset);
        return out;
    }

    Json read(const GltfTexture& texture, std::string_view encoding, std::string_view name,
              const char* channel) {
        Json out;
        out["texture"] = declare(texture, encoding, name);
        if (channel) out["channel"] = channel;
        if (Json uv = coordinate(texture); uv != 0) out["uv"] = uv;
        return out;
    }

    // `number` times a channel of a texture.
    Json scaled(double number, const std::optional<GltfTexture>& texture, std::string_view encoding,
                std::string_view name, const char* channel) {
        if (!texture) return short_number(number);
        Json value = read(*texture, encoding, name, channel);
        if (number == 1) return value;
        return {{"op", "multiply"}, {"a", value}, {"b", short_number(number)}};
    }

    Json scaled_color(const std::array<double, 3>& color, const std::optional<GltfTexture>& texture,
                      std::string_view name) {
        const std::array white{1.0, 1.0, 1.0};
        if (!texture) return numbers(color);
        Json value = read(*texture, "color", name, nullptr);
        if (color == white) return value;
        return {{"op", "multiply_color"}, {"a", value}, {"b", numbers(color)}};
    }

    Json normal_layer() {
        if (!from_.normal_texture) return nullptr;
        Json layer;
        layer["id"] = "normal";
        layer["kind"] = "normal_map";
        layer["texture"] = declare(*from_.normal_texture, "tangent_normal", "normal");
        if (Json uv = coordinate(*from_.normal_texture); uv != 0) layer["uv"] = uv;
        // The file's tangents belong to uv 0, and do not turn with it.
        if (from_.normal_texture->set == 0 && from_.normal_texture->rotation == 0) layer["basis"] = "vertex";
        if (from_.normal_scale != 1) layer["strength"] = short_number(from_.normal_scale);
        return layer;
    }

    Json base_color() {
        const auto& c = from_.base_color;
        Json color = scaled_color({c[0], c[1], c[2]}, from_.base_color_texture, "base_color");
        if (!from_.vertex_color) return color;
        return {{"op", "multiply_color"}, {"a", color}, {"b", {{"op", "vertex_rgb"}}}};
    }

    Json opacity() {
        Json value = scaled(from_.base_color[3], from_.base_color_texture, "color", "base_color", "a");
        if (!from_.vertex_color) return value;
        return {{"op", "multiply"}, {"a", value}, {"b", {{"op", "vertex_color"}, {"channel", "a"}}}};
    }

    Json surface_of() {
        Json out;
        out["base_color"] = base_color();
        out["metallic"] =
            scaled(from_.metallic, from_.metallic_roughness_texture, "mask", "metallic_roughness", "b");
        out["roughness"] =
            scaled(from_.roughness, from_.metallic_roughness_texture, "mask", "metallic_roughness", "g");
        if (from_.occlusion_texture && from_.occlusion_strength > 0) {
            Json red = read(*from_.occlusion_texture, "mask", "occlusion", "r");
            if (from_.occlusion_strength == 1) {
                out["occlusion"] = red;
            } else {
                out["occlusion"] = {
                    {"op", "mix"}, {"a", 1}, {"b", red}, {"t", short_number(from_.occlusion_strength)}};
            }
        }
        if (from_.emission != std::array{0.0, 0.0, 0.0})
            out["emission"] = scaled_color(from_.emission, from_.emission_texture, "emission");
        if (from_.alpha != GltfAlpha::opaque) out["opacity"] = opacity();
        if (from_.alpha == GltfAlpha::mask) out["alpha_test"] = short_number(from_.alpha_cutoff);
        if (from_.double_sided) out["two_sided"] = "flip";
        return out;
    }

    const GltfMaterial& from_;
    const std::vector<std::string>& image_files_;
    Json textures_ = Json::object();
};

}  // namespace

std::optional<ImportedFiles> import_gltf(Files& files, const std::filesystem::path& path, Diags& diags) {
    std::optional<asset::GltfMaterials> gltf = asset::read_gltf_materials(files, path, diags);
    if (!gltf) return std::nullopt;
    ImportedFiles out;
    std::vector<std::string> image_files;
    FileNames image_names, material_names;
    for (std::size_t i = 0; i < gltf->images.size(); ++i) {
        asset::GltfImage& image = gltf->images[i];
        image_files.emplace_back();
        if (image.bytes.empty()) continue;
        image_files.back() =
            image_names.make(image.name, fmt::format("image_{}", i)) + (image.jpeg ? ".jpg" : ".png");
        out.emplace_back("textures/" + image_files.back(), std::move(image.bytes));
    }
    for (std::size_t i = 0; i < gltf->materials.size(); ++i) {
        const GltfMaterial& material = gltf->materials[i];
        std::string stem = material_names.make(material.name, fmt::format("material_{}", i));
        for (const std::string& name : material.left_out) {
            diags.warning(Code::import_left_out, {},
                          fmt::format("'{}': extension '{}' of material '{}' is left out",
                                      printable(path.string()), printable(name), printable(material.name)));
        }
        out.emplace_back(stem + ".json", pretty(Writer(material, image_files).write()));
    }
    return out;
}

}  // namespace sg::import
