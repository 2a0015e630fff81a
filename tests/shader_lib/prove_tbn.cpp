// Tangent frames (shader_lib/surfgrad/tbn.glsl) against double precision, and the invariants of what they
// give.
#include "conditions.hpp"
#include "draws.hpp"
#include "ir/reference/resolve.hpp"
#include "ir/reference/tbn.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/tbn.glsl";
const std::string kBasisUv = std::string("SgBasis basis = sg_basis_uv(") + kFrame + ", " + kUv + ");";
constexpr const char* kPut = "put(0, basis.tangent); put(3, basis.bitangent);";

void put_basis(const ref::Basis& basis, Expect& out) {
    out.put(0, basis.tangent), out.put(3, basis.bitangent);
}

std::string orthonormal_and_towards_growth(const In& in, const In& out) {
    const glm::dvec3 n = in.v3(0), t = out.v3(0), b = out.v3(3);
    const double allowed = 40 * kUlp * cancellation(in);
    if (!is_unit(t) || !is_unit(b)) return "T or B is not unit";
    if (!(std::abs(glm::dot(t, n)) <= allowed)) return "T leaves the tangent plane";
    if (!(std::abs(glm::dot(b, n)) <= 1e-6 && std::abs(glm::dot(b, t)) <= 1e-6))
        return "B is not perpendicular";
    const ref::Tangents raw = ref::tangents_of(frame_of(in), uv_of(in));
    if (!(glm::dot(t, raw.per_s) > 0.0)) return "T does not point to +s";
    return glm::dot(b, raw.per_t) > -allowed * glm::length(raw.per_t) ? "" : "B does not point to +t";
}

void draw_vertex(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction();
    in.put(0, n * random.uniform(0.3, 1.0));  // interpolated: shorter than 1
    in.put(3, (tangent_of(random, n) + 0.3 * random.direction()) * random.uniform(0.3, 1.0));
    in.put(6, random.sign());
}

// A unit tangent-space normal that leans by at most 80 degrees.
glm::dvec3 draw_normal(Random& random) {
    return {random.direction2() * std::sin(random.uniform(0.0, 1.4)), 0.0};
}

std::vector<Case> made_basis_cases() {
    return {
        {.name = "basis_vertex",
         .include = kFile,
         .inputs = 7,
         .outputs = 6,
         .glsl = std::string("SgBasis basis = sg_basis_vertex(v3(0), v4(3));") + kPut,
         .draw = draw_vertex,
         .reference = [](const In& in,
                         Expect& out) { put_basis(ref::basis_vertex(in.v3(0), in.v4(3)), out); },
         // The inverse root (4) and a cross product whose terms are at most 1.3 long (3), all of vectors
         // below 1.3.
         .bound = {.absolute = 16 * kUlp},
         .condition = [](const In& in) { return 1.3 / glm::length(in.v3(0)); },
         .mutants = {{kFile, "SgBasis(scale * vertex_tangent.xyz", "SgBasis(vertex_tangent.xyz"}}},
        {.name = "basis_uv",
         .include = kFile,
         .inputs = 15,
         .outputs = 6,
         .glsl = kBasisUv + kPut,
         .draw = draw_frame_and_uv,
         .reference = [](const In& in,
                         Expect& out) { put_basis(ref::basis_uv(frame_of(in), uv_of(in)), out); },
         // A projection (7), a product and a difference (2), a normalisation (6), and a cross product for B
         // (3).
         .bound = {.absolute = 36 * kUlp},
         .condition = cancellation,
         .property = orthonormal_and_towards_growth,
         .mutants = {{kFile, "det < 0.0 ? -frame.flip_sign : frame.flip_sign", "frame.flip_sign"},
                     {kFile, "det < 0.0 ? -scale : scale", "scale"}}},
    };
}

