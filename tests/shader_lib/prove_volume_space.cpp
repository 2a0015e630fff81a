// Volume gradients and footprints between spaces (shader_lib/surfgrad/volume_space.glsl) against double
// precision.
#include "ir/reference/volume_space.hpp"

#include <fmt/format.h>

#include <glm/ext/matrix_transform.hpp>

#include "ir/reference/noise.hpp"
#include "published.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/volume_space.glsl";

glm::dmat3 matrix(const In& in) {
    return {in.v3(0), in.v3(3), in.v3(6)};
}

// A rotation times a scale of any sign per axis times another rotation; some flattened to a plane.
glm::dmat3 random_instance(Random& random) {
    auto rotation = [&] {
        return glm::dmat3(glm::rotate(glm::dmat4(1.0), random.uniform(-3.0, 3.0), random.direction()));
    };
    glm::dmat3 scale(0.0);
    for (int axis = 0; axis < 3; ++axis) scale[axis][axis] = random.sign() * random.magnitude(0.05, 20.0);
    return rotation() * scale * rotation();
}

void draw_gradient(Random& random, Draw& in) {
    glm::dmat3 m = random_instance(random);
    if (random.below(16) == 0) m[2] = m[0] * 2.0;  // a flattened object
    for (int column = 0; column < 3; ++column) in.put(static_cast<std::size_t>(3 * column), m[column]);
    in.put(9, random.direction() * random.magnitude(1e-3, 100.0));
}

// |cofactors| |gradient| / |det|: what the rounding of the three cross products and of the determinant is
// multiplied by, once for the sum and once, by |a||b||c| / |det|, for the quotient.
double conditioned(const In& in) {
    const glm::dmat3 m = matrix(in);
    const double a = glm::length(m[0]), b = glm::length(m[1]), c = glm::length(m[2]);
    const double det = std::abs(glm::determinant(m));
    if (!(det > 1e-6 * a * b * c)) return 1.0;
    const double cofactors = std::max({b * c, c * a, a * b});
    return (1.0 + a * b * c / det) * cofactors * glm::length(in.v3(9)) / det;
}

// The height that the object carries changes along M v as it changes along v.
std::string chain_rule(const In& in, const In& out) {
    const glm::dmat3 m = matrix(in);
    if (out.v3(0) == glm::dvec3(0.0)) return "";
    for (glm::dvec3 v : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        const double moved = glm::dot(out.v3(0), m * v), still = glm::dot(in.v3(9), v);
        const double allowed = 64 * kUlp * conditioned(in) * glm::length(m * v);
        if (!(std::abs(moved - still) <= allowed))
            return fmt::format("{} along M v, {} along v", moved, still);
    }
    return "";
}

Case to_world() {
    return {
        .name = "gradient_to_world",
        .include = kFile,
        .inputs = 12,
        .outputs = 3,
        .glsl = "put(0, sg_gradient_to_world(m3(0), v3(9)));",
        .draw = draw_gradient,
        .reference = [](const In& in,
                        Expect& out) { out.put(0, ref::gradient_to_world(matrix(in), in.v3(9))); },
        // Cross products 3 roundings, the sum 3 per component, the determinant 8, the quotient 1; doubled.
        .bound = {.absolute = 32 * kUlp},
        .condition = conditioned,
        .property = chain_rule,
        .mutants = {{kFile, "gradient.y * cross(c, a)", "gradient.y * cross(a, c)"},
                    {kFile, "abs(det) > 1e-6 *", "abs(det) >= 0.0 *"}}};
}

std::vector<Case> cases() {
    return {to_world(),
            {.name = "footprint",
             .include = kFile,
             .inputs = 6,
             .outputs = 1,
             .glsl = "put(0, sg_footprint(v3(0), v3(3)));",
             .draw =
                 [](Random& random, Draw& in) {
                     in.put(0, random.direction() * random.magnitude(1e-5, 1e3));
                     in.put(3, random.below(8) == 0 ? glm::dvec3(0.0)
                                                    : random.direction() * random.magnitude(1e-5, 1e3));
                 },
             .reference = [](const In& in, Expect& out) { out.put(0, ref::footprint(in.v3(0), in.v3(3))); },
             // A sum of three squares, 5 roundings, halved by the root, and the root itself; doubled.
             .bound = {.relative = 8 * kUlp},
             .mutants = {{kFile, "max(dot(dpdx, dpdx), dot(dpdy, dpdy))",
                          "min(dot(dpdx, dpdx), dot(dpdy, dpdy))"},
                         {kFile, "max(dot(dpdx, dpdx), dot(dpdy, dpdy))", "dot(dpdx, dpdx)"}}}};
}

SG_PROVE(VolumeSpace, cases());

// Defect 6: the sign of the determinant does not belong to a volume gradient.
TEST(VolumeSpacePublished, SignOfDeterminant) {
    expect_only_library_holds(
        to_world(), "",
        "mat3 m = m3(0); float d = determinant(m);"
        "vec3 a = m[0], b = m[1], c = m[2], h = v3(9);"
        "vec3 g = (h.x * cross(b, c) + h.y * cross(c, a) + h.z * cross(a, b)) / d;"
        "put(0, abs(d) > 1e-6 * length(a) * length(b) * length(c) ? sign(d) * g : vec3(0.0));");
}

// Defect 9: after parallax two neighbouring pixels may have hit either side of a ledge. The difference of
// their positions is no footprint: it wipes out octaves that the surface under the pixel shows.
TEST(VolumeSpacePublished, FootprintFromMarchedPositions) {
    Case item{.name = "footprint_at_a_ledge",
              .include = kFile,
              .inputs = 9,
              .outputs = 1,
              .glsl = "put(0, sg_footprint(v3(0), v3(3)));",
              .draw =
                  [](Random& random, Draw& in) {
                      in.put(0, random.direction() * random.magnitude(1e-3, 1e-1));
                      in.put(3, random.direction() * random.magnitude(1e-3, 1e-1));
                      in.put(6, random.coin() ? glm::dvec3(0.0) : random.direction());  // the ledge
                  },
              .reference = [](const In& in, Expect& out) { out.put(0, ref::footprint(in.v3(0), in.v3(3))); },
              .bound = {.relative = 8 * kUlp}};
    expect_only_library_holds(item, "",
                              "vec3 here = vec3(0.0), right = here + v3(0) + v3(6), below = here + v3(3);"
                              "put(0, max(length(right - here), length(below - here)));");
}

// Rotating an object changes nothing in object space (L): noise on the object, looked up there and carried to
// world axes, gives the rotated normal.
TEST(VolumeSpace, RotationCarriesNoiseAlong) {
    Random random("rotation");
    for (int i = 0; i < 1000; ++i) {
        const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), random.uniform(-3.0, 3.0), random.direction()));
        const glm::dvec3 p = random.within(4.0), n = random.direction();
        const glm::dvec3 in_object = ref::noise_fractal_sum(p, 0.01, 4).gradient;
        const glm::dvec3 in_world = ref::gradient_to_world(turn, in_object);
        auto bumped = [](glm::dvec3 normal, glm::dvec3 g) {
            return glm::normalize(normal - g + glm::dot(normal, g) * normal);
        };
        EXPECT_LT(glm::length(bumped(turn * n, in_world) - turn * bumped(n, in_object)), 1e-12);
    }
}

}  // namespace
}  // namespace sg::proof
