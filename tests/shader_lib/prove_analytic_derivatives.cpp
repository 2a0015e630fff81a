// Screen derivatives without derivative instructions (shader_lib/surfgrad/analytic_derivatives.glsl): against
// the difference of neighbouring pixels on the plane, for every kind of camera up to a distance of 20000.
#include "camera.hpp"
#include "draws.hpp"
#include "ir/reference/analytic_derivatives.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/analytic_derivatives.glsl";

// Where things stand in the input: position, n, view, facing, the two matrices, the camera (for the reference
// alone).
constexpr std::size_t kNormal = 3, kView = 6, kFacing = 9, kScreen = 10, kClip = 26, kCamera = 42;
constexpr int kInputs = 42 + static_cast<int>(Camera::kFloats);

void put_matrix(Draw& in, std::size_t at, const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) in.put(at + 4 * static_cast<std::size_t>(column), m[column]);
}

// side: +1 for a plane that faces the viewer, -1 for one that faces away.
void draw_seen_plane(Random& random, Draw& in, double least_cosine, double side) {
    const Camera camera = draw_camera(random);
    const glm::dvec3 position = draw_point(random, camera, random.magnitude(1.5, 20000.0));
    const glm::dvec3 view = camera.view(position);
    const double cosine = random.uniform(least_cosine, 1.0);
    const glm::dvec3 n = side * cosine * view + std::sqrt(1.0 - cosine * cosine) * tangent_of(random, view);
    in.put(0, position), in.put(kNormal, n), in.put(kView, view), in.put(kFacing, 1.0);
    put_matrix(in, kScreen, camera.relative_from_screen());
    put_matrix(in, kClip, camera.clip_from_relative());
    camera.pack(in, kCamera);
}

void draw_facing(Random& random, Draw& in) {
    draw_seen_plane(random, in, 0.02, 1.0);
}

ref::ScreenDerivatives expected_of(const In& in, glm::dvec3 n) {
    return ref::analytic_derivatives(in.v3(0), n, Camera::unpack(in, kCamera).relative_from_screen());
}

// A pixel's size at the point, over the square of the cosine: the slide along the ray is 1/cosine long, and
// rounding of the two unit vectors moves the cosine in its turn.
double slant(const In& in) {
    const Camera camera = Camera::unpack(in, kCamera);
    const double reach = camera.orthographic ? 1.0 : glm::length(in.v3(0));
    const double pixel = 2.0 * camera.half_height * reach / camera.viewport.y;
    const double cosine = glm::dot(in.v3(kNormal), in.v3(kView));
    return pixel / (cosine * cosine);
}

// Pixel vectors (matrix 1, product 1, clip w 7 with its rounded row) and their part along n (4); the cosine
// (4, and 4 for the rounded n and view); slide, product and difference (3); the reference's central
// difference adds 1e-8 at most.
constexpr Bound kBound = {.absolute = 48 * kUlp + 1e-8};

constexpr const char* kDerivatives =
    "vec3 n = sg_facing_normal(v3(3), v3(6)); float w = (m4(26) * vec4(v3(0), 1.0)).w;"
    "SgScreenDerivatives d = sg_analytic_derivatives(v3(0), n, v3(6), m4(10), w); put(0, d.dpdx); put(3, "
    "d.dpdy);";

std::string whole_frame(const In& in, const In& out) {
    const glm::dvec3 n = in.v3(kNormal);
    const double length = glm::length(out.v3(0)) + glm::length(out.v3(3));
    const bool tangent =
        std::abs(glm::dot(out.v3(6), n)) + std::abs(glm::dot(out.v3(9), n)) <= 28 * kUlp * length;
    return tangent ? "" : "sigma is not perpendicular to n";
}

std::vector<Case> plane_cases() {
    return {
        {.name = "facing_normal",
         .include = kFile,
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_facing_normal(v3(0), v3(3)));",
         .draw = [](Random& random,
                    Draw& in) { in.put(0, random.direction()), in.put(3, random.direction()); },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::facing_normal(in.v3(0), in.v3(3))); },
         .bound = {.absolute = 20 * kUlp},  // a dot product (3), products (2) and a difference up to 2 (1);
                                            // unit length (4)
         .property =
             [](const In& in, const In& out) {
                 return is_unit(out.v3(0)) && glm::dot(out.v3(0), in.v3(3)) > -1e-6
                            ? ""
                            : "not a unit vector towards the viewer";
             },
         .mutants = {{kFile, "min(dot(n, view), 0.0)", "max(dot(n, view), 0.0)"},
                     {kFile, "n - 2.0 * min", "n - min"}}},
        {.name = "analytic_derivatives",
         .include = kFile,
         .inputs = kInputs,
         .outputs = 6,
         .glsl = kDerivatives,
         .draw = draw_facing,
         .reference =
             [](const In& in, Expect& out) {
                 const ref::ScreenDerivatives d = expected_of(in, in.v3(kNormal));
                 out.put(0, d.dpdx), out.put(3, d.dpdy);
             },
         .bound = kBound,
         .condition = slant,
         .mutants = {{kFile, "vec3 across = clip_w * (", "vec3 across = ("}}},
    };
}

