// From surface gradients to normals (shader_lib/surfgrad/resolve.glsl) against double precision.
#include "draws.hpp"
#include "ir/reference/resolve.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/resolve.glsl";

void draw_normal_and_gradient(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction();
    in.put(0, n);
    in.put(3, tangent_of(random, n) * random.magnitude(1e-4, 1e6));
}

std::vector<Case> cases() {
    return {
        {.name = "resolve",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), v3(3)));",
         .draw = draw_normal_and_gradient,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::resolve(in.v3(0), in.v3(3))); },
         // The difference (1), then as for any normalisation (5).
         .bound = {.absolute = 12 * kUlp},
         .property = unit_and_outward,
         .mutants = {{kFile, "bumped * inversesqrt(square)", "bumped"}}},
        {.name = "resolve_any_input",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), v3(3)));",
         .draw = draw_normal_then_wild,
         .property = unit,
         // Listing 1 itself.
         .mutants = {{kFile, "return square > 1e-30 && square < 1e38 ? bumped * inversesqrt(square) : n;",
                      "return normalize(n - g);"}}},
        {.name = "flip",
         .include = kFile,
         .inputs = 4,
         .outputs = 3,
         .glsl = "put(0, sg_flip(v3(0), f(3)));",
         .draw = [](Random& random, Draw& in) { in.put(0, random.direction()), in.put(3, random.sign()); },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::flip(in.v3(0), in[3])); },
         .bound = {.absolute = 1e-30}},  // a product with 1 or -1 is exact
        {.name = "invert",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_invert(v3(0), v3(3)));",
         .draw = [](Random& random,
                    Draw& in) { in.put(0, random.direction()), in.put(3, random.direction()); },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::invert(in.v3(0), in.v3(3))); },
         // A dot product (3), two products (2), a difference (1), all of vectors up to 2 long.
         .bound = {.absolute = 24 * kUlp},
         .property = unit,
         .mutants = {{kFile, "2.0 * dot(n, resolved) * n - resolved",
                      "resolved - 2.0 * dot(n, resolved) * n"}}},
        {.name = "invert_is_the_negative_gradient",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_invert(v3(0), sg_resolve(v3(0), v3(3))));",
         .draw = draw_normal_and_gradient,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::resolve(in.v3(0), -in.v3(3))); },
         // Both of the above; g was rounded off the tangent plane by one more.
         .bound = {.absolute = 42 * kUlp}},
    };
}

SG_PROVE(Resolve, cases());

}  // namespace
}  // namespace sg::proof
