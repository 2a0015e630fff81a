#include "surfgrad/volume.glsl"
vec3 lumps(SgVolume place, float frequency) { return frequency * sg_volume_perlin(sg_volume_scale(place, frequency)).gradient; }
