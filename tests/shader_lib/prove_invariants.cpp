// The invariants of the specification's section 1, for every producer of a surface gradient: ONE table, a row
// per producer, a column per invariant. A cell says kHolds, and then is a test of its own, or why the
// invariant does not concern the producer; a row without one of its cells does not compile.
#include <algorithm>
#include <array>

#include "conditions.hpp"
#include "library_index.hpp"
#include "place.hpp"

namespace sg::proof {
namespace {

enum Invariant {
    kTangential,
    kLinear,
    kOdd,
    kMirroredU,
    kMirroredV,
    kTurned,
    kViewport,
    kUnit,
    kOutward,
    kInvariants
};
constexpr std::array<const char*, kInvariants> kInvariantNames = {"tangential",      "linear",     "odd",
                                                                  "mirrored_u",      "mirrored_v", "turned",
                                                                  "viewport_turned", "unit",       "outward"};

constexpr std::string_view kHolds = "holds";
constexpr std::string_view kNoUv = "no texture coordinate is involved";
constexpr std::string_view kNoScreen = "no screen derivative is involved";
constexpr std::string_view kNoStrength = "a stored normal has no strength: section 1 excepts from_normal";

struct Producer {
    std::string_view name;
    std::string_view include;
    std::string_view glsl;  // g of k times the height at the place p
    // What rounding may make of g: so many kUlp times the condition.
    double roundings;
    double (*condition)(const In&);
    std::array<std::string_view, kInvariants> cells;
    bool textures = false;
    bool conformal = false;  // a turn keeps g where s and t are perpendicular and as long (TBN style)
};

double tbn_size(const In& in) {
    return glm::length(in.v2(kDerivAt)) * cancellation(in);
}
double vertex_size(const In& in) {
    return glm::length(in.v2(kDerivAt));
}
double resolved_size(const In& in) {
    const glm::dvec3 t = in.v3(kTangentAt), n = in.v3(kNormalAt);
    return glm::length(in.v2(kDerivAt)) * glm::length(t) / glm::length(glm::cross(t, n));
}
double normal_size(const In& in) {
    const double cosine = glm::dot(in.v3(0), glm::normalize(in.v3(kVectorAt)));
    return 1.0 + 1.0 / std::max(cosine * cosine, 1.0 / (128.0 * 128.0));
}
double screen_size(const In& in) {
    return inversion(frame_of(in), in.v2(kScreenAt));
}
// The slopes of a derivative d per texel of `texels`, with the shares of the chain rule that may cancel, also
// after a turn.
double slopes(const In& in, glm::dvec2 d, double texels) {
    const ref::Uv uv = uv_of(in);
    return 2.0 * texels * glm::length(d) * inversion(frame_of(in), {glm::length(uv.dx), glm::length(uv.dy)});
}
double height_size(const In& in) {
    return slopes(in, in.v2(kDerivAt), 256.0);
}
// A read of the ramp is off by 12 kUlp of a height of 1 (prove_height_map.cpp); a texel's slope is 1/128.
double tap_size(const In& in) {
    const ref::Uv uv = uv_of(in);
    const double step = kTexels * std::min(glm::length(uv.dx), glm::length(uv.dy));
    return slopes(in, kRamp, kTexels) * (1.0 + 128.0 / step);
}
double map_size(const In& in) {
    return cancellation(in);
}
double volume_size(const In& in) {
    return glm::length(in.v3(kVectorAt));
}
double noise_size(const In&) {
    return 4.0 * 4.0;  // octaves of gradients up to 4
}
double decal_size(const In& in) {
    return 16.0 * glm::length(in.v2(kDerivAt));
}
double sum_size(const In& in) {
    return tbn_size(in) + volume_size(in);
}

constexpr Producer kProducers[] = {
    {"tbn_uv",
     "surfgrad/tbn.glsl",
     "sg_surfgrad_from_tbn(k * p.d, sg_basis_uv(p.frame, p.uv))",
     42,
     tbn_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds},
     false,
     true},
    {"tbn_vertex",
     "surfgrad/tbn.glsl",
     "sg_surfgrad_from_tbn(k * p.d, sg_basis_vertex(p.frame.normal, p.tangent))",
     42,
     vertex_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kNoScreen, kHolds,
      "section 1 excepts interpolated tangents, which need not be perpendicular to n"}},
    {"tbn_resolved",
     "surfgrad/tbn.glsl",
     "sg_surfgrad_from_tbn(k * p.d, sg_basis_resolved(sg_basis_vertex(p.v, p.tangent), p.frame.normal))",
     68,
     resolved_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds,
      "T is projected and B made from it: on the tilted plane that is TBN style under shear, which section 1 "
      "excepts",
      kNoScreen, kHolds, kHolds}},
    {"from_normal",
     "surfgrad/from_normal.glsl",
     "sg_surfgrad_from_normal(p.frame.normal, p.v)",
     36,
     normal_size,
     {kHolds, kNoStrength, kNoStrength, kNoUv, kNoUv, kNoUv, kNoScreen, kHolds, kHolds}},
    {"from_screen_height",
     "surfgrad/from_height.glsl",
     "sg_surfgrad_from_screen_height(p.frame, k * p.dh)",
     48,
     screen_size,
     {kHolds, kHolds, kHolds, kNoUv, kNoUv, kNoUv, kHolds, kHolds, kHolds}},
    {"from_height",
     "surfgrad/from_height.glsl",
     "sg_surfgrad_from_height(p.frame, p.uv, vec2(256.0), k * p.d)",
     92,
     height_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds}},
    {"from_three_taps",
     "surfgrad/from_height.glsl",
     "sg_surfgrad_from_screen_height(p.frame, k * PICK(sg_screen_height_three_tap, p))",
     48,
     tap_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds},
     true},
    {"tbn_of_height_map",
     "surfgrad/tbn.glsl surfgrad/height_map.glsl",
     "sg_surfgrad_from_tbn(k * PICK(sg_deriv_from_height, p), sg_basis_uv(p.frame, p.uv))",
     66,
     map_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds},
     true,
     true},
    {"tbn_of_height_map_hq",
     "surfgrad/tbn.glsl surfgrad/height_map.glsl",
     "sg_surfgrad_from_tbn(k * PICK(sg_deriv_from_height_hq, p), sg_basis_uv(p.frame, p.uv))",
     66,
     map_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds},
     true,
     true},
    {"from_volume",
     "surfgrad/from_volume.glsl",
     "sg_surfgrad_from_volume(p.frame.normal, k * p.v)",
     26,
     volume_size,
     {kHolds, kHolds, kHolds, kNoUv, kNoUv, kNoUv, kNoScreen, kHolds, kHolds}},
    {"noise",
     "surfgrad/from_volume.glsl surfgrad/volume.glsl",
     "sg_surfgrad_from_volume(p.frame.normal, k * sg_noise_power(sg_volume_turbulence("
     "SgVolume(p.v, p.frame.dpdx, p.frame.dpdy), 3), 2.0).gradient)",
     26,
     noise_size,
     {kHolds, kHolds, kHolds, kNoUv, kNoUv, kNoUv, kHolds, kHolds, kHolds}},
    {"triplanar",
     "surfgrad/from_volume.glsl surfgrad/triplanar.glsl",
     "sg_surfgrad_from_volume(p.frame.normal, sg_triplanar_gradient(sg_triplanar_weights(p.frame.normal, "
     "3.0), k * p.d,"
     " k * p.d.yx, -k * p.d, SG_RIGHT_HAND, SG_UPPER_LEFT))",
     42,
     vertex_size,
     {kHolds, kHolds, kHolds,
      "who tiles negatively negates d; hands and origins: Triplanar.HandAndOriginDoNotShow",
      "who tiles negatively negates d; hands and origins: Triplanar.HandAndOriginDoNotShow",
      "the axes of the three planes are fixed", kNoScreen, kHolds, kHolds}},
    {"planar",
     "surfgrad/from_volume.glsl surfgrad/triplanar.glsl",
     "sg_surfgrad_from_volume(p.frame.normal, sg_planar_gradient(k * p.d, 1, SG_RIGHT_HAND, SG_UPPER_LEFT))",
     42,
     vertex_size,
     {kHolds, kHolds, kHolds,
      "who tiles negatively negates d; hands and origins: Triplanar.HandAndOriginDoNotShow",
      "who tiles negatively negates d; hands and origins: Triplanar.HandAndOriginDoNotShow",
      "the axes of the plane are fixed", kNoScreen, kHolds, kHolds}},
    {"decal_box",
     "surfgrad/from_volume.glsl surfgrad/decal.glsl",
     "sg_surfgrad_from_volume(p.frame.normal, sg_decal_gradient(k * p.d, sg_decal_box(p.projector, "
     "p.frame.position,"
     " p.frame.dpdx, p.frame.dpdy)))",
     64,
     decal_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds}},
    {"decal_cone",
     "surfgrad/from_volume.glsl surfgrad/decal.glsl",
     "sg_surfgrad_from_volume(p.frame.normal, sg_decal_gradient_scaled(k * p.d, sg_decal_cone(p.projector,"
     " p.frame.position, p.frame.dpdx, p.frame.dpdy), vec2(1.0), 1.0))",
     64,
     decal_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds}},
    {"decal_sphere",
     "surfgrad/from_volume.glsl surfgrad/decal.glsl",
     "sg_surfgrad_from_volume(p.frame.normal, sg_decal_gradient(k * p.d, sg_decal_sphere(p.projector,"
     " p.frame.position, p.frame.dpdx, p.frame.dpdy)))",
     64,
     decal_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, "the faces of the cube are fixed to the projector", kHolds,
      kHolds, kHolds}},
    {"combinations",
     "surfgrad/tbn.glsl surfgrad/from_volume.glsl surfgrad/combine.glsl",
     "sg_combine_mix(sg_combine_add(sg_surfgrad_from_tbn(k * p.d, sg_basis_uv(p.frame, p.uv)),"
     " sg_combine_scale(sg_surfgrad_from_volume(p.frame.normal, k * p.v), -0.5)),"
     " sg_combine_mask(sg_surfgrad_from_volume(p.frame.normal, k * p.v), 0.25), 0.3)",
     60,
     sum_size,
     {kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds, kHolds},
     false,
     true},
};

