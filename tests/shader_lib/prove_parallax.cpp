// Parallax (shader_lib/surfgrad/parallax.glsl) against double precision.
#include "ir/reference/parallax.hpp"

#include <fmt/format.h>

#include "draws.hpp"
#include "published.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/parallax.glsl";

std::string call(const char* text) {
    return fmt::format(fmt::runtime(text), kFrame, kUv);
}

// How far the steps of a pixel are from spanning an area.
double squint(const ref::Frame& frame) {
    return glm::length(frame.dpdx) * glm::length(frame.dpdy) /
           std::abs(glm::dot(frame.dpdx, glm::cross(frame.dpdy, frame.normal)));
}
double stretch(const ref::Frame& frame, const ref::Uv& uv) {
    return glm::length(uv.dx) / glm::length(frame.dpdx) + glm::length(uv.dy) / glm::length(frame.dpdy);
}

// The cross product and the dot product 6 roundings, times 1/(|dpdx| sine); the determinant 8 over the sine
// once more.
double direction_condition(const In& in) {
    const ref::Frame frame = frame_of(in);
    const double wide = squint(frame);
    return 1.0 + stretch(frame, uv_of(in)) * wide * wide;
}

Case direction() {
    return {.name = "parallax_direction",
            .include = kFile,
            .inputs = 18,
            .outputs = 3,
            .glsl = call("put(0, sg_parallax_direction({}, {}, v3(15)));"),
            .draw =
                [](Random& random, Draw& in) {
                    draw_frame_and_uv(random, in);
                    in.put(15, random.direction());
                },
            .reference =
                [](const In& in, Expect& out) {
                    out.put(0, ref::parallax_direction(frame_of(in), uv_of(in), in.v3(15)));
                },
            .bound = {.absolute = 32 * kUlp},
            .condition = direction_condition,
            .mutants = {{kFile, "vec2(dot(frame.dpdy, level)", "vec2(-dot(frame.dpdy, level)"},
                        {kFile, "-dot(frame.dpdx, level))", "dot(frame.dpdx, level))"},
                        {kFile, "dot(frame.normal, direction))", "-dot(frame.normal, direction))"}}};
}

// A frame whose steps lie in the tangent plane, as after analytic derivatives.
void flatten(Draw& in) {
    const In read{std::span<const float>(in.floats())};
    const glm::dvec3 n = read.v3(0);
    in.put(3, ref::reject(read.v3(3), n));
    in.put(6, ref::reject(read.v3(6), n));
}

// There and back: a step in the tangent plane, to texture space, to pixels, to the surface.
Case round_trip() {
    return {.name = "parallax_round_trip",
            .blunt = "there and back: the cases of the two ways have the formulas alone",
            .include = kFile,
            .inputs = 18,
            .outputs = 3,
            .glsl = call(
                "SgFrame frame = {}; SgUv uv = {}; vec2 offset = sg_parallax_direction(frame, uv, v3(15)).xy;"
                "put(0, sg_parallax_position(frame, sg_parallax_pixels(uv, offset), 0.0));"),
            .draw =
                [](Random& random, Draw& in) {
                    draw_frame_and_uv(random, in);
                    flatten(in);
                    in.put(15, tangent_of(random, In{std::span<const float>(in.floats())}.v3(0)));
                },
            .reference = [](const In& in, Expect& out) { out.put(0, in.v3(15)); },
            // As parallax_direction, then the inverse of the coordinate's two steps: 6 roundings over its
            // squint, twice.
            .bound = {.absolute = 64 * kUlp},
            .condition =
                [](const In& in) {
                    const ref::Frame frame = frame_of(in);
                    const ref::Uv uv = uv_of(in);
                    const double det = std::abs(uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x);
                    const double narrow = glm::length(uv.dx) * glm::length(uv.dy) / det;
                    // A step of a unit across narrow, long pixels is many of one and few of the other.
                    const double uneven = std::max(glm::length(uv.dx) / glm::length(uv.dy),
                                                   glm::length(uv.dy) / glm::length(uv.dx)) +
                                          std::max(glm::length(frame.dpdx) / glm::length(frame.dpdy),
                                                   glm::length(frame.dpdy) / glm::length(frame.dpdx));
                    return squint(frame) * squint(frame) * narrow * narrow * uneven * uneven;
                },
            .mutants = {{kFile, "uv.dx.x * offset.y - uv.dx.y * offset.x",
                         "uv.dx.y * offset.x - uv.dx.x * offset.y"}}};
}

