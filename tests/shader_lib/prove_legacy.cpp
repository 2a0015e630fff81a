// What the method replaces (shader_lib/surfgrad/legacy.glsl) against double precision, and where it falls
// short.
#include "ir/reference/legacy.hpp"

#include "draws.hpp"
#include "ir/reference/from_volume.hpp"
#include "ir/reference/resolve.hpp"
#include "published.hpp"
#include "skipped.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/legacy.glsl";

// The length that is normalised: what an error is divided by. Short ones are left out.
double over(double length) {
    return length < 0.05 ? INFINITY : 1.0 + 1.0 / length;
}

Case perlin() {
    return {.name = "legacy_perlin_normal",
            .include = kFile,
            .inputs = 6,
            .outputs = 3,
            .glsl = "put(0, sg_legacy_perlin_normal(v3(0), v3(3)));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.direction());
                    in.put(3, random.direction() * random.magnitude(1e-3, 10.0));
                },
            .reference = [](const In& in,
                            Expect& out) { out.put(0, ref::legacy_perlin_normal(in.v3(0), in.v3(3))); },
            .bound = {.absolute = 16 * kUlp},  // a difference 1, normalising 6; doubled
            .condition = [](const In& in) { return over(glm::length(in.v3(0) - in.v3(3))); },
            .property = unit,
            .mutants = {{kFile, "{ return sg_resolve(n, gradient); }",
                         "{ return sg_resolve(n, sg_reject(gradient, n)); }"}}};
}

ref::Hand hand(double sign) {
    return sign > 0.0 ? ref::Hand::left : ref::Hand::right;
}
ref::Origin origin(double sign) {
    return sign > 0.0 ? ref::Origin::lower_left : ref::Origin::upper_left;
}

// Inputs: 0 n, 3 weights, 6 m_x, 9 m_y, 12 m_z, 15 hand, 16 origin.
Case triplanar() {
    auto normal = [](const In& in) {
        return ref::legacy_triplanar_normal(in.v3(0), in.v3(3), in.v3(6), in.v3(9), in.v3(12), hand(in[15]),
                                            origin(in[16]));
    };
    return {
        .name = "legacy_triplanar_normal",
        .include = kFile,
        .inputs = 17,
        .outputs = 3,
        .glsl = "put(0, sg_legacy_triplanar_normal(v3(0), v3(3), v3(6), v3(9), v3(12), f(15), f(16)));",
        .draw =
            [](Random& random, Draw& in) {
                const glm::dvec3 n = random.direction();
                in.put(0, n);
                in.put(3, ref::triplanar_weights(n, 3.0));
                for (std::size_t k = 6; k < 15; k += 3) in.put(k, random.direction());
                in.put(15, random.sign());
                in.put(16, random.sign());
            },
        .reference = [normal](const In& in, Expect& out) { out.put(0, normal(in)); },
        .bound = {.absolute = 32 * kUlp},  // lean 5 of length below 2, difference 1, normalising 6; doubled
        .condition =
            [](const In& in) {
                const glm::dvec3 lean = ref::triplanar_gradient(in.v3(3), in.v2(6), in.v2(9), in.v2(12),
                                                                hand(in[15]), origin(in[16]));
                return over(glm::length(in.v3(0) + lean));
            },
        .property = unit,
        .mutants = {{kFile, "-m_x.xy, -m_y.xy, -m_z.xy", "-m_x.xy / m_x.z, -m_y.xy, -m_z.xy"}}};
}

// Inputs: 0 n, 3 axis_s, 6 axis_t, 9 towards, 12 d, 14 alpha.
Case decal() {
    return {.name = "legacy_decal_normal",
            .include = kFile,
            .inputs = 15,
            .outputs = 3,
            .glsl = "put(0, sg_legacy_decal_normal(v3(0), v3(3), v3(6), v3(9), v2(12), f(14)));",
            .draw =
                [](Random& random, Draw& in) {
                    const glm::dvec3 towards = random.direction(), s = tangent_of(random, towards);
                    in.put(0, random.direction());
                    in.put(3, s);
                    in.put(6, random.sign() * glm::cross(towards, s));
                    in.put(9, towards);
                    in.put(12, glm::dvec2(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)));
                    in.put(14, random.below(4) == 0 ? random.below(2) : random.uniform(0.0, 1.0));
                },
            .reference =
                [](const In& in, Expect& out) {
                    out.put(0, ref::legacy_decal_normal(in.v3(0), in.v3(3), in.v3(6), in.v3(9), in.v2(12),
                                                        in[14]));
                },
            .bound = {.absolute = 48 * kUlp},  // normalised twice: 2 * (4 + 6), blended 3; doubled
            .condition =
                [](const In& in) {
                    const glm::dvec3 p = glm::normalize(in.v3(9) - in[12] * in.v3(3) - in[13] * in.v3(6));
                    return over(glm::length(glm::mix(in.v3(0), p, in[14])));
                },
            .property = unit,
            .mutants = {{kFile, "alpha * (n - projected)", "(1.0 - alpha) * (n - projected)"},
                        {kFile, "alpha * (n - projected)", "alpha * (projected - n)"}}};
}

