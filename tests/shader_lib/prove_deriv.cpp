// Tangent-space normals and derivatives (shader_lib/surfgrad/deriv.glsl) against double precision.
#include "harness.hpp"
#include "ir/reference/deriv.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/deriv.glsl";

void draw_tangent_normal(Random& random, Draw& in) {
    glm::dvec3 m = random.direction() * random.magnitude(1e-3, 1.0);
    if (random.below(4) == 0) m.z *= random.magnitude(1e-6, 1.0);  // steep: some beyond the clamp
    in.put(0, m);
}

std::string within_slope(const In&, const In& out) {
    const double limit = ref::kMaxSlope * (1.0 + 4.0 * kUlp);
    return std::abs(out[0]) <= limit && std::abs(out[1]) <= limit ? "" : "beyond 128";
}

std::vector<Case> cases() {
    return {
        {.name = "decode_signed",
         .include = kFile,
         .inputs = 4,
         .outputs = 5,
         .glsl = "put(0, sg_decode_signed(v2(0), f(3))); put(2, sg_decode_signed(v3(0), f(3)));",
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 3; ++k) in.put(k, random.uniform(0.0, 1.0));
                 in.put(3, 127.0 + 0.5 * random.below(3));
             },
         .reference =
             [](const In& in, Expect& out) {
                 for (std::size_t k = 0; k < 5; ++k)
                     out.put(k, ref::decode_signed(in[k < 2 ? k : k - 2], in[3]));
             },
         // 255 texel rounds at 255 u, the difference loses it to the zero code: 255 u / 127, twice for the
         // doubling.
         .bound = {.absolute = 6 * kUlp, .relative = 4 * kUlp},
         .mutants =
             {{kFile,
               "vec2 texel, float zero) {\n    return clamp((255.0 * texel - zero) / min(zero, 255.0 - zero)",
               "vec2 texel, float zero) {\n    return clamp((255.0 * texel - zero) / 127.5"},
              {kFile, "vec3 texel, float zero) {\n    return clamp((255.0 * texel - zero)",
               "vec3 texel, float zero) {\n    return clamp((255.0 * texel - 127.5)"}}},
        {.name = "deriv_from_normal_xyz",
         .include = kFile,
         .inputs = 3,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_normal_xyz(v3(0)));",
         .draw = draw_tangent_normal,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::deriv_from_normal_xyz(in.v3(0))); },
         // Two divisions.
         .bound = {.absolute = 1e-30, .relative = 4 * kUlp},
         .property = within_slope,
         .mutants = {{kFile, "? -m.xy / z", "? m.xy / z"},
                     {kFile, "? -m.xy / z", "? -m.yx / z"},
                     {kFile, "? -m.xy / z", "? vec2(-m.x, m.y) / z"},
                     {kFile, "vec3 magnitude = abs(m);", "vec3 magnitude = vec3(abs(m.xy), m.z);"},
                     {kFile, "max(magnitude.x, magnitude.y) / SG_MAX_SLOPE", "magnitude.x / SG_MAX_SLOPE"}}},
    };
}

SG_PROVE(Deriv, cases());

}  // namespace
}  // namespace sg::proof
