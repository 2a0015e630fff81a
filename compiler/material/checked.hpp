// A material in which everything that a user can get wrong is right: names are resolved, files exist, types fit.
// What follows (lowering, optimising, emission) cannot fail on it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "material/material.hpp"

namespace sg::material {

struct CheckedParameter {
    std::string name;
    ParameterType type = ParameterType::scalar;
    std::array<double, 4> fallback{};
    std::optional<std::array<double, 2>> range;
    std::string label;
    std::string unit;
};

struct CheckedTexture {
    std::string name;
    std::string file;  // as written
    std::string hash;  // of the file's bytes
    ir::TextureEncoding encoding{};
    bool green_up = true;
    double zero = 127.5;
    SamplerDecl sampler;
};

struct CheckedLayer {
    std::string id;  // unique; "layer 2" where none was given
    const layers::LayerKind* kind = nullptr;
    std::vector<layers::FieldValue> values;  // one per field of the kind
};

// A number or a parameter, of the count that its use needs.
struct CheckedNumber {
    std::array<double, 4> numbers{};
    ir::ParameterId parameter;
};

struct CheckedMaterial {
    std::string name;
    std::vector<CheckedParameter> parameters;
    std::vector<CheckedTexture> textures;  // those that a layer uses, in the order of the file
    std::vector<CheckedLayer> layers;
    CheckedNumber base_color;
    CheckedNumber metallic;
    CheckedNumber roughness;
    TwoSided two_sided = TwoSided::off;
};

// Where files may be: the material's own folder first, then each -I root.
struct Roots {
    std::vector<std::filesystem::path> folders;
};

inline constexpr std::size_t kMaxTextures = 64;
inline constexpr std::size_t kMaxLayers = 256;

// Reports unknown names, wrong encodings and parameter types, duplicate ids, files that are missing or out of bounds.
// Empty exactly when it added an error.
std::optional<CheckedMaterial> check(const Material& material, Files& files, const Roots& roots, Diags& diags);

// What an artefact knows of a type by name: "float", "vec2", "vec3", "vec4", "color".
std::string_view parameter_type_name(ParameterType type);
ir::Type ir_type(ParameterType type);

// Lowers to a verified module whose outputs are everything that an entry point can ask for.
ir::Module lower(const CheckedMaterial& material);

}  // namespace sg::material
