// What a shader takes in and gives out: the one truth for the GLSL text and for the manifest.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/ir.hpp"

namespace sg::emit {

// ---- what the material has, alike for all entry points (set 1) ----

struct ParameterSlot {
    std::string member;  // GLSL name in the block
    ir::Type type{};
    std::uint32_t offset = 0;  // std140, bytes
};

struct TextureSlot {
    std::string variable;       // GLSL name
    std::uint32_t texture = 0;  // into ir::Module::textures
    std::uint32_t binding = 0;
    std::uint32_t sampler = 0;  // into MaterialInterface::samplers
};

struct SamplerSlot {
    std::string variable;
    std::uint32_t group = 0;  // the caller's number for samplers that are set alike
    std::uint32_t binding = 0;
};

struct MaterialInterface {
    std::vector<ParameterSlot> parameters;  // one per parameter of the module, then one per derived number
    std::uint32_t block_size = 0;           // bytes, a multiple of 16; 0 without parameters
    std::vector<TextureSlot> textures;      // those that the module samples, by binding
    std::vector<SamplerSlot> samplers;

    std::size_t first_derived = 0;  // of `parameters`

    [[nodiscard]] const TextureSlot* texture(std::uint32_t index) const;
};

// `sampler_group[i]` tells which textures sample alike. `module` is the optimised one: textures that it does
// not sample get no binding. Bindings are dense: the block (if any) is 0, textures start at 1, samplers
// follow.
MaterialInterface material_interface(const ir::Module& module, std::span<const std::uint32_t> sampler_group);

// Whether a value of this attribute is read from the block.
bool reads_block(ir::Attribute attribute);

// ---- what one entry point uses ----

// What the vertex stage hands to the fragment stage.
struct Varying {
    ir::Op source{};        // one of the operations that read the vertex stage
    std::uint32_t set = 0;  // of a uv_set
};
bool is_varying(ir::Op op);

struct VertexInput {
    std::string_view name;  // of the attribute: "position", "uv0"
    std::string_view format;
    std::string_view glsl_type;
    std::uint32_t location = 0;
};
// The attribute that a varying is made from.
VertexInput vertex_input(const Varying& varying);
// All attributes that a vertex shader reads for these: position, which places the vertex, and each other one
// once.
std::vector<VertexInput> vertex_inputs(std::span<const Varying> varyings);
// Between the stages: names are "sg_out_<name>" and "sg_in_<name>".
std::uint32_t varying_location(const Varying& varying);
std::string_view varying_name(const Varying& varying);

enum class BindingKind { uniform_buffer, texture, sampler };
struct Binding {
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    BindingKind kind{};
    std::string name;
    bool in_vertex = false;
    bool in_fragment = false;
};

struct View {
    std::string name;
    std::uint32_t number = 0;
    std::uint32_t components = 3;
    std::string_view kind;  // "direction", "position", "uv" or "vector"
};

struct EntryInterface {
    std::vector<Varying> varyings;  // by location; position is always fed to the vertex stage
    std::vector<Binding> bindings;  // by set and binding
    std::vector<View> views;        // of the debug entry
};

}  // namespace sg::emit
