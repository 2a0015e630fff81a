// Triplanar and planar projection (shader_lib/surfgrad/triplanar.glsl) against double precision.
#include "ir/reference/triplanar.hpp"

#include "ir/reference/from_height.hpp"
#include "ir/reference/from_volume.hpp"
#include "published.hpp"
#include "skipped.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/triplanar.glsl";

using ref::Hand;
using ref::Origin;

Hand hand(double sign) {
    return sign > 0.0 ? Hand::left : Hand::right;
}
Origin origin(double sign) {
    return sign > 0.0 ? Origin::lower_left : Origin::upper_left;
}

// Any normal, with those near the planes' limits and on the axes; k from none to one that underflows.
void draw_weights(Random& random, Draw& in) {
    glm::dvec3 n = random.direction();
    if (random.below(8) == 0) n = glm::round(n);
    if (random.below(8) == 0) n = glm::normalize(glm::dvec3(random.sign(), random.sign(), random.sign()));
    in.put(0, glm::length(n) > 0.0 ? glm::normalize(n) : glm::dvec3(0, 0, 1));
    in.put(3, random.below(8) == 0 ? 0.0 : random.magnitude(0.1, 1000.0));
}

// pow(r, k) = exp2(k log2 r): an error of r, here 3 u of |n| - 0.2 over |n| - 0.2, counts k times; where r^k
// is below 1e-9 it does not count. At k = 0 a plane appears at once when |n| passes 0.2: nothing is asserted
// within rounding of it.
double weight_condition(const In& in) {
    double worst = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double shown = std::abs(in[axis]) - 0.2;
        if (std::abs(shown) < 1e-6 && in[3] < 0.5) return INFINITY;
        const double largest = std::max({std::abs(in[0]), std::abs(in[1]), std::abs(in[2])}) - 0.2;
        const double ratio = std::max(shown, 0.0) / largest;
        if (ratio <= 0.0) continue;
        const double weight = std::pow(ratio, in[3]);
        worst += weight * in[3] * (1.0 / std::max(shown, 1e-7) + std::abs(std::log2(ratio)));
    }
    return worst;
}

std::string shares(const In&, const In& out) {
    const bool inside = out[0] >= 0.0 && out[1] >= 0.0 && out[2] >= 0.0;
    return inside && std::abs(out[0] + out[1] + out[2] - 1.0) < 1e-6 ? "" : "no shares of 1";
}

Case weights() {
    return {
        .name = "triplanar_weights",
        .include = kFile,
        .inputs = 4,
        .outputs = 3,
        .glsl = "put(0, sg_triplanar_weights(v3(0), f(3)));",
        .draw = draw_weights,
        .reference = [](const In& in, Expect& out) { out.put(0, ref::triplanar_weights(in.v3(0), in[3])); },
        // The power 16 (8 of log2, 6 of exp2, 2 around), twice for the sum of which it is a share.
        .bound = {.absolute = 32 * kUlp},
        .condition = weight_condition,
        .property = shares,
        .mutants = {{kFile, "abs(n) - 0.2", "abs(n) - 0.1"},
                    {kFile, "max(k, 1e-9)", "k + 1.0"},
                    {kFile, "vec3 ratio = facing / max(max(facing.x, facing.y), max(facing.z, 1e-30));",
                     "vec3 ratio = facing;"},
                    {kFile, "w / (w.x + w.y + w.z)", "w"}}};
}

// Any vector as a normal still gives shares.
Case wild_weights() {
    Case item = weights();
    item.name = "triplanar_weights_any_input";
    item.draw = [](Random& random, Draw& in) {
        for (std::size_t k = 0; k < 3; ++k) in.put(k, random.wild_number());
        in.put(3, random.coin() ? random.below(5) : random.magnitude(1e-3, 1e6));
    };
    item.reference = {};
    item.condition = {};
    item.mutants = {{kFile, "w.z = max(w.z, 1e-30);", ""}, {kFile, "max(abs(n) - 0.2, 0.0)", "abs(n) - 0.2"}};
    return item;
}

void put_signs(Random& random, Draw& in, std::size_t at) {
    in.put(at, random.sign());
    in.put(at + 1, random.sign());
}

void put_uv(Expect& out, std::size_t at, const ref::Uv& uv) {
    out.put(at, uv.st);
    out.put(at + 2, uv.dx);
    out.put(at + 4, uv.dy);
}