std::vector<Case> frame_cases() {
    return {
        {.name = "analytic_derivatives_facing_away",
         .include = kFile,
         .inputs = kInputs,
         .outputs = 6,
         .glsl = kDerivatives,
         .draw = [](Random& random, Draw& in) { draw_seen_plane(random, in, 0.02, -1.0); },
         .reference =
             [](const In& in, Expect& out) {
                 const glm::dvec3 mirrored = glm::reflect(in.v3(kNormal), in.v3(kView));
                 const ref::ScreenDerivatives d = expected_of(in, mirrored);
                 out.put(0, d.dpdx), out.put(3, d.dpdy);
             },
         .bound = {.absolute = kBound.absolute + 20 * kUlp},  // and the mirroring
         .condition = slant,
         .mutants = {{kFile, "min(dot(n, view), 0.0)", "0.0"}}},
        {.name = "frame_rebuilt",
         .include = kFile,
         .inputs = kInputs,
         .outputs = 16,
         .glsl = "SgFrame frame = sg_frame_rebuilt(v3(0), v3(3), f(9), v3(6), m4(10), m4(26));"
                 "put(0, frame.dpdx); put(3, frame.dpdy); put(6, frame.sigma_x); put(9, frame.sigma_y);"
                 "put(12, frame.flip_sign); put(13, frame.normal);",
         .draw =
             [](Random& random, Draw& in) {
                 // The back of a "flip" surface, or a front.
                 const double facing = random.sign();
                 draw_seen_plane(random, in, 0.02, facing);
                 in.put(kFacing, facing);
             },
         .reference =
             [](const In& in, Expect& out) {
                 const Camera camera = Camera::unpack(in, kCamera);
                 const ref::Frame frame = ref::frame_rebuilt(in.v3(0), in.v3(kNormal), in[kFacing],
                                                             in.v3(kView), camera.relative_from_screen());
                 out.put(0, frame.dpdx), out.put(3, frame.dpdy), out.put(6, frame.sigma_x),
                     out.put(9, frame.sigma_y);
                 out.put(12, frame.flip_sign), out.put(13, frame.normal);
             },
         .bound = {.absolute = kBound.absolute + 14 * kUlp},  // and a projection
         .condition = slant,
         .property = whole_frame,
         .mutants = {{kFile, "sg_facing_normal(facing * n, view)", "sg_facing_normal(n, view)"},
                     {kFile, "dot(n, cross(d.dpdx,", "dot(plane, cross(d.dpdx,"}}},
    };
}

// An interpolated normal that leans away from the viewer: the pixel shows another plane than n's, and sigma
// is what that plane's steps have in n's.
Case facing_away_case() {
    Case item = frame_cases().back();
    item.name = "frame_rebuilt_facing_away";
    item.draw = [](Random& random, Draw& in) {
        const double facing = random.sign();
        draw_seen_plane(random, in, 0.02, -facing);
        in.put(kFacing, facing);
    };
    item.bound.absolute += 20 * kUlp;  // and the mirroring
    item.mutants = {};
    return item;
}

std::vector<Case> cases() {
    return joined(joined(plane_cases(), frame_cases()), {facing_away_case()});
}

std::vector<Case> edge_on_cases() {
    return {{.name = "analytic_derivatives_edge_on",
             .include = kFile,
             .inputs = kInputs,
             .outputs = 6,
             .glsl = kDerivatives,
             .draw =
                 [](Random& random, Draw& in) {
                     draw_facing(random, in);
                     const In sofar(in.floats());
                     const double cosine = random.coin() ? 0.0 : random.sign() * random.magnitude(1e-9, 1e-3);
                     in.put(kNormal, tangent_of(random, sofar.v3(kView)) + cosine * sofar.v3(kView));
                 },
             .property =
                 [](const In&, const In& out) {
                     return is_finite(out.v3(0)) && is_finite(out.v3(3)) && glm::length(out.v3(0)) < 1e10
                                ? ""
                                : "not finite";
                 },
             .mutants = {{kFile, "view / max(dot(n, view), SG_EDGE_ON_COSINE)", "view / dot(n, view)"}}}};
}

SG_PROVE(AnalyticDerivatives, cases());
SG_PROVE(AnalyticDerivativesEdgeOn, edge_on_cases());

}  // namespace
}  // namespace sg::proof
