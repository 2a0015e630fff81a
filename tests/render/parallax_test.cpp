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

struct Case {
    double zero_level = 1;
    bool orthographic = false;
    const char* two_sided = "off";  // else seen from behind
    [[nodiscard]] bool behind() const { return std::string(two_sided) != "off"; }
    // Which way heights go along z: on the back of a mirror surface towards the viewer as well; a flip
    // surface is one sheet.
    [[nodiscard]] double up() const { return std::string(two_sided) == "mirror" ? -1 : 1; }
};

Recipe recipe(const Case& c) {
    Recipe out{R"({ "version": 1,
      "textures": { "h": { "file": "textures/pebble_height.png", "encoding": "height" } },
      "bump": [ { "parallax": { "kind": "occlusion", "texture": "h", "strength": 0.15, "zero_level": )" +
                   fmt::format("{}", c.zero_level) + R"(, "min_steps": 40, "max_steps": 40 },
                  "layers": [ { "kind": "height_map", "texture": "h", "strength": 0.15 } ] } ],
      "surface": { "two_sided": ")" +
                   c.two_sided + R"(" } })",
               sample_files(),
               {"debug"},
               true};
    return out;
}

runtime::Scene scene(const Case& c) {
    runtime::Scene out;
    out.content.meshes.push_back(*runtime::make_shape("plane"));
    out.content.instances.push_back({"", 0, glm::mat4(1)});
    out.camera.position = {1.6, -1.1, c.behind() ? -2.2 : 2.2};
    out.camera.fov_degrees = 40;
    if (c.orthographic) out.camera.ortho_height = 2.2;
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
    // dz/dx and dz/dy of a height of 1 over a texel to each side; t runs against y.
    [[nodiscard]] dvec2 slope_at(dvec2 st) const {
        const double texel = 1.0 / image_.width;
        return {(at(st + dvec2(texel, 0)) - at(st - dvec2(texel, 0))) / texel / 4,
                (at(st - dvec2(0, texel)) - at(st + dvec2(0, texel))) / texel / 4};
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
    double agreement = 0;     // of the normals' x and y with the slopes there, -1 to 1
};

// A ray goes down `drop` and `run` to the side in a step, and ends where the distance to the surface, taken
// as linear over the step, is 0. The true distance is 0 somewhere in the same step, and changes over it by at
// most the drop and what the surface rises along the run: nowhere in the step is it larger.
Findings find(const Case& c, const target::ShaderLibrary& library) {
    static const Heights heights;
    const Made made = make(recipe(c), library);
    const runtime::Scene seen = scene(c);
    const runtime::Picture moved = draw(made, seen, "moved-position", kSide, kSide);
    const runtime::Picture mesh = draw(made, seen, "position", kSide, kSide);
    const runtime::Picture normals = draw(made, seen, "normal", kSide, kSide);
    const dvec3 camera = seen.camera.position, along = -glm::normalize(camera);
    const double drop = kStrength / kSteps;
    Findings out;
    std::vector<double> errors;
    std::size_t beyond = 0;
    dvec3 products(0);  // of normals and slopes, of normals, of slopes
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            if (!covered(moved, x, y)) continue;
            const dvec3 from = rgb(mesh, x, y), to = rgb(moved, x, y), place = to + camera;
            const dvec2 st((place.x + 1) / 2, (1 - place.y) / 2);
            const double error = std::abs(c.up() * place.z - kStrength * (heights.at(st) - c.zero_level));
            const dvec3 ray = c.orthographic ? along : glm::normalize(from);
            const dvec2 run = dvec2(ray) * (drop / std::abs(ray.z)) / 2.0;  // of st
            const double rise = kStrength * heights.steepest() * (std::abs(run.x) + std::abs(run.y));
            errors.push_back(error / drop);
            beyond += error <= drop + rise + 1e-5 ? 0 : 1;  // and the roundings of a position of length 3
            out.off_ray = std::max(out.off_ray, glm::length(glm::cross(to - from, ray)));
            const dvec2 slope = c.up() * heights.slope_at(st), n = rgb(normals, x, y);
            products += dvec3(glm::dot(n, slope), glm::dot(n, n), glm::dot(slope, slope));
        }
    }
    out.off_surface = percentiles(errors);
    out.agreement = products.x / std::sqrt(products.y * products.z);
    out.beyond = static_cast<double>(beyond) / static_cast<double>(errors.size());
    return out;
}

