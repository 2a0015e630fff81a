// Decals (shader_lib/surfgrad/decal.glsl) against double precision.
#include "ir/reference/decal.hpp"

#include <fmt/format.h>

#include "ir/reference/from_volume.hpp"
#include "published.hpp"
#include "skipped.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/decal.glsl";

// Inputs: 0 the projector's columns (16), 16 position, 19 dpdx, 22 dpdy.
glm::dmat4 projector(const In& in) {
    return {in.v4(0), in.v4(4), in.v4(8), in.v4(12)};
}

// A projector of 0.2 to 20 units with some shear, and a position whose place in it is drawn: within, around,
// behind.
void draw_projector(Random& random, Draw& in) {
    glm::dmat3 linear(0.0);
    while (std::abs(glm::determinant(linear)) < 0.2) {
        for (int c = 0; c < 3; ++c) linear[c] = random.direction();
    }
    linear *= random.magnitude(0.05, 5.0);
    const glm::dvec3 centre = random.within(5.0);
    const glm::dvec3 shift = -linear * centre;
    for (int c = 0; c < 3; ++c) in.put(static_cast<std::size_t>(4 * c), glm::dvec4(linear[c], 0.0));
    in.put(12, glm::dvec4(shift, 1.0));
    in.put(16, centre + glm::inverse(linear) * random.within(2.0));
    in.put(19, random.direction() * random.magnitude(1e-3, 0.1));
    in.put(22, random.direction() * random.magnitude(1e-3, 0.1));
}

// The position in projector space is a sum of terms up to this size; a central projection divides that by
// what lies ahead, once for st and once more for its gradients. Near the apex, and where two faces of a cube
// meet, nothing is asserted.
double magnified(const In& in, double ahead) {
    const glm::dmat4 m = projector(in);
    double terms = 1.0;
    for (int c = 0; c < 4; ++c)
        terms +=
            glm::length(glm::dvec3(m[c])) * (c < 3 ? std::abs(in[16 + static_cast<std::size_t>(c)]) : 1.0);
    double row = 0.0;
    for (int c = 0; c < 3; ++c) row = std::max(row, glm::length(glm::dvec3(m[c])));
    const double reach = glm::length(glm::dvec3(m * glm::dvec4(in.v3(16), 1.0)));
    return terms * (1.0 + row) * (1.0 + reach / ahead) * (1.0 + 1.0 / ahead) * (1.0 + 1.0 / ahead);
}

double box_condition(const In& in) {
    return magnified(in, INFINITY);
}
double cone_condition(const In& in) {
    const double ahead = (projector(in) * glm::dvec4(in.v3(16), 1.0)).z;
    return std::abs(ahead) < 1e-3 ? INFINITY : magnified(in, ahead < 0.0 ? INFINITY : ahead);
}
double sphere_condition(const In& in) {
    const glm::dvec3 size = glm::abs(glm::dvec3(projector(in) * glm::dvec4(in.v3(16), 1.0)));
    double sorted[] = {size.x, size.y, size.z};
    std::sort(sorted, sorted + 3);
    return sorted[2] < 1e-3 || sorted[2] - sorted[1] < 1e-4 ? INFINITY : magnified(in, sorted[2]);
}

void put_decal(Expect& out, const ref::Decal& decal) {
    out.put(0, decal.uv.st);
    out.put(2, decal.uv.dx);
    out.put(4, decal.uv.dy);
    out.put(6, decal.grad_s);
    out.put(9, decal.grad_t);
    out.put(12, decal.local);
}

using Lookup = ref::Decal (*)(const glm::dmat4&, glm::dvec3, glm::dvec3, glm::dvec3);