std::vector<Case> changed_basis_cases() {
    return {
        {.name = "basis_resolved",
         .include = kFile,
         .inputs = 18,
         .outputs = 6,
         .glsl = kBasisUv + "basis = sg_basis_resolved(basis, v3(15));" + kPut,
         .draw =
             [](Random& random, Draw& in) {
                 draw_frame_and_uv(random, in);
                 in.put(15, random.direction());
             },
         .reference =
             [](const In& in, Expect& out) {
                 put_basis(ref::basis_resolved(ref::basis_uv(frame_of(in), uv_of(in)), in.v3(15)), out);
             },
         // As basis_uv, then a projection (7), a normalisation (6) and a cross product (3) more, over the
         // part of T that survives the projection.
         .bound = {.absolute = 68 * kUlp},
         .condition =
             [](const In& in) {
                 const glm::dvec3 t = ref::basis_uv(frame_of(in), uv_of(in)).tangent;
                 return cancellation(in) / glm::length(glm::cross(t, in.v3(15)));
             },
         .property =
             [](const In& in, const In& out) {
                 const glm::dvec3 n = in.v3(15);
                 // A tangent within a few degrees of n keeps few digits.
                 if (glm::length(glm::cross(ref::basis_uv(frame_of(in), uv_of(in)).tangent, n)) < 0.05)
                     return "";
                 return is_unit(out.v3(0)) && is_unit(out.v3(3)) && std::abs(glm::dot(out.v3(0), n)) < 1e-5 &&
                                std::abs(glm::dot(out.v3(3), n)) < 1e-5
                            ? ""
                            : "not tangent to the resolved normal";
             },
         .mutants = {{kFile, "vec3 across = cross(n, tangent);", "vec3 across = basis.bitangent;"}}},
        {.name = "basis_mirror",
         .include = kFile,
         .inputs = 17,
         .outputs = 6,
         .glsl = kBasisUv + "basis = sg_basis_mirror(basis, v2(15));" + kPut,
         .draw =
             [](Random& random, Draw& in) {
                 draw_frame_and_uv(random, in);
                 in.put(15, glm::dvec2(random.sign() * random.magnitude(0.1, 10.0),
                                       random.sign() * random.magnitude(0.1, 10.0)));
             },
         // By definition: the basis of the scaled coordinate.
         .reference =
             [](const In& in, Expect& out) {
                 put_basis(ref::basis_uv(frame_of(in), ref::uv_scale(uv_of(in), in.v2(15))), out);
             },
         .bound = {.absolute = 36 * kUlp},  // as basis_uv: signs are exact
         .condition = cancellation,
         .mutants = {{kFile, "scale.x < 0.0 ? -basis.tangent : basis.tangent", "basis.tangent"},
                     {kFile, "scale.y < 0.0 ? -basis.bitangent : basis.bitangent",
                      "scale.x < 0.0 ? -basis.bitangent : basis.bitangent"}}},
    };
}

std::vector<Case> basis_cases() {
    return joined(made_basis_cases(), changed_basis_cases());
}

const std::string kGradientUv = kBasisUv + "vec3 g = sg_surfgrad_from_tbn(v2(15), basis);";

void draw_gradient(Random& random, Draw& in) {
    draw_frame_and_uv(random, in);
    in.put(15, random.direction2() * random.magnitude(1e-3, 128.0));
}

glm::dvec3 gradient_of(const In& in) {
    return ref::surfgrad_from_tbn(in.v2(15), ref::basis_uv(frame_of(in), uv_of(in)));
}

double gradient_condition(const In& in) {
    return glm::length(in.v2(15)) * cancellation(in);
}

std::string tangential(const In& in, const In& out) {
    return std::abs(glm::dot(out.v3(0), in.v3(0))) <= 40 * kUlp * gradient_condition(in)
               ? ""
               : "g leaves the tangent plane";
}

// basis_uv (36) and a sum of two products (3), doubled.
constexpr Bound kGradientBound = {.absolute = 42 * kUlp};

// A change of the input that must not change g: the same reference, other GLSL.
Case unchanged(std::string name, const std::string& frame, const std::string& uv, const std::string& d) {
    return {.name = "surfgrad_from_tbn_" + name,
            .include = "surfgrad/tbn.glsl",
            .inputs = 17,
            .outputs = 3,
            .glsl = "SgUv uv = " + std::string(kUv) + "; vec2 d = v2(15); put(0, sg_surfgrad_from_tbn(" + d +
                    ", sg_basis_uv(" + frame + ", " + uv + ")));",
            .draw = draw_gradient,
            .reference = [](const In& in, Expect& out) { out.put(0, gradient_of(in)); },
            .bound = kGradientBound,
            .condition = gradient_condition};
}

