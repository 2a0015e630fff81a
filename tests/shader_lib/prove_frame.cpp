// The surface frame (shader_lib/surfgrad/frame.glsl) against double precision.
#include "draws.hpp"
#include "ir/reference/frame.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/frame.glsl";
constexpr const char* kPutFrame =
    "put(0, frame.normal); put(3, frame.dpdx); put(6, frame.dpdy); put(9, frame.sigma_x); put(12, "
    "frame.sigma_y);"
    "put(15, frame.flip_sign); put(16, frame.position);";

void put_frame(const ref::Frame& frame, Expect& out) {
    out.put(0, frame.normal), out.put(3, frame.dpdx), out.put(6, frame.dpdy);
    out.put(9, frame.sigma_x), out.put(12, frame.sigma_y);
    out.put(15, frame.flip_sign), out.put(16, frame.position);
}

// A projection loses 5 roundings of the vector's length, and n, rounded, is off unit length by 2 more.
constexpr Bound kProjection = {.absolute = 14 * kUlp};

double longest_step(const In& in) {
    return std::max(glm::length(in.v3(3)), glm::length(in.v3(6)));
}

std::string sigma_is_tangent(const In& in, const In& out) {
    const glm::dvec3 n = out.v3(0);
    const double allowed = 14 * kUlp * longest_step(in);
    return std::abs(glm::dot(out.v3(9), n)) <= allowed && std::abs(glm::dot(out.v3(12), n)) <= allowed
               ? ""
               : "sigma is not perpendicular to n";
}

void draw_any_length(Random& random, Draw& in) {
    in.put(0, random.direction() * random.magnitude(1e-14, 1e14));
}

std::vector<Case> frame_cases() {
    return {
        {.name = "reject",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_reject(v3(3), v3(0)));",
         .draw = [](Random& random,
                    Draw& in) { in.put(0, random.direction()), in.put(3, random.within(10.0)); },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::reject(in.v3(3), in.v3(0))); },
         .bound = kProjection,
         .condition = [](const In& in) { return glm::length(in.v3(3)); }},
        {.name = "frame",
         .include = kFile,
         .inputs = 12,
         .outputs = 19,
         .glsl = std::string("SgFrame frame = sg_frame(v3(9), v3(3), v3(6), v3(0));") + kPutFrame,
         .draw = [](Random& random, Draw& in) { draw_frame(random, in, 0), in.put(9, random.within(100.0)); },
         .reference = [](const In& in,
                         Expect& out) { put_frame(ref::frame(in.v3(9), in.v3(3), in.v3(6), in.v3(0)), out); },
         .bound = kProjection,
         .condition = longest_step,
         .property = sigma_is_tangent,
         .mutants = {{kFile, "float sign_dp = dot(n, cross(dpdx, dpdy)) < 0.0",
                      "float sign_dp = dot(dpdx, cross(n, dpdy)) < 0.0"}}},
        {.name = "frame_inverse_area",
         .include = kFile,
         .inputs = 12,
         .outputs = 1,
         .glsl = "put(0, sg_frame_inverse_area(sg_frame(v3(9), v3(3), v3(6), v3(0))));",
         .draw = [](Random& random, Draw& in) { draw_frame(random, in, 0), in.put(9, random.within(100.0)); },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::frame_inverse_area(ref::frame(in.v3(9), in.v3(3), in.v3(6), in.v3(0))));
             },
         // A cross product (3), a dot product (5) and a division (2), of |dpdx||dpdy|, in an area that is
         // less.
         .bound = {.absolute = 20 * kUlp},
         .condition =
             [](const In& in) {
                 const double steps = glm::length(in.v3(3)) * glm::length(in.v3(6));
                 const double area =
                     ref::frame_inverse_area(ref::frame(in.v3(9), in.v3(3), in.v3(6), in.v3(0)));
                 return steps * area * area;
             },
         .mutants = {{kFile, "1.0 / area", "area"}}},
        {.name = "frame_resolved",
         .include = kFile,
         .inputs = 15,
         .outputs = 19,
         .glsl =
             std::string("SgFrame frame = sg_frame_resolved(sg_frame(v3(9), v3(3), v3(6), v3(0)), v3(12));") +
             kPutFrame,
         .draw =
             [](Random& random, Draw& in) {
                 draw_frame(random, in, 0), in.put(9, random.within(100.0)), in.put(12, random.direction());
             },
         .reference =
             [](const In& in, Expect& out) {
                 put_frame(ref::frame_resolved(ref::frame(in.v3(9), in.v3(3), in.v3(6), in.v3(0)), in.v3(12)),
                           out);
             },
         .bound = kProjection,
         .condition = longest_step,
         .property = sigma_is_tangent,
         .mutants = {{kFile, "                   frame.flip_sign);",
                      "                   sg_frame(frame.position, frame.dpdx, frame.dpdy, n).flip_sign);"},
                     {kFile, "SgFrame(frame.position, n, frame.dpdx",
                      "SgFrame(frame.position, frame.normal, frame.dpdx"}}},
    };
}

std::vector<Case> normal_cases() {
    return {
        {.name = "base_normal",
         .include = kFile,
         .inputs = 3,
         .outputs = 3,
         .glsl = "put(0, sg_base_normal(v3(0)));",
         .draw = draw_any_length,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::base_normal(in.v3(0))); },
         // A dot product (3 roundings, halved by the root), the inverse root (2) and the product (1).
         .bound = {.absolute = 10 * kUlp},
         .property = unit,
         .mutants = {{kFile, "vertex_normal * inversesqrt(square)", "vertex_normal"}}},
        {.name = "base_normal_any_input",
         .include = kFile,
         .inputs = 3,
         .outputs = 3,
         .glsl = "put(0, sg_base_normal(v3(0)));",
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 3; ++k) in.put(k, random.wild());
             },
         .property = unit,
         .mutants = {{kFile, "square > 1e-30 && square < 1e30", "square > 1e-30"},
                     {kFile, "square > 1e-30 && square < 1e30", "square < 1e30"}}},
        {.name = "mirror_normal",
         .include = kFile,
         .inputs = 4,
         .outputs = 3,
         .glsl = "put(0, sg_mirror_normal(v3(0), f(3)));",
         .draw = [](Random& random, Draw& in) { in.put(0, random.direction()), in.put(3, random.sign()); },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::mirror_normal(in.v3(0), in[3])); },
         .bound = {.absolute = 1e-30}},  // a product with 1 or -1 is exact
    };
}

SG_PROVE(Frame, frame_cases());
SG_PROVE(Normal, normal_cases());

}  // namespace
}  // namespace sg::proof
