#include "tests/cross/results.hpp"

#include <stdexcept>

#include "tests/cross/gl.hpp"
#include "tests/cross/hlsl.hpp"
#include "tests/cross/metal.hpp"
#include "tests/cross/process.hpp"
#include "tests/cross/webgl.hpp"
#include "tests/cross/wgsl.hpp"

namespace sg::cross {
namespace {

using target::Language;
using target::Target;

bool is_web(const Target& target) {
    return target.name == "essl300";
}
bool is_recipe(const Target& target) {
    return &target == &wgsl_recipe();
}

// The two stages of every entry point of a sample in a target.
std::vector<ShaderPair> pairs_of(const Sample& sample, const Target& target) {
    std::vector<ShaderPair> out;
    for (const runtime::EntryPoint& entry : sample.artefact.entries) {
        auto text = [&](const char* stage) {
            return sample.texts.at(sample.name + "." + entry.name + "." + stage + "." +
                                   std::string(target.name) + "." + std::string(target.extension));
        };
        out.push_back({text("vert"), text("frag")});
    }
    return out;
}

// "" or a tool's words, by pair.
std::vector<std::string> refusals_of(const std::vector<ShaderPair>& pairs, const Target& target) {
    if (is_web(target)) return webgl_draw({}, pairs).refusals;
    std::vector<std::string> out, texts;
    std::vector<HlslText> hlsl;
    for (const ShaderPair& pair : pairs) {
        hlsl.push_back({pair.vertex, true});
        hlsl.push_back({pair.fragment, false});
        texts.push_back(pair.vertex);
        texts.push_back(pair.fragment);
    }
    if (target.language == Language::glsl || target.language == Language::essl) {
        for (const ShaderPair& pair : pairs)
            out.push_back(gl_refusal(pair.vertex, pair.fragment, target.language));
        return out;
    }
    auto single = target.language == Language::hlsl ? hlsl_refusals(hlsl) : metal_refusals(texts);
    for (std::size_t i = 0; i < single.size(); i += 2) out.push_back(single[i] + single[i + 1]);
    return out;
}

// WGSL: what naga refuses is not drawn.
void fill_recipe(std::vector<Result>& rows) {
    std::vector<Drawing> drawings;
    std::vector<std::string> texts;
    std::vector<Result*> drawn, of_text;
    for (Result& row : rows) {
        row.refusal = wgsl_refusal(sample(row.sample), texts);
        of_text.resize(texts.size(), &row);
        if (!row.refusal.empty()) continue;
        drawings.push_back(wgsl_drawing(sample(row.sample)));
        drawn.push_back(&row);
    }
    WgslOutcome outcome = wgsl_draw(drawings, texts);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        drawn[i]->refusal += outcome.refusals[i];
        if (!outcome.pictures[i].empty())
            drawn[i]->difference =
                compare(expected(sample(drawn[i]->sample), wgsl_recipe()), outcome.pictures[i]);
    }
    for (std::size_t i = 0; i < of_text.size(); ++i)
        of_text[i]->refusal += outcome.refusals[drawn.size() + i];
}

std::vector<Result> results_of(const Target& target) {
    std::vector<Result> out;
    for (const std::string& name : sample_names())
        out.push_back({name, &target, missing_tool(target), "", {}});
    if (!missing_tool(target).empty()) return out;
    if (is_recipe(target)) {
        fill_recipe(out);
        return out;
    }
    std::vector<ShaderPair> pairs;
    for (const Result& row : out) {
        auto of_sample = pairs_of(sample(row.sample), target);
        pairs.insert(pairs.end(), of_sample.begin(), of_sample.end());
    }
    auto refusals = refusals_of(pairs, target);
    std::vector<Drawing> drawings;
    std::vector<Result*> drawn;
    std::size_t pair = 0;
    for (Result& row : out) {
        const Sample& s = sample(row.sample);
        for (std::size_t k = 0; k < s.artefact.entries.size(); ++k) row.refusal += refusals.at(pair++);
        if (!row.refusal.empty()) continue;
        drawings.push_back(drawing(s, target));
        drawn.push_back(&row);
    }
    auto pictures = draw_all(drawings);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (!pictures[i].empty())
            drawn[i]->difference = compare(expected(sample(drawn[i]->sample), target), pictures[i]);
    }
    return out;
}

}  // namespace