Case lookup(const char* shape, Lookup reference, double (*condition)(const In&),
            std::vector<Mutant> mutants) {
    const bool faces = std::string_view(shape) == "sphere";
    return {
        .name = fmt::format("decal_{}", shape),
        .blunt = faces
                     ? "the place's rounding over that of the face ahead; decal_central has the formula alone"
                     : "",
        .include = kFile,
        .inputs = 25,
        .outputs = 15,
        .glsl = fmt::format("SgDecal d = sg_decal_{}(m4(0), v3(16), v3(19), v3(22));"
                            "put(0, d.uv.st); put(2, d.uv.dx); put(4, d.uv.dy);"
                            "put(6, d.grad_s); put(9, d.grad_t); put(12, d.local);",
                            shape),
        .draw = draw_projector,
        .reference =
            [reference](const In& in, Expect& out) {
                put_decal(out, reference(projector(in), in.v3(16), in.v3(19), in.v3(22)));
            },
        // The matrix product 4 roundings, quotient, slope and difference 5, the dot product 3; doubled.
        .bound = {.absolute = 24 * kUlp},
        .condition = condition,
        .mutants = std::move(mutants)};
}

std::vector<Case> lookups() {
    return {
        lookup("box", ref::decal_box, box_condition,
               {{kFile, "row_s = sg_decal_row(projector, 0)", "row_s = projector[0].xyz"},
                {kFile, "vec2(dot(row_s, dpdx), dot(row_t, dpdx))",
                 "vec2(dot(row_s, dpdx), dot(row_s, dpdy))"}}),
        lookup("cone", ref::decal_cone, cone_condition,
               {{kFile, "row_s - slope.x * row_ahead", "row_s"},
                {kFile, "bool before = ray.z > 1e-6;", "bool before = true;"},
                {kFile, "0.5 / ray.z : 0.0", "1.0 / ray.z : 0.0"}}),
        lookup("sphere", ref::decal_sphere, sphere_condition,
               {{kFile, "vec3(side * local.x, -local.y, size.z)", "vec3(local.x, -local.y, size.z)"},
                {kFile, "vec3(local.x, side * local.z, size.y)", "vec3(local.x, local.z, size.y)"},
                {kFile, "vec3(-side * local.z, -local.y, size.x)", "vec3(side * local.z, -local.y, size.x)"},
                {kFile, "vec3 row_ahead = side * (on_z", "vec3 row_ahead = (on_z"},
                {kFile, "(on_y ? x : -side * z)", "(on_y ? x : z)"}})};
}

std::string share_of_one(const In&, const In& out) {
    return out[0] >= 0.0 && out[0] <= 1.0 ? "" : "not in 0..1";
}

// Slopes: of the smooth step 1.5 / edge; of a quotient by z, which matters where it is below 1, at most 1 /
// z.
// A length (3) and a quotient (1) from 1 (1), over the edge (1): 6 roundings over the edge times the cubic's
// slope of 1.5; the cubic itself 5. Doubled.
double round_condition(const In& in) {
    return 10.0 + 18.0 / in[3];
}
double tapering_condition(const In& in) {
    return round_condition(in) * (1.0 + 1.0 / std::max(in[2], 0.02));
}

Case falloff(const char* shape, const char* arguments, double (*reference)(const In&),
             double (*condition)(const In&), std::vector<Mutant> mutants) {
    return {.name = fmt::format("decal_falloff_{}", shape),
            .include = kFile,
            .inputs = 5,
            .outputs = 1,
            .glsl = fmt::format("put(0, sg_decal_falloff_{}({}));", shape, arguments),
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.within(1.3));
                    if (random.coin()) in.put(2, std::abs(random.uniform(0.02, 1.1)));
                    in.put(3, random.uniform(0.05, 1.0));
                    in.put(4, random.uniform(0.0, 1.0));
                },
            .reference = [reference](const In& in, Expect& out) { out.put(0, reference(in)); },
            .bound = {.absolute = kUlp},
            .condition = condition,
            .property = share_of_one,
            .mutants = std::move(mutants)};
}

