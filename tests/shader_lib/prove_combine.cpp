// Combinations of bumps (shader_lib/surfgrad/combine.glsl) against double precision.
#include "draws.hpp"
#include "ir/reference/combine.hpp"
#include "ir/reference/deriv.hpp"
#include "ir/reference/from_normal.hpp"
#include "ir/reference/resolve.hpp"
#include "ir/reference/tbn.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/combine.glsl";
constexpr double kSteepest = 1.5;  // radians: a slope of 14

glm::dvec3 outward(Random& random, double steepest = kSteepest) {
    const double lean = random.uniform(0.0, steepest);
    return {random.direction2() * std::sin(lean), std::cos(lean)};
}
void draw_pair(Random& random, Draw& in) {
    in.put(0, outward(random)), in.put(3, outward(random));
}
void draw_gradients(Random& random, Draw& in) {
    in.put(0, random.within(10.0)), in.put(3, random.within(10.0));
    in.put(6, random.uniform(0.0, 1.0));
}
double larger(const In& in) {
    return std::max(glm::length(in.v3(0)), glm::length(in.v3(3)));
}

// The slopes' rounding reaches the normal at most undiminished, and slopes of opposite sign may cancel.
double slopes(const In& in) {
    return 1.0 + glm::length(ref::deriv_from_normal_xyz(in.v3(0))) +
           glm::length(ref::deriv_from_normal_xyz(in.v3(3)));
}

std::vector<Case> gradient_cases() {
    return {
        {.name = "combine_add",
         .include = kFile,
         .inputs = 7,
         .outputs = 3,
         .glsl = "put(0, sg_combine_add(v3(0), v3(3)));",
         .draw = draw_gradients,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::combine_add(in.v3(0), in.v3(3))); },
         .bound = {.absolute = 1e-30, .relative = 2 * kUlp},  // one sum
         .mutants = {{kFile, "{ return a + b; }", "{ return a; }"}}},
        {.name = "combine_scale",
         .include = kFile,
         .inputs = 7,
         .outputs = 3,
         .glsl = "put(0, sg_combine_scale(v3(0), f(3)));",
         .draw = draw_gradients,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::combine_scale(in.v3(0), in[3])); },
         .bound = {.absolute = 1e-30, .relative = 2 * kUlp},  // one product
         .mutants = {{kFile, "return strength * g;", "return abs(strength) * g;"}}},
        {.name = "combine_mask",
         .include = kFile,
         .inputs = 7,
         .outputs = 3,
         .glsl = "put(0, sg_combine_mask(v3(0), f(6)));",
         .draw = draw_gradients,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::combine_mask(in.v3(0), in[6])); },
         .bound = {.absolute = 1e-30, .relative = 2 * kUlp},  // one product
         .mutants = {{kFile, "min(mask, 1.0) * g", "g"}}},
        {.name = "combine_mask_hides_anything",
         .include = kFile,
         .inputs = 4,
         .outputs = 3,
         .glsl = "put(0, sg_combine_mask(v3(0), f(3)));",
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 3; ++k) in.put(k, random.wild());
                 in.put(3, random.coin() ? 0.0 : std::nan(""));
             },
         .reference = [](const In&, Expect& out) { out.put(0, glm::dvec3(0.0)); },
         .bound = {.absolute = 1e-30},
         .mutants = {{kFile, "mask > 0.0 ? min(mask, 1.0) * g : vec3(0.0)", "mask * g"}}},
        {.name = "combine_mix",
         .include = kFile,
         .inputs = 7,
         .outputs = 3,
         .glsl = "put(0, sg_combine_mix(v3(0), v3(3), f(6)));",
         .draw = draw_gradients,
         .reference = [](const In& in,
                         Expect& out) { out.put(0, ref::combine_mix(in.v3(0), in.v3(3), in[6])); },
         .bound = {.absolute = 8 * kUlp},  // 1 - t, two products and a sum
         .condition = larger,
         .mutants = {{kFile, "t < 1.0 ? between : b", "b"}}},
        {.name = "combine_mix_hides_anything",
         .include = kFile,
         .inputs = 8,
         .outputs = 6,
         .glsl = "put(0, sg_combine_mix(v3(0), v3(3), f(6))); put(3, sg_combine_mix(v3(3), v3(0), f(7)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, random.within(10.0)), in.put(6, glm::dvec2(0.0, 1.0));
                 for (std::size_t k = 3; k < 6; ++k) in.put(k, random.wild());
             },
         .reference = [](const In& in, Expect& out) { out.put(0, in.v3(0)), out.put(3, in.v3(0)); },
         .bound = {.absolute = 1e-30},  // a copy
         .mutants = {{kFile, "return t > 0.0 ? upper : a;", "return upper;"},
                     {kFile, "t < 1.0 ? between : b", "between"}}},
    };
}

constexpr const char* kPutPair = "put(0, pair.first); put(2, pair.second);";

