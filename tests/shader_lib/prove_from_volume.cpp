// Surface gradients of volume bumps (shader_lib/surfgrad/from_volume.glsl) against double precision.
#include <algorithm>

#include "draws.hpp"
#include "ir/reference/from_volume.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/from_volume.glsl";

double cut_length(const In& in) {
    const glm::dvec3 size = glm::abs(in.v3(3));
    const double largest = std::max({size.x, size.y, size.z, ref::kMaxVolumeGradient});
    return glm::length(size) * ref::kMaxVolumeGradient / largest;
}

void draw_gradient(Random& random, Draw& in) {
    in.put(0, random.direction());
    in.put(3, random.direction() * random.magnitude(1e-3, 1e6));
}

std::vector<Case> cases() {
    return {
        {.name = "surfgrad_from_volume",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_surfgrad_from_volume(v3(0), v3(3)));",
         .draw = draw_gradient,
         .reference = [](const In& in,
                         Expect& out) { out.put(0, ref::surfgrad_from_volume(in.v3(0), in.v3(3))); },
         .bound = {.absolute = 18 * kUlp},  // a projection (7), and the cut (2)
         .condition = cut_length,
         .property =
             [](const In& in, const In& out) {
                 return std::abs(glm::dot(out.v3(0), in.v3(0))) <= 14 * kUlp * cut_length(in)
                            ? ""
                            : "g leaves the tangent plane";
             },
         .mutants = {{kFile, "SG_MAX_VOLUME_GRADIENT / largest * gradient", "gradient"}}},
        {.name = "surfgrad_from_volume_is_linear",
         .include = kFile,
         .inputs = 7,
         .outputs = 3,
         .glsl = "put(0, sg_surfgrad_from_volume(v3(0), f(6) * v3(3)) - f(6) * "
                 "sg_surfgrad_from_volume(v3(0), v3(3)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, random.direction()), in.put(3, random.direction() * random.magnitude(1e-3, 1e3));
                 in.put(6, random.uniform(-4.0, 4.0));
             },
         .reference = [](const In&, Expect& out) { out.put(0, glm::dvec3(0.0)); },
         .bound = {.absolute = 24 * kUlp},  // five roundings in each projection, one in each product
         .condition = [](const In& in) { return 4.0 * glm::length(in.v3(3)); },
         .mutants = {{kFile, "SG_MAX_VOLUME_GRADIENT = 16384.0", "SG_MAX_VOLUME_GRADIENT = 500.0"}}},
        {.name = "surfgrad_from_volume_along_n",
         .blunt = "what is left of a gradient along n is rounding alone",
         .include = std::string(kFile) + " surfgrad/resolve.glsl",
         .inputs = 4,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), sg_surfgrad_from_volume(v3(0), f(3) * v3(0))));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, random.direction()), in.put(3, random.sign() * random.magnitude(1.0, 1e15));
             },
         .reference = [](const In& in, Expect& out) { out.put(0, in.v3(0)); },
         // A projection's 7 roundings of the longest gradient: g is shorter than this, and should be 0.
         // Gradients are cut by their largest component, so that three of that size make the longest: sqrt(3)
         // = 1.7321 of it.
         .bound = {.absolute = 14 * kUlp * 1.7321 * ref::kMaxVolumeGradient},
         .property = unit_and_outward,
         .mutants = {{kFile, "SG_MAX_VOLUME_GRADIENT / largest * gradient", "gradient"}}},
        {.name = "surfgrad_from_volume_any_input",
         .include = std::string(kFile) + " surfgrad/resolve.glsl",
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), sg_surfgrad_from_volume(v3(0), v3(3))));",
         .draw = draw_normal_then_wild,
         .property = unit_and_outward},
    };
}

SG_PROVE(FromVolume, cases());

}  // namespace
}  // namespace sg::proof