std::vector<Case> falloffs() {
    return {
        falloff("box", "v3(0), f(3)", [](const In& in) { return ref::decal_falloff_box(in.v3(0), in[3]); },
                round_condition,
                {{kFile, "max(max(size.x, size.y), size.z), edge", "max(size.x, size.y), edge"},
                 {kFile, "(1.0 - reach) / max(edge, 1e-6)", "1.0 - reach"},
                 {kFile, "t * t * (3.0 - 2.0 * t)", "t"}}),
        falloff("cone", "v3(0), f(3)", [](const In& in) { return ref::decal_falloff_cone(in.v3(0), in[3]); },
                tapering_condition,
                {{kFile, "max(side, local.z), edge", "side, edge"},
                 {kFile, "bool before = local.z > 1e-6;\n    float side = before ? length",
                  "bool before = true;\n    float side = before ? length"}}),
        falloff("sphere", "v3(0), f(3)",
                [](const In& in) { return ref::decal_falloff_sphere(in.v3(0), in[3]); }, round_condition,
                {{kFile, "sg_decal_fade(length(local), edge)", "sg_decal_fade(length(local.xy), edge)"}}),
        falloff("capsule", "v3(0), f(4), f(3)",
                [](const In& in) { return ref::decal_falloff_capsule(in.v3(0), in[4], in[3]); },
                round_condition,
                {{kFile, "abs(local.z) - half_length;", "local.z - half_length;"},
                 {kFile, "abs(local.z) < half_length ? 0.0", "abs(local.z) < 0.0 ? 0.0"}}),
        falloff("wedge", "v3(0), f(3)",
                [](const In& in) { return ref::decal_falloff_wedge(in.v3(0), in[3]); }, tapering_condition,
                {{kFile, "max(max(side, abs(local.y)), local.z), edge", "max(side, local.z), edge"}})};
}

// Whatever a register holds, a falloff is a number from 0 to 1, and NaN or the outside give 0.
Case wild_falloffs() {
    return {.name = "decal_falloff_any_input",
            .include = kFile,
            .inputs = 4,
            .outputs = 6,
            .glsl =
                "vec3 p = v3(0); float e = f(3);"
                "put(0, sg_decal_falloff_box(p, e)); put(1, sg_decal_falloff_cone(p, e));"
                "put(2, sg_decal_falloff_sphere(p, e)); put(3, sg_decal_falloff_capsule(p, 0.5, e));"
                "put(4, sg_decal_falloff_wedge(p, e)); put(5, sg_decal_angle_fade(p, vec3(0.0, 0.0, 1.0), "
                "0.5, 0.2));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.within(1.0));
                    in.put(static_cast<std::size_t>(random.below(3)), random.wild_number());
                    if (random.coin())
                        in.put(static_cast<std::size_t>(random.below(3)), random.wild_number());
                    in.put(3, random.uniform(0.0, 1.0));
                },
            .property =
                [](const In& in, const In& out) {
                    const glm::dvec3 size = glm::abs(in.v3(0));
                    const bool outside = std::max({size.x, size.y, size.z}) >= 1.0;  // of the box
                    for (std::size_t k = 0; k < 6; ++k) {
                        if (!(out[k] >= 0.0 && out[k] <= 1.0)) return fmt::format("shape {} not in 0..1", k);
                    }
                    if (outside && out[0] != 0.0) return std::string("the box shows what is outside");
                    return std::string();
                },
            .mutants = {{kFile, "clamp((1.0 - reach) / max(edge, 1e-6), 0.0, 1.0)",
                         "(1.0 - reach) / max(edge, 1e-6)"},
                        {kFile, "return facing > cos_none ? t : 0.0;",
                         "return (facing - cos_none) / (cos_full - cos_none);"}}};
}