Case coordinates() {
    return {.name = "triplanar_uv",
            .include = kFile,
            .inputs = 11,
            .outputs = 18,
            .glsl =
                "SgTriplanarUv a = sg_triplanar_uv(v3(0), v3(3), v3(6), f(9), f(10));"
                "put(0, a.x.st); put(2, a.x.dx); put(4, a.x.dy);"
                "put(6, a.y.st); put(8, a.y.dx); put(10, a.y.dy);"
                "put(12, a.z.st); put(14, a.z.dx); put(16, a.z.dy);",
            .draw =
                [](Random& random, Draw& in) {
                    for (std::size_t k = 0; k < 9; k += 3) in.put(k, random.within(10.0));
                    put_signs(random, in, 9);
                },
            .reference =
                [](const In& in, Expect& out) {
                    ref::TriplanarUv uv =
                        ref::triplanar_uv(in.v3(0), in.v3(3), in.v3(6), hand(in[9]), origin(in[10]));
                    put_uv(out, 0, uv.x);
                    put_uv(out, 6, uv.y);
                    put_uv(out, 12, uv.z);
                },
            .bound = {},  // signs and a choice of components: exact
            .mutants = {{kFile, "vec3 turn = vec3(1.0, origin, hand);", "vec3 turn = vec3(1.0, 1.0, hand);"},
                        {kFile, "vec2(1.0, origin * hand)", "vec2(1.0, hand)"},
                        {kFile, "along_y * p.xz, along_y * dpdx.xz", "along_y * p.zx, along_y * dpdx.zx"},
                        {kFile, "SgUv(q.xy, qx.xy, qy.xy)", "SgUv(q.xy, qy.xy, qx.xy)"}}};
}

Case gradient() {
    return {.name = "triplanar_gradient",
            .include = kFile,
            .inputs = 11,
            .outputs = 3,
            .glsl = "put(0, sg_triplanar_gradient(v3(0), v2(3), v2(5), v2(7), f(9), f(10)));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, glm::abs(random.within(1.0)));
                    for (std::size_t k = 3; k < 9; ++k) in.put(k, random.uniform(-4.0, 4.0));
                    put_signs(random, in, 9);
                },
            .reference =
                [](const In& in, Expect& out) {
                    out.put(0, ref::triplanar_gradient(in.v3(0), in.v2(3), in.v2(5), in.v2(7), hand(in[9]),
                                                       origin(in[10])));
                },
            // Two products below 4 and their sum: 4 + 4 + 8 halves of u, doubled.
            .bound = {.absolute = 16 * kUlp},
            .mutants = {{kFile, "wz * d_z.x + wy * d_y.x", "wz * d_z.x + wx * d_y.x"},
                        {kFile, "origin * (wz * d_z.y + wx * d_x.y)", "wz * d_z.y + wx * d_x.y"},
                        {kFile, "origin * wy * d_y.y", "wy * d_y.y"}}};
}

Case planar() {
    return {.name = "planar",
            .include = kFile,
            .inputs = 14,
            .outputs = 9,
            .glsl =
                "int axis = int(f(11)); SgUv a = sg_planar_uv(v3(0), v3(3), v3(6), axis, f(9), f(10));"
                "put(0, a.st); put(2, a.dx); put(4, a.dy);"
                "put(6, sg_planar_gradient(v2(12), axis, f(9), f(10)));",
            .draw =
                [](Random& random, Draw& in) {
                    for (std::size_t k = 0; k < 9; k += 3) in.put(k, random.within(10.0));
                    put_signs(random, in, 9);
                    in.put(11, random.below(3));
                    in.put(12, glm::dvec2(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0)));
                },
            .reference =
                [](const In& in, Expect& out) {
                    const int axis = static_cast<int>(in[11]);
                    put_uv(out, 0,
                           ref::planar_uv(in.v3(0), in.v3(3), in.v3(6), axis, hand(in[9]), origin(in[10])));
                    out.put(6, ref::planar_gradient(in.v2(12), axis, hand(in[9]), origin(in[10])));
                },
            .bound = {},  // as triplanar_uv; the weights are 0 and 1
            .mutants = {{kFile, "if (axis == 0) chosen = planes.x;", ""}}};
}

std::vector<Case> cases() {
    return {weights(), wild_weights(), coordinates(), gradient(), planar()};
}

SG_PROVE(Triplanar, cases());

TEST(Triplanar, FewNormalsSitOnAPlanesLimit) {
    expect_few_skipped(weights(), 0.01);
}

TEST(Triplanar, GoldenWeights) {
    const double golden[] = {0.0011902, 0.1464178, 0.8523920};
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, 3));
    const std::vector<float> in = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z),
                                   3.0f};
    const std::vector<float> shader = evaluate(weights(), in);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(shader[static_cast<std::size_t>(k)], golden[k], 1e-5);
        EXPECT_NEAR(ref::triplanar_weights(n, 3.0)[k], golden[k], 1e-7);
    }
}

