// Surface gradients from object- and world-space normals (shader_lib/surfgrad/from_normal.glsl).
#include "draws.hpp"
#include "ir/reference/from_normal.hpp"
#include "ir/reference/resolve.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/from_normal.glsl";

// n, then a vector of any length that leans by up to 180 degrees, as often as not close to the tangent plane.
void draw_normals(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction();
    const double along =
        random.coin() ? random.uniform(-1.0, 1.0) : random.sign() * random.magnitude(1e-4, 1.0);
    in.put(0, n);
    in.put(3, (tangent_of(random, n) * std::sqrt(1.0 - along * along) + along * n) *
                  random.magnitude(1e-12, 1e15));
}

// Rounding moves the cosine k between n and v by 4 u; g = tan is about 1/k long and moves by 4 u / k^2, up to
// the clamp.
double steepness(const In& in) {
    const glm::dvec3 g = ref::surfgrad_from_normal(in.v3(0), in.v3(3));
    return 1.0 + glm::dot(g, g);
}

std::string bounded_and_tangential(const In& in, const In& out) {
    const glm::dvec3 g = out.v3(0);
    if (!(glm::length(g) <= ref::kMaxSurfgrad * (1.0 + 16 * kUlp))) return "longer than 128";
    return std::abs(glm::dot(g, in.v3(0))) <= 20 * kUlp * steepness(in) ? "" : "g leaves the tangent plane";
}

const Mutant kUnclamped = {kFile, "float rise = max(abs(along), length(tilt) / SG_MAX_SURFGRAD);",
                           "float rise = abs(along);"};

std::vector<Case> cases() {
    return {
        {.name = "surfgrad_from_normal",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_surfgrad_from_normal(v3(0), v3(3)));",
         .draw = draw_normals,
         .reference = [](const In& in,
                         Expect& out) { out.put(0, ref::surfgrad_from_normal(in.v3(0), in.v3(3))); },
         // Cosine (3), n's own length (2), projection (7), length (4), division and product (2).
         .bound = {.absolute = 36 * kUlp},
         .condition = steepness,
         .property = bounded_and_tangential,
         .mutants = {kUnclamped}},
        {.name = "surfgrad_from_normal_inverts_resolve",
         .include = std::string(kFile) + " surfgrad/resolve.glsl",
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_surfgrad_from_normal(v3(0), sg_resolve(v3(0), v3(3))));",
         .draw =
             [](Random& random, Draw& in) {
                 const glm::dvec3 n = random.direction();
                 in.put(0, n), in.put(3, tangent_of(random, n) * random.magnitude(1e-3, 127.0));
             },
         .reference = [](const In& in, Expect& out) { out.put(0, in.v3(3)); },
         .bound = {.absolute = 52 * kUlp},  // as above, and the resolve (8)
         .condition = [](const In& in) { return 1.0 + glm::dot(in.v3(3), in.v3(3)); },
         .mutants = {{kFile, "-tilt / max(rise, 1e-15)", "-tilt"}}},
        {.name = "surfgrad_from_normal_any_input",
         .include = std::string(kFile) + " surfgrad/resolve.glsl",
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), sg_surfgrad_from_normal(v3(0), v3(3))));",
         .draw = draw_normal_then_wild,
         .property = unit_and_outward},
        {.name = "normal_from_object",
         .include = kFile,
         .inputs = 12,
         .outputs = 3,
         .glsl = "put(0, sg_normal_from_object(m3(3), v3(0)));",
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 12; ++k) in.put(k, random.uniform(-2.0, 2.0));
             },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::normal_from_object(glm::dmat3(in.v3(3), in.v3(6), in.v3(9)), in.v3(0)));
             },
         .bound = {.absolute = 3 * 4 * 10 * kUlp}},  // three products of at most 4, five roundings
    };
}

SG_PROVE(FromNormal, cases());

std::vector<float> gradient_of(std::vector<float> n_and_v) {
    return evaluate(cases()[0], n_and_v);
}

TEST(FromNormalEdges, ZeroIsFlat) {
    for (float x : gradient_of({0.6f, 0.0f, 0.8f, 0.0f, 0.0f, 0.0f})) EXPECT_EQ(x, 0.0f);
}

TEST(FromNormalEdges, InwardIsTheMirrorImageInFrontAndContinuousThroughTheTangentPlane) {
    const std::vector<float> front = gradient_of({0, 0, 1, 0.6f, 0.0f, 0.8f}),
                             back = gradient_of({0, 0, 1, 0.6f, 0.0f, -0.8f});
    EXPECT_EQ(front, back);
    const std::vector<float> above = gradient_of({0, 0, 1, 1.0f, 0.0f, 1e-7f}),
                             below = gradient_of({0, 0, 1, 1.0f, 0.0f, -1e-7f});
    EXPECT_EQ(above, below);
    EXPECT_EQ(above[0], -128.0f);
}

// A sphere of radius 1 scaled by (1, 2, 0.5): the map holds the sphere's normals, the mesh's own normal is
// anything near.
TEST(FromNormalEdges, NonUniformScaleGivesTheEllipsoidsNormal) {
    const glm::dvec3 scale(1.0, 2.0, 0.5);
    const Case item = {.name = "ellipsoid",
                       .include = std::string(kFile) + " surfgrad/resolve.glsl",
                       .inputs = 15,
                       .outputs = 3,
                       .glsl =
                           "put(0, sg_resolve(v3(0), sg_surfgrad_from_normal(v3(0), "
                           "sg_normal_from_object(m3(6), v3(3)))));"};
    constexpr std::size_t kPlaces = 100;
    Random random("ellipsoid");
    std::vector<float> inputs(15 * kPlaces);
    std::vector<glm::dvec3> expected;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const glm::dvec3 on_sphere = random.direction();
        // The gradient of x^2/a^2 + y^2/b^2 + z^2/c^2 at the scaled point.
        expected.push_back(glm::normalize(on_sphere * scale / (scale * scale)));
        Draw in(std::span<float>(inputs).subspan(15 * i, 15));
        in.put(0, glm::normalize(expected.back() + 0.3 * random.direction())), in.put(3, on_sphere);
        // Cofactors of the scale: products of the other two factors.
        in.put(6, glm::dvec3(1.0, 0.0, 0.0)), in.put(9, glm::dvec3(0.0, 0.5, 0.0)),
            in.put(12, glm::dvec3(0.0, 0.0, 2.0));
    }
    const std::vector<float> got = evaluate(item, inputs);
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const glm::dvec3 n(got[3 * i], got[3 * i + 1], got[3 * i + 2]);
        EXPECT_LT(glm::length(n - expected[i]), 2e-6) << "SG_SEED=" << run_seed();
    }
}

}  // namespace
}  // namespace sg::proof
