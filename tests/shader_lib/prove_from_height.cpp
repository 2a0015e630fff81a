// Scale-dependent surface gradients (shader_lib/surfgrad/from_height.glsl) against double precision.
#include "conditions.hpp"
#include "draws.hpp"
#include "ir/reference/from_height.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/from_height.glsl";

void draw_screen_height(Random& random, Draw& in) {
    draw_frame(random, in, 0);
    const double step =
        std::min(glm::length(frame_of(In(in.floats())).dpdx), glm::length(frame_of(In(in.floats())).dpdy));
    in.put(9, random.direction2() * step * random.magnitude(1e-3, 30.0));
}

double screen_condition(const In& in) {
    return inversion(frame_of(in), in.v2(9));
}

std::string slopes_are_the_given(const In& in, const In& out) {
    const ref::Frame frame = frame_of(in);
    const glm::dvec3 g = out.v3(0);
    const double allowed = 64 * kUlp * screen_condition(in);
    const bool tangent = std::abs(glm::dot(g, frame.normal)) <= allowed;
    const bool x = std::abs(glm::dot(g, frame.sigma_x) - in[9]) <= allowed * glm::length(frame.dpdx);
    const bool y = std::abs(glm::dot(g, frame.sigma_y) - in[10]) <= allowed * glm::length(frame.dpdy);
    return tangent && x && y ? "" : "g . dP is not dH";
}

void draw_texture_height(Random& random, Draw& in) {
    draw_frame_and_uv(random, in);
    in.put(15, glm::dvec2(1 + random.below(4096), 1 + random.below(4096)));
    in.put(17, random.direction2() * random.magnitude(1e-4, 10.0));
}

double texture_condition(const In& in) {
    const glm::dvec2 a = glm::abs(in.v2(15) * in.v2(17));
    const ref::Uv uv = uv_of(in);
    // Both shares of the chain rule count, though they may cancel.
    return inversion(frame_of(in), {glm::dot(a, glm::abs(uv.dx)), glm::dot(a, glm::abs(uv.dy))});
}

const std::string kTexture =
    std::string("sg_surfgrad_from_height(") + kFrame + ", " + kUv + ", v2(15), v2(17))";

Case same_as_plain(std::string name, const std::string& glsl) {
    return {.name = "surfgrad_from_height_" + name,
            .include = kFile,
            .inputs = 19,
            .outputs = 3,
            .glsl = "SgFrame frame = " + std::string(kFrame) + "; SgUv uv = " + kUv +
                    "; vec2 dim = v2(15), d = v2(17); put(0, " + glsl + ");",
            .draw = draw_texture_height,
            .reference =
                [](const In& in, Expect& out) {
                    out.put(0, ref::surfgrad_from_height(frame_of(in), uv_of(in), in.v2(15), in.v2(17)));
                },
            .bound = {.absolute = 52 * kUlp},
            .condition = texture_condition};
}

std::vector<Case> invariant_cases() {
    Case turned = same_as_plain(
        "turned",
        "sg_surfgrad_from_height(frame, sg_uv_transform(uv, vec2(1.0), 1.0, vec2(0.0)), vec2(1.0), "
        "mat2(cos(1.0), sin(1.0), -sin(1.0), cos(1.0)) * (dim * d))");
    turned.blunt = "a turn and its opposite are in the bound; surfgrad_from_height has the formula alone";
    turned.bound.absolute += 40 * kUlp;  // the turn, there and back (prove_uv.cpp)
    // |a| + |b| may grow by sqrt(2) under a turn, and products of either component with both steps now count.
    turned.condition = [](const In& in) {
        const double d = glm::length(in.v2(15) * in.v2(17));
        const ref::Uv uv = uv_of(in);
        return 2.0 * inversion(frame_of(in), {d * glm::length(uv.dx), d * glm::length(uv.dy)});
    };
    return {
        turned,
        same_as_plain(
            "mirrored_u",
            "sg_surfgrad_from_height(frame, sg_uv_scale(uv, vec2(-1.0, 1.0)), dim, vec2(-d.x, d.y))"),
        same_as_plain(
            "mirrored_v",
            "sg_surfgrad_from_height(frame, sg_uv_scale(uv, vec2(1.0, -1.0)), dim, vec2(d.x, -d.y))"),
        same_as_plain("viewport_turned",
                      "sg_surfgrad_from_height(sg_frame(vec3(0.0), v3(3), -v3(6), v3(0)), SgUv(uv.st, uv.dx, "
                      "-uv.dy), dim, d)"),
        same_as_plain("normal_negated",
                      "sg_surfgrad_from_height(sg_frame(vec3(0.0), v3(3), v3(6), -v3(0)), uv, dim, d)"),
        same_as_plain("negative_height", "-sg_surfgrad_from_height(frame, uv, dim, -d)"),
        // Letter D. The same texture at twice the resolution: texels are half as far apart.
        same_as_plain("twice_the_texels", "sg_surfgrad_from_height(frame, uv, 2.0 * dim, 0.5 * d)"),
        // Twice the distance: every screen derivative doubles.
        same_as_plain("twice_as_far",
                      "sg_surfgrad_from_height(sg_frame(vec3(0.0), 2.0 * v3(3), 2.0 * v3(6), v3(0)), "
                      "sg_uv_scale(uv, vec2(2.0)), 0.5 * dim, 2.0 * d)"),
        same_as_plain("doubles_with_tiling",
                      "0.5 * sg_surfgrad_from_height(frame, sg_uv_scale(uv, vec2(2.0)), dim, d)"),
        same_as_plain("halves_with_object_scale",
                      "2.0 * sg_surfgrad_from_height(sg_frame(vec3(0.0), 2.0 * v3(3), 2.0 * v3(6), v3(0)), "
                      "uv, dim, d)"),
    };
}

