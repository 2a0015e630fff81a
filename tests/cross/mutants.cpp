#include "tests/cross/mutants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "tests/cross/results.hpp"
#include "tests/cross/wgsl.hpp"

namespace sg::cross {
namespace {

using target::Language;

void change(std::string& text, const char* pattern, const std::string& with) {
    std::string changed = std::regex_replace(text, std::regex(pattern), with);
    if (changed == text) throw std::runtime_error(fmt::format("nothing like {} in\n{}", pattern, text));
    text = std::move(changed);
}

void swap_words(std::string& text, const std::string& a, const std::string& b) {
    std::size_t at = text.find(a), other = text.find(b);
    if (at == text.npos || other == text.npos)
        throw std::runtime_error(fmt::format("no {} and {} in\n{}", a, b, text));
    text.replace(std::max(at, other), at < other ? b.size() : a.size(), at < other ? a : b);
    text.replace(std::min(at, other), at < other ? a.size() : b.size(), at < other ? b : a);
}

// The first two textures of the fragment shader are read from each other's place. ESSL 3.00 states no places:
// there the manifest is wrong.
void swap_bindings(Drawing& drawing) {
    std::vector<Slot*> textures;
    for (Slot& slot : drawing.fragment.slots) {
        if (slot.kind == "texture") textures.push_back(&slot);
    }
    if (drawing.target->version == 300) return std::swap(textures.at(0)->name, textures.at(1)->name);
    auto place = [&](const Slot& slot) -> std::string {
        switch (drawing.target->language) {
            case Language::spirv:
                return fmt::format("@group({}) @binding({})", slot.set, slot.binding);
            case Language::hlsl:
                return drawing.target->version > 50
                           ? fmt::format("register(t{}, space{})", slot.index, slot.space)
                           : fmt::format("register(t{})", slot.index);
            case Language::msl:
                return fmt::format("[[texture({})]]", slot.index);
            default:
                return fmt::format("layout(binding = {}) uniform", slot.index);
        }
    };
    swap_words(drawing.fragment.text, place(*textures.at(0)), place(*textures.at(1)));
}

void transpose_matrix(Drawing& drawing) {
    std::string& text = drawing.vertex.text;
    switch (drawing.target->language) {
        case Language::spirv:
            return change(text, "\\((mat3x3<f32>\\([^;]*\\)) \\* (_e\\d+)\\);", "($2 * $1);");
        case Language::hlsl:
            return change(text, "row_major float4x4 sg_object_block_normal",
                          "column_major float4x4 sg_object_block_normal");
        case Language::msl:
            return change(text, "= (float3x3\\(sg_object_block.normal[^;]*\\)) \\* normal;",
                          "= normal * $1;");
        default:
            return change(text, "= (mat3\\(sg_object_block.normal[^;]*\\)) \\* normal;", "= normal * $1;");
    }
}

void flip_t(Drawing& drawing) {
    std::string& text = drawing.fragment.text;
    switch (drawing.target->language) {
        case Language::spirv:
            return change(text, "textureSampleGrad\\((\\w+), (\\w+), (_e\\d+),",
                          "textureSampleGrad($1, $2, vec2<f32>($3.x, 1f - $3.y),");
        case Language::hlsl:
            return change(text, "SampleGrad\\(filtering, uv.st,",
                          "SampleGrad(filtering, float2(uv.st.x, 1.0f - uv.st.y),");
        case Language::msl:
            return change(text, "sample\\(filtering, uv.st,",
                          "sample(filtering, float2(uv.st.x, 1.0 - uv.st.y),");
        default:
            return change(text, "textureGrad\\(image, uv.st,",
                          "textureGrad(image, vec2(uv.st.x, 1.0 - uv.st.y),");
    }
}

// ---- of the function's caller ----

void swap_arguments(Drawing& drawing) {
    change(drawing.fragment.text, "made = (\\w+)\\((\\w+), (\\w+), (\\w+), (\\w+),",
           "made = $1($2, $3, $5, $4,");
}
void flip_given_t(Drawing& drawing) {
    const std::string vec2 =
        drawing.target->language == Language::hlsl || drawing.target->language == Language::msl ? "float2"
                                                                                                : "vec2";
    change(drawing.fragment.text, "given.uv0 = ([^;]*);", "given.uv0 = " + vec2 + "($1.x, 1.0 - $1.y);");
}
void point_dy_up(Drawing& drawing) {
    change(drawing.fragment.text, "given.uv0_dy = ", "given.uv0_dy = -1.0 * ");
}
void forget_back_faces(Drawing& drawing) {
    change(drawing.fragment.text, "given.facing = [^;]*;", "given.facing = -1.0;");
}

void keep_clip_space(Drawing& drawing) {
    change(drawing.vertex.text, "\n *(\\w+\\.|)gl_Position.y = -[^\n]*", "");
}

// ---- of attachments and of depth ----

void swap_attachments(Drawing& drawing) {
    std::string& text = drawing.fragment.text;
    switch (drawing.target->language) {
        case Language::spirv:
            return swap_words(text, "@location(0) member:", "@location(1) member_1:");
        case Language::hlsl:
            return swap_words(text, "SV_Target0", "SV_Target1");
        case Language::msl:
            return swap_words(text, "[[color(0)]]", "[[color(1)]]");
        default:
            return swap_words(text, "layout(location = 0) out", "layout(location = 1) out");
    }
}
void turn_alpha_test(Drawing& drawing) {
    change(drawing.fragment.text, "< 0\\.4375", "> 0.4375");
}
void push_back(Drawing& drawing) {
    change(drawing.vertex.text, "((\\w+\\.|)gl_Position)\\.y = -", "$1.z = $1.z * 1.001; $&");
}
void keep_depth_range(Drawing& drawing) {
    change(drawing.vertex.text, "\n *gl_Position.z = 2.0[^\n]*", "");
}

}  // namespace

std::vector<Mutant> mutants(const target::Target& target) {
    struct Kind {
        const char *name, *sample, *entry;
        void (*make)(Drawing&);
        bool gl_alone = false;
    };
    static const Kind kKinds[] = {
        {"two bindings swapped", "layered", "normal", swap_bindings},
        {"a matrix transposed", "layered", "normal", transpose_matrix},
        {"t flipped", "layered", "normal", flip_t},
        {"Vulkan's clip space kept", "layered", "normal", keep_clip_space},
        {"two textures of the function swapped", "layered", "function", swap_arguments},
        {"t flipped for the function", "layered", "function", flip_given_t},
        {"a derivative of the function upward", "layered", "function", point_dy_up},
        {"the function told of back faces alone", "layered", "function", forget_back_faces},
        {"two attachments swapped", "perforated", "gbuffer", swap_attachments},
        {"the alpha test turned round", "perforated", "gbuffer", turn_alpha_test},
        {"the alpha test of depth turned round", "perforated", "depth", turn_alpha_test},
        {"depth off by a thousandth", "perforated", "depth", push_back},
        {"Vulkan's range of depth kept", "perforated", "depth", keep_depth_range, true}};
    const auto shots = shots_of(target);
    const bool gl = target.language == Language::glsl || target.language == Language::essl;
    std::vector<Mutant> out;
    for (const Kind& kind : kKinds) {
        const Shown& what = shown(kind.entry);
        if (std::find(shots.begin(), shots.end(), &what) == shots.end() || (kind.gl_alone && !gl)) continue;
        out.push_back({kind.name, &target == &wgsl_recipe() ? wgsl_drawing(sample(kind.sample), what)
                                                            : drawing(sample(kind.sample), target, what)});
        kind.make(out.back().drawing);
    }
    return out;
}

}  // namespace sg::cross