// Inputs: 0 normal, 3 tangent, 7 m.
void draw_vertex(Random& random, Draw& in) {
    const glm::dvec3 n = random.direction();
    in.put(0, n * random.magnitude(0.2, 2.0));
    const glm::dvec3 t = tangent_of(random, n) + random.uniform(-0.8, 0.8) * n;
    in.put(3, glm::dvec4(t * random.magnitude(0.2, 2.0), random.sign()));
    in.put(7, random.direction());
}

std::string right_angles(const In&, const In& out) {
    const glm::dvec3 t = out.v3(0), b = out.v3(3), n = out.v3(6);
    const bool units = is_unit(t, 1e-6) && is_unit(b, 1e-6) && is_unit(n, 1e-6);
    const double lean = std::abs(glm::dot(t, n)) + std::abs(glm::dot(b, n)) + std::abs(glm::dot(t, b));
    return units && lean < 2e-6 ? "" : "not orthonormal";
}

std::vector<Case> vertex_cases() {
    return {{.name = "legacy_tbn",
             .include = kFile,
             .inputs = 10,
             .outputs = 9,
             .glsl = "mat3 m = sg_legacy_tbn(v3(0), v4(3)); put(0, m[0]); put(3, m[1]); put(6, m[2]);",
             .draw = draw_vertex,
             .reference =
                 [](const In& in, Expect& out) {
                     const glm::dmat3 m = ref::legacy_tbn(in.v3(0), in.v4(3));
                     for (int c = 0; c < 3; ++c) out.put(static_cast<std::size_t>(3 * c), m[c]);
                 },
             .bound = {.absolute = 48 * kUlp},  // normalising 6, rejection 6 over a cosine above 0.78, again
                                                // 6, cross 3; doubled
             .property = right_angles,
             .mutants = {{kFile, "tangent.w < 0.0 ? -1.0 : 1.0", "tangent.w < 0.0 ? 1.0 : -1.0"},
                         {kFile, "cross(n, t), n)", "cross(n, t), normal)"}}},
            {.name = "legacy_object_normal",
             .include = kFile,
             .inputs = 10,
             .outputs = 3,
             .glsl = "put(0, sg_legacy_object_normal(v3(7), v3(0), v4(3)));",
             .draw = draw_vertex,
             .reference =
                 [](const In& in, Expect& out) {
                     out.put(0, ref::legacy_object_normal(in.v3(7), in.v3(0), in.v4(3)));
                 },
             .bound = {.absolute = 96 * kUlp},  // the frame as above, three products of it
             .property = unit,
             .mutants = {{kFile, "vec3 bumped = frame * m;", "vec3 bumped = m * frame;"}}},
            {.name = "legacy_tangent_vectors",
             .include = kFile,
             .inputs = 16,
             .outputs = 6,
             .glsl = "SgTangentVectors a = sg_legacy_tangent_vectors(v3(7), v3(0), v4(3), v3(10), v3(13));"
                     "put(0, a.view); put(3, a.light);",
             .draw =
                 [](Random& random, Draw& in) {
                     const glm::dvec3 n = random.direction();
                     in.put(0, n);
                     in.put(3, glm::dvec4(tangent_of(random, n), random.sign()));
                     for (std::size_t k = 7; k < 16; k += 3) in.put(k, random.within(10.0));
                 },
             .reference =
                 [](const In& in, Expect& out) {
                     const ref::TangentVectors a =
                         ref::legacy_tangent_vectors(in.v3(7), in.v3(0), in.v4(3), in.v3(10), in.v3(13));
                     out.put(0, a.view);
                     out.put(3, a.light);
                 },
             .bound = {.absolute =
                           2 * 8 * 35 * kUlp},  // difference 1, cross 2, dot 5, of vectors up to 35; doubled
             .mutants = {{kFile, "transpose(mat3(tangent.xyz, tangent.w", "(mat3(tangent.xyz, tangent.w"},
                         {kFile, "(light - position)", "light"}}}};
}

