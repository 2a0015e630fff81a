#include "tests/proof/kinds.hpp"

#include <cmath>

#include "ir/reference/decal.hpp"

namespace sg::proof {
namespace {

using glm::dvec2;
using glm::dvec3;
using ref::dvec4;
using runtime::SmoothShape;

constexpr double kTau = 6.283185307179586;
constexpr double kSide = kFunctionSide;

// ---- what the textures hold ----

dvec2 height_slope(dvec2 c) {
    const double a = 0.05 * kTau * std::cos(kTau * (2 * c.x + c.y) + 0.4);
    const double b = 0.04 * kTau * std::cos(kTau * (c.x - 3 * c.y) + 1.7);
    return {2 * a + b, a - 3 * b};
}

// The torus of the built-in shapes, its axes stretched by factors.
struct TorusPoint {
    dvec3 normal, along_s, along_t;  // unit; dP/ds, dP/dt
};
TorusPoint torus(dvec2 st, dvec3 stretch) {
    const double a = kTau * (st.x - 0.5), b = kTau * (0.5 - st.y), ring = 1 + 0.4 * std::cos(b);
    return {
        glm::normalize(dvec3(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a)) / stretch),
        kTau * ring * dvec3(std::cos(a), 0, -std::sin(a)) * stretch,
        -kTau * 0.4 * dvec3(-std::sin(b) * std::sin(a), std::cos(b), -std::sin(b) * std::cos(a)) * stretch};
}

// Slopes along the unit directions of +s and +t on the torus; on uv set 1 these have changed places.
auto torus_slope(dvec3 stretch) {
    return [stretch](dvec2 c) {
        const TorusPoint p = torus(c, stretch);
        return height_slope(c) / dvec2(glm::length(p.along_s), glm::length(p.along_t));
    };
}
auto torus_slope_1(dvec3 stretch) {
    return [stretch](dvec2 c) {
        const TorusPoint p = torus({c.y, c.x}, stretch);
        return height_slope(c) / dvec2(glm::length(p.along_t), glm::length(p.along_s));
    };
}

dvec4 stored(dvec3 v) {
    return dvec4(0.5 * v + 0.5, 1);
}
Texel normal_of(std::function<dvec2(dvec2)> slope) {
    return [slope](dvec2 c) { return stored(glm::normalize(dvec3(-slope(c), 1))); };
}
Texel derivative_of(std::function<dvec2(dvec2)> slope) {
    return [slope](dvec2 c) { return stored(dvec3(slope(c) / 4.0, 0)); };
}
// Object space is before the stretch, to which normals come back by its transpose.
Texel object_normal(dvec3 stretch) {
    return [stretch](dvec2 c) {
        const TorusPoint p = torus(c, stretch);
        const dvec2 d = height_slope(c);
        const dvec3 g = d.x * p.along_s / glm::dot(p.along_s, p.along_s) +
                        d.y * p.along_t / glm::dot(p.along_t, p.along_t);
        return stored(glm::normalize(stretch * (p.normal - g)));
    };
}
// What the maps of slopes on the torus hold.
Texel torus_normals(dvec3 stretch) {
    return normal_of(torus_slope(stretch));
}
Texel torus_normals_1(dvec3 stretch) {
    return normal_of(torus_slope_1(stretch));
}
Texel torus_derivatives(dvec3 stretch) {
    return derivative_of(torus_slope(stretch));
}
Texel heights() {
    return [](dvec2 c) { return dvec4(test_height(c)); };
}

// ---- the table ----

std::string map_material(const std::string& encoding, const std::string& layer) {
    return R"({"version": 1, "textures": {"map": {"file": "any.png", "green": "down", "encoding": ")" +
           encoding + R"("}}, "bump": [{"layers": [{"id": "bump", "texture": "map", "strength": "$h", )" +
           layer + "}]}]";
}
std::string plain_map(const std::string& encoding, const std::string& layer, const std::string& more = "") {
    return R"({"version": 1, "textures": {"map": {"file": "any.png", "encoding": ")" + encoding + "\"" +
           more + R"(}}, "bump": [{"layers": [{"id": "bump", "texture": "map", "strength": "$h", )" + layer +
           "}]}]";
}

void add_uv_kinds(std::vector<KindCase>& out) {
    const auto torus_shape = SmoothShape::torus;
    for (const std::string method : {"hq", "forward", "screen"})
        out.push_back({"height_map_" + method,
                       torus_shape,
                       plain_map("height", R"("kind": "height_map", "method": ")" + method + "\""),
                       {{"map", heights()}}});
    out.push_back({"height_map_on_uv1",
                   torus_shape,
                   plain_map("height", R"("kind": "height_map", "uv": 1)"),
                   {{"map", heights()}}});
    // Maps of slopes: what they hold depends on how the torus is stretched.
    auto add = [&](const std::string& name, const std::string& material, Texel (*map)(dvec3)) {
        KindCase c{name, torus_shape, material, {{"map", map(dvec3(1))}}, {{"map", 1}}};
        c.stretched = map;
        out.push_back(c);
    };
    const std::string map = R"("kind": "normal_map")";
    add("normal_map", map_material("tangent_normal", map), torus_normals);
    add("normal_map_on_uv1", map_material("tangent_normal", map + R"(, "uv": 1)"), torus_normals_1);
    add("normal_map_from_the_vertex", map_material("tangent_normal", map + R"(, "basis": "vertex")"),
        torus_normals);
    add("normal_map_of_two_channels", map_material("tangent_normal_xy", map), torus_normals);
    // Displacement: the map's slope is per texel, its height of kSide texels has the length kSide "$h".
    out.push_back({"normal_map_as_displacement",
                   torus_shape,
                   map_material("tangent_normal", map + R"(, "scale": "displacement")"),
                   {{"map", normal_of(height_slope)}},
                   {{"map", kSide}},
                   1 / kSide});
    add("derivative_map",
        plain_map("derivative", R"("kind": "derivative_map")", R"(, "green": "down", "range": 4)"),
        torus_derivatives);
    add("object_normal_map", plain_map("object_normal", R"("kind": "object_normal_map")"), object_normal);
}