constexpr bool every_cell_is_filled() {
    for (const Producer& producer : kProducers) {
        for (std::string_view cell : producer.cells) {
            if (cell != kHolds && cell.size() < 12) return false;
        }
    }
    return true;
}
static_assert(every_cell_is_filled(), "a producer does not answer an invariant");

const char* statement_of(Invariant invariant) {
    switch (invariant) {
        case kTangential:
            return "put(0, gradient(p, 1.0));";
        case kLinear:
            return "put(0, gradient(p, f(26)) - f(26) * gradient(p, 1.0));";
        case kOdd:
            return "put(0, gradient(p, -1.0) + gradient(p, 1.0));";
        case kMirroredU:
            return "put(0, gradient(mirrored_u(p), 1.0) - gradient(p, 1.0));";
        case kMirroredV:
            return "put(0, gradient(mirrored_v(p), 1.0) - gradient(p, 1.0));";
        case kTurned:
            return "put(0, gradient(turned(p), 1.0) - gradient(p, 1.0));";
        case kViewport:
            return "put(0, gradient(viewport_turned(p), 1.0) - gradient(p, 1.0));";
        default:
            return "put(0, sg_resolve(v3(0), gradient(p, 1.0)));";
    }
}

Case case_of(const Producer& producer, Invariant invariant) {
    Case item = {.name = std::string(producer.name) + "_" + kInvariantNames[invariant],
                 .include = std::string(producer.include) +
                            " surfgrad/frame.glsl surfgrad/uv.glsl surfgrad/resolve.glsl",
                 .inputs = kSize,
                 .outputs = 3,
                 .count = 20000};
    item.declarations = std::string(kPlaceGlsl) + (producer.textures ? kLookupsGlsl : "") +
                        "vec3 gradient(Place p, float k) { return " + std::string(producer.glsl) + "; }\n";
    item.glsl = std::string("Place p = place(); ") + statement_of(invariant);
    if (producer.textures) item.textures = ramp_of_places();
    if (invariant == kUnit || invariant == kOutward) {
        item.draw = draw_anywhere;
        item.property = invariant == kUnit ? unit : unit_and_outward;
        return item;
    }
    const bool conformal = invariant == kTurned && producer.conformal;
    item.draw = [conformal](Random& random, Draw& in) { draw_place(random, in, conformal); };
    // Both sides are off by this; a factor of up to 4 and a turn (10 roundings of coordinates and derivatives
    // that both magnify) count too.
    const double sides = 2.0 * (invariant == kLinear ? 4.0 : 1.0) * (invariant == kTurned ? 2.0 : 1.0);
    const double allowed = 2.0 * producer.roundings * kUlp * sides;
    auto condition = producer.condition;
    if (invariant == kTangential) {
        item.property = [allowed, condition](const In& in, const In& out) {
            return std::abs(glm::dot(out.v3(0), in.v3(0))) <= allowed * condition(in)
                       ? ""
                       : "g leaves the tangent plane";
        };
        return item;
    }
    item.reference = [](const In&, Expect& out) { out.put(0, glm::dvec3(0.0)); };
    item.bound = {.absolute = allowed};
    item.condition = condition;
    return item;
}

