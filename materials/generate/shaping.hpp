// Small parts that height functions are made of.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sg::samples {

inline double clamp01(double x) {
    return std::min(std::max(x, 0.0), 1.0);
}
inline double fraction(double x) {
    return x - std::floor(x);
}
inline double smooth(double x) {
    return x * x * (3.0 - 2.0 * x);
}
inline double mix(double a, double b, double x) {
    return a + (b - a) * x;
}

// 0 below x = 0, 1 above x = 1, steep at first and level at the end: the profile of a worn edge.
inline double bevel(double x) {
    const double rest = 1.0 - clamp01(x);
    return 1.0 - rest * rest;
}

// A smooth wave of period 1 between -1 (at 0) and 1 (at 1/2), close to a cosine.
inline double wave(double x) {
    const double f = fraction(x);
    return 2.0 * smooth(f < 0.5 ? 2.0 * f : 2.0 - 2.0 * f) - 1.0;
}

// i modulo n, never negative.
inline int wrap(int i, int n) {
    return ((i % n) + n) % n;
}

// The shortest way from b to a on a circle of circumference 1.
inline double wrapped_difference(double a, double b) {
    return fraction(a - b + 0.5) - 0.5;
}

// A number in [0, 1) for each pair of integers and purpose.
inline double random_of(int i, int j, std::uint32_t purpose) {
    std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9e3779b1u ^
                      static_cast<std::uint32_t>(j) * 0x85ebca77u ^ purpose * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (h ^ h >> 15) / 4294967296.0;
}

// Smooth random heights in [0, 1), cells x cells lattice points per tile.
inline double value_noise(double s, double t, int cells, std::uint32_t purpose) {
    const double x = s * cells, y = t * cells;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const double u = smooth(x - std::floor(x)), v = smooth(y - std::floor(y));
    auto at = [&](int di, int dj) { return random_of(wrap(i + di, cells), wrap(j + dj, cells), purpose); };
    return mix(mix(at(0, 0), at(1, 0), u), mix(at(0, 1), at(1, 1), u), v);
}

// Distance from (x, y) to the border of the box, positive inside.
inline double inside_box(double x, double y, double left, double top, double right, double bottom) {
    return std::min(std::min(x - left, right - x), std::min(y - top, bottom - y));
}

}  // namespace sg::samples
