// Bricks102 of ambientCG: a height map and a normal map of the same wall, 1024 x 512 texels, as 8-bit JPEGs.
//
// The heights' unit is not known, so it is fitted: s of least squares between slopes. And the two maps are no
// exact pair. Of a band of frequencies, slopes (heights by central differences, whole map) correlate by 0.95
// at 8 to 16 waves a side, 0.97 to 32, 0.94 to 128, 0.91 to 256 and 0.81 to 512, and s
// is 10.1, 9.9, 9.3, 8.8, 8.5 and 9.6 texels. What the files can lose is less. All steps of the JPEGs' tables
// are 1, so that a texel is off by 1 / sqrt(12) from each of two roundings, a slope by 0.41 / 255 * sqrt(1/2)
// * 9 = 0.010 per axis, of which a share of pi (32 / 1024)^2 in power lies in all bands up to 32 waves:
// 0.001, of slopes of 0.07 rms there. So a quarter of the slopes, sqrt(1 - 0.97^2), differs in the asset
// itself.
//
// What is asserted: each drawn normal is that of its own texels, computed here in double precision, so that
// the drawn pair is as far apart as the texels are and no farther. And the pair goes together in what a
// mistake of ours would change: which way is up, and the aspect of 2 to 1, by fits of s along each axis.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "runtime/mesh/shapes.hpp"
#include "runtime/proof/angles.hpp"
#include "tests/proof/shared_data.hpp"

