#include "tests/cross/results.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>

#include "target/spirv.hpp"
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

// The function's caller in Vulkan's GLSL, between the stages that were shipped.
ShaderWords glsl_to_words(const Drawing& drawing) {
    std::string fault;
    auto words = target::compile_glsl(drawing.fragment.text, drawing.sample->name, target::Stage::fragment,
                                      drawn_library(), {}, fault);
    if (!words) throw std::runtime_error("glslang: " + fault);
    return {drawing.sample->artefact.entry(drawing.shown->entry)->vertex.words, std::move(*words)};
}

// All at once: two child processes share the work.
void compile_hlsl(const std::vector<Drawing>& drawings) {
    std::vector<HlslText> texts;
    for (const Drawing& drawing : drawings) {
        texts.push_back({drawing.vertex.text, true});
        texts.push_back({drawing.fragment.text, false});
    }
    hlsl_refusals(texts);
}

// The rows' pictures, of one target; rows that were refused have none.
void fill_shots(std::vector<Result>& rows, const Target& target,
                const std::function<Drawing(const Sample&, const Shown&)>& make) {
    std::vector<Drawing> drawings;
    std::vector<std::pair<Result*, const Shown*>> drawn;
    for (Result& row : rows) {
        if (!row.refusal.empty()) continue;
        for (const Shown* what : shots_of(target)) {
            drawings.push_back(make(sample(row.sample), *what));
            drawn.emplace_back(&row, what);
        }
    }
    auto pictures = draw_all(drawings);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        auto [row, what] = drawn[i];
        if (!pictures[i].refusal.empty())
            row->refusal += fmt::format("{}: {}\n", what->name, pictures[i].refusal);
        for (std::size_t plane = 0; pictures[i].refusal.empty() && plane < what->planes.size(); ++plane)
            row->shots.push_back({what, plane, difference(drawings[i], pictures[i], plane)});
    }
}

// WGSL: what naga or Dawn refuses is not drawn.
void fill_recipe(std::vector<Result>& rows) {
    std::vector<std::string> texts;
    std::vector<Result*> of_text;
    for (Result& row : rows) {
        row.refusal = wgsl_refusal(sample(row.sample), texts);
        of_text.resize(texts.size(), &row);
    }
    auto refusals = texts.empty() ? std::vector<std::string>{} : wgsl_draw({}, texts).refusals;
    for (std::size_t i = 0; i < of_text.size(); ++i) of_text[i]->refusal += refusals[i];
    fill_shots(rows, wgsl_recipe(), wgsl_drawing);
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
    fill_shots(out, target, [&](const Sample& s, const Shown& what) { return drawing(s, target, what); });
    return out;
}

// A tool that gives up on all is no reason to stop.
std::vector<Result> results_or_refusals(const Target& target) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Result> out;
    try {
        out = results_of(target);
    } catch (const std::runtime_error& error) {
        for (const std::string& name : sample_names()) out.push_back({name, &target, "", error.what(), {}});
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    fmt::print("{}: {:.1f} s\n", target.name, seconds.count());
    return out;
}

}  // namespace

// HLSL comes back as SPIR-V and runs on the same device with the same inputs: what may differ is the order of
// about a hundred additions and multiplications of numbers near 1, each off by 2^-24.
//
// The others interpolate by themselves (GL with its rows upside down, Metal in our rasteriser). Interpolation
// in 32-bit floats is off by some 4 units in the last place. Positions are 4.9 radii from the camera at most,
// and one pixel is 0.016 radii wide (30 degrees, 128 pixels): the difference of two of them, a screen
// derivative, is off by 4 2^-23 4.9 / 0.016 = 1.5e-4 of itself, and so is the direction of a tangent that
// follows from it. Texture coordinates are off by 4 2^-23, which at 10 repeats of 256 texels, with normals
// that turn by 0.3 from texel to texel, turns the normal by 3.7e-4. Together 5.2e-4. Where the surface turns
// away from the eye the determinant of the texture's derivatives is much smaller than the product of their
// lengths and the first part grows: ten times as much for the last thousandth of the pixels.
//
// Positions are rounded to 1/256 pixel from values with those errors, so a pixel in a thousand may be covered
// by one picture alone, and where two rasterisers differ (Metal), a pixel within 1/256 pixel of an edge may
// be shaded from the neighbouring facet, whose frame is another one: of these, a twentieth of all, the 99.9th
// percentile holds alone.
//
// WGSL is compared with SwiftShader's own Vulkan, which interpolates the same numbers: as HLSL, but for the y
// that naga negates and Chromium's driver negates back, which moves pixels on the outline.
//
// All that holds for normals, and for what `gbuffer` holds beside them: numbers up to 1, read from the same
// textures. unit_of() says how much faster gradients and radiance change.
//
// Depth is linear across a facet: a rasteriser adds two products of a slope and up to 128 pixels. A slope is
// 0.016 radii times the tangent of the angle between normal and eye, which is below 30 for 99.9 % of what a
// sphere shows (the rest has a cosine below 1/30), times the 1/2 by which depth grows per radius here; so the
// products are up to 0.016 30 / 2 128 = 31, and 4 units in their last place 1.5e-5.
Limit limit_of(const Target& target, const Shown& shown) {
    constexpr double kRounding = 100.0 / (1 << 24), kInterpolation = 5.2e-4, kDepth = 1.5e-5;
    constexpr std::size_t kEdge = std::size_t{kSide} * kSide / 1000;
    const bool same_inputs = target.language == Language::hlsl || target.language == Language::spirv;
    if (same_inputs) return {kRounding, kRounding, is_recipe(target) ? kEdge : 0};
    const double most = shown.name == "depth" ? kDepth : kInterpolation;
    return {10 * most, most, kEdge};
}