Case angle_fade() {
    return {
        .name = "decal_angle_fade",
        .include = kFile,
        .inputs = 8,
        .outputs = 1,
        .glsl = "put(0, sg_decal_angle_fade(v3(0), v3(3), f(6), f(7)));",
        .draw =
            [](Random& random, Draw& in) {
                in.put(0, random.direction());
                in.put(3, random.direction());
                const double none = random.uniform(-1.0, 0.8);
                in.put(7, none);
                in.put(6, random.uniform(none + 0.05, 1.0));
            },
        .reference = [](const In& in,
                        Expect& out) { out.put(0, ref::decal_angle_fade(in.v3(0), in.v3(3), in[6], in[7])); },
        // The cosine 5 roundings, two differences and a quotient 3; doubled; over the width of the fade.
        .bound = {.absolute = 16 * kUlp},
        .condition = [](const In& in) { return 1.0 / (in[6] - in[7]); },
        .property = share_of_one,
        .mutants = {{kFile, "facing - cos_none)", "facing - cos_full)"},
                    {kFile, "dot(n, towards)", "abs(dot(n, towards))"}}};
}

// Inputs: 0 grad_s, 3 grad_t, 6 d, 8 dim, 10 height.
Case gradients() {
    auto decal = [](const In& in) { return ref::Decal{{}, {}, in.v3(0), in.v3(3)}; };
    return {.name = "decal_gradient",
            .include = kFile,
            .inputs = 11,
            .outputs = 6,
            .glsl =
                "SgDecal decal = SgDecal(vec3(0.0), SgUv(vec2(0.0), vec2(0.0), vec2(0.0)), v3(0), v3(3));"
                "put(0, sg_decal_gradient(v2(6), decal));"
                "put(3, sg_decal_gradient_scaled(v2(6), decal, v2(8), f(10)));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.direction() * random.magnitude(0.1, 10.0));
                    in.put(3, random.below(16) == 0 ? glm::dvec3(0.0)
                                                    : random.direction() * random.magnitude(0.1, 10.0));
                    in.put(6, glm::dvec2(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0)));
                    in.put(8, glm::dvec2(1.0 + random.below(2048), 1.0 + random.below(2048)));
                    in.put(10, random.magnitude(1e-6, 1e-4));
                },
            .reference =
                [decal](const In& in, Expect& out) {
                    out.put(0, ref::decal_gradient(in.v2(6), decal(in)));
                    out.put(3, ref::decal_gradient_scaled(in.v2(6), decal(in), in.v2(8), in[10]));
                },
            // A unit direction 6 roundings, times 4, twice, and their sum 8; height dim d |grad| <= 8.4, 5
            // roundings; doubled.
            .bound = {.absolute = 2 * (2 * 4 * 6 + 8 + 5 * 9) * kUlp},
            .mutants = {{kFile, "height * dim * d", "height * d"},
                        {kFile, "d * inversesqrt(max(vec2(dot(decal.grad_s, decal.grad_s)",
                         "d * inversesqrt(max(vec2(dot(decal.grad_t, decal.grad_t)"}}};
}

// Inputs: 0 axis_s, 3 axis_t, 6 d.
Case gradients_along() {
    return {
        .name = "decal_gradient_along",
        .include = kFile,
        .inputs = 8,
        .outputs = 3,
        .glsl = "put(0, sg_decal_gradient_along(v2(6), v3(0), v3(3)));",
        .draw =
            [](Random& random, Draw& in) {
                in.put(0, random.direction());
                in.put(3, random.below(16) == 0 ? glm::dvec3(0.0) : random.direction());
                in.put(6, glm::dvec2(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0)));
            },
        .reference = [](const In& in,
                        Expect& out) { out.put(0, ref::decal_gradient_along(in.v2(6), in.v3(0), in.v3(3))); },
        // Two products of up to 4 and their sum of up to 8: 16 roundings; doubled.
        .bound = {.absolute = 32 * kUlp},
        .mutants = {{kFile, "return d.x * axis_s + d.y * axis_t; }", "return d.x * (axis_s + axis_t); }"},
                    {kFile, "{ return d.x * axis_s +", "{ return abs(d.x) * axis_s +"}}};
}

