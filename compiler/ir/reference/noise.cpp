#include "ir/reference/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sg::ref {
namespace {

constexpr std::array<int, 256> kPermutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,
    69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,
    94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136,
    171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122,
    60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161,
    1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196, 135, 130, 116, 188, 159, 86,
    164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126,
    255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213,
    119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,   129, 22,  39,  253,
    19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,  242, 193,
    238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,
    222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

// The middles of a cube's twelve edges; four of them stand twice, to fill sixteen places.
const std::array<glm::dvec3, 16> kGradients = {{{1, 1, 0},
                                                {-1, 1, 0},
                                                {1, -1, 0},
                                                {-1, -1, 0},
                                                {1, 0, 1},
                                                {-1, 0, 1},
                                                {1, 0, -1},
                                                {-1, 0, -1},
                                                {0, 1, 1},
                                                {0, -1, 1},
                                                {0, 1, -1},
                                                {0, -1, -1},
                                                {1, 1, 0},
                                                {0, -1, 1},
                                                {-1, 1, 0},
                                                {0, -1, -1}}};

int permuted(int i) {
    return kPermutation[static_cast<std::size_t>(i % 256)];
}

// A corner's ramp direction, by its integer coordinates modulo 256.
glm::dvec3 corner_gradient(glm::ivec3 corner) {
    const int hash = permuted(permuted(permuted(corner.x) + corner.y) + corner.z);
    return kGradients[static_cast<std::size_t>(hash % 16)];
}

// The weight of a corner at distance t in 0..1 along one axis, and its derivative: 1 - (6 t^5 - 15 t^4 + 10
// t^3).
double weight_at(double t) {
    return 1.0 - (6.0 * std::pow(t, 5) - 15.0 * std::pow(t, 4) + 10.0 * std::pow(t, 3));
}
double weight_slope(double t) {
    return -(30.0 * std::pow(t, 4) - 60.0 * std::pow(t, 3) + 30.0 * t * t);
}

int modulo_256(double cell) {
    return static_cast<int>(cell - 256.0 * std::floor(cell / 256.0));
}

template <typename Octave>
Noise octave_sum(double footprint, int octaves, Octave octave) {
    Noise sum;
    for (int i = 0; i < octaves; ++i) {
        const double frequency = std::ldexp(1.0, i), weight = octave_weight(frequency * footprint);
        if (weight == 0.0) continue;
        const Noise n = octave(frequency);
        sum.value += weight * n.value / frequency;
        sum.gradient += weight * n.gradient;
    }
    return sum;
}

}  // namespace

Noise noise_perlin(glm::dvec3 p) {
    const glm::dvec3 cell = glm::floor(p), inside = p - cell;
    Noise sum;
    for (int number = 0; number < 8; ++number) {
        const glm::ivec3 side(number & 1, (number >> 1) & 1, number >> 2);
        const glm::dvec3 offset = inside - glm::dvec3(side);
        glm::ivec3 corner;
        glm::dvec3 weight, slope;
        for (int axis = 0; axis < 3; ++axis) {
            corner[axis] = modulo_256(cell[axis] + side[axis]);
            weight[axis] = weight_at(std::abs(offset[axis]));
            slope[axis] = weight_slope(std::abs(offset[axis])) * (offset[axis] < 0.0 ? -1.0 : 1.0);
        }
        const glm::dvec3 ramp = corner_gradient(corner);
        const double height = glm::dot(ramp, offset);
        const double all = weight.x * weight.y * weight.z;
        sum.value += all * height;
        sum.gradient +=
            all * ramp + height * glm::dvec3(slope.x * weight.y * weight.z, weight.x * slope.y * weight.z,
                                             weight.x * weight.y * slope.z);
    }
    return sum;
}

double octave_weight(double footprint) {
    if (!(footprint < 1.0)) return 0.0;
    const double t = std::clamp((footprint - 0.5) / 0.5, 0.0, 1.0);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

Noise noise_fractal_sum(glm::dvec3 p, double footprint, int octaves) {
    return octave_sum(footprint, octaves, [&](double frequency) { return noise_perlin(frequency * p); });
}

Noise noise_turbulence(glm::dvec3 p, double footprint, int octaves) {
    return octave_sum(footprint, octaves, [&](double frequency) {
        const Noise n = noise_perlin(frequency * p);
        const double side = n.value > 0.0 ? 1.0 : (n.value < 0.0 ? -1.0 : 0.0);
        return Noise{std::abs(n.value), side * n.gradient};
    });
}

Noise noise_power(const Noise& f, double k) {
    if (!(f.value > 0.0)) return {};
    const double slope = std::min(k * power(f.value, k - 1.0), 128.0);
    return {power(f.value, k), slope * f.gradient};
}

}  // namespace sg::ref