void add_volume_kinds(std::vector<KindCase>& out) {
    const auto rock = SmoothShape::rock;
    for (const std::string layer :
         {R"("kind": "triplanar")", R"("kind": "triplanar", "hand": "left", "origin": "lower_left")",
          R"("kind": "planar", "axis": "x")", R"("kind": "planar", "axis": "z", "space": "world")"}) {
        std::string name = layer.find("planar\", \"axis") != layer.npos ? "planar" : "triplanar";
        if (layer.find("left") != layer.npos || layer.find("world") != layer.npos) name += "_otherwise";
        out.push_back({name,
                       rock,
                       map_material("tangent_normal", layer),
                       {{"map", normal_of(height_slope)}},
                       {{"map", 1}}});
    }
    for (const std::string noise :
         {R"("perlin")", R"("fractal_sum", "octaves": 3)", R"("turbulence", "octaves": 3, "space": "world")",
          R"("turbulence", "octaves": 2, "power": 2)"}) {
        std::string name = "noise_" + noise.substr(1, noise.find('"', 1) - 1);
        if (noise.find("power") != noise.npos) name += "_to_a_power";
        out.push_back(
            {name,
             rock,
             R"({"version": 1, "bump": [{"layers": [{"id": "bump", "kind": "noise", "frequency": 2, "strength": "$h", "function": )" +
                 noise + "}]}]",
             {},
             {},
             0.3});
    }
    const std::string box = R"("kind": "decal", "size": [2, 2, 2], "shape": )";
    for (const std::string shape : {"box", "capsule", "wedge"}) {
        // The wedge's image flies from its edge, which lies behind the rock as seen along -z.
        const std::string place =
            shape == "wedge" ? R"(, "size": [3, 3, 6], "position": [0, 0, 3])" : R"(, "size": [2, 2, 2])";
        const double half = shape == "wedge" ? 3 : 2;
        auto slope = [half](dvec2 c) { return height_slope(c) / (2 * half); };
        out.push_back({"decal_" + shape,
                       rock,
                       map_material("tangent_normal",
                                    R"("kind": "decal", "edge": 0.5, "shape": ")" + shape + "\"" + place),
                       {{"map", normal_of(slope)}},
                       {{"map", 1}}});
    }
    for (const std::string shape : {"cone", "sphere"}) {
        KindCase c{"decal_" + shape,
                   SmoothShape::sphere,
                   map_material(
                       "tangent_normal",
                       R"("kind": "decal", "rotation": [-20, 200, 0], "size": [1.5, 1.5, 1.5], "shape": ")" +
                           shape + "\""),
                   {},
                   {{"map", 1}}};
        c.decal = true;
        out.push_back(c);
    }
}

