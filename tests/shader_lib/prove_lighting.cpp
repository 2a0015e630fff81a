// The lighting models (shader_lib/lighting/) against double precision.
#include "ir/reference/lighting.hpp"

#include "draws.hpp"
#include "harness.hpp"
#include "ir/reference/legacy.hpp"

namespace sg::proof {
namespace {

constexpr const char* kGgx = "lighting/ggx.glsl";
constexpr const char* kPhong = "lighting/phong.glsl";
constexpr double kPi = 3.14159265358979323846;

std::string below(const In& out, double least) {
    for (std::size_t k = 0; k < out.size(); ++k) {
        if (!(out[k] >= least) || std::isinf(out[k]))
            return "below " + std::to_string(least) + ", or no number";
    }
    return "";
}

// ---- the parts of GGX ----

// Two directions at any angle, half of them close.
void draw_two_directions(Random& random, Draw& in) {
    const glm::dvec3 a = random.direction();
    in.put(0, a);
    in.put(3, random.coin() ? random.direction()
                            : glm::normalize(a + random.magnitude(1e-6, 1.0) * random.direction()));
}

std::vector<Case> parts() {
    return {
        {.name = "sin2_between",
         .include = kGgx,
         .inputs = 6,
         .outputs = 1,
         .glsl = "put(0, sg_sin2_between(v3(0), v3(3)));",
         .draw = draw_two_directions,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::sin2_between(in.v3(0), in.v3(3))); },
         // c2: a difference, which counts twice, a product and two sums, 5; what follows 2, for c2 / 4 is at
         // most 1/2; lengths are a rounding from 1: 2 for c2, 4 for the reference. Doubled. Lengths that
         // differ by two roundings make a chord of nothing as long.
         .bound = {.absolute = 2 * 4 * kUlp * kUlp, .relative = 2 * 13 * kUlp},
         .property = [](const In&, const In& out) { return out[0] <= 1.0 ? below(out, 0.0) : "above 1"; },
         .mutants = {{kGgx, "c2 - 0.25 * c2 * c2", "c2"},
                     {kGgx, "chord = a - b", "chord = a + b"},
                     {kGgx, "min(dot(chord, chord), 2.0)", "dot(chord, chord)"}}},
        {.name = "ggx_distribution",
         .include = kGgx,
         .inputs = 2,
         .outputs = 1,
         .glsl = "put(0, sg_ggx_distribution(f(0), f(1)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, random.coin() ? random.uniform(0.0, 1.0) : random.magnitude(1e-9, 1.0));
                 in.put(1, random.magnitude(2e-3, 1.0));
             },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::ggx_distribution(in[0], in[1])); },
         // f has 4 roundings of terms up to f itself, which count twice; 5 more; doubled.
         .bound = {.relative = 2 * 13 * kUlp},
         .property = [](const In&, const In& out) { return below(out, 1e-7); },
         .mutants = {{kGgx, "/ (3.14159265 * f * f)", "/ (3.14159265 * f)"},
                     {kGgx, "return a2 /", "return alpha /"}}},
        {.name = "ggx_visibility",
         .include = kGgx,
         .inputs = 3,
         .outputs = 1,
         .glsl = "put(0, sg_ggx_visibility(f(0), f(1), f(2)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, random.below(16) == 0 ? 0.0 : random.magnitude(1e-4, 1.0));
                 in.put(1, random.below(16) == 0 ? 0.0 : random.magnitude(1e-4, 1.0));
                 in.put(2, random.magnitude(2e-3, 1.0));
             },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::ggx_visibility(in[0], in[1], in[2])); },
         .bound = {.relative = 2 * 10 * kUlp},  // sums of positive numbers: 8 to l + v, a quotient
         .property = [](const In&, const In& out) { return below(out, 0.24); },  // 1 / 4 at normal incidence
         .mutants = {{kGgx, "0.5 / max", "1.0 / max"}, {kGgx, "max(l + v, 1e-6)", "(l + v)"}}},
        {.name = "fresnel",
         .include = kGgx,
         .inputs = 4,
         .outputs = 3,
         .glsl = "put(0, sg_fresnel(v3(0), f(3)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, glm::dvec3(0.5) + random.within(0.5));
                 in.put(3, random.uniform(-0.2, 1.1));
             },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::fresnel(in.v3(0), in[3])); },
         .bound = {.absolute = 2 * 10 * kUlp},  // of numbers up to 1
         .property = [](const In&, const In& out) { return below(out, 0.0); },
         .mutants = {{kGgx, "m2 * m2 * m", "m2 * m2"},
                     {kGgx, "clamp(1.0 - cos_d, 0.0, 1.0)", "1.0 - cos_d"}}}};
}

