// An artefact as compiler/artefacts.md describes it: the manifest in plain structs, with the shaders it
// names.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diag.hpp"
#include "base/files.hpp"
#include "runtime/expression.hpp"
#include "runtime/gpu/sampler_state.hpp"

namespace sg::runtime {

struct ShaderStage {
    std::string file;  // a plain name, beside the manifest
    std::string hash;
    std::vector<std::uint32_t> words;
};

struct VertexInput {
    std::string name;  // "position", "normal", "tangent", "color", "uv0" to "uv7"
    std::uint32_t location = 0;
    std::uint32_t components = 0;  // floats, 2 to 4
};

struct BindingSlot {
    enum class Kind { uniform_buffer, texture, sampler };
    std::uint32_t set = 0;  // 0 to 2
    std::uint32_t binding = 0;
    Kind kind = Kind::uniform_buffer;
    bool in_vertex = false;
    bool in_fragment = false;
};

enum class ViewKind { radiance, direction, position, uv, vector };
struct DebugView {
    std::string name;
    std::uint32_t number = 0;
    std::uint32_t components = 3;  // 1 to 4; with 4, alpha is data and not coverage
    ViewKind kind = ViewKind::vector;
};

struct EntryPoint {
    std::string name;
    ShaderStage vertex;
    ShaderStage fragment;
    std::vector<VertexInput> inputs;
    std::vector<BindingSlot> bindings;
    std::vector<DebugView> views;
    std::vector<std::string> outputs;  // float4s that the fragment stage writes, by location
};

struct Parameter {
    std::string name;
    std::string
        type;  // "float", "vec2", "vec3", "vec4", "color", "bool", "int" (both are floats, too) or "mat4"
    std::size_t offset = 0;
    std::vector<float> initial;  // as many numbers as the type says; a matrix by its columns
    std::optional<std::array<double, 2>> range;
};
// Numbers that are computed from the parameters whenever one of them changes.
struct DerivedParameter {
    std::size_t offset = 0;
    std::size_t count = 1;  // of numbers
    Expression expression;
};
struct ParameterBlock {
    std::size_t size = 0;  // bytes, a multiple of 16
    std::vector<Parameter> parameters;
    std::vector<Expression> steps;  // each may use the earlier ones
    std::vector<DerivedParameter> derived;
};

struct TextureSlot {
    enum class Encoding { plain, normal_xyz, normal_xy };
    std::string name;           // for messages
    std::string file;           // as the author wrote it, relative to the texture root
    std::string hash;           // "": not known
    std::uint32_t binding = 0;  // in set 1
    Encoding encoding = Encoding::plain;
    double zero = 127.5;
    std::array<int, 4> channels{0, 1, 2, 3};  // of a normal: where x, y, z and the rest stand
    bool srgb = false;
    std::uint32_t sampler_binding = 0;  // in set 1: the sampler that it is read with
    std::string parameter;              // that exchanges the file; "" without one
};

struct SamplerSlot {
    std::uint32_t binding = 0;  // in set 1
    gpu::SamplerState state;
};

struct Artefact {
    std::string name;
    std::filesystem::path folder;  // of the manifest
    bool two_sided = false;
    std::vector<EntryPoint> entries;
    std::optional<ParameterBlock> parameters;
    std::vector<TextureSlot> textures;
    std::vector<SamplerSlot> samplers;

    [[nodiscard]] const EntryPoint* entry(std::string_view name) const;  // null if there is none
};

// Whether a text is a manifest (as opposed to a material): a JSON object with "format": "surfgrad-artefact".
bool is_manifest(std::string_view text);

// The manifest alone, without the words of its shaders; `file` stands in messages. All of its errors are
// reported, each as manifest_format with the JSON pointer of the value.
std::optional<Artefact> read_manifest(std::string_view text, std::string_view file, Diags& diags);

// The manifest and its shaders. Fails with file_missing, file_unreadable, manifest_format, or
// manifest_mismatch where a shader's bytes do not have the hash that the manifest states.
std::optional<Artefact> read_artefact(Files& files, const std::filesystem::path& manifest, Diags& diags);

}  // namespace sg::runtime