// One bump in space, h(p), seen by each plane as an image: whatever hand and origin, the derivative of that
// image along its own +s and +t, carried back, is the bump's gradient in the plane; so all four combinations
// agree on all six faces.
TEST(Triplanar, HandAndOriginDoNotShow) {
    Random random("hand_and_origin");
    auto height = [](glm::dvec3 p) {
        return std::sin(p.x) + std::cos(1.3 * p.y + 0.2) + std::sin(0.7 * p.z - 0.4);
    };
    for (int i = 0; i < 600; ++i) {
        glm::dvec3 n(0.0);
        n[i % 3] = i % 6 < 3 ? 1.0 : -1.0;
        const glm::dvec3 p = random.within(3.0), w = ref::triplanar_weights(n, 3.0);
        glm::dvec3 first(0.0);
        for (int combination = 0; combination < 4; ++combination) {
            const Hand h = combination % 2 == 0 ? Hand::right : Hand::left;
            const Origin o = combination < 2 ? Origin::upper_left : Origin::lower_left;
            glm::dvec2 d[3];
            for (int axis = 0; axis < 3; ++axis) {
                // The image's pixel one step further along s or t shows the point whose coordinate is st +
                // step.
                const glm::dvec3 along_s = ref::planar_gradient({1, 0}, axis, h, o),
                                 along_t = ref::planar_gradient({0, 1}, axis, h, o);
                const double e = 1e-5;
                d[axis] = {(height(p + e * along_s) - height(p - e * along_s)) / (2 * e),
                           (height(p + e * along_t) - height(p - e * along_t)) / (2 * e)};
                const glm::dvec2 seen = ref::planar_uv(p + along_s, {}, {}, axis, h, o).st -
                                        ref::planar_uv(p, {}, {}, axis, h, o).st;
                EXPECT_LT(glm::length(seen - glm::dvec2(1, 0)), 1e-12);
            }
            const glm::dvec3 g =
                ref::surfgrad_from_volume(n, ref::triplanar_gradient(w, d[0], d[1], d[2], h, o));
            if (combination == 0) first = g;
            EXPECT_LT(glm::length(g - first), 1e-12);
            const double e = 1e-5;
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 step(0.0);
                step[axis] = e;
                const double slope = (height(p + step) - height(p - step)) / (2 * e);
                EXPECT_NEAR(g[axis], axis == i % 3 ? 0.0 : slope, 1e-9);
            }
        }
    }
}

// The gradient is that of the blended heights sum w H(st), by differences, with the weights held (Eq 19).
TEST(TriplanarReference, GradientIsDifferenceOfHeights) {
    Random random("triplanar_differences");
    auto image = [](glm::dvec2 st, double phase) {
        return std::sin(st.x + phase) * std::cos(0.8 * st.y - phase);
    };
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 p = random.within(3.0), w = ref::triplanar_weights(random.direction(), 2.0);
        const Hand h = random.coin() ? Hand::right : Hand::left;
        const Origin o = random.coin() ? Origin::upper_left : Origin::lower_left;
        auto height = [&](glm::dvec3 q) {
            double sum = 0.0;
            for (int axis = 0; axis < 3; ++axis)
                sum += w[axis] * image(ref::planar_uv(q, {}, {}, axis, h, o).st, axis);
            return sum;
        };
        glm::dvec2 d[3];
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec2 st = ref::planar_uv(p, {}, {}, axis, h, o).st;
            d[axis] = {std::cos(st.x + axis) * std::cos(0.8 * st.y - axis),
                       -0.8 * std::sin(st.x + axis) * std::sin(0.8 * st.y - axis)};
        }
        const glm::dvec3 gradient = ref::triplanar_gradient(w, d[0], d[1], d[2], h, o);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = 1e-5;
            EXPECT_NEAR(gradient[axis], (height(p + step) - height(p - step)) / 2e-5, 1e-6);
        }
    }
}

// E: the weighted sum of three scale-dependent surface gradients is the projected volume gradient, when the
// frame's steps are perpendicular to the normal.
TEST(Triplanar, SumOfSurfaceGradientsIsTheVolumeForm) {
    Random random("triplanar_volume");
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 n = random.direction(), w = ref::triplanar_weights(n, 3.0);
        const glm::dvec3 step_x = ref::reject(random.direction(), n),
                         step_y = ref::reject(random.direction(), n);
        if (glm::length(glm::cross(step_x, step_y)) < 0.05) continue;
        const ref::Frame frame = ref::frame({}, step_x, step_y, n);
        glm::dvec2 d[3];
        glm::dvec3 sum(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
            const ref::Uv uv = ref::planar_uv({}, step_x, step_y, axis, Hand::right, Origin::upper_left);
            sum += w[axis] * ref::surfgrad_from_screen_height(
                                 frame, {glm::dot(d[axis], uv.dx), glm::dot(d[axis], uv.dy)});
        }
        const glm::dvec3 volume =
            ref::triplanar_gradient(w, d[0], d[1], d[2], Hand::right, Origin::upper_left);
        EXPECT_LT(glm::length(sum - ref::surfgrad_from_volume(n, volume)), 1e-10);
    }
}

// Defect 5: powers of small numbers underflow before they are divided, and 0^0 is undefined.
TEST(TriplanarPublished, WeightsUnderflow) {
    expect_only_library_holds(weights(), "",
                              "vec3 w = max(abs(v3(0)) - 0.2, 0.0); w = pow(w, vec3(f(3)));"
                              "put(0, w / (w.x + w.y + w.z));");
}

}  // namespace
}  // namespace sg::proof
