// The published reference's defects that concern frames, bases and normals: each formula, in our own words,
// breaks where the library holds. (Others stand with their concepts: DerivPublished, HeightMapPublished, and
// more.)
#include "camera.hpp"
#include "draws.hpp"
#include "ir/reference/analytic_derivatives.hpp"
#include "ir/reference/from_normal.hpp"
#include "published.hpp"

namespace sg::proof {
namespace {

// Defect 1. A level camera above a level plane with the depth range 0.1 to infinity; the point lies at a
// given view depth.
Case distant_plane(double view_depth) {
    Camera camera;
    camera.depth = Depth::reversed_infinite;
    const glm::dmat4 screen = camera.relative_from_screen(), clip = camera.clip_from_relative();
    auto put = [](Draw& in, std::size_t at, const glm::dmat4& m) {
        for (int c = 0; c < 4; ++c) in.put(at + 4 * static_cast<std::size_t>(c), m[c]);
    };
    return {.name = "distant_plane",
            .include = "surfgrad/analytic_derivatives.glsl",
            .inputs = 46,
            .outputs = 6,
            .glsl =
                "float w = (m4(26) * vec4(v3(0), 1.0)).w; SgScreenDerivatives d ="
                "sg_analytic_derivatives(v3(0), v3(3), v3(6), m4(10), w); put(0, d.dpdx); put(3, d.dpdy);",
            .draw =
                [=](Random& random, Draw& in) {
                    const glm::dvec3 position = draw_point(random, camera, view_depth);
                    const glm::dvec3 view = camera.view(position);
                    const glm::dvec3 n = glm::normalize(view + 0.7 * tangent_of(random, view));
                    in.put(0, position), in.put(3, n), in.put(6, view);
                    put(in, 10, screen), put(in, 26, clip);
                    const glm::dvec4 seen = glm::inverse(screen) * glm::dvec4(position, 1.0);
                    in.put(42, glm::dvec2(seen) / seen.w);
                },
            .reference =
                [=](const In& in, Expect& out) {
                    const auto d = ref::analytic_derivatives(in.v3(0), in.v3(3), screen);
                    out.put(0, d.dpdx), out.put(3, d.dpdy);
                },
            .bound = {.absolute = 0.01},  // one percent
            .condition =
                [=](const In& in) {
                    const auto d = ref::analytic_derivatives(in.v3(0), in.v3(3), screen);
                    return std::min(glm::length(d.dpdx), glm::length(d.dpdy));
                }};
}

// Meet the pixel's ray with the plane in homogeneous coordinates, then the quotient rule, with a guard on the
// square of w.
constexpr const char* kHomogeneous = R"(
void published(vec3 p, vec3 n, mat4 m, vec2 pixel, out vec3 dpdx, out vec3 dpdy) {
    vec4 plane = vec4(n, -dot(p, n)) * m;
    vec4 per_x = m[0] - m[2] * (plane.x / plane.z);
    vec4 per_y = m[1] - m[2] * (plane.y / plane.z);
    vec4 at = per_x * pixel.x + per_y * pixel.y + m[3] - m[2] * (plane.w / plane.z);
    float square = max(1.192093e-7, at.w * at.w);
    dpdx = (per_x.xyz * at.w - at.xyz * per_x.w) / square;
    dpdy = (per_y.xyz * at.w - at.xyz * per_y.w) / square;
}
)";
constexpr const char* kHomogeneousCall =
    "vec3 x, y; published(v3(0), v3(3), m4(10), v2(42), x, y); put(0, x); put(3, y);";

double published_part(double view_depth) {
    Case item = distant_plane(view_depth);
    item.declarations = kHomogeneous, item.glsl = kHomogeneousCall;
    const std::vector<float> inputs = draw_inputs(item, 1);
    const std::vector<float> got = evaluate(item, inputs);
    const auto expected = ref::analytic_derivatives(In(inputs).v3(0), In(inputs).v3(3),
                                                    [] {
                                                        Camera c;
                                                        c.depth = Depth::reversed_infinite;
                                                        return c;
                                                    }()
                                                        .relative_from_screen());
    return glm::length(In(got).v3(0)) / glm::length(expected.dpdx);
}

TEST(AnalyticDerivativesPublished, AreTooSmallFromADepthOf2896On) {
    for (double depth : {4000.0, 20000.0})
        expect_only_library_holds(distant_plane(depth), kHomogeneous, kHomogeneousCall);
    // The square root of the guard, 3.45e-4, is one over 2896: beyond, a square takes its place.
    EXPECT_NEAR(published_part(2000.0), 1.0, 0.05);
    EXPECT_NEAR(published_part(4000.0), 2896.3 * 2896.3 / (4000.0 * 4000.0), 0.05);
    EXPECT_NEAR(published_part(20000.0), 0.021, 0.005);
}

// Defect 3, second half: the tangent is normalised whenever the determinant is not exactly zero.
constexpr const char* kUnguardedBasis = R"(
SgBasis published(SgFrame frame, SgUv uv) {
    float det = uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x;
    float s = det < 0.0 ? -1.0 : 1.0;
    vec3 t = s * (uv.dy.y * frame.sigma_x - uv.dx.y * frame.sigma_y);
    if (abs(det) > 0.0) t = normalize(t);
    return SgBasis(t, s * frame.flip_sign * cross(frame.normal, t));
}
)";