// ---- GGX ----

// 0 base_color, 3 metallic, 4 roughness, 5 occlusion, 6 emission, 9 n, 12 view, 15 light, 18 radiance, 21
// ambient.
void draw_ggx(Random& random, Draw& in) {
    in.put(0, glm::dvec3(0.5) + random.within(0.5));
    in.put(3, random.uniform(0.0, 1.0));
    in.put(4, random.uniform(0.0, 1.0));
    in.put(5, random.uniform(0.0, 1.0));
    in.put(6, glm::dvec3(0.5) + random.within(0.5));
    const glm::dvec3 n = random.direction();
    in.put(9, n);
    auto direction = [&] {
        return random.coin() ? random.direction() : glm::normalize(n + random.within(0.7));
    };
    const glm::dvec3 view = direction();
    in.put(12, view);
    in.put(15, direction());
    if (random.below(3) == 0) {  // within a sharp highlight
        const glm::dvec3 mirrored = glm::reflect(-view, n);
        in.put(15, glm::normalize(mirrored + random.magnitude(1e-4, 1.0) * random.direction()));
        in.put(4, random.magnitude(0.02, 0.5));
    }
    for (std::size_t k : {18, 21}) in.put(k, glm::dvec3(0.5) + random.within(0.5));
}
ref::GgxSurface ggx_surface(const In& in) {
    return {in.v3(0), in[3], in[4], in[5], in.v3(6)};
}

// Roundings in units of kGgxRoundings. The base: Fresnel 10, cosine 4. The mirrored part: those and
// visibility 10; what 4 in cos_l and cos_v do; the distribution: 13, twice the 9 of sin2, and what the 5 of
// the half vector's components do to it: twice 5 chords, relative to f, which counts twice.
// Half the diagonal of view and light is cos_d if both are as long: each is within a rounding, which the
// length divides and the fifth power has five times.
constexpr double kGgxRoundings = 16;
double ggx_condition(const In& in) {
    const glm::dvec3 sum = in.v3(12) + in.v3(15), n = in.v3(9);
    const double length = glm::length(sum);
    if (length < 0.05) return INFINITY;
    const double alpha = std::max(in[4] * in[4], 2e-3);
    const double cos_l = glm::clamp(glm::dot(n, in.v3(15)), 0.0, 1.0);
    const double cos_v = std::abs(glm::dot(n, in.v3(12))) + 1e-4;
    const double sin2 = ref::sin2_between(n, sum / length), chord = glm::distance(n, sum / length);
    const double lobe = kPi * ref::ggx_distribution(sin2, alpha) * ref::ggx_visibility(cos_l, cos_v, alpha);
    const double f = sin2 + alpha * alpha * (1.0 - sin2);
    const double distribution = (31.0 + 20.0 * chord / f) / kGgxRoundings;
    const double diagonal = 2.0 * 5.0 / length / kGgxRoundings;
    return 1.0 + diagonal + lobe * (1.0 + cos_l * (2.0 + 1.0 / cos_v + diagonal + distribution));
}

std::vector<Case> ggx() {
    Case direct = {
        .name = "ggx",
        .include = kGgx,
        .inputs = 24,
        .outputs = 3,
        .glsl =
            "put(0, sg_ggx(SgGgxSurface(v3(0), f(3), f(4), f(5), v3(6)), v3(9), v3(12), v3(15), v3(18)));",
        .draw = draw_ggx,
        .reference =
            [](const In& in, Expect& out) {
                out.put(0, ref::ggx(ggx_surface(in), in.v3(9), in.v3(12), in.v3(15), in.v3(18)));
            },
        .bound = {.absolute = 2 * kGgxRoundings * kUlp},
        .condition = ggx_condition,
        .property = [](const In&, const In& out) { return below(out, 0.0); },
        .mutants = {{kGgx, "surface.roughness * surface.roughness", "surface.roughness"},
                    {kGgx, "(1.0 - surface.metallic) *", ""},
                    {kGgx, "mix(vec3(0.04)", "mix(vec3(0.0)"},
                    {kGgx, "0.5 * length2 * per_length", "length2 * per_length"},
                    {kGgx, "mix(base, vec3(lobe), fresnel)", "base + fresnel * lobe"}}};
    Case whole = direct;
    whole.name = "ggx_radiance";
    whole.glsl =
        "put(0, sg_ggx_radiance(SgGgxSurface(v3(0), f(3), f(4), f(5), v3(6)), v3(9), "
        "SgLights(v3(12), v3(15), v3(18), v3(21))));";
    whole.reference = [](const In& in, Expect& out) {
        out.put(0,
                ref::ggx_radiance(ggx_surface(in), in.v3(9), {in.v3(12), in.v3(15), in.v3(18), in.v3(21)}));
    };
    whole.bound.absolute += 2 * 8 * kUlp;  // three more terms up to 1
    whole.mutants = {{kGgx, "surface.occlusion * surface.base_color", "surface.base_color"},
                     {kGgx, " + surface.emission", ""}};
    // View against light, both behind the surface, straight along it: a number all the same.
    Case any = direct;
    any.name = "ggx_any_direction";
    any.draw = [](Random& random, Draw& in) {
        draw_ggx(random, in);
        const glm::dvec3 kAxes[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}};
        in.put(9, kAxes[0]);
        for (std::size_t k : {12, 15}) in.put(k, kAxes[random.below(3)]);
        in.put(4, random.coin() ? 0.0 : 1.0);
    };
    any.reference = {};
    any.condition = {};
    any.mutants = {
        {kGgx, "max(surface.roughness * surface.roughness, 2e-3)", "surface.roughness * surface.roughness"}};
    return {direct, whole, any};
}