std::vector<Case> surveyed_cases() {
    return {
        {.name = "combine_pd",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_combine_pd(v3(0), v3(3)));",
         .draw = draw_pair,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::combine_pd(in.v3(0), in.v3(3))); },
         .bound = {.absolute =
                       18 *
                       kUlp},  // two slopes (2 each), a sum (1), a normalisation (6): of the slopes' size
         .condition = slopes,
         .property = unit},
        {.name = "combine_whiteout",
         .include = kFile,
         .inputs = 6,
         .outputs = 4,
         .glsl = std::string("SgDerivPair pair = sg_combine_whiteout(v3(0), v3(3));") + kPutPair,
         .draw = [](Random& random,
                    Draw& in) { in.put(0, outward(random, 1.45)), in.put(3, outward(random, 1.45)); },
         .reference =
             [](const In& in, Expect& out) {
                 const ref::DerivPair pair = ref::combine_whiteout(in.v3(0), in.v3(3));
                 out.put(0, pair.first), out.put(2, pair.second);
             },
         .bound = {.absolute = 1e-30, .relative = 6 * kUlp},  // a product and a division
         .mutants = {{kFile, "float z = a.z * b.z;", "float z = a.z;"}}},
        {.name = "combine_udn",
         .include = kFile,
         .inputs = 6,
         .outputs = 4,
         .glsl = std::string("SgDerivPair pair = sg_combine_udn(v3(0), v3(3));") + kPutPair,
         .draw = draw_pair,
         .reference =
             [](const In& in, Expect& out) {
                 const ref::DerivPair pair = ref::combine_udn(in.v3(0), in.v3(3));
                 out.put(0, pair.first), out.put(2, pair.second);
             },
         .bound = {.absolute = 1e-30, .relative = 4 * kUlp},  // a division
         .mutants = {{kFile, "sg_deriv_from_normal_xyz(vec3(b.xy, a.z))", "sg_deriv_from_normal_xyz(b)"}}},
    };
}

std::vector<Case> turned_and_summed_cases() {
    return {
        {.name = "combine_rnm",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_combine_rnm(v3(0), v3(3)));",
         .draw = draw_pair,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::combine_rnm(in.v3(0), in.v3(3))); },
         // A dot product up to 2 (4), a division (1), a product up to 2 (1), a difference (1); a and b off
         // unit length (2).
         .bound = {.absolute = 36 * kUlp},
         .property = unit,
         .mutants = {{kFile, "vec3 u = vec3(-b.xy, b.z);", "vec3 u = b;"}, {kFile, "abs(a.z) + 1.0", "a.z"}}},
        {.name = "combine_weighted",
         .include = kFile,
         .inputs = 8,
         .outputs = 3,
         .glsl = "put(0, sg_combine_weighted(v3(0), v3(3), v2(6)));",
         .draw =
             [](Random& random, Draw& in) {
                 draw_pair(random, in);
                 in.put(6, glm::dvec2(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)));
             },
         .reference = [](const In& in,
                         Expect& out) { out.put(0, ref::combine_weighted(in.v3(0), in.v3(3), in.v2(6))); },
         .bound = {.absolute = 22 * kUlp},  // as combine_pd with two products more
         .condition = slopes,
         .property = unit,
         .mutants = {{kFile, "weights.x * sg_deriv_from_normal_xyz(a)",
                      "weights.y * sg_deriv_from_normal_xyz(a)"},
                     {kFile, "+ weights.y * sg_deriv_from_normal_xyz(b)", "+ sg_deriv_from_normal_xyz(b)"}}},
        {.name = "combine_additive",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_combine_additive(v3(0), v3(3)));",
         .draw = draw_pair,
         .reference = [](const In& in,
                         Expect& out) { out.put(0, ref::combine_additive(in.v3(0), in.v3(3))); },
         .bound = {.absolute =
                       18 * kUlp},  // two products and a sum (3), a normalisation (6), of the slopes' size
         .condition = slopes,
         .property = unit,
         .mutants = {{kFile, "b.z * a.xy + a.z * b.xy", "a.z * a.xy + b.z * b.xy"},
                     {kFile, "b.z * a.xy + a.z * b.xy", "a.xy + b.xy"},
                     {kFile, "a.xy + a.z * b.xy, a.z * b.z", "a.xy + a.z * b.xy, a.z"}}},
    };
}

// n and two gradients of it, up to the clamp of a derivative.
void draw_gradients_of_a_normal(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction();
    in.put(0, n);
    in.put(3, tangent_of(random, n) * random.magnitude(1e-3, 127.0));
    in.put(6, tangent_of(random, n) * random.magnitude(1e-3, 127.0));
}
// Two slopes below 42 degrees, of which one turns the other to less than the clamp; then the tangents of a uv
// set, either handed.
void draw_slopes_on_a_basis(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction(), tangent = tangent_of(random, n);
    in.put(0, n);
    in.put(3, random.direction2() * random.uniform(0.0, 0.9));
    in.put(5, random.direction2() * random.uniform(0.0, 0.9));
    in.put(7, tangent), in.put(10, random.sign() * glm::cross(n, tangent));
}

