// The height functions behind the sample textures: analytic, tileable, and without any symmetry that would
// hide a flipped sign. Only + - * / sqrt, comparisons and integers, so that every machine computes the same
// bits.
//
// s and t are texture coordinates (t downward), periodic with period 1; heights are in widths of the tile.
#pragma once

namespace sg::samples {

double brick_height(double s, double t);
double scratch_height(double s, double t);
double weave_height(double s, double t);
double ramp_height(double s, double t);
double pebble_height(double s, double t);
double dome_height(double s, double t);
double rib_height(double s, double t);
double ripple_height(double s, double t);

}  // namespace sg::samples