// Rays that graze a surface magnify what rounding does: the interpreter's own bound for that, at the 99.9th
// percentile, is 0.11 degrees (tests/oracle, parallax_dents.json, first level), 27 times the 0.004 degrees of
// other samples. The last thousandth, where rounding may decide at which step a march ends, ten times as
// much.
Limit limit_of(const Target& target, const Shown& shown, const Sample& sample) {
    constexpr double kGrazing = 2e-3, kMagnified = 27;
    const Limit out = limit_of(target, shown);
    const bool marches = std::any_of(sample.texts.begin(), sample.texts.end(), [](const auto& text) {
        return text.second.find("sg_parallax_occlusion") != std::string::npos;
    });
    if (!marches || shown.name == "depth") return out;
    const double p999 = std::min(kMagnified * out.p999, kGrazing);
    return {10 * p999, p999, out.one_alone};
}

// A gradient g turns the normal by its own change divided by 1 + g^2 or more. Radiance follows a base colour
// by the light, 1.1 and 0.09 from all around, and the normal through the highlight: the light times F0 V
// cos_l (F0 / 4) times pi D, which is 1 / alpha^2 at the peak and falls as (1 + x^2)^-2, x the tangent of the
// angle over alpha, at most 1.04 / alpha per radian.
std::vector<double> unit_of(const Sample& sample, const Target& target, const Shown& what) {
    std::vector<double> out;
    if (what.name == "debug") {
        const Pixels& gradient = expected(sample, target, what);
        for (std::size_t i = 0; i < kPlane; i += 4) {
            const double x = double{gradient[i]}, y = double{gradient[i + 1]}, z = double{gradient[i + 2]};
            out.push_back(1 + x * x + y * y + z * z);
        }
    }
    if (what.name == "forward") {
        const Pixels& planes = expected(sample, target, shown("gbuffer"));
        for (std::size_t i = 0; i < kPlane; i += 4) {
            const double color = double{*std::max_element(&planes[i], &planes[i] + 3)},
                         roughness = double{planes[kPlane + i + 3]},
                         metallic = double{planes[2 * kPlane + i]},
                         alpha = std::max(roughness * roughness, 0.01), f0 = 0.04 + (color - 0.04) * metallic;
            out.push_back(1.19 + 1.1 * f0 / 4 * 1.04 / (alpha * alpha * alpha));
        }
    }
    return out;
}

Difference difference(const Drawing& drawing, const Drawn& drawn, std::size_t plane) {
    const Target& target = *drawing.target;
    const Shown& what = *drawing.shown;
    return compare(expected(*drawing.sample, target, what), drawn.pixels,
                   {plane, unit_of(*drawing.sample, target, what), drawn.on_edge});
}

std::string_view accepted_by(const Target& target) {
    switch (target.language) {
        case Language::spirv:
            return is_recipe(target) ? "naga, then Dawn" : "glslang, spirv-val";
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
            return is_recipe(target) ? "WebGPU on SwiftShader" : "lavapipe";
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
    if (target.language == Language::spirv) return "";
    return is_web(target) ? webgl_missing() : gl_missing(target.language);
}

const Pixels& expected(const Sample& sample, const Target& target, const Shown& shown) {
    if (is_recipe(target)) return reference(base_sample(sample), shown, Driver::swiftshader);
    return reference(target.language == Language::msl ? base_sample(sample) : sample, shown);
}

std::vector<const Shown*> shots_of(const Target& target) {
    std::vector<std::string_view> names = {"normal", "forward", "debug", "function", "gbuffer", "depth"};
    if (target.language == Language::spirv) names = {"function"};
    if (is_recipe(target)) names = {"normal", "forward", "gbuffer", "depth"};
    std::vector<const Shown*> out;
    for (std::string_view name : names) out.push_back(&shown(name));
    return out;
}

std::vector<Drawn> draw_all(const std::vector<Drawing>& drawings) {
    if (drawings.empty()) return {};
    const Target& target = *drawings.front().target;
    std::vector<Drawn> out;
    if (is_web(target) || is_recipe(target)) {
        PageOutcome page = is_web(target) ? webgl_draw(drawings) : wgsl_draw(drawings, {});
        for (std::size_t i = 0; i < drawings.size(); ++i)
            out.push_back({std::move(page.pictures[i]), std::move(page.refusals[i])});
        return out;
    }
    if (target.language == Language::msl) {
        for (MetalPicture& picture : metal_draw(drawings))
            out.push_back({std::move(picture.pixels), "", std::move(picture.on_edge)});
        return out;
    }
    if (target.language == Language::hlsl) compile_hlsl(drawings);
    for (const Drawing& drawing : drawings) {
        try {
            bool gl = target.language == Language::glsl || target.language == Language::essl;
            bool hlsl = target.language == Language::hlsl;
            out.push_back(
                {gl ? gl_draw(drawing)
                    : render_words(*drawing.sample, hlsl ? hlsl_to_words(drawing) : glsl_to_words(drawing),
                                   *drawing.shown),
                 ""});
        } catch (const std::runtime_error& error) {
            out.push_back({{}, error.what()});
        }
    }
    return out;
}

const std::vector<Result>& results() {
    static const std::vector<Result> kResults = [] {
        std::vector<std::vector<Result>> by_target;
        for (const Target& target : target::all_targets()) {
            by_target.push_back(results_or_refusals(target));
        }
        by_target.push_back(results_or_refusals(wgsl_recipe()));
        std::vector<Result> out;
        for (std::size_t i = 0; i < sample_names().size(); ++i) {
            for (const auto& column : by_target) out.push_back(column[i]);
        }
        return out;
    }();
    return kResults;
}

}  // namespace sg::cross