constexpr const char* kSpace = "surfgrad/combine.glsl surfgrad/resolve.glsl";

std::vector<Case> reoriented_cases() {
    const Mutant not_turned{kFile, "vec3 t = n + sg_resolve(n, a);", "vec3 t = n;"},
        not_opposite{kFile, "vec3 u = n + b;", "vec3 u = n - b;"};
    return {
        {.name = "combine_reoriented",
         .include = kSpace,
         .inputs = 9,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), sg_combine_reoriented(v3(0), v3(3), v3(6))));",
         .draw = draw_gradients_of_a_normal,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::resolve(in.v3(0), ref::combine_reoriented(in.v3(0), in.v3(3), in.v3(6))));
             },
         // The turn as in combine_rnm (36) with a's resolve (8) in t, which counts twice; the gradient of a
         // normal moves the cosine and the sine to it by 7 each, its resolve by 8.
         .bound = {.absolute = 74 * kUlp},
         .property = unit_and_outward,
         .mutants = {not_turned, not_opposite}},
        {.name = "combine_reoriented_gradient",
         .include = kFile,
         .inputs = 9,
         .outputs = 3,
         .glsl = "put(0, sg_combine_reoriented(v3(0), v3(3), v3(6)));",
         .draw = draw_gradients_of_a_normal,
         .reference = [](const In& in,
                         Expect& out) { out.put(0, ref::combine_reoriented(in.v3(0), in.v3(3), in.v3(6))); },
         .bound = {.absolute = 66 * kUlp},  // as above without the last resolve
         .condition =
             [](const In& in) {
                 const glm::dvec3 g = ref::combine_reoriented(in.v3(0), in.v3(3), in.v3(6));
                 return 1.0 + glm::dot(g, g);  // as of surfgrad_from_normal
             },
         .mutants = {not_turned}},
        {.name = "combine_reoriented_on_one_uv_set",
         .include = kSpace,
         .inputs = 13,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), sg_combine_reoriented(v3(0), v2(3).x * v3(7) + v2(3).y * v3(10), "
                 "v2(5).x * v3(7) + v2(5).y * v3(10))));",
         .draw = draw_slopes_on_a_basis,
         // What the two maps give in their own tangent space.
         .reference =
             [](const In& in, Expect& out) {
                 const glm::dvec3 m =
                     ref::combine_rnm(ref::normal_from_deriv(in.v2(3)), ref::normal_from_deriv(in.v2(5)));
                 const ref::Basis basis{in.v3(7), in.v3(10)};
                 out.put(
                     0, ref::resolve(in.v3(0), ref::surfgrad_from_tbn(ref::deriv_from_normal_xyz(m), basis)));
             },
         // As above; the basis as rounded is off unit length and off a right angle to n by 2 each, of slopes
         // up to 1.
         .bound = {.absolute = (74 + 8) * kUlp},
         .property = unit_and_outward,
         .mutants = {not_turned, not_opposite}},
        resolved_case("combine_reoriented", kFile, 9, "sg_combine_reoriented(v3(0), v3(3), v3(6))"),
    };
}

std::vector<Case> normal_cases() {
    return joined(joined(surveyed_cases(), turned_and_summed_cases()), reoriented_cases());
}

SG_PROVE(Combine, gradient_cases());
SG_PROVE(CombineNormals, normal_cases());

// Letter G: two maps on one uv set, both added and one on top of the other.
TEST(CombineEdges, RnmAgreesWithAResolveOnTopOfAResolve) {
    Random random("rnm and post-resolve");
    for (int i = 0; i < 10000; ++i) {
        const glm::dvec3 a = outward(random, 0.35), b = outward(random, 0.35);
        const glm::dvec2 d = ref::deriv_from_normal_xyz(b);
        // T and B of the level surface, brought to the normal a (the rotation that RNM applies keeps more of
        // them).
        const glm::dvec3 t = glm::normalize(glm::dvec3(1, 0, 0) - a * a.x), across = glm::cross(a, t);
        const glm::dvec3 post = glm::normalize(a - d.x * t - d.y * across);
        EXPECT_LT(glm::length(post - ref::combine_rnm(a, b)), 0.05) << "SG_SEED=" << run_seed();
    }
}

TEST(CombineEdges, TwoLevelNormalsAddToALevelOne) {
    const std::vector<float> up = evaluate(normal_cases()[5], std::vector<float>{1, 0, 0, 0, 1, 0});
    EXPECT_EQ(up, (std::vector<float>{0, 0, 1}));
}

}  // namespace
}  // namespace sg::proof
