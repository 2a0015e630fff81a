// Improved Perlin noise, its octave sums and a power of them, in double precision, from the definitions: a
// weighted sum over the eight corners of a cell, differentiated by the product rule.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

struct Noise {
    double value = 0.0;
    glm::dvec3 gradient{0.0};  // with respect to the point
};

// Perlin 2002. Any finite p.
Noise noise_perlin(glm::dvec3 p);
// How much of an octave is left when a pixel covers `footprint` of its cells: 1 up to one half, 0 from 1 on.
double octave_weight(double footprint);
// Perlin 1985: the sums over i < octaves of n(2^i p) / 2^i and of its absolute value. footprint: in the space
// of p.
Noise noise_fractal_sum(glm::dvec3 p, double footprint, int octaves);
Noise noise_turbulence(glm::dvec3 p, double footprint, int octaves);
// max(f, 0)^k; the derivative of the power is held at or below 128. k >= 0.
Noise noise_power(const Noise& f, double k);

}  // namespace sg::ref
