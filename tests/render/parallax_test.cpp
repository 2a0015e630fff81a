// Parallax occlusion against the surface itself, in double precision: the point that a pixel shows lies on
// the displaced plane and on the pixel's ray.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "asset/image.hpp"
#include "runtime/mesh/shapes.hpp"
#include "tests/render/workshop.hpp"

namespace sg::truth {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::uint32_t kSide = 160;  // pixels
constexpr double kStrength = 0.15;    // world units; the plane is 2 wide, so a unit of st is 2 of them
constexpr int kSteps = 40;

Recipe recipe(const std::string& zero_level) {
    Recipe out{R"({ "version": 1,
      "textures": { "h": { "file": "textures/pebble_height.png", "encoding": "height" } },
      "bump": [ { "parallax": { "kind": "occlusion", "texture": "h", "strength": 0.15, "zero_level": )" +
                   zero_level + R"(, "min_steps": 40, "max_steps": 40 },
                  "layers": [ { "kind": "height_map", "texture": "h", "strength": 0.15 } ] } ] })",
               sample_files(),
               {"debug"},
               true};
    return out;
}

runtime::Scene scene(bool orthographic) {
    runtime::Scene out;
    out.content.meshes.push_back(*runtime::make_shape("plane"));
    out.content.instances.push_back({"", 0, glm::mat4(1)});
    out.camera.position = {1.6, -1.1, 2.2};
    out.camera.fov_degrees = 40;
    if (orthographic) out.camera.ortho_height = 2.2;
    return out;
}

// The texels as the shader filters them: bilinear, repeated, at the first level.
class Heights {
public:
    Heights() {
        Diags diags;
        image_ =
            asset::read_image(sample_files().at("textures/pebble_height.png"), "h", Place{}, diags).value();
        const double n = image_.width;
        for (std::uint32_t y = 0; y < image_.height; ++y) {
            for (std::uint32_t x = 0; x < image_.width; ++x) {
                const double here = texel(x, y);
                steepest_ = std::max(
                    {steepest_, n * std::abs(texel(x + 1, y) - here), n * std::abs(texel(x, y + 1) - here)});
            }
        }
    }
    [[nodiscard]] double at(dvec2 st) const {
        const dvec2 place = st * double(image_.width) - 0.5, corner = glm::floor(place), t = place - corner;
        const auto x = static_cast<std::int64_t>(corner.x), y = static_cast<std::int64_t>(corner.y);
        return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), t.x),
                        glm::mix(texel(x, y + 1), texel(x + 1, y + 1), t.x), t.y);
    }
    // No bilinear patch changes faster along s or t, per unit of st.
    [[nodiscard]] double steepest() const { return steepest_; }

private:
    [[nodiscard]] double texel(std::int64_t x, std::int64_t y) const {
        const std::int64_t n = image_.width;
        return image_.at(static_cast<std::uint32_t>((x % n + n) % n),
                         static_cast<std::uint32_t>((y % n + n) % n), 0);
    }
    asset::Image image_;
    double steepest_ = 0;
};

struct Findings {
    Percentiles off_surface;  // in steps of the march
    double beyond = 0;        // the share of pixels that are farther off than a step can be
    double off_ray = 0;       // world units, the largest
};

// A ray goes down `drop` and `run` to the side in a step, and ends where the distance to the surface, taken
// as linear over the step, is 0. The true distance is 0 somewhere in the same step, and changes over it by at
// most the drop and what the surface rises along the run: nowhere in the step is it larger.
Findings find(double zero_level, bool orthographic, const target::ShaderLibrary& library) {
    static const Heights heights;
    const Made made = make(recipe(fmt::format("{}", zero_level)), library);
    const runtime::Scene seen = scene(orthographic);
    const runtime::Picture moved = draw(made, seen, "moved-position", kSide, kSide);
    const runtime::Picture mesh = draw(made, seen, "position", kSide, kSide);
    const dvec3 camera = seen.camera.position, along = -glm::normalize(camera);
    const double drop = kStrength / kSteps;
    Findings out;
    std::vector<double> errors;
    std::size_t beyond = 0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            if (!covered(moved, x, y)) continue;
            const dvec3 from = rgb(mesh, x, y), to = rgb(moved, x, y), place = to + camera;
            const dvec2 st((place.x + 1) / 2, (1 - place.y) / 2);
            const double error = std::abs(place.z - kStrength * (heights.at(st) - zero_level));
            const dvec3 ray = orthographic ? along : glm::normalize(from);
            const dvec2 run = dvec2(ray) * (drop / -ray.z) / 2.0;  // of st
            const double rise = kStrength * heights.steepest() * (std::abs(run.x) + std::abs(run.y));
            errors.push_back(error / drop);
            beyond += error <= drop + rise + 1e-5 ? 0 : 1;  // and the roundings of a position of length 3
            out.off_ray = std::max(out.off_ray, glm::length(glm::cross(to - from, ray)));
        }
    }
    out.off_surface = percentiles(errors);
    out.beyond = static_cast<double>(beyond) / static_cast<double>(errors.size());
    return out;
}

TEST(ParallaxOcclusion, ShowsPointsOfTheSurfaceOnTheRay) {
    for (double zero_level : {1.0, 0.5, 0.0}) {
        for (bool orthographic : {false, true}) {
            const Findings f = find(zero_level, orthographic, target::embedded_library());
            fmt::print(
                "zero level {}{}: off the surface by {:.4f} steps (median), {:.3f} (99 %), {:.2f} at most; "
                "off "
                "the ray by {:.1e}; {} pixels\n",
                zero_level, orthographic ? ", orthographic" : "", f.off_surface.median, f.off_surface.p99,
                f.off_surface.max, f.off_ray, f.off_surface.count);
            EXPECT_GT(f.off_surface.count, 5000u);
            EXPECT_EQ(f.beyond, 0);
            EXPECT_LE(f.off_surface.median, 0.25);  // the line over a step is nearer than its ends are
            EXPECT_LE(f.off_ray, 2e-5);             // 32 roundings of a position of length 3, twice
        }
    }
}

struct Wrong {
    const char* text;  // of surfgrad/parallax.glsl, must stand there exactly once
    const char* wrong;
};

TEST(ParallaxOcclusion, WrongShadersDoNot) {
    const Wrong wrongs[] = {
        {"height * frame.normal;", "0.5 * height * frame.normal;"},
        {"+ pixels.x * frame.sigma_x", "- pixels.x * frame.sigma_x"},
        {"st + ray * per_height, level);\n    }", "st - ray * per_height, level);\n    }"},
        {"float height = ray + back * drop;", "float height = ray + drop;"},
        {"view.xy / max(view.z, SG_PARALLAX_MIN_COSINE)", "view.xy"},
    };
    for (const Wrong& w : wrongs) {
        target::ShaderLibrary library = target::embedded_library();
        std::string& text = library.files["surfgrad/parallax.glsl"];
        const std::size_t at = text.find(w.text);
        ASSERT_TRUE(at != text.npos && text.find(w.text, at + 1) == text.npos)
            << "the library changed: " << w.text;
        text.replace(at, std::string(w.text).size(), w.wrong);
        const Findings f = find(1.0, false, library);
        const bool noticed = f.beyond > 0 || f.off_surface.median > 0.25 || f.off_ray > 2e-5;
        EXPECT_TRUE(noticed) << w.wrong;
    }
}

}  // namespace
}  // namespace sg::truth
