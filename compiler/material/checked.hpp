// A material in which everything that a user can get wrong is right: names are resolved, files exist, types
// fit. What follows (lowering, optimising, emission) cannot fail on it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "base/limits.hpp"
#include "layers/lower_context.hpp"
#include "material/find_file.hpp"
#include "material/material.hpp"

namespace sg::material {

struct CheckedParameter {
    std::string name;
    ParameterType type = ParameterType::scalar;
    std::array<double, 16> fallback{};  // a matrix by its columns
    std::optional<std::array<double, 2>> range;
    std::string label;
    std::string unit;
};

struct CheckedTexture {
    std::string name;
    std::string file;       // as written, seen from the material's folder
    std::string hash;       // of the file's bytes
    std::string parameter;  // that replaces the file; "" without one
    std::string label;      // of the parameter
    ir::TextureEncoding encoding{};
    layers::TextureFacts facts;
    ColorSpace color_space = ColorSpace::linear;
    SamplerDecl sampler;
};

struct CheckedLayer {
    std::string id;                           // unique; "layer 2" where none was given
    const layers::LayerKind* kind = nullptr;  // null for a group
    std::vector<layers::FieldValue> values;   // one per field of the kind
    std::vector<layers::FieldValue> common;   // one per common field
    std::vector<CheckedLayer> group;
    std::vector<CheckedLayer> equivalent;  // at most one
};

// A file of the user's GLSL. What it says is checked by who has a compiler at hand.
struct CheckedShader {
    std::string file;  // as written
    SourcePtr source;
    std::string hash;                // of its bytes
    std::string text;                // under names that collide with nothing; empty until it was verified
    std::vector<std::string> names;  // those
};

// What a layer wants of such a file.
struct ShaderCall {
    std::size_t shader = 0;
    std::string function;
    std::string result;                  // GLSL type
    std::vector<std::string> arguments;  // GLSL types
    At file_at, function_at;
};

struct CheckedParallax {
    const layers::ParallaxKind* kind = nullptr;
    std::vector<layers::FieldValue> values;  // one per field of the kind
};

struct CheckedSurface {
    std::uint32_t lighting = 0;              // into ir::all_lighting_models()
    std::vector<layers::FieldValue> values;  // one per field of layers::surface_fields()
    std::optional<double> alpha_test;
    TwoSided two_sided = TwoSided::off;
};

struct CheckedMaterial {
    std::string name;
    std::vector<CheckedParameter> parameters;
    std::vector<CheckedTexture> textures;  // those that a layer or node names, in the order of the file
    std::vector<layers::NodeInstance> nodes;
    std::vector<std::pair<std::string, std::string>> bases;  // that it extends: file and hash
    std::vector<CheckedShader> shaders;
    std::vector<ShaderCall> calls;
    std::optional<CheckedParallax> parallax;        // of the first stage
    std::vector<std::vector<CheckedLayer>> stages;  // each ends in a resolve
    std::vector<std::string> stage_ids;             // "" where none was given
    CheckedSurface surface;
    Budget budget;
    SourcePtr source;  // of the budget: of an instance, the material that it extends
};

inline constexpr std::size_t kMaxTextures = 64;
inline constexpr std::size_t kMaxLayers = 256;
inline constexpr std::size_t kMaxStages = 8;
inline constexpr std::size_t kMaxArguments = 32;
// Of the block, what is left by the derived parameters, of at most 16 bytes each.
inline constexpr std::uint32_t kMaxParameterBytes = kMaxBlockBytes - kMaxDerived * 16;
inline constexpr std::size_t kMaxShaderBytes = 1u << 20u;  // of one file

// Reports unknown names, wrong encodings and types, cycles, duplicate ids, files that are missing or out of
// bounds. Empty exactly when it added an error.
std::optional<CheckedMaterial> check(const Material& material, Files& files, const Roots& roots,
                                     Diags& diags);

ir::Type ir_type(ParameterType type);  // of one that is no texture; true is 1
// How many numbers it is.
std::size_t number_count(ParameterType type);

// Whether "green", "zero", "range" or "swizzle" means something for a texture of this encoding.
bool setting_counts(std::string_view setting, ir::TextureEncoding encoding);
// How many channels an encoding has; 0: it cannot be swizzled, for what reads it gathers texels of red.
std::size_t channel_count(ir::TextureEncoding encoding);

// Layers of the user's own GLSL: called, or replaced by the layers that they are equivalent to.
enum class Custom { called, replaced };
// Whether each of them has an equivalent.
bool has_reference(const CheckedMaterial& material);

// Lowers to a verified module whose outputs are everything that an entry point can ask for.
ir::Module lower(const CheckedMaterial& material, Custom custom = Custom::called,
                 layers::Numbers numbers = layers::Numbers::baked);

}  // namespace sg::material
