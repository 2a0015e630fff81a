// The numbers that bound the figures, computed from what they come from: a map's own texels, and a formula's
// own error in double precision. A figure's claim may ask for no more than they allow.
//
// Where a bound has two parts that each hold for all but a share of the places, their sum holds for all but
// twice that share: a median is bounded by two quartiles, a 95th percentile by two of 97.5.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "runtime/proof/angles.hpp"
#include "tests/render/workshop.hpp"

namespace sg::proof {
namespace {

using glm::dvec2;
using glm::dvec3;
using std::size_t;

const std::string kMaterials = SG_SOURCE_DIR "/materials/";

class Map {
public:
    explicit Map(const std::string& file) {
        RealFiles files;
        Diags diags;
        const std::string path = kMaterials + "textures/" + file;
        image_ = asset::read_image(files.read(path).bytes, path, {}, diags).value();
    }
    [[nodiscard]] int side() const { return static_cast<int>(image_.width); }
    [[nodiscard]] double at(int x, int y, int c = 0) const {
        auto wrapped = [&](int i) { return static_cast<std::uint32_t>((i + 2 * side()) % side()); };
        return image_.at(wrapped(x), wrapped(y), c);
    }
    [[nodiscard]] dvec2 sobel(int x, int y) const {
        dvec2 out(0);
        for (int i = -1; i <= 1; ++i) {
            const double weight = (i == 0 ? 2 : 1) / 8.0;
            out.x += weight * (at(x + 1, y + i) - at(x - 1, y + i));
            out.y += weight * (at(x + i, y + 1) - at(x + i, y - 1));
        }
        return out;
    }

private:
    asset::Image image_;
};

// ---- the smooth surface through a map's heights: Catmull and Rom's ----

struct Weights {
    std::array<double, 4> value, derivative;
    explicit Weights(double t)
        : value{(-t * t * t + 2 * t * t - t) / 2, (3 * t * t * t - 5 * t * t + 2) / 2,
                (-3 * t * t * t + 4 * t * t + t) / 2, (t * t * t - t * t) / 2},
          derivative{(-3 * t * t + 4 * t - 1) / 2, (9 * t * t - 10 * t) / 2, (-9 * t * t + 8 * t + 1) / 2,
                     (3 * t * t - 2 * t) / 2} {}
};

struct Smooth {
    double value = 0;
    dvec2 slope{0};  // of the value, per texel
};
Smooth smooth_at(const Map& map, dvec2 texels) {
    const dvec2 corner = glm::floor(texels);
    const Weights across(texels.x - corner.x), down(texels.y - corner.y);
    Smooth out;
    for (size_t k = 0; k < 16; ++k) {
        const size_t i = k % 4, j = k / 4;
        const double h = map.at(static_cast<int>(corner.x) - 1 + static_cast<int>(i),
                                static_cast<int>(corner.y) - 1 + static_cast<int>(j));
        out.value += h * across.value[i] * down.value[j];
        out.slope += h * dvec2(across.derivative[i] * down.value[j], across.value[i] * down.derivative[j]);
    }
    return out;
}

// ---- shares of places ----

using Degrees = std::vector<double>;
double quantile(Degrees degrees, double share) {
    std::sort(degrees.begin(), degrees.end());
    return degrees[static_cast<size_t>(share * static_cast<double>(degrees.size() - 1))];
}

double between(dvec2 slope, dvec2 other) {
    return angle_degrees(dvec3(-slope, 1), dvec3(-other, 1));
}

template <class Found>
Degrees at_places(const Map& map, double steepness, Found found) {
    constexpr int kPlaces = 4;  // per side of a texel
    Degrees out;
    for (int y = 0; y < map.side() * kPlaces; ++y) {
        for (int x = 0; x < map.side() * kPlaces; ++x) {
            const dvec2 place = (dvec2(x, y) + 0.5) / double(kPlaces);
            out.push_back(between(steepness * found(place), steepness * smooth_at(map, place).slope));
        }
    }
    return out;
}

// What derivatives of filtered texels, mixed linearly, are off the smooth surface. steepness: the slope of a
// step of value 1 over one texel.
Degrees derivatives(const char* file, double steepness) {
    const Map map(file);
    return at_places(map, steepness, [&](dvec2 place) {
        const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
        const dvec2 t = place - glm::floor(place);
        return glm::mix(glm::mix(map.sobel(x, y), map.sobel(x + 1, y), t.x),
                        glm::mix(map.sobel(x, y + 1), map.sobel(x + 1, y + 1), t.x), t.y);
    });
}

// What differences over one texel are off: half a texel in both directions.
Degrees differences(const char* file, double steepness) {
    const Map map(file);
    auto linear = [&](dvec2 place) {
        const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
        const dvec2 t = place - glm::floor(place);
        return glm::mix(glm::mix(map.at(x, y), map.at(x + 1, y), t.x),
                        glm::mix(map.at(x, y + 1), map.at(x + 1, y + 1), t.x), t.y);
    };
    return at_places(map, steepness, [&](dvec2 place) {
        return dvec2(linear(place + dvec2(1, 0)), linear(place + dvec2(0, 1))) - linear(place);
    });
}

// Half the angle between normals that stand `apart` texels from each other: what lies between them cannot be
// known better. steepness: a factor of their slopes.
Degrees neighbours(const char* file, double zero, double steepness, int apart) {
    const Map map(file);
    auto normal = [&](int x, int y) {
        const double unit = zero == 127.5 ? 127.5 : 127;
        auto decoded = [&](int c) { return (map.at(x, y, c) * 255 - zero) / unit; };
        return dvec3(steepness * decoded(0), steepness * decoded(1), decoded(2));
    };
    Degrees out;
    for (int y = 0; y < map.side(); ++y) {
        for (int x = 0; x < map.side(); ++x) {
            out.push_back(angle_degrees(normal(x, y), normal(x + apart, y)) / 2);
            out.push_back(angle_degrees(normal(x, y), normal(x, y + apart)) / 2);
        }
    }
    return out;
}

// ---- Lengyel's formula ----

// A plane of side 2 with the heights of a map, its value 1/2 on the plane, looked at from `eye`. Between the
// normals that a ray really meets and those where so many planes lead (7.51: n_z h v_xy), in double
// precision.
Degrees planes(const char* file, double strength, dvec3 eye, int count) {
    const Map map(file);
    auto at = [&](dvec2 xy) {
        return smooth_at(map, dvec2(xy.x + 1, 1 - xy.y) / 2.0 * double(map.side()) - 0.5);
    };
    auto normal = [&](dvec2 xy) {
        const dvec2 slope = strength * map.side() / 2 * at(xy).slope;
        return glm::normalize(dvec3(-slope.x, slope.y, 1));
    };
    auto height = [&](dvec2 xy) { return strength * (at(xy).value - 0.5); };
    Degrees out;
    for (int i = 0; i < 100 * 60; ++i) {
        const dvec2 start(-0.7 + 0.014 * (i % 100), -0.5 + 0.0166 * (i / 100));
        const dvec3 view = glm::normalize(eye - dvec3(start, 0));
        dvec2 led = start;
        for (int k = 0; k < count; ++k) led += normal(led).z * height(led) * dvec2(view) / double(count);
        double z = strength / 2;
        auto hit = [&] { return start + z / view.z * dvec2(view); };
        while (z > height(hit())) z -= 2e-4;
        out.push_back(angle_degrees(normal(led), normal(hit())));
    }
    return out;
}

// ---- what the figures claim ----

// A claim, by the words that its text begins with, and the parts of its bound.
void expect_bound(const std::string& figure, const std::string& words, const std::vector<double>& parts) {
    RealFiles files;
    const auto json =
        nlohmann::json::parse(files.read(kMaterials + "figures/" + figure + ".figure.json").bytes);
    for (const auto& claim : json.at("claims")) {
        const std::string text = claim.at("text");
        if (!text.starts_with(words)) continue;
        double sum = 0;
        for (double part : parts) {
            sum += part;
            const std::string number = fmt::format("{:.1f}", part);
            EXPECT_NE(text.find(number), std::string::npos)
                << figure << " must say " << number << ": " << text;
        }
        fmt::print("{}: below {}, derived {:.2f}\n", figure, claim.at("below").get<double>(), sum);
        EXPECT_LE(claim.at("below").get<double>(), sum) << figure << ": " << text;
        EXPECT_GT(claim.at("below").get<double>(), sum - 0.1) << figure << ": " << text;
        return;
    }
    ADD_FAILURE() << figure << " has no claim that begins with " << words;
}

// On the rock a texel of the stones is 0.0041 units high or more, and stands for 0.006: slopes times 1.5 at
// most. A pixel is 3 texels of the gravel wide, in figure 7 a 2.
TEST(Bounds, OfTheRock) {
    const Degrees stones = neighbours("pebble_normal.png", 127, 1.5, 1),
                  gravel = neighbours("pebble_normal.png", 127, 0.8, 3);
    expect_bound("figure_7", "At half", {quantile(stones, 0.75), quantile(gravel, 0.75)});
    const Degrees near = neighbours("pebble_normal.png", 127, 0.8, 2);
    expect_bound("figure_7_a", "At half", {quantile(near, 0.5)});
    expect_bound("figure_7_a", "At 95 %", {quantile(near, 0.95)});
}

TEST(Bounds, OfTheCarvedPebbles) {
    const Degrees stones = derivatives("pebble_height.png", 0.1 * 128 / 2),
                  grain = differences("pebble_height.png", 0.006 * 6 * 128 / 2);
    expect_bound("figure_7_c", "At half", {quantile(stones, 0.75), quantile(grain, 0.75)});
    expect_bound("figure_7_c", "At 95 %", {quantile(stones, 0.975), quantile(grain, 0.975)});
    expect_bound("figure_7_d", "At half", {quantile(stones, 0.5)});
    expect_bound("figure_7_d", "At 95 %", {quantile(stones, 0.95)});
}

TEST(Bounds, OfTangentPlanes) {
    const dvec3 eye(0.2, -1.9, 2.3);
    const Degrees four = planes("pebble_height_fine.png", 0.08, eye, 4),
                  none = planes("pebble_height_fine.png", 0.08, eye, 0),
                  texels = neighbours("pebble_normal.png", 127, 1, 1);
    fmt::print("median without planes {:.2f}, with four {:.2f}\n", quantile(none, 0.5), quantile(four, 0.5));
    expect_bound("lengyel_7_15", "At half", {quantile(four, 0.75), quantile(texels, 0.75)});
}

}  // namespace
}  // namespace sg::proof