std::vector<Case> cases() {
    return {
        {.name = "surfgrad_from_screen_height",
         .include = kFile,
         .inputs = 11,
         .outputs = 3,
         .glsl = std::string("put(0, sg_surfgrad_from_screen_height(") + kFrame + ", v2(9)));",
         .draw = draw_screen_height,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::surfgrad_from_screen_height(frame_of(in), in.v2(9)));
             },
         // Two projections (7 each), a cross product (3), the determinant (3), sum and division (4).
         .bound = {.absolute = 48 * kUlp},
         .condition = screen_condition,
         .property = slopes_are_the_given,
         .mutants = {{kFile, "dh.x * frame.sigma_y - dh.y * frame.sigma_x",
                      "dh.x * frame.sigma_y + dh.y * frame.sigma_x"},
                     {"surfgrad/frame.glsl", "dot(frame.normal, cross(frame.dpdx, frame.dpdy))",
                      "dot(frame.dpdx, frame.dpdx)"}}},
        {.name = "screen_height_from_deriv",
         .include = kFile,
         .inputs = 19,
         .outputs = 2,
         .glsl = std::string("put(0, sg_screen_height_from_deriv(") + kUv + ", v2(15), v2(17)));",
         .draw = draw_texture_height,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::screen_height_from_deriv(uv_of(in), in.v2(15), in.v2(17)));
             },
         .bound = {.absolute = 6 * kUlp},  // two products and a sum
         .condition =
             [](const In& in) {
                 const glm::dvec2 a = glm::abs(in.v2(15) * in.v2(17));
                 return std::max(glm::dot(a, glm::abs(in.v2(11))), glm::dot(a, glm::abs(in.v2(13))));
             },
         .mutants = {{kFile, "vec2 per_st = dim * d;", "vec2 per_st = d;"},
                     {kFile, "vec2 per_st = dim * d;", "vec2 per_st = dim.yx * d;"}}},
        {.name = "surfgrad_from_height",
         .include = kFile,
         .inputs = 19,
         .outputs = 3,
         .glsl = "put(0, " + kTexture + ");",
         .draw = draw_texture_height,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::surfgrad_from_height(frame_of(in), uv_of(in), in.v2(15), in.v2(17)));
             },
         .bound = {.absolute = 52 * kUlp},  // as both above, less what they share
         .condition = texture_condition},
        resolved_case("surfgrad_from_screen_height", kFile, 11,
                      std::string("sg_surfgrad_from_screen_height(") + kFrame + ", v2(9))"),
        resolved_case("surfgrad_from_height", kFile, 19, kTexture),
    };
}

SG_PROVE(FromHeight, cases());
SG_PROVE(FromHeightInvariants, invariant_cases());

TEST(FromHeightEdges, AFootprintWithoutAreaIsFlat) {
    const std::vector<float> line = {0, 0, 1, 0.1f, 0.2f, 0, 0.2f, 0.4f, 0, 0.5f, -0.5f};
    for (float x : evaluate(cases()[0], line)) EXPECT_EQ(x, 0.0f);
}

}  // namespace
}  // namespace sg::proof