namespace sg::proof {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::uint32_t kPixels = 160;
constexpr double kTexels = 128;  // that the picture shows: magnified, so that the first level is read
const std::string kFolder = "textures/ambientcg/Bricks102/Bricks102_1K-JPG_";

// The wall lies on a plane of 2 by 1 units, seen in three places. `height`: another than 1.
runtime::Scene wall(int place, double height) {
    const dvec3 kPlaces[] = {{-0.6, 0.2 * height, 0}, {0.1, -0.15 * height, 0}, {0.55, 0.3 * height, 0}};
    runtime::Scene out;
    out.content.meshes.push_back(runtime::make_plane(4, false));
    out.content.instances.push_back({"", 0, glm::scale(glm::mat4(1), glm::vec3(1, height / 2, 1))});
    out.camera.target = kPlaces[place];
    out.camera.position = kPlaces[place] + dvec3(0, 0, 3);
    out.camera.ortho_height = kTexels * 2 / 1024;
    return out;
}

// ---- the texels, in double precision ----

class Texels {
public:
    explicit Texels(const std::string& file) {
        Diags diags;
        image_ = asset::read_image(bytes_of(file), file, {}, diags).value();
    }
    // Between the four texels around a coordinate, of what `value` gives for a texel.
    template <class Value>
    [[nodiscard]] dvec3 between(dvec2 st, Value value) const {
        const dvec2 at = st * dvec2(image_.width, image_.height) - 0.5, corner = glm::floor(at),
                    t = at - corner;
        const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
        return glm::mix(glm::mix(value(x, y), value(x + 1, y), t.x),
                        glm::mix(value(x, y + 1), value(x + 1, y + 1), t.x), t.y);
    }
    [[nodiscard]] dvec3 texel(int x, int y) const {
        auto wrapped = [](int at, std::uint32_t size) {
            return static_cast<std::uint32_t>(at + static_cast<int>(size)) % size;
        };
        const std::uint32_t column = wrapped(x, image_.width), row = wrapped(y, image_.height);
        return {image_.at(column, row, 0), image_.at(column, row, 1), image_.at(column, row, 2)};
    }

private:
    asset::Image image_;
};

// Sobel's derivatives, per texel; t downwards.
dvec2 slope_of_heights(const Texels& heights, dvec2 st) {
    return heights.between(st, [&](int x, int y) {
        dvec3 out(0);
        for (int i = -1; i <= 1; ++i) {
            const double weight = (i == 0 ? 2 : 1) / 8.0;
            out.x += weight * (heights.texel(x + 1, y + i).x - heights.texel(x - 1, y + i).x);
            out.y += weight * (heights.texel(x + i, y + 1).x - heights.texel(x + i, y - 1).x);
        }
        return out;
    });
}
dvec2 slope_of_map(const Texels& map, dvec2 st) {
    const dvec3 m = 2.0 * map.between(st, [&](int x, int y) { return map.texel(x, y); }) - 1.0;
    return dvec2(-m.x, m.y) / m.z;
}

// ---- pairs of slopes ----

struct Pair {
    std::vector<dvec2> a, b;
    [[nodiscard]] dvec3 sums(dvec2 axes) const {  // of a a, b b, a b
        dvec3 out(0);
        for (std::size_t i = 0; i < a.size(); ++i) {
            const dvec2 p = a[i] * axes, q = b[i] * axes;
            out += dvec3(glm::dot(p, p), glm::dot(q, q), glm::dot(p, q));
        }
        return out;
    }
    [[nodiscard]] double correlation() const {
        const dvec3 s = sums(dvec2(1));
        return s.z / std::sqrt(s.x * s.y);
    }
    // The factor of `a` that comes nearest to `b`, of both axes or of one.
    [[nodiscard]] double scale(dvec2 axes = dvec2(1)) const {
        const dvec3 s = sums(axes);
        return s.z / s.x;
    }
    [[nodiscard]] Numbers apart(double factor) const {
        std::vector<double> out;
        for (std::size_t i = 0; i < a.size(); ++i)
            out.push_back(angle_degrees(dvec3(factor * a[i], 1), dvec3(b[i], 1)));
        return numbers_of(out);
    }
};

// What the maps give at each pixel of the three places: t downwards, heights per value 1 and texel.
struct Drawn {
    std::vector<dvec2> slopes, coordinates;
};
Drawn drawn(const std::string& file, const std::string& texture, const std::string& layer, double factor,
            double height = 1) {
    const truth::Made made = one_layer(kFolder + file, texture, layer);
    Drawn out;
    for (int place = 0; place < 3; ++place) {
        const runtime::Scene scene = wall(place, height);
        const runtime::Picture normal = truth::draw(made, scene, "normal", kPixels, kPixels),
                               uv = truth::draw(made, scene, "uv0", kPixels, kPixels);
        for (std::uint32_t y = 0; y < kPixels; ++y) {
            for (std::uint32_t x = 0; x < kPixels; ++x) {
                const dvec3 n = truth::rgb(normal, x, y);
                out.slopes.push_back(factor * dvec2(-n.x, n.y) / n.z);
                out.coordinates.emplace_back(truth::rgb(uv, x, y));
            }
        }
    }
    return out;
}
const std::string kNormals = R"("kind": "normal_map")";

constexpr double kStrength = 0.02, kTexel = 2.0 / 1024;  // world units
// Slopes from heights, as if value 1 were one texel high.
Drawn drawn_heights(double height) {
    return drawn("Displacement.jpg", R"("encoding": "height")",
                 fmt::format(R"("kind": "height_map", "strength": {})", kStrength), kTexel / kStrength,
                 height);
}
// The ratio of s along both axes: 1 but for what the asset is; 2 or 1/2 with a wrong aspect.
bool same_scale_along_both(const Pair& pair) {
    const double ratio = pair.scale({1, 0}) / pair.scale({0, 1});
    fmt::print("value 1 is {:.2f} texels high, {:.2f} by slopes along s, {:.2f} along t\n", pair.scale(),
               pair.scale({1, 0}), pair.scale({0, 1}));
    return ratio < std::sqrt(2) && ratio > std::sqrt(0.5);
}

TEST(Bricks, HeightsGoWithTheirNormals) {
    SG_NEEDS(kFolder + "Displacement.jpg");
    const Drawn heights = drawn_heights(1);
    const Drawn up = drawn("NormalGL.jpg", R"("encoding": "tangent_normal")", kNormals, 1);
    const Drawn down = drawn("NormalDX.jpg", R"("encoding": "tangent_normal", "green": "down")", kNormals, 1);
    const Drawn wrong = drawn("NormalDX.jpg", R"("encoding": "tangent_normal")", kNormals, 1);
    const Texels height_texels(kFolder + "Displacement.jpg"), map_texels(kFolder + "NormalGL.jpg");
    Pair texels, pictures{heights.slopes, up.slopes};
    for (const dvec2 st : heights.coordinates) {
        texels.a.push_back(slope_of_heights(height_texels, st));
        texels.b.push_back(slope_of_map(map_texels, st));
    }
    const Numbers own = Pair{heights.slopes, texels.a}.apart(1), map = Pair{up.slopes, texels.b}.apart(1);
    const double s = texels.scale();
    const Numbers apart = pictures.apart(s), before = texels.apart(s);
    fmt::print("heights against their texels {}\n  map against its texels {}\n", text_of(own), text_of(map));
    fmt::print("correlation {:.4f} drawn, {:.4f} of texels; apart {}\n  of texels {}\n",
               pictures.correlation(), texels.correlation(), text_of(apart), text_of(before));
    // A coordinate of 32 bits is off by 6e-8, 6e-5 texels, over which a slope changes by 2 a texel at most:
    // 0.007 degrees.
    EXPECT_LT(own.max, 0.007);
    EXPECT_LT(map.max, 0.007);
    EXPECT_LT(apart.p95, before.p95 + 2 * 0.007);
    EXPECT_TRUE(same_scale_along_both(pictures));
    const double right = pictures.correlation(), dx = Pair{heights.slopes, down.slopes}.correlation(),
                 turned = Pair{heights.slopes, wrong.slopes}.correlation();
    fmt::print("correlation {:.4f} with green up, {:.4f} down, {:.4f} turned\n", right, dx, turned);
    EXPECT_NEAR(right, texels.correlation(), 0.001);
    EXPECT_NEAR(dx, right, 0.01);  // another JPEG of the same map
    EXPECT_LT(turned, 0);
    // On a square plane slopes along t would be half as steep as the map says.
    const Drawn square = drawn_heights(2),
                square_map = drawn("NormalGL.jpg", R"("encoding": "tangent_normal")", kNormals, 1, 2);
    EXPECT_FALSE(same_scale_along_both({square.slopes, square_map.slopes}));
}

}  // namespace
}  // namespace sg::proof