// HLSL comes back as SPIR-V and runs on the same device with the same inputs: what may differ is the order of
// about a
//   hundred additions and multiplications of numbers near 1, each off by 2^-24.
// The others interpolate by themselves (GL with its rows upside down, Metal in our rasteriser). Interpolation
// in 32-bit
//   floats is off by some 4 units in the last place. Positions are 4.9 radii from the camera at most, and one
//   pixel is 0.016 radii wide (30 degrees, 128 pixels): the difference of two of them, a screen derivative,
//   is off by 4 2^-23 4.9 / 0.016 = 1.5e-4 of itself, and so is the direction of a tangent that follows from
//   it. Texture coordinates are off by 4 2^-23, which at 10 repeats of 256 texels, with normals that turn by
//   0.3 from texel to texel, turns the normal by 3.7e-4. Together 5.2e-4. Where the surface turns away from
//   the eye the determinant of the texture's derivatives is much smaller than the product of their lengths
//   and the first part grows: ten times as much for the last thousandth of the pixels.
// Positions are rounded to 1/256 pixel from values with those errors, so a pixel in a thousand may be covered
// by one
//   picture alone, and where two rasterisers differ (Metal), a pixel on an edge may be shaded from the
//   neighbouring facet. Facets turn by 2 pi / 64 around the tube; the frame's derivatives turn with them, and
//   a gradient of 1/2 moves by 0.05.
// WGSL is compared with SwiftShader's own Vulkan, which interpolates the same numbers: as HLSL, but for the y
// that naga
//   negates and Chromium's driver negates back, which moves pixels on the outline.
Limit limit_of(const Target& target) {
    constexpr double kRounding = 100.0 / (1 << 24), kInterpolation = 5.2e-4, kFacet = 0.05;
    constexpr std::size_t kEdge = std::size_t{kSide} * kSide / 1000;
    if (target.language == Language::hlsl) return {kRounding, kRounding, 0};
    if (is_recipe(target)) return {kRounding, kRounding, kEdge};
    if (target.language == Language::msl) return {kFacet, kInterpolation, kEdge};
    return {10 * kInterpolation, kInterpolation, kEdge};
}

std::string_view accepted_by(const Target& target) {
    switch (target.language) {
        case Language::spirv:
            return "naga, then Chromium";
        case Language::hlsl:
            return "glslang's HLSL front end";
        case Language::msl:
            return "clang++ with a shim";
        default:
            return is_web(target) ? "Chromium" : "Mesa";
    }
}

std::string_view drawn_by(const Target& target) {
    switch (target.language) {
        case Language::spirv:
            return "WebGPU on SwiftShader";
        case Language::hlsl:
            return "lavapipe";
        case Language::msl:
            return "the shim and a rasteriser in the tests";
        case Language::glsl:
            return "OpenGL 4.5 on llvmpipe";
        case Language::essl:
            return is_web(target) ? "WebGL 2 on llvmpipe" : "OpenGL ES 3.1 on llvmpipe";
    }
    return "";
}

std::string missing_tool(const Target& target) {
    if (target.language == Language::hlsl)
        return has_program("glslangValidator") ? "" : "no glslangValidator";
    if (target.language == Language::msl) return metal_missing();
    if (is_recipe(target)) return wgsl_missing();
    return is_web(target) ? webgl_missing() : gl_missing(target.language);
}

const Pixels& expected(const Sample& sample, const Target& target) {
    if (is_recipe(target)) return reference(base_sample(sample), Driver::swiftshader);
    return reference(target.language == Language::msl ? base_sample(sample) : sample);
}

std::vector<Pixels> draw_all(const std::vector<Drawing>& drawings) {
    if (drawings.empty()) return {};
    const Target& target = *drawings.front().target;
    if (target.language == Language::msl) return metal_draw(drawings);
    if (is_web(target)) return webgl_draw(drawings, {}).pictures;
    if (is_recipe(target)) return wgsl_draw(drawings, {}).pictures;
    std::vector<Pixels> out;
    for (const Drawing& drawing : drawings) {
        bool hlsl = target.language == Language::hlsl;
        out.push_back(hlsl ? render_words(sample(drawing.sample), hlsl_to_words(drawing)) : gl_draw(drawing));
    }
    return out;
}

const std::vector<Result>& results() {
    static const std::vector<Result> kResults = [] {
        std::vector<std::vector<Result>> by_target;
        for (const Target& target : target::all_targets()) {
            if (target.language != Language::spirv) by_target.push_back(results_of(target));
        }
        by_target.push_back(results_of(wgsl_recipe()));
        std::vector<Result> out;
        for (std::size_t i = 0; i < sample_names().size(); ++i) {
            for (const auto& column : by_target) out.push_back(column[i]);
        }
        return out;
    }();
    return kResults;
}

}  // namespace sg::cross