// ---- Phong ----

// 0 base_color, 3 specular, 6 shininess, 7 occlusion, 8 emission, 11 n, 14 view, 17 light, 20 radiance, 23
// ambient, 26 tangent.
void draw_phong(Random& random, Draw& in) {
    for (std::size_t k : {0, 3, 8, 20, 23}) in.put(k, glm::dvec3(0.5) + random.within(0.5));
    in.put(6, random.magnitude(1.0, 1000.0));
    in.put(7, random.uniform(0.0, 1.0));
    const glm::dvec3 n = random.direction(), light = random.direction();
    in.put(11, n);
    in.put(17, light);
    in.put(14, random.coin() ? random.direction()
                             : glm::normalize(2.0 * glm::dot(n, light) * n - light + random.within(0.3)));
    in.put(26, glm::dvec4(tangent_of(random, n), random.sign()));
}
void phong_reference(const In& in, Expect& out) {
    out.put(0, ref::phong_radiance({in.v3(0), in.v3(3), in[6], in[7], in.v3(8)}, in.v3(11),
                                   {in.v3(14), in.v3(17), in.v3(20), in.v3(23)}));
}

std::vector<Case> phong() {
    Case world = {
        .name = "phong_radiance",
        .include = kPhong,
        .inputs = 30,
        .outputs = 3,
        .glsl =
            "put(0, sg_phong_radiance(SgPhongSurface(v3(0), v3(3), f(6), f(7), v3(8)), v3(11), "
            "SgLights(v3(14), v3(17), v3(20), v3(23))));",
        .draw = draw_phong,
        .reference = phong_reference,
        // The two shares as in legacy_phong, 24; products and sums of numbers up to 1: 10, doubled.
        .bound = {.absolute = (24 + 2 * 10) * kUlp},
        .condition = [](const In& in) { return 1.0 + in[6]; },
        .property = [](const In&, const In& out) { return below(out, 0.0); },
        .mutants = {{kPhong, "share.specular * surface.specular", "share.specular * surface.base_color"},
                    {kPhong, "surface.occlusion * surface.base_color", "surface.base_color"},
                    {kPhong, " + surface.emission", ""},
                    {kPhong, "surface.shininess)", "2.0 * surface.shininess)"}}};
    // The workshop's way: normal, view and light in the space of tangent, bitangent and normal give the same
    // picture.
    Case tangent_space = world;
    tangent_space.name = "phong_in_tangent_space";
    tangent_space.glsl =
        "mat3 world_from_tangent = sg_legacy_tbn(v3(11), v4(26));"
        "vec3 n = v3(11) * world_from_tangent, view = v3(14) * world_from_tangent, light = v3(17) * "
        "world_from_tangent;"
        "put(0, sg_phong_radiance(SgPhongSurface(v3(0), v3(3), f(6), f(7), v3(8)), n, "
        "SgLights(view, light, v3(20), v3(23))));";
    tangent_space.bound.absolute +=
        4 * 24 * kUlp;  // a matrix that is orthonormal to 24 (legacy_tbn) on both sides of two cosines
    tangent_space.mutants = {{"surfgrad/legacy.glsl", "cross(n, t), n)", "cross(n, t), 0.9 * n)"}};
    return {world, tangent_space};
}

std::vector<Case> cases() {
    return joined(joined(parts(), ggx()), phong());
}

SG_PROVE(Lighting, cases());

}  // namespace
}  // namespace sg::proof
