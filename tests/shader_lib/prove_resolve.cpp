// From surface gradients to normals (shader_lib/surfgrad/resolve.glsl) against double precision.
#include <algorithm>

#include "draws.hpp"
#include "ir/reference/from_volume.hpp"
#include "ir/reference/resolve.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/resolve.glsl";

void draw_normal_and_gradient(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction();
    in.put(0, n);
    in.put(3, tangent_of(random, n) * random.magnitude(1e-4, 1e6));
}

// Interpolated normal and tangent, side, map and strengths.
void draw_vertex_map(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction();
    in.put(0, n * random.uniform(0.3, 1.0));
    in.put(3, (tangent_of(random, n) + 0.3 * random.direction()) * random.uniform(0.3, 1.0));
    in.put(6, random.sign()), in.put(7, random.sign());
    glm::dvec3 m = random.direction();
    if (random.below(4) == 0) m.z *= random.magnitude(1e-4, 1.0);
    in.put(8, m * random.magnitude(0.1, 1.0));
    in.put(11, glm::dvec2(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0)));
}

const char* const kVertexMap = "put(0, sg_resolve_vertex_map(v3(0), v4(3), f(7), v3(8), v2(11)));";

Case vertex_map() {
    return {
        .name = "resolve_vertex_map",
        .include = kFile,
        .inputs = 13,
        .outputs = 3,
        .glsl = kVertexMap,
        .draw = draw_vertex_map,
        .reference =
            [](const In& in, Expect& out) {
                out.put(0, ref::resolve_vertex_map(in.v3(0), in.v4(3), in[7], in.v3(8), in.v2(11)));
            },
        // The clamp (2), three products (3 each, a cross product in one), two sums (2), a normalisation (6).
        .bound = {.absolute = 36 * kUlp},
        .condition =
            [](const In& in) {  // what the three terms are longer than their sum
                const glm::dvec3 n = in.v3(0), t = in.v3(3), b = glm::cross(n, t), m = in.v3(8);
                const double z = std::max(std::abs(m.z), std::max(std::abs(m.x), std::abs(m.y)) / 128.0);
                const glm::dvec2 lean = in.v2(11) * glm::dvec2(m);
                const glm::dvec3 sum = in[7] * z * n + lean.x * t + (in[6] < 0.0 ? -lean.y : lean.y) * b;
                return (z * glm::length(n) + std::abs(lean.x) * glm::length(t) +
                        2.0 * std::abs(lean.y) * glm::length(n) * glm::length(t)) /
                       glm::length(sum);
            },
        .property = unit,
        .mutants = {{kFile, "max(magnitude.x, magnitude.y) / SG_MAX_SLOPE", "0.0"},
                    {kFile, "z * n +", "n +"}}};
}

// Not-a-number stays with its texel; no texel at all is flat.
Case vertex_map_any_texel() {
    Case item = vertex_map();
    item.name = "resolve_vertex_map_any_texel";
    item.draw = [](Random& random, Draw& in) {
        draw_vertex_map(random, in);
        for (std::size_t k = 8; k < 11; ++k) in.put(k, random.coin() ? random.wild() : 0.0f);
    };
    item.reference = {};
    item.condition = {};
    item.property = [](const In& in, const In& out) -> std::string {
        const glm::dvec3 n = in[7] * in.v3(0);
        if (glm::length(out.v3(0) - n) < 1e-6) return "";
        if (!is_unit(out.v3(0))) return "neither unit nor the normal";
        return in.v3(8) == glm::dvec3(0.0) && !(glm::dot(out.v3(0), glm::normalize(n)) > 1.0 - 1e-6)
                   ? "not flat"
                   : "";
    };
    item.mutants = {{kFile, "bool number = square < 1e38;", "bool number = true;"}};
    return item;
}

