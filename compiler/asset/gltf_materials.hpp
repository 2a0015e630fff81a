// The materials of a glTF 2.0 file, as they stand there (core metallic-roughness, KHR_texture_transform,
// KHR_materials_emissive_strength).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "base/files.hpp"

namespace sg::asset {

// A picture as its file holds it: PNG or JPEG bytes.
struct GltfImage {
    std::string name;   // of the file it came from, or of the image; may be empty
    std::string bytes;  // empty where no material uses it
    bool jpeg = false;
};

enum class GltfWrap { repeat, clamp, mirror };
struct GltfSampler {
    GltfWrap wrap_s = GltfWrap::repeat, wrap_t = GltfWrap::repeat;
    bool nearest = false;      // magnified
    bool nearest_mip = false;  // between levels
    bool operator==(const GltfSampler&) const = default;
};

// st' = R (scale st) + offset, where a positive rotation turns +s towards -t: glTF says counter-clockwise,
// and t points down.
struct GltfTexture {
    std::size_t image = 0;  // into GltfMaterials::images
    GltfSampler sampler;
    std::uint32_t set = 0;  // TEXCOORD_n
    std::array<double, 2> scale{1, 1}, offset{0, 0};
    double rotation = 0;  // radians
};

enum class GltfAlpha { opaque, mask, blend };
struct GltfMaterial {
    std::string name;  // may be empty
    std::array<double, 4> base_color{1, 1, 1, 1};
    double metallic = 1, roughness = 1;
    std::array<double, 3> emission{0, 0, 0};  // with the strength of KHR_materials_emissive_strength
    double normal_scale = 1, occlusion_strength = 1;
    std::optional<GltfTexture> base_color_texture;          // sRGB, alpha linear
    std::optional<GltfTexture> metallic_roughness_texture;  // blue and green
    std::optional<GltfTexture> normal_texture;              // green up
    std::optional<GltfTexture> occlusion_texture;           // red
    std::optional<GltfTexture> emission_texture;            // sRGB
    GltfAlpha alpha = GltfAlpha::opaque;
    double alpha_cutoff = 0.5;
    bool double_sided = false;
    bool vertex_color = false;  // every primitive that uses it has COLOR_0, a factor on the base colour
    std::vector<std::string> left_out;  // names of its other extensions
};

struct GltfMaterials {
    std::vector<GltfMaterial> materials;
    std::vector<GltfImage> images;
};

// Reads the materials and the pictures that they use through `files`; a picture must lie below the file's
// folder. Errors: mesh_format (damage, no materials), image_format (a picture that is neither PNG nor JPEG),
// file_missing, file_unreadable, path_escapes. Never crashes on hostile bytes.
std::optional<GltfMaterials> read_gltf_materials(Files& files, const std::filesystem::path& path,
                                                 Diags& diags);

}  // namespace sg::asset