// Inputs: 0 sum, 3 gradient, 6 alpha (0 and 1 often; then what does not count may be NaN).
Case accumulation() {
    return {
        .name = "decal_accumulation",
        .include = kFile,
        .inputs = 7,
        .outputs = 6,
        .glsl = "put(0, sg_decal_add(v3(0), v3(3), f(6))); put(3, sg_decal_mask(v3(0), v3(3), f(6)));",
        .draw =
            [](Random& random, Draw& in) {
                in.put(0, random.within(8.0));
                in.put(3, random.within(8.0));
                in.put(6, random.below(4) == 0 ? random.below(2) : random.uniform(0.0, 1.0));
                if (in.floats()[6] == 0.0f && random.coin()) in.put(3, glm::dvec3(NAN));
            },
        .reference =
            [](const In& in, Expect& out) {
                out.put(0, ref::decal_add(in.v3(0), in.v3(3), in[6]));
                out.put(3, ref::decal_mask(in.v3(0), in.v3(3), in[6]));
            },
        // Three roundings of numbers up to 16; doubled.
        .bound = {.absolute = 6 * 16 * kUlp},
        .property =
            [](const In& in, const In& out) {
                if (in[6] == 0.0 && (out.v3(0) != in.v3(0) || out.v3(3) != in.v3(0)))
                    return "0 does not leave";
                return in[6] == 1.0 && out.v3(3) != in.v3(3) ? "1 does not replace" : "";
            },
        .mutants = {{kFile, "sum + alpha * gradient", "sum + gradient"},
                    {kFile, "alpha > 0.0 ? sum + alpha * gradient : sum", "sum + alpha * gradient"},
                    {kFile, "alpha > 0.0 ? mix(sum, gradient, alpha) : sum", "mix(sum, gradient, alpha)"}}};
}

std::vector<Case> cases() {
    std::vector<Case> out = {wild_falloffs(), angle_fade(), gradients(), gradients_along(), accumulation()};
    for (auto& more : {lookups(), falloffs()}) out.insert(out.end(), more.begin(), more.end());
    return out;
}

SG_PROVE(Decal, cases());

TEST(Decal, FewPlacesAreTooNearToTheApexOrBetweenFaces) {
    for (const Case& item : lookups()) expect_few_skipped(item, 0.01);
}

// Behind the apex, on it and in the centre: finite, no gradient, no strength.
TEST(Decal, NothingAheadIsFiniteAndWithoutEffect) {
    for (const char* shape : {"cone", "sphere"}) {
        Case item = lookup(shape, ref::decal_cone, box_condition, {});
        std::vector<float> in(25, 0.0f);
        for (std::size_t k : {0u, 5u, 10u, 15u}) in[k] = 1.0f;
        in[19] = in[23] = 0.01f;
        if (item.name == "decal_cone") in[18] = -0.5f;
        for (float value : evaluate(item, in)) EXPECT_TRUE(std::isfinite(value)) << shape;
        const std::vector<float> out = evaluate(item, in);
        for (std::size_t k = 2; k < 12; ++k) EXPECT_EQ(out[k], 0.0f) << shape << " " << k;
    }
    EXPECT_EQ(ref::decal_falloff_cone({0, 0, -0.5}, 0.5), 0.0);
}