void add_composites(std::vector<KindCase>& out) {
    const std::string head = R"({"version": 1, "textures": {"map": {"file": "any.png", "encoding": "height"},
        "slopes": {"file": "any.png", "green": "down", "encoding": "tangent_normal"}}, "bump": [{"layers": [)";
    const std::string height = R"({"id": "a", "kind": "height_map", "texture": "map", "strength": "$h")";
    const std::string noise =
        R"({"id": "b", "kind": "noise", "function": "perlin", "frequency": 2, "strength": "$h")";
    const std::string slopes = R"({"id": "c", "kind": "triplanar", "texture": "slopes", "strength": "$h")";
    const std::map<std::string, Texel> textures = {{"map", heights()}, {"slopes", normal_of(height_slope)}};
    const std::map<std::string, double> partners = {{"slopes", 1}};
    auto add = [&](const std::string& name, const std::string& layers) {
        out.push_back({name, SmoothShape::torus, head + layers + "]}]", textures, partners, 0.5});
    };
    add("sum", height + "}, " + noise + "}, " + slopes + "}");
    add("group_under_a_mask", height + R"(}, {"id": "g", "kind": "group", "mask": 0.6, "layers": [)" + noise +
                                  "}, " + slopes + "}]}");
    add("mix", height + "}, " + noise + R"(, "blend": "mix", "mask": 0.4})");
    add("chain_of_two", height + "}]}, {\"layers\": [" + noise + "}");
    add("chain_of_three", height + "}]}, {\"layers\": [" + noise + "}]}, {\"layers\": [" + slopes + "}");
}

// Slopes so low that all ways of blending two normals add them, but for the square of a slope: 0.02 of those
// above, 0.03 at most.
constexpr double kLow = 0.02;
Texel low_normals(dvec3 stretch) {
    return normal_of([stretch](dvec2 c) { return kLow * torus_slope(stretch)(c); });
}

void add_equals(std::vector<KindCase>& out) {
    const std::string layer = R"({"kind": "normal_map", "texture": "map", "strength": "$h", "id": )";
    const std::string head =
        R"({"version": 1, "textures": {"map": {"file": "any.png", "green": "down", "encoding": "tangent_normal"}}, "bump": [{"layers": [)";
    for (const std::string method : {"pd", "whiteout", "udn", "rnm", "weighted"}) {
        KindCase c{"normal_blend_" + method,
                   SmoothShape::torus,
                   head + layer + "\"a\"}, " + layer + "\"b\"}]}]",
                   {{"map", low_normals(dvec3(1))}},
                   {{"map", kLow}},
                   0.5 / kLow};
        c.stretched = low_normals;
        c.drawn = head +
                  R"({"id": "both", "kind": "normal_blend", "texture": "map", "second_texture": "map", )" +
                  R"("strength": "$h", "method": ")" + method + "\"}]}]";
        out.push_back(c);
    }
    const std::string bump = R"({"version": 1, "bump": [{"layers": [{"id": "bump", "strength": "$h", )";
    KindCase own{"custom",
                 SmoothShape::rock,
                 bump + R"("kind": "noise", "frequency": 2, "function": "turbulence", "power": 2}]}])",
                 {},
                 {},
                 0.3};
    own.drawn = bump + R"("kind": "custom", "file": "shaders/custom.glsl", "function": "dents", )" +
                R"("returns": "volume_gradient", "arguments": ["object", 2, 2]}]}])";
    out.push_back(own);
}

// A decal's slope is per unit length where its image falls on the unit sphere around the projector.
Texel decal_texture(const glm::dmat4& projector, bool cube) {
    return [projector, cube](dvec2 st) {
        const dvec3 local =
            cube ? dvec3(2 * st.x - 1, 1 - 2 * st.y, 1) : dvec3(2 * st.x - 1, 2 * st.y - 1, 1);
        const dvec3 p = glm::normalize(glm::inverse(glm::dmat3(projector)) * local);
        const ref::Decal d =
            cube ? ref::decal_sphere(projector, p, {}, {}) : ref::decal_cone(projector, p, {}, {});
        const dvec2 slope = height_slope(st) * dvec2(glm::length(d.grad_s), glm::length(d.grad_t));
        return stored(glm::normalize(dvec3(-slope, 1)));
    };
}

glm::dmat4 projector_of(Subject& subject) {
    ir::Evaluator evaluator(subject.module(), subject.bindings());
    const auto& values = evaluator.run({});
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (subject.module().values[i].op == ir::Op::projector) return std::get<glm::dmat4>(values[i]);
    }
    throw std::runtime_error("no projector");
}

}  // namespace

double test_height(dvec2 c) {
    return 0.05 * std::sin(kTau * (2 * c.x + c.y) + 0.4) + 0.04 * std::sin(kTau * (c.x - 3 * c.y) + 1.7);
}

const std::vector<KindCase>& all_kind_cases() {
    static const std::vector<KindCase> kCases = [] {
        std::vector<KindCase> out;
        add_uv_kinds(out);
        add_volume_kinds(out);
        add_composites(out);
        return out;
    }();
    return kCases;
}

const std::vector<KindCase>& equal_kind_cases() {
    static const std::vector<KindCase> kCases = [] {
        std::vector<KindCase> out;
        add_equals(out);
        return out;
    }();
    return kCases;
}

namespace {

std::string plain_json(const KindCase& c) {
    return c.material + R"(, "parameters": {"h": {"type": "float", "default": 1, "range": [-1, 1]}}})";
}

}  // namespace

std::map<std::string, Texel> textures_of(const KindCase& c, dvec3 stretch) {
    if (c.stretched) return {{"map", c.stretched(stretch)}};
    if (!c.decal) return c.textures;
    Subject plain(plain_json(c));
    return {{"map", decal_texture(projector_of(plain), c.name == "decal_sphere")}};
}

Subject made_subject(const KindCase& c, const std::string& json) {
    Subject out(json.empty() ? plain_json(c) : json, textures_of(c));
    for (const auto& [name, length] : c.partners) out.give_partner(name, test_height, length);
    return out;
}

}  // namespace sg::proof
