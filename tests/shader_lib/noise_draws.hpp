// Points at which noise is drawn, and how far its roundings go: for every proof that looks noise up.
#pragma once

#include "harness.hpp"
#include "ir/reference/noise.hpp"

namespace sg::proof {

inline constexpr int kOctaves = 6;

// Everywhere that noise is different: within a cell, on its faces, across the wrap at 256, negative, far
// away.
inline glm::dvec3 draw_point(Random& random) {
    glm::dvec3 p = random.within(random.magnitude(0.5, 2000.0));
    if (random.below(4) == 0) {
        const int axis = random.below(3);
        p[axis] = std::round(p[axis]) + (random.coin() ? 0.0 : random.sign() * random.magnitude(1e-7, 1e-2));
    }
    if (random.below(16) == 0) p.x = random.sign() * (256.0 + random.uniform(-1.0, 1.0));
    if (random.below(64) == 0) p = glm::round(p);
    return p;
}

inline void put_noise(Expect& out, const ref::Noise& noise) {
    out.put(0, noise.value);
    out.put(1, noise.gradient);
}

// Roundings of the shader, in units of kUlp. The fade curve: Horner's middle values reach 15, which costs at
// most 24 near f = 1 (less than 12 below 0.8). The ramps: 6. The interpolation multiplies the fade's error by
// differences of ramps, which add up to less than 4, and rounds 9 times: value 4 * 24 + 6 + 9 = 111. The
// gradient: three interpolations of numbers in -1..1 (2 * 24 each at most, 3 axes, of which two are far from
// f = 1 in all but rare cells) and slope * across
// <= 1.875 * (4 * 24 + 12 + 9), together less than 370.
inline constexpr double kValueRoundings = 111.0, kGradientRoundings = 370.0;

// |sign| of an octave is a matter of luck within the rounding of its value, also where the sum's terms happen
// to cancel exactly in double; the zeros at integers are no sums and exact in both.
inline bool on_a_corner(glm::dvec3 p, double footprint, int octaves) {
    bool corner = false;
    for (int i = 0; i < octaves; ++i) {
        const double frequency = std::ldexp(1.0, i);
        const glm::dvec3 q = frequency * p;
        const bool rounded =
            q != glm::floor(q) && std::abs(ref::noise_perlin(q).value) < kValueRoundings * kUlp;
        corner |= rounded && ref::octave_weight(frequency * footprint) > 0.0;
    }
    return corner;
}

}  // namespace sg::proof