// The derivative in a decal's plane is that of its height H(st), by differences.
TEST(DecalReference, GradientsAreDifferencesOfHeights) {
    Random random("decal_differences");
    auto height = [](glm::dvec2 st) { return std::sin(5.0 * st.x) * std::cos(4.0 * st.y); };
    std::vector<float> floats(25);
    for (int i = 0; i < 3000; ++i) {
        Draw draw{std::span<float>(floats)};
        draw_projector(random, draw);
        const In in{std::span<const float>(floats)};
        for (Lookup shape : {&ref::decal_box, &ref::decal_cone, &ref::decal_sphere}) {
            if (cone_condition(in) > 1e3 || sphere_condition(in) > 1e3) continue;
            auto at = [&](glm::dvec3 p) { return shape(projector(in), p, {}, {}); };
            const glm::dvec3 p = in.v3(16);
            const ref::Decal decal = at(p);
            const glm::dvec2 st = decal.uv.st;
            const glm::dvec2 slope(5.0 * std::cos(5.0 * st.x) * std::cos(4.0 * st.y),
                                   -4.0 * std::sin(5.0 * st.x) * std::sin(4.0 * st.y));
            const glm::dvec3 gradient = ref::decal_gradient_scaled(slope, decal, {1, 1}, 1.0);
            // The image does not change along the ray of projection: nor does the height.
            const glm::dvec3 ahead = shape == &ref::decal_box ? glm::dvec3(0, 0, 1) : decal.local;
            const glm::dvec3 ray = glm::normalize(glm::inverse(glm::dmat3(projector(in))) * ahead);
            EXPECT_LT(std::abs(glm::dot(gradient, ray)), 1e-9 * (1.0 + glm::length(gradient)));
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 step(0.0);
                step[axis] = 1e-6;
                const double difference = (height(at(p + step).uv.st) - height(at(p - step).uv.st)) / 2e-6;
                EXPECT_NEAR(gradient[axis], difference, 1e-6 * (1.0 + glm::length(gradient)));
            }
        }
    }
}

// Additive decals may come in any order, and one projection at the end equals one for each.
TEST(Decal, OrderAndProjectionOnce) {
    Random random("decal_order");
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n = random.direction(), a = random.within(3.0), b = random.within(3.0);
        const double alpha = random.uniform(0.0, 1.0), beta = random.uniform(0.0, 1.0);
        const glm::dvec3 ab = ref::decal_add(ref::decal_add({}, a, alpha), b, beta);
        const glm::dvec3 ba = ref::decal_add(ref::decal_add({}, b, beta), a, alpha);
        EXPECT_LT(glm::length(ab - ba), 1e-14);
        const glm::dvec3 each =
            alpha * ref::surfgrad_from_volume(n, a) + beta * ref::surfgrad_from_volume(n, b);
        EXPECT_LT(glm::length(ref::surfgrad_from_volume(n, ab) - each), 1e-13);
    }
}

// The gradient of a box is that along the unit rows of its matrix, wherever the position is; to what length
// the rows are scaled does not matter.
TEST(Decal, ABoxHasOneGradient) {
    Random random("decal_rows");
    std::vector<float> floats(25);
    for (int i = 0; i < 1000; ++i) {
        Draw draw{std::span<float>(floats)};
        draw_projector(random, draw);
        const In in{std::span<const float>(floats)};
        const glm::dmat4 rows = glm::transpose(projector(in));
        const glm::dvec2 d(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0));
        const glm::dvec3 along =
            ref::decal_gradient_along(d, ref::unit_or_shorter(rows[0]), ref::unit_or_shorter(rows[1]));
        const ref::Decal box = ref::decal_box(projector(in), in.v3(16), in.v3(19), in.v3(22));
        EXPECT_LT(glm::length(along - ref::decal_gradient(d, box)), 1e-14);
    }
    EXPECT_EQ(ref::unit_or_shorter(glm::dvec3(0.0)), glm::dvec3(0.0));
}

// F: at a silhouette the neighbouring pixel shows another surface, and the difference of lookups asks for the
// smallest level of detail: the bright edges.
TEST(DecalPublished, DifferencesAcrossSilhouettes) {
    Case item = lookup("box", ref::decal_box, box_condition, {});
    expect_only_library_holds(item, "",
                              "mat4 m = m4(0); SgDecal d = sg_decal_box(m, v3(16), v3(19), v3(22));"
                              "vec3 behind = v3(16) + v3(19) + vec3(0.0, 0.0, 3.0);"
                              "vec2 right = 0.5 + 0.5 * (m * vec4(behind, 1.0)).xy;"
                              "put(0, d.uv.st); put(2, right - d.uv.st); put(4, d.uv.dy);"
                              "put(6, d.grad_s); put(9, d.grad_t); put(12, d.local);");
}

}  // namespace
}  // namespace sg::proof