// Inputs: 0 frame, 9 uv, 15 offset, 17 height, 18 dndx, 21 dndy, 24 pixels.
void draw_corrections(Random& random, Draw& in) {
    draw_frame_and_uv(random, in);
    in.put(15, random.direction2() * random.magnitude(1e-4, 0.3));
    in.put(17, random.uniform(-0.3, 0.3));
    in.put(18, random.direction() * random.magnitude(1e-4, 0.1));
    in.put(21, random.direction() * random.magnitude(1e-4, 0.1));
    in.put(24, random.direction2() * random.uniform(0.0, 4.0));
}

// The offset over the coordinate's steps, with the roundings of its determinant; then over the frame's.
double pixels_condition(const In& in) {
    const ref::Uv uv = uv_of(in);
    const double det = std::abs(uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x);
    const double longer = std::max(glm::length(uv.dx), glm::length(uv.dy));
    return 1.0 +
           glm::length(in.v2(15)) * longer / det * (1.0 + glm::length(uv.dx) * glm::length(uv.dy) / det);
}

Case correction(const char* name, int outputs, const char* glsl) {
    return {.name = name,
            .include = kFile,
            .inputs = 26,
            .outputs = outputs,
            .glsl = call(glsl),
            .draw = draw_corrections};
}

Case pixels() {
    Case item = correction("parallax_pixels", 2, "put(0, sg_parallax_pixels({1}, v2(15)));");
    item.reference = [](const In& in, Expect& out) {
        out.put(0, ref::parallax_pixels(uv_of(in), in.v2(15)));
    };
    item.bound = {.absolute = 16 * kUlp};  // numerator 3, determinant 3, quotient 1; doubled
    item.condition = pixels_condition;
    item.mutants = {
        {kFile, "uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x", "uv.dx.x * uv.dy.y + uv.dx.y * uv.dy.x"}};
    return item;
}

Case position() {
    Case item = correction(
        "parallax_position", 3,
        "SgFrame frame = {0}; frame.position = v3(18); put(0, sg_parallax_position(frame, v2(24), f(17)));");
    item.reference = [](const In& in, Expect& out) {
        ref::Frame frame = frame_of(in);
        frame.position = in.v3(18);
        out.put(0, ref::parallax_position(frame, in.v2(24), in[17]));
    };
    item.bound = {.absolute = 32 * kUlp};  // rejection 6, products and sums 6; doubled
    item.condition = [](const In& in) { return 1.0 + 4.0 * (glm::length(in.v3(3)) + glm::length(in.v3(6))); };
    item.mutants = {
        {kFile, "height * frame.normal;", "-height * frame.normal;"},
        {kFile, "frame.position + pixels.x", "pixels.x"},
    };
    return item;
}

Case normal() {
    Case item =
        correction("parallax_normal", 3, "put(0, sg_parallax_normal(v3(0), v3(18), v3(21), v2(24)));");
    item.reference = [](const In& in, Expect& out) {
        out.put(0, ref::parallax_normal(in.v3(0), in.v3(18), in.v3(21), in.v2(24)));
    };
    item.bound = {.absolute = 24 * kUlp};  // sums 4 of length below 2, normalising 6; doubled
    item.condition = [](const In& in) {
        return 2.0 / glm::length(in.v3(0) + in[24] * in.v3(18) + in[25] * in.v3(21));
    };
    item.property = unit;
    return item;
}