std::vector<Case> cases() {
    std::vector<Case> out;
    for (const Producer& producer : kProducers) {
        for (int i = 0; i < kInvariants; ++i) {
            if (producer.cells[static_cast<std::size_t>(i)] == kHolds)
                out.push_back(case_of(producer, static_cast<Invariant>(i)));
        }
    }
    return out;
}

SG_PROVE(Invariants, cases());

// What is left for interpolated tangents, that lean out of the plane of n: g leaves it by no more than they
// do.
Case leaning() {
    return {.name = "tbn_vertex_leaning",
            .include = "surfgrad/tbn.glsl",
            .inputs = 9,
            .outputs = 3,
            .glsl = "put(0, sg_surfgrad_from_tbn(v2(7), sg_basis_vertex(v3(0), v4(3))));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.direction() * random.uniform(0.3, 1.0));
                    in.put(3, random.direction() * random.uniform(0.3, 1.0)), in.put(6, random.sign());
                    in.put(7, random.direction2() * random.magnitude(1e-2, 128.0));
                },
            .property =
                [](const In& in, const In& out) {
                    const glm::dvec3 n = glm::normalize(in.v3(0)), t = in.v3(3);
                    const double d = glm::length(in.v2(7)), length = glm::length(in.v3(0));
                    // Products of vectors up to 1 over |N|: 16 roundings.
                    const double allowed = d * (std::abs(glm::dot(t, n)) + 32 * kUlp) / length;
                    return std::abs(glm::dot(out.v3(0), n)) <= allowed ? ""
                                                                       : "g leaves the plane farther than T";
                },
            .mutants = {{"surfgrad/tbn.glsl", "SgBasis(scale * vertex_tangent.xyz",
                         "SgBasis(scale * scale * vertex_tangent.xyz"},
                        {"surfgrad/tbn.glsl", "side * cross(vertex_normal, vertex_tangent.xyz)",
                         "side * vertex_tangent.zxy"}}};
}

