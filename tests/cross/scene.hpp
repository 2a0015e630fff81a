// One scene and every sample, compiled for every target: what each API needs to draw it, as plain bytes.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/render.hpp"
#include "target/shader_library.hpp"
#include "target/targets.hpp"

namespace sg::cross {

constexpr std::uint32_t kSide = 128;  // pixels per side of every picture

// Planes of rgba per pixel, upper row first: one for each colour attachment, or (depth, depth, depth, 1) of
// an entry point without any. Alpha of the last plane is 0 where nothing was drawn.
using Pixels = std::vector<float>;
constexpr std::size_t kPlane = std::size_t{kSide} * kSide * 4;  // floats

// A row of the manifest: where a target's text has what SPIR-V has at (set, binding).
struct Slot {
    std::string kind;  // "uniform_buffer", "texture" or "sampler"
    std::uint32_t set = 0, binding = 0;
    std::string name;
    std::uint32_t index = 0;  // of register, buffer, texture, sampler, block or unit
    std::uint32_t space = 0;
    std::uint32_t sampler_binding = 0;
};
struct Stage {
    std::string text;
    std::vector<Slot> slots;
};
struct Attribute {
    std::uint32_t location = 0;
    std::uint32_t components = 0;
    std::vector<float> values;
};
struct TextureView {
    const std::vector<asset::Image>* chain = nullptr;
    bool srgb = false;
};

// What is drawn: a view of an entry point. The entry point `function` shows the normal that it returns, in
// the stages of `forward`.
struct Shown {
    std::string_view name;                 // of the entry point
    std::string_view entry;                // whose stages are drawn
    std::vector<std::string_view> views;   // of the runtime; one for each plane
    std::vector<std::string_view> planes;  // what each holds
};
std::span<const Shown> all_shown();
const Shown& shown(std::string_view name);

struct Sample;

// One entry point of one sample in one target; in a target of language spirv without texts, and with all
// slots in `fragment`.
struct Drawing {
    const Sample* sample = nullptr;
    const target::Target* target = nullptr;
    const Shown* shown = nullptr;
    Stage vertex, fragment;
    std::vector<Attribute> attributes;
    std::vector<std::uint32_t> indices;
    std::array<std::vector<std::byte>, 3> blocks;                  // by set: frame, material, object
    std::map<std::uint32_t, TextureView> textures;                 // by binding in set 1
    std::map<std::uint32_t, runtime::gpu::SamplerState> samplers;  // by binding in set 1
    bool cull_back = true;
    std::size_t attachments = 1;  // of colour; 0: depth alone
};

struct Sample {
    std::string name;
    std::map<std::string, std::string> texts;  // every cross-compiled file, by name
    runtime::Artefact artefact;
    runtime::TextureSet textures;
    std::vector<std::byte> parameters;
    std::map<std::string, std::string> glsl;  // as generated, by "<entry>.<stage>"
    std::string manifest;
};

// Those of materials/ and one of tests/cross/materials, which drops pixels.
std::vector<std::string> sample_names();
// Compiled once; every level of detail is explicit (tests/support/own_levels.hpp), so that pictures differ by
// the text alone.
const Sample& sample(const std::string& name);
const target::ShaderLibrary& drawn_library();    // that it is compiled with
const Sample& shipped(const std::string& name);  // with the library as it is
// By another stem, or with another shader library.
Sample make_sample(const std::string& name, const std::string& stem, const target::ShaderLibrary& library);
// The sample with level 0 of each texture alone, in floats: how a driver decodes sRGB is its own affair.
const Sample& base_sample(const Sample& sample);
Drawing drawing(const Sample& sample, const target::Target& target, const Shown& shown = shown("normal"));

// The SPIR-V render, or that of other shaders in its place. `words`: vertex and fragment.
using ShaderWords = std::array<std::vector<std::uint32_t>, 2>;
enum class Driver { llvmpipe, swiftshader };
const Pixels& reference(const Sample& sample, const Shown& shown = shown("normal"),
                        Driver driver = Driver::llvmpipe);
// Drawn once.
const Pixels& render_words(const Sample& sample, const ShaderWords& words,
                           const Shown& shown = shown("normal"), Driver driver = Driver::llvmpipe);
bool has_swiftshader();  // Chromium's, for Vulkan
// What the validation layers said to all that llvmpipe drew.
std::vector<std::string> validation_messages();

// A picture as rgba floats.
std::vector<float> texels_of(const asset::Image& image);
// Level 0 of a texture as a shader reads it: sRGB decoded.
std::vector<float> linear_texels(const TextureView& view);

struct Difference {
    double largest = 0;         // of any channel of any pixel that both cover, but of those on an edge
    double on_edge = 0;         // likewise, of those
    std::size_t edges = 0;      // how many they are
    double p999 = 0;            // 99.9th percentile of all pixels' largest channel
    std::size_t both = 0;       // pixels that both cover
    std::size_t one_alone = 0;  // pixels that one covers and the other does not
};
struct Measure {
    std::size_t plane = 0;
    std::vector<double> unit;   // by pixel, differences count in it; empty: 1
    std::vector<bool> on_edge;  // by pixel: a rounding decides which facet is seen; empty: none
};
Difference compare(const Pixels& a, const Pixels& b, const Measure& measure = {});

}  // namespace sg::cross