// Inputs: 0 m, 3 light, 6 view, 9 power.
Case phong() {
    return {
        .name = "legacy_phong",
        .include = kFile,
        .inputs = 10,
        .outputs = 2,
        .glsl =
            "SgPhong a = sg_legacy_phong(v3(0), v3(3), v3(6), f(9)); put(0, a.diffuse); put(1, a.specular);",
        .draw =
            [](Random& random, Draw& in) {
                const glm::dvec3 m = random.direction(), light = random.direction();
                in.put(0, m);
                in.put(3, light);
                in.put(6, random.coin()
                              ? random.direction()
                              : glm::normalize(2.0 * glm::dot(m, light) * m - light + random.within(0.3)));
                in.put(9, random.magnitude(1.0, 64.0));
            },
        .reference =
            [](const In& in, Expect& out) {
                const ref::Phong a = ref::legacy_phong(in.v3(0), in.v3(3), in.v3(6), in[9]);
                out.put(0, a.diffuse);
                out.put(1, a.specular);
            },
        // The cosine 12 roundings, its power k times that and 8 for log2; exp2 6.
        .bound = {.absolute = 24 * kUlp},
        .condition = [](const In& in) { return 1.0 + in[9]; },
        .property =
            [](const In&, const In& out) {
                const bool shares = out[0] >= 0.0 && out[0] <= 1.0 && out[1] >= 0.0 && out[1] <= 1.0;
                return std::string(shares ? "" : "not in 0..1");
            },
        .mutants = {{kFile, "2.0 * facing * m - light", "light - 2.0 * facing * m"},
                    {kFile, "2.0 * facing * m - light", "2.0 * m - light"},
                    {kFile, "clamp(facing, 0.0, 1.0)", "facing"},
                    {kFile, "mirrored > 0.0 ? min(pow(mirrored, power), 1.0) : 0.0",
                     "pow(abs(mirrored), power)"}}};
}

std::vector<Case> cases() {
    std::vector<Case> out = {perlin(), triplanar(), decal(), phong(),
                             resolved_case("legacy_perlin", kFile, 6, "vec3(0.0)", false)};
    out.back().glsl = "put(0, sg_legacy_perlin_normal(v3(0), v3(3)));";
    for (const Case& item : vertex_cases()) out.push_back(item);
    return out;
}

SG_PROVE(Legacy, cases());

TEST(Legacy, FewNormalsCancel) {
    for (const Case& item : {perlin(), triplanar(), decal()}) expect_few_skipped(item, 0.01);
}

// Figure 4: a gradient below the tangent plane pulls Perlin's normal inward; the projected one stays out. A
// raw volume gradient is never resolved elsewhere.
TEST(Legacy, PerlinPointsInwardWhereTheProjectionDoesNot) {
    const glm::dvec3 n(0, 0, 1), gradient(0.3, 0.0, 2.0);
    EXPECT_LT(glm::dot(ref::legacy_perlin_normal(n, gradient), n), 0.0);
    EXPECT_GT(glm::dot(ref::resolve(n, ref::surfgrad_from_volume(n, gradient)), n), 0.9);
}

// Figure 5: Geiss' slopes end at 45 degrees.
TEST(Legacy, GeissFlattensSteepMaps) {
    const glm::dvec3 steep = glm::normalize(glm::dvec3(-10.0, 0.0, 1.0)), z(0, 0, 1);
    const glm::dvec3 bumped =
        ref::legacy_triplanar_normal(z, z, steep, steep, steep, ref::Hand::right, ref::Origin::lower_left);
    EXPECT_GT(bumped.z, std::sqrt(0.5) - 1e-9);
    const glm::dvec3 volume =
        ref::triplanar_gradient(z, {10, 0}, {10, 0}, {10, 0}, ref::Hand::right, ref::Origin::lower_left);
    EXPECT_LT(ref::resolve(z, ref::surfgrad_from_volume(z, volume)).z, 0.1);
}

// A degenerate vertex: T = B = 0, and the normal stays.
TEST(Legacy, TangentAlongNormal) {
    for (const glm::dvec4 tangent : {glm::dvec4(0, 0, 2, 1), glm::dvec4(0, 0, 0, 1)}) {
        const glm::dmat3 m = ref::legacy_tbn({0, 0, 1}, tangent);
        EXPECT_EQ(m[0], glm::dvec3(0.0));
        EXPECT_EQ(m[1], glm::dvec3(0.0));
        const std::vector<float> in = {0, 0, 1, 0, 0, static_cast<float>(tangent.z), 1, 0.6f, 0, 0.8f};
        const std::vector<float> out = evaluate(vertex_cases()[0], in);
        for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(out[k], 0.0f);
    }
}

// Listing 7.8 crosses the interpolated normal, not the unit one: its B is as long as that, and its normal is
// off.
TEST(LegacyPublished, BitangentOfInterpolatedNormal) {
    expect_only_library_holds(
        vertex_cases()[1], "",
        "vec3 normal = v3(0), n = normalize(normal), m = v3(7); vec4 g = v4(3);"
        "vec3 t = normalize(g.xyz - n * dot(g.xyz, n)); vec3 b = g.w * cross(normal, t);"
        "put(0, m.x * t + m.y * b + m.z * n);");
}

}  // namespace
}  // namespace sg::proof