std::vector<Case> gradient_cases() {
    std::vector<Case> cases = {
        {.name = "surfgrad_from_tbn",
         .include = kFile,
         .inputs = 17,
         .outputs = 3,
         .glsl = kGradientUv + "put(0, g);",
         .draw = draw_gradient,
         .reference = [](const In& in, Expect& out) { out.put(0, gradient_of(in)); },
         .bound = kGradientBound,
         .condition = gradient_condition,
         .property = tangential},
        {.name = "surfgrad_from_tbn_is_linear",
         .include = kFile,
         .inputs = 18,
         .outputs = 3,
         .glsl = kBasisUv + "put(0, sg_surfgrad_from_tbn(f(17) * v2(15), basis) - f(17) * "
                            "sg_surfgrad_from_tbn(v2(15), basis));",
         .draw = [](Random& random,
                    Draw& in) { draw_gradient(random, in), in.put(17, random.uniform(-4.0, 4.0)); },
         .reference = [](const In&, Expect& out) { out.put(0, glm::dvec3(0.0)); },
         .bound = {.absolute = 12 * kUlp},  // three roundings on either side of one product
         .condition = [](const In& in) { return 4.0 * glm::length(in.v2(15)); }},
        // Mirrored U: s runs the other way, and so does the derivative along it.
        unchanged("mirrored_u", kFrame, "sg_uv_scale(uv, vec2(-1.0, 1.0))", "vec2(-d.x, d.y)"),
        unchanged("mirrored_v", kFrame, "sg_uv_scale(uv, vec2(1.0, -1.0))", "vec2(d.x, -d.y)"),
        // Letter D: neither tiling nor distance nor the object's size is felt.
        unchanged("twice_as_far", "sg_frame(vec3(0.0), 2.0 * v3(3), 2.0 * v3(6), v3(0))",
                  "sg_uv_scale(uv, vec2(2.0))", "d"),
        unchanged("on_a_larger_object", "sg_frame(vec3(0.0), 8.0 * v3(3), 8.0 * v3(6), v3(0))", "uv", "d"),
        unchanged("tiled", kFrame, "sg_uv_scale(uv, vec2(7.0))", "d"),
        // The viewport's y turned: both derivatives of dy change their sign.
        unchanged("viewport_turned", "sg_frame(vec3(0.0), v3(3), -v3(6), v3(0))",
                  "SgUv(uv.st, uv.dx, -uv.dy)", "d"),
        // A two-sided surface from behind: n alone is negated.
        unchanged("normal_negated", "sg_frame(vec3(0.0), v3(3), v3(6), -v3(0))", "uv", "d"),
    };
    return cases;
}

// Conformal coordinates: T and B are the surface's own tangents there, so that a turn of uv cannot change g.
void draw_conformal(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction(), along = tangent_of(random, n);
    const glm::dvec2 step = random.direction2() * random.magnitude(1e-4, 0.1);
    const double size = random.magnitude(1e-3, 1.0);
    in.put(0, n), in.put(3, size * along), in.put(6, size * glm::cross(n, along));
    in.put(9, glm::dvec2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)));
    in.put(11, step), in.put(13, random.sign() * glm::dvec2(-step.y, step.x));
    in.put(15, random.direction2() * random.magnitude(1e-3, 128.0));
}

std::vector<Case> turned_cases() {
    Case quarter =
        unchanged("turned_by_90_degrees", kFrame,
                  "sg_uv_transform(uv, vec2(1.0), 1.5707963267948966, vec2(0.0))", "vec2(-d.y, d.x)");
    quarter.draw = draw_conformal;
    Case any = unchanged("turned_by_1_radian", kFrame, "sg_uv_transform(uv, vec2(1.0), 1.0, vec2(0.0))",
                         "vec2(cos(1.0) * d.x - sin(1.0) * d.y, sin(1.0) * d.x + cos(1.0) * d.y)");
    any.draw = draw_conformal;
    // The turn itself: 10 roundings for sine, cosine and the products (prove_uv.cpp), twice.
    quarter.bound.absolute += 40 * kUlp, any.bound.absolute += 40 * kUlp;
    return {quarter, any};
}

// Letter G: three bumps, each on top of the one before; every stage is a new frame.
Case three_resolves() {
    return {.name = "three_resolves",
            .include = std::string(kFile) + " surfgrad/resolve.glsl",
            .inputs = 21,
            .outputs = 9,
            .glsl = "SgFrame a = " + std::string(kFrame) + "; SgUv uv = " + kUv + ";" +
                    "vec3 first = sg_resolve(a.normal, sg_surfgrad_from_tbn(v2(15), sg_basis_uv(a, uv)));"
                    "SgFrame b = sg_frame_resolved(a, first);"
                    "vec3 second = sg_resolve(first, sg_surfgrad_from_tbn(v2(17), sg_basis_uv(b, uv)));"
                    "SgFrame c = sg_frame_resolved(b, second);"
                    "vec3 third = sg_resolve(second, sg_surfgrad_from_tbn(v2(19), sg_basis_uv(c, uv)));"
                    "put(0, first); put(3, second); put(6, third);",
            .draw =
                [](Random& random, Draw& in) {
                    draw_gradient(random, in);
                    in.put(17, random.direction2() * random.magnitude(1e-3, 128.0));
                    in.put(19, random.direction2() * random.magnitude(1e-3, 128.0));
                },
            .property =
                [](const In&, const In& out) {
                    return is_unit(out.v3(0)) && is_unit(out.v3(3)) && is_unit(out.v3(6))
                               ? ""
                               : "a stage is not unit";
                }};
}