SG_PROVE(InvariantsLeaning, std::vector<Case>{leaning()});

// A wrong change in each column: every producer must notice where the change is one of its own arguments;
// where the column compares gradients alone, one producer shows that it compares.
struct WrongChange {
    Invariant invariant;
    const char* find;
    const char* replace;
};
constexpr WrongChange kWrongChanges[] = {
    {kTangential, "gradient(p, 1.0)", "gradient(p, 1.0) + 1e-2 * length(gradient(p, 1.0)) * v3(0)"},
    {kLinear, "f(26) * gradient(p, 1.0)", "1.01 * f(26) * gradient(p, 1.0)"},
    {kOdd, "gradient(p, -1.0) +", "0.99 * gradient(p, -1.0) +"},
    {kMirroredU, "p.d.x = -p.d.x, p.tangent = -p.tangent, p.image = 1;", "p.tangent = -p.tangent;"},
    {kMirroredV, "p.d.y = -p.d.y, p.tangent.w = -p.tangent.w, p.image = 2;", "p.tangent.w = -p.tangent.w;"},
    {kTurned, "p.d = turn * p.d, p.image = 3;", ""},
    {kViewport, "p.frame = sg_frame(vec3(0.0), v3(3), -v3(6), v3(0));", "p.frame.dpdy = p.frame.dpdx;"},
    {kUnit, "sg_resolve(v3(0), gradient(p, 1.0))", "v3(0) - gradient(p, 1.0)"},
    {kOutward, "sg_resolve(v3(0), gradient(p, 1.0))", "sg_resolve(v3(0), gradient(p, 1.0) + 1.01 * v3(0))"},
};

TEST(InvariantTable, WrongChangesAreNoticed) {
    for (const WrongChange& wrong : kWrongChanges) {
        for (const Producer& producer : kProducers) {
            const bool own = wrong.invariant >= kMirroredU && wrong.invariant <= kViewport;
            if (producer.cells[wrong.invariant] != kHolds || (!own && producer.name != "from_volume"))
                continue;
            // The gradients of volumes do not hang on the steps that the viewport turns.
            if (wrong.invariant == kViewport && producer.glsl.find("from_volume") != std::string_view::npos)
                continue;
            Case item = case_of(producer, wrong.invariant);
            item.count = 2000;
            std::string& text = wrong.find[0] == 'p' && wrong.find[1] == '.' ? item.declarations : item.glsl;
            const std::size_t at = text.find(wrong.find);
            ASSERT_NE(at, std::string::npos) << wrong.find;
            text.replace(at, std::string_view(wrong.find).size(), wrong.replace);
            const std::vector<float> inputs = draw_inputs(item, item.count);
            EXPECT_NE(compare(item, inputs, evaluate(item, inputs)).violation, "")
                << item.name << " SG_SEED=" << run_seed();
        }
    }
}

// What makes a gradient or a derivative has a row.
TEST(InvariantTable, HasEveryProducer) {
    for (const auto& [function, file] : library_functions()) {
        const bool produces = function.starts_with("sg_surfgrad_") || function.ends_with("_gradient") ||
                              function.starts_with("sg_basis_uv");
        const bool listed = std::any_of(
            std::begin(kProducers), std::end(kProducers),
            [&](const Producer& producer) { return producer.glsl.find(function) != std::string_view::npos; });
        EXPECT_TRUE(!produces || listed) << function << " of " << file << " has no row";
    }
}

}  // namespace
}  // namespace sg::proof