Case detail() {
    Case item = correction("parallax_detail_uv", 6,
                           "SgUv a = sg_parallax_detail_uv({0}, {1}, v2(24), v3(18), v3(21)); put(0, a.st); "
                           "put(2, a.dx); put(4, a.dy);");
    item.reference = [](const In& in, Expect& out) {
        const ref::Uv uv = ref::parallax_detail_uv(frame_of(in), uv_of(in), in.v2(24), in.v3(18), in.v3(21));
        out.put(0, uv.st);
        out.put(2, uv.dx);
        out.put(4, uv.dy);
    };
    item.bound = {.absolute =
                      32 * kUlp};  // as parallax_direction, of a step below 0.1; st: 4 roundings of 4 pixels
    item.condition = [](const In& in) {
        const ref::Uv uv = uv_of(in);
        return direction_condition(in) + 4.0 * (glm::length(uv.dx) + glm::length(uv.dy)) + glm::length(uv.st);
    };
    item.mutants = {{kFile,
                     "sg_parallax_direction(frame, uv, dpdx).xy, sg_parallax_direction(frame, uv, dpdy).xy",
                     "uv.dx, uv.dy"}};
    return item;
}

Case simple() {
    Case item = correction(
        "parallax_uv_offset_scale", 10,
        "SgUv a = sg_parallax_uv({1}, v2(15)); put(0, a.st); put(2, a.dx); put(4, a.dy);"
        "put(6, sg_parallax_offset(v3(18), f(17))); put(8, sg_parallax_scale(f(17), 4, vec2(64.0, 32.0)));");
    item.reference = [](const In& in, Expect& out) {
        const ref::Uv uv = ref::parallax_uv(uv_of(in), in.v2(15));
        out.put(0, uv.st);
        out.put(2, uv.dx);
        out.put(4, uv.dy);
        out.put(6, ref::parallax_offset(in.v3(18), in[17]));
        out.put(8, ref::parallax_scale(in[17], 4, {64.0, 32.0}));
    };
    item.bound = {.relative = 8 * kUlp};  // four roundings, doubled
    item.mutants = {{kFile, "return height * view.xy;", "return height * view.xy / view.z;"},
                    {kFile, "(2.0 * float(max(steps, 1)) * dim)", "(float(max(steps, 1)) * dim)"},
                    {kFile, "(2.0 * float(max(steps, 1)) * dim)", "(2.0 * dim)"}};
    return item;
}

// Whatever is handed in: n stays a unit normal.
Case wild_normal() {
    Case item{.name = "parallax_normal_any_input",
              .include = kFile,
              .inputs = 26,
              .outputs = 3,
              .glsl = "put(0, sg_parallax_normal(v3(0), v3(18), v3(21), v2(24)));",
              .draw = draw_normal_then_wild,
              .property = unit};
    item.mutants = {{kFile, "square > 1e-6 && square < 1e30", "square > 1e-6"}};
    return item;
}

// No area on the screen or in the texture: no offset.
Case degenerate() {
    return {
        .name = "parallax_degenerate",
        .include = kFile,
        .inputs = 18,
        .outputs = 4,
        .glsl = call(
            "put(0, sg_parallax_direction({0}, {1}, v3(15)).xy); put(2, sg_parallax_pixels({1}, v2(15)));"),
        .draw =
            [](Random& random, Draw& in) {
                draw_frame_and_uv(random, in);
                const In read{std::span<const float>(in.floats())};
                const double factor = random.below(3) - 1.0;
                in.put(6, factor * read.v3(3));
                in.put(13, factor * read.v2(11));
                in.put(15, random.direction());
            },
        .reference = [](const In&, Expect& out) { out.put(0, glm::dvec4(0.0)); },
        .bound = {},
        .mutants = {{"surfgrad/frame.glsl", "abs(area) > 1e-5 * largest ? 1.0 / area : 0.0", "1.0 / area"},
                    {kFile, "float scale = abs(det) > 1e-6 * largest ? 1.0 / det : 0.0;",
                     "float scale = 1.0 / det;"}}};
}

std::vector<Case> cases() {
    return {direction(), round_trip(), degenerate(), wild_normal(), pixels(),
            position(),  normal(),     detail(),     simple()};
}

SG_PROVE(Parallax, cases());

// Defect 11: under an orthographic camera all rays are parallel; the way to the origin is not the view.
TEST(ParallaxPublished, OrthographicView) {
    Case item = direction();
    expect_only_library_holds(item, "",
                              call("vec3 position = 5.0 * v3(15) + v3(0);"
                                   "put(0, sg_parallax_direction({}, {}, normalize(-position)));"));
}

}  // namespace
}  // namespace sg::proof