// A normal and a volume gradient.
Case volume() {
    return {
        .name = "resolve_volume",
        .include = kFile,
        .inputs = 6,
        .outputs = 3,
        .glsl = "put(0, sg_resolve_volume(v3(0), v3(3)));",
        .draw =
            [](Random& random, Draw& in) {
                in.put(0, random.direction()), in.put(3, random.direction() * random.magnitude(1e-3, 1e6));
            },
        .reference = [](const In& in, Expect& out) { out.put(0, ref::resolve_volume(in.v3(0), in.v3(3))); },
        // A dot product (3), n's own length (2), two sums and two products (4), a quotient (1), and a
        // normalisation (5); doubled.
        .bound = {.absolute = 30 * kUlp},
        .condition =
            [](const In& in) {  // what the terms are longer than their sum
                const glm::dvec3 n = in.v3(0), v = in.v3(3), size = glm::abs(v);
                const double rise =
                    std::max({size.x, size.y, size.z, ref::kMaxVolumeGradient}) / ref::kMaxVolumeGradient;
                const double along = glm::dot(n, v);
                return (rise + std::abs(along) + glm::length(v)) / glm::length((rise + along) * n - v);
            },
        .property = unit_and_outward,
        .mutants = {{kFile, "largest / SG_MAX_VOLUME_GRADIENT, 1.0", "0.0, 1.0"},
                    {kFile, "(rise + dot(n, gradient)) * n", "rise * n"}}};
}

Case volume_any_input() {
    Case item = volume();
    item.name = "resolve_volume_any_input";
    item.draw = draw_normal_then_wild;
    item.reference = {};
    item.condition = {};
    item.mutants = {{kFile, "* n - gradient;", "* n - gradient; if (true) return normalize(bumped);"}};
    return item;
}

Case volume_along_n() {
    Case item = volume();
    item.name = "resolve_volume_along_n";
    item.blunt = "what is left of a gradient along n is rounding alone";
    item.inputs = 4;
    item.glsl = "put(0, sg_resolve_volume(v3(0), f(3) * v3(0)));";
    item.draw = [](Random& random, Draw& in) {
        in.put(0, random.direction()), in.put(3, random.sign() * random.magnitude(1.0, 1e15));
    };
    item.reference = [](const In& in, Expect& out) { out.put(0, in.v3(0)); };
    // The roundings of the two terms (10), each sqrt(3) * 16384 of rise or shorter.
    item.bound = {.absolute = 10 * kUlp * 1.7321 * ref::kMaxVolumeGradient};
    item.condition = {};
    item.mutants = {{kFile, "largest / SG_MAX_VOLUME_GRADIENT, 1.0", "0.0, 1.0"}};
    return item;
}

Case towards() {
    return {
        .name = "resolve_towards",
        .include = kFile,
        .inputs = 7,
        .outputs = 3,
        .glsl = "put(0, sg_resolve_towards(v3(0), v3(3), f(6)));",
        .draw =
            [](Random& random, Draw& in) {
                const glm::dvec3 n = random.direction();
                const double along =
                    random.coin() ? random.uniform(-1.0, 1.0) : random.sign() * random.magnitude(1e-4, 1.0);
                in.put(0, n);
                in.put(3, tangent_of(random, n) * std::sqrt(1.0 - along * along) + along * n);
                in.put(6, random.below(4) == 0 ? random.below(2) : random.uniform(-1.0, 2.0));
            },
        .reference = [](const In& in,
                        Expect& out) { out.put(0, ref::resolve_towards(in.v3(0), in.v3(3), in[6])); },
        // A dot product (3), the lengths of both (4), four sums and five products (9), a normalisation (5);
        // doubled.
        .bound = {.absolute = 42 * kUlp},
        .condition =
            [](const In& in) {  // what the terms are longer than their sum
                const glm::dvec3 n = in.v3(0), v = in.v3(3);
                const double along = glm::dot(n, v), part = in[6];
                const double rise = std::max(std::abs(along), 1.0 / 128.0);
                return (rise + std::abs(part * along) + std::abs(part)) /
                       glm::length((rise - part * along) * n + part * v);
            },
        .property = unit_and_outward,
        .mutants = {{kFile, "max(abs(along), (1.0 - 0.5 * along * along) / SG_MAX_SURFGRAD)", "abs(along)"},
                    {kFile, "(rise - part * along) * n", "(rise - along) * n"}}};
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
         .mutants = {{kFile, "vec3 bumped = n - g;", "vec3 bumped = 0.5 * n - g;"}}},
        {.name = "resolve_any_input",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), v3(3)));",
         .draw = draw_normal_then_wild,
         .property = unit,
         // Listing 1 itself.
         .mutants = {{kFile, "vec3 bumped = n - g;",
                      "if (true) return normalize(n - g); vec3 bumped = n - g;"}}},
        vertex_map(),
        vertex_map_any_texel(),
        volume(),
        volume_any_input(),
        volume_along_n(),
        towards(),
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