// Letter C, all eight: mirrored u, a turned viewport, a negated normal. T and B are made anew for each.
TEST(BasisEdges, PointToGrowingCoordinatesInAllEightMirrorings) {
    for (int which = 0; which < 8; ++which) {
        Case item = basis_cases()[1];
        item.name = "mirroring_" + std::to_string(which);
        item.draw = [which](Random& random, Draw& in) {
            draw_frame_and_uv(random, in);
            const In sofar(in.floats());
            glm::dvec2 dx = sofar.v2(11), dy = sofar.v2(13);
            if (which & 1) dx.x = -dx.x, dy.x = -dy.x;
            if (which & 2) in.put(6, -sofar.v3(6)), dy = -dy;
            if (which & 4) in.put(0, -sofar.v3(0));
            in.put(11, dx), in.put(13, dy);
        };
        const std::vector<float> inputs = draw_inputs(item, kMutantCount);
        EXPECT_EQ(compare(item, inputs, evaluate(item, inputs)).violation, "")
            << which << " SG_SEED=" << run_seed();
    }
}

// Letter I: a mirrored instance negates w in its vertex stage, so that B, made from the mirrored N and T,
// still points to +t of the surface.
TEST(BasisEdges, AMirroredInstanceKeepsItsBitangentTowardsT) {
    const Case item = {.name = "mirrored_instance",
                       .include = kFile,
                       .inputs = 7,
                       .outputs = 3,
                       .glsl = "put(0, sg_basis_vertex(v3(0), v4(3)).bitangent);"};
    // x mirrored: N and T in world space, w negated; object-space B = cross((0,0,1), (1,0,0)) = (0,1,0) is
    // left by it.
    EXPECT_EQ(evaluate(item, std::vector<float>{0, 0, 1, -1, 0, 0, -1}), (std::vector<float>{0, 1, 0}));
    EXPECT_EQ(evaluate(item, std::vector<float>{0, 0, 1, 1, 0, 0, 1}), (std::vector<float>{0, 1, 0}));
}

std::vector<Case> any_input_cases() {
    const std::string basis_of_wild =
        "sg_basis_uv(sg_frame(vec3(0.0), v3(3), v3(6), v3(0)), SgUv(v2(9), v2(11), v2(13)))";
    Case mikk = {
        .name = "mikktspace_form",
        .include = std::string(kFile) + " surfgrad/resolve.glsl surfgrad/deriv.glsl",
        .inputs = 10,
        .outputs = 3,
        .glsl =
            "vec3 n = sg_base_normal(v3(0)); put(0, sg_resolve(n, sg_surfgrad_from_tbn("
            "sg_deriv_from_normal_xyz(v3(7)), sg_basis_vertex(v3(0), v4(3)))));",
        .draw =
            [](Random& random, Draw& in) {
                draw_vertex(random, in);
                const glm::dvec3 lean = draw_normal(random);
                in.put(7, glm::dvec3(lean.x, lean.y, std::sqrt(1.0 - glm::dot(lean, lean))));
            },
        // normalize(m.x T + m.y B + m.z N) of raw interpolated vectors.
        .reference =
            [](const In& in, Expect& out) {
                const glm::dvec3 n = in.v3(0), t = in.v3(3), m = in.v3(7);
                out.put(0, ref::normalized(m.x * t + m.y * in[6] * glm::cross(n, t) + m.z * n));
            },
        // The specification's own bound; 1/|N| and 1/m.z cancel in the normalisation.
        .bound = {.absolute = 1e-6},
        .condition =
            [](const In& in) {  // where T and B take away most of N, little is left to round
                const glm::dvec3 n = in.v3(0), t = in.v3(3), m = in.v3(7);
                const double left = glm::length(m.x * t + m.y * in[6] * glm::cross(n, t) + m.z * n);
                return std::max(1.0, 1.0 / left);
            },
        .mutants = {{kFile, "SgBasis(scale * vertex_tangent.xyz", "SgBasis(normalize(vertex_tangent.xyz)"},
                    {kFile, "side * cross(", "side / scale * cross("}}};
    return {mikk, three_resolves(),
            resolved_case("surfgrad_from_tbn_uv", kFile, 17,
                          "sg_surfgrad_from_tbn(clamp(v2(15), -128.0, 128.0), " + basis_of_wild + ")"),
            resolved_case("surfgrad_from_tbn_resolved", kFile, 18,
                          "sg_surfgrad_from_tbn(clamp(v2(15), -128.0, 128.0), "
                          "sg_basis_resolved(SgBasis(v3(3), v3(6)), v3(0)))"),
            resolved_case("surfgrad_from_tbn_vertex", kFile, 12,
                          "sg_surfgrad_from_tbn(v2(10), sg_basis_vertex(v3(3), v4(6)))", false)};
}

SG_PROVE(Basis, basis_cases());
SG_PROVE(Tbn, gradient_cases());
SG_PROVE(TbnTurned, turned_cases());
SG_PROVE(TbnForms, any_input_cases());

}  // namespace
}  // namespace sg::proof