TEST(ParallaxOcclusion, ShowsPointsOfTheSurfaceOnTheRay) {
    for (double zero_level : {1.0, 0.5, 0.0}) {
        for (bool orthographic : {false, true}) {
            const Findings f = find({zero_level, orthographic}, target::embedded_library());
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
            EXPECT_LT(f.agreement, -0.8);           // normals lean away from where it rises
        }
    }
}

// From behind: the unit normal of z = f(x, y) that has z < 0 is (f_x, f_y, -1) / |...|.
TEST(ParallaxOcclusion, ShowsTheBacksOfTwoSidedSurfaces) {
    for (const char* two_sided : {"mirror", "flip"}) {
        for (double zero_level : {1.0, 0.0}) {
            const Case c{zero_level, false, two_sided};
            const Findings f = find(c, target::embedded_library());
            fmt::print(
                "{}, zero level {}: off the surface by {:.4f} steps (median), {:.2f} at most; off the ray by "
                "{:.1e}; normals and slopes agree by {:.3f}; {} pixels\n",
                two_sided, zero_level, f.off_surface.median, f.off_surface.max, f.off_ray, f.agreement,
                f.off_surface.count);
            EXPECT_GT(f.off_surface.count, 5000u);
            EXPECT_EQ(f.beyond, 0);
            EXPECT_LE(f.off_surface.median, 0.25);
            EXPECT_LE(f.off_ray, 2e-5);
            EXPECT_GT(f.agreement, 0.8);
        }
    }
}

// Degrees between the normals of a sample drawn plainly and with a viewport of negative height.
Percentiles turned(const std::string& sample, const target::ShaderLibrary& library) {
    Recipe recipe{"", sample_files()};
    recipe.json = recipe.files.at(sample + ".json");
    const Made made = make(recipe, library);
    const runtime::Scene seen = scene({});
    const runtime::Picture plain = draw(made, seen, "normal", kSide, kSide),
                           upright = upside_down(draw(made, seen, "normal", kSide, kSide, true));
    std::vector<double> out;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            if (!covered(plain, x, y) || !covered(upright, x, y)) continue;
            const dvec3 a = rgb(plain, x, y), b = rgb(upright, x, y);
            out.push_back(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232);
        }
    }
    return percentiles(out);
}

// Four roundings of a coordinate up to 5 (2.4e-7 each, 3e-5 of 128 texels), over which slopes change by 2 a
// texel at most: 0.014 degrees; and of its derivatives, 0.015 a pixel: 6e-5 of a tilt of 45 degrees, 0.003.
TEST(Parallax, DoesNotCareWhichWayYGrows) {
    for (const char* sample : {"parallax_offset", "parallax_steps", "parallax_occlusion", "parallax_dents"}) {
        const Percentiles p = turned(sample, target::embedded_library());
        fmt::print(
            "{}: negative viewport {:.6f} degrees (median), {:.6f} (99 %), {:.4f} at most; {} pixels\n",
            sample, p.median, p.p99, p.max, p.count);
        EXPECT_GT(p.count, 5000u);
        EXPECT_LT(p.p99, 0.017);
    }
    target::ShaderLibrary library = target::embedded_library();
    std::string& text = library.files["surfgrad/analytic_derivatives.glsl"];
    const std::string sign = "< 0.0 ? -1.0 : 1.0;";
    const std::size_t at = text.find(sign);
    ASSERT_TRUE(at != text.npos && text.find(sign, at + 1) == text.npos) << "the library changed";
    text.replace(at, sign.size(), "< 0.0 ? -1.0 : -1.0;");
    EXPECT_GT(turned("parallax_detail", library).median, 1);
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
        const Findings f = find({}, library);
        const bool noticed = f.beyond > 0 || f.off_surface.median > 0.25 || f.off_ray > 2e-5;
        EXPECT_TRUE(noticed) << w.wrong;
    }
}

}  // namespace
}  // namespace sg::truth