Case degenerate_basis(std::string name, std::function<void(Random&, Draw&)> draw) {
    return {
        .name = std::move(name),
        .include = "surfgrad/tbn.glsl",
        .inputs = 15,
        .outputs = 6,
        .glsl = std::string("SgBasis b = sg_basis_uv(") + kFrame + ", " + kUv +
                "); put(0, b.tangent); put(3, b.bitangent);",
        .draw = std::move(draw),
        .reference = [](const In&, Expect& out) { out.put(0, glm::dvec3(0.0)), out.put(3, glm::dvec3(0.0)); },
        .bound = {.absolute = 1e-30}};
}
const std::string kPublishedBasis = std::string("SgBasis b = published(") + kFrame + ", " + kUv +
                                    "); put(0, b.tangent); put(3, b.bitangent);";

TEST(BasisPublished, ASurfaceWithoutAFootprintIsNotANumber) {
    const Case item = degenerate_basis("edge_on", [](Random& random, Draw& in) {
        draw_frame_and_uv(random, in);
        // Both steps of the position along n: sigma is 0. An axis keeps that exact.
        in.put(0, glm::dvec3(0, 0, 1)), in.put(3, glm::dvec3(0, 0, 0.5)), in.put(6, glm::dvec3(0, 0, -0.25));
    });
    expect_only_library_holds(item, kUnguardedBasis, kPublishedBasis);
}

TEST(BasisPublished, CoordinatesOnALineGiveSpeckles) {
    const Case item = degenerate_basis("collinear", [](Random& random, Draw& in) {
        draw_frame_and_uv(random, in);
        // dy is a multiple of dx, up to the rounding of its components: a relative determinant of 1e-7.
        in.put(13, In(in.floats()).v2(11) * random.uniform(0.5, 2.0));
    });
    expect_only_library_holds(item, kUnguardedBasis, kPublishedBasis);
}

// Defect 7, first half: vertex T and B on a resolved normal, as if they were still tangent to it.
TEST(BasisPublished, VertexTangentsAreNotTangentAfterAResolve) {
    const Case item = {.name = "after_resolve",
                       .include = "surfgrad/tbn.glsl",
                       .inputs = 11,
                       .outputs = 1,
                       .glsl =
                           "SgBasis b = sg_basis_resolved(sg_basis_vertex(v3(0), v4(3)), v3(7));"
                           "put(0, dot(sg_surfgrad_from_tbn(vec2(0.6, -0.8), b), v3(7)));",
                       .draw =
                           [](Random& random, Draw& in) {
                               const glm::dvec3 n = random.direction();
                               in.put(0, n), in.put(3, tangent_of(random, n)), in.put(6, random.sign());
                               in.put(7, glm::normalize(n + 0.8 * tangent_of(random, n)));
                           },
                       .reference = [](const In&, Expect& out) { out.put(0, 0.0); },
                       .bound = {.absolute = 68 * kUlp}};  // as basis_resolved (prove_tbn.cpp)
    expect_only_library_holds(
        item, "",
        "put(0, dot(sg_surfgrad_from_tbn(vec2(0.6, -0.8), sg_basis_vertex(v3(0), v4(3))), v3(7)));");
}

// Defect 7, second half: the handedness is a fact of the geometry. Determined again from the old steps and a
// normal that a bump turned beyond them, it changes.
TEST(FramePublished, HandednessFromAResolvedNormalTurnsTheBitangent) {
    const Case item = {
        .name = "handedness",
        .include = "surfgrad/frame.glsl",
        .inputs = 12,
        .outputs = 1,
        .glsl = "put(0, sg_frame_resolved(sg_frame(vec3(0.0), v3(3), v3(6), v3(0)), v3(9)).flip_sign);",
        .draw =
            [](Random& random, Draw& in) {
                draw_frame(random, in, 0);
                const In sofar(in.floats());
                // Steps that lean with an interpolated normal, and a bump of up to 80 degrees.
                in.put(9, glm::normalize(sofar.v3(0) +
                                         random.uniform(0.0, 5.0) * tangent_of(random, sofar.v3(0))));
            },
        .reference = [](const In& in, Expect& out) { out.put(0, frame_of(in).flip_sign); },
        .bound = {.absolute = 1e-30}};
    expect_only_library_holds(item, "", "put(0, sg_frame(vec3(0.0), v3(3), v3(6), v3(9)).flip_sign);");
}

// Defect 8: (k n - v) over |k|, where only 1e-7 keeps k from zero.
TEST(FromNormalPublished, GrowsWithoutBoundTowardsTheTangentPlane) {
    const Case item = {
        .name = "grazing",
        .include = "surfgrad/from_normal.glsl",
        .inputs = 6,
        .outputs = 1,
        .glsl = "put(0, length(sg_surfgrad_from_normal(v3(0), v3(3))));",
        .draw =
            [](Random& random, Draw& in) {
                const glm::dvec3 n = random.direction();
                in.put(0, n), in.put(3, tangent_of(random, n) + random.uniform(-1.0, 1.0) * 1e-3 * n);
            },
        .property =
            [](const In&, const In& out) {
                return out[0] <= ref::kMaxSurfgrad * (1.0 + 16 * kUlp) ? "" : "longer than 128";
            }};
    expect_only_library_holds(item,
                              "vec3 published(vec3 n, vec3 v) { float k = dot(n, v); return (k * n - v) / "
                              "max(1.192093e-7, abs(k)); }",
                              "put(0, length(published(v3(0), v3(3))));");
}

}  // namespace
}  // namespace sg::proof
