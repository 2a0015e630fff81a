// A place in the space in which a volume bump map is looked up, with its screen derivatives: what a Uv is to textures.
// Everything here hands the place and its footprint on to noise.glsl and triplanar.glsl.
// Source: Mikkelsen 2020, section 3.6, Eq 19.
#ifndef SG_VOLUME
#define SG_VOLUME

#include "surfgrad/noise.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/volume_space.glsl"

struct SgVolume {
    vec3 p;   // object space, or absolute world space
    vec3 dx;  // dp/dx per pixel to the right
    vec3 dy;  // dp/dy per pixel downward
};

// A lookup at another frequency.
//   volume: any; frequency: cells or repeats per unit. Result: derivatives scale alike. Cost: 14 instructions.
//   Source: section 3.6.
SgVolume sg_volume_scale(SgVolume volume, float frequency) {
    return SgVolume(frequency * volume.p, frequency * volume.dx, frequency * volume.dy);
}

// One octave of Perlin noise; it vanishes as a pixel grows to a cell.
//   volume: cells of size 1. Result: as sg_noise_perlin. Cost: 303 instructions. Source: section 3.6.
SgNoise sg_volume_perlin(SgVolume volume) { return sg_noise_fractal_sum(volume.p, sg_footprint(volume.dx, volume.dy), 1); }

// A fractal sum.
//   volume: any; octaves: 0 to 20. Result: as sg_noise_fractal_sum.
//   Cost: 305 instructions, nearly all of them once per visible octave. Source: section 3.6; Perlin 1985.
SgNoise sg_volume_fractal_sum(SgVolume volume, int octaves) {
    return sg_noise_fractal_sum(volume.p, sg_footprint(volume.dx, volume.dy), octaves);
}

// Turbulence.
//   volume: any; octaves: 0 to 20. Result: as sg_noise_turbulence.
//   Cost: 309 instructions, nearly all of them once per visible octave. Source: section 3.6; Perlin 1985.
SgNoise sg_volume_turbulence(SgVolume volume, int octaves) {
    return sg_noise_turbulence(volume.p, sg_footprint(volume.dx, volume.dy), octaves);
}

// The coordinates of a triplanar lookup. hand, origin: as in triplanar.glsl.
// Cost: 18 instructions (9 where hand and origin are constant). Source: Eq 19.
SgTriplanarUv sg_volume_triplanar_uv(SgVolume volume, float hand, float origin) {
    return sg_triplanar_uv(volume.p, volume.dx, volume.dy, hand, origin);
}

// All weight of a triplanar lookup on one plane: planar projection along x. Cost: 0 instructions.
// Source: Eq 19 with one weight.
vec3 sg_axis_x() { return vec3(1.0, 0.0, 0.0); }

// Planar projection along y. Cost: 0 instructions. Source: Eq 19 with one weight.
vec3 sg_axis_y() { return vec3(0.0, 1.0, 0.0); }

// Planar projection along z. Cost: 0 instructions. Source: Eq 19 with one weight.
vec3 sg_axis_z() { return vec3(0.0, 0.0, 1.0); }

#endif
