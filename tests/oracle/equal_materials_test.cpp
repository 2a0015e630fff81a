// Materials that mean the same, written in two ways, and what a material must come to: by the interpreter.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compile.hpp"
#include "ir/text.hpp"
#include "tests/oracle/memory_texture.hpp"
#include "tests/oracle/random_module.hpp"
#include "tests/render/workshop.hpp"

namespace sg::oracle {
namespace {

using Json = nlohmann::json;
using ref::dvec3;

// A height that rises by 1/16 per texel.
struct Ramp : ref::TextureSource {
    static constexpr int kSide = 16;
    static constexpr double kRise = 1.0 / kSide;
    glm::dvec4 fetch(glm::ivec2 texel, int) const override { return glm::dvec4(kRise * texel.x); }
    glm::ivec2 size(int) const override { return {kSide, kSide}; }
    int levels() const override { return 1; }
};

class Meaning {
public:
    // Every texture holds the same noise, a colour its red in alpha alone; or all hold `texels`.
    explicit Meaning(const std::string& text, const ref::TextureSource* texels = nullptr) {
        MemoryFiles files;
        for (const auto& [path, bytes] : truth::sample_files()) files.contents["in/" + path] = bytes;
        CompileRequest request{.source = std::make_shared<Source>(Source{"case.json", text})};
        request.stem = "case";
        request.roots = {"in"};
        request.entries = {"normal"};
        Diags diags;
        const auto compiled = compile_material(request, files, target::embedded_library(), diags);
        if (!compiled) throw std::runtime_error(text + "\n" + render(diags));
        std::string fault;
        module_ = ir::parse(compiled->ir, fault).value();
        std::mt19937_64 random(3);
        noise_ = random_texture(random, {8, 8});
        color_ = noise_;
        for (auto& level : color_.chain) {
            for (auto& texel : level.texels) texel = {0, 0, 0, texel.r};
        }
        for (const ir::Texture& texture : module_.textures) {
            const bool color = texture.encoding == ir::TextureEncoding::color;
            bindings_.textures.emplace_back().texels = texels ? texels : color ? &color_ : &noise_;
        }
        const Json json = Json::parse(text);
        for (const ir::Parameter& p : module_.parameters) {
            const auto numbers = json["parameters"][p.name]["default"].get<std::vector<double>>();
            bindings_.parameters.push_back(ir::datum_of(p.type, numbers));
        }
    }
    [[nodiscard]] dvec3 normal(const ir::PixelInputs& pixel) const {
        ir::Evaluator evaluator(module_, bindings_);
        evaluator.run(pixel);
        return std::get<dvec3>(evaluator.output(ir::Output::normal));
    }
    ir::Module& module() { return module_; }

private:
    ir::Module module_;
    ref::MemoryTexture noise_, color_;
    ir::Bindings bindings_;
};

std::string material(const std::string& bump, const std::string& cutout = "mask",
                     const std::string& parameters = "{}") {
    return R"({ "version": 1, "parameters": )" + parameters + R"(, "textures": {
        "n": { "file": "textures/pebble_normal.png", "encoding": "tangent_normal" },
        "o": { "file": "textures/pebble_sphere_object.png", "encoding": "object_normal" },
        "h": { "file": "textures/rib_height.png", "encoding": "height" },
        "cut": { "file": "textures/stone_color.png", "encoding": ")" +
           cutout + R"(" } }, "bump": [ )" + bump + " ] }";
}

std::vector<ir::PixelInputs> pixels() {
    std::mt19937_64 random(run_seed());
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    std::vector<ir::PixelInputs> out;
    for (int i = 0; i < 400; ++i) {
        out.push_back(random_pixel(random));
        const dvec3 p(place(random), place(random), place(random));
        out.back().object = out.back().world = {p, out.back().dpdx, out.back().dpdy};
        out.back().facing = 1;
    }
    return out;
}

// How many pixels have a bump; none of them differs.
int same(const Meaning& a, const Meaning& b) {
    int bumped = 0;
    for (const ir::PixelInputs& pixel : pixels()) {
        const dvec3 normal = a.normal(pixel);
        EXPECT_LT(glm::distance(normal, b.normal(pixel)), 1e-12);
        bumped += glm::distance(normal, glm::normalize(pixel.vertex_normal)) > 1e-3;
    }
    return bumped;
}

// In how many pixels they differ.
int different(const Meaning& a, const Meaning& b) {
    int out = 0;
    for (const ir::PixelInputs& pixel : pixels())
        out += glm::distance(a.normal(pixel), b.normal(pixel)) > 1e-3 ? 1 : 0;
    return out;
}

// Turned by 90 degrees about x: up is +z, and the image flies along +y. So right is (x - 0.5) / 2, down
// (2 - z) / 4, ahead 0.4 (y + 1).
TEST(EqualMaterials, AProjectorsMatrixIsItsPlace) {
    for (const char* shape : {"box", "cone", "sphere", "wedge"}) {
        const std::string decal =
            std::string(R"({ "layers": [ { "kind": "decal", "space": "world", "shape": ")") + shape +
            R"(", "texture": "n", "strength": 0.5, )";
        const Meaning placed(material(
            decal + R"("position": [0.5, -1, 2], "rotation": [90, 0, 0], "size": [2, 4, 2.5] } ] })"));
        const Meaning thrown(material(
            decal + R"("projector": "$place" } ] })", "mask",
            R"({ "place": { "type": "mat4", "default": [0.5, 0, 0, 0, 0, 0, 0.4, 0, 0, -0.25, 0, 0, -0.25, 0.5, 0.4, 1] } })"));
        EXPECT_GT(same(placed, thrown), 5) << shape;
    }
}

TEST(EqualMaterials, AColoursAlphaCutsAsAMaskDoes) {
    const std::string decal =
        R"({ "layers": [ { "kind": "decal", "texture": "n", "size": [3, 3, 3], "cutout": "cut" } ] })";
    EXPECT_GT(same(Meaning(material(decal, "mask")), Meaning(material(decal, "color"))), 100);
}

// Between nothing and all of a bump.
TEST(EqualMaterials, AMaskBeyondOneShowsAll) {
    auto bump = [](const std::string& mask) {
        return material(R"({ "layers": [ { "kind": "normal_map", "texture": "n", "mask": )" + mask +
                        " } ] }");
    };
    auto node = [&](double value) {
        return bump(R"({ "op": "add", "a": 0, "b": )" + std::to_string(value) + " }");
    };
    const Meaning whole(bump("1"));
    EXPECT_GT(same(whole, Meaning(node(4))), 100);
    EXPECT_EQ(same(Meaning(bump("0")), Meaning(node(-4))), 0);
    EXPECT_GT(different(whole, Meaning(bump("0.5"))), 100);
}

// A bump is cut behind its strength: fine steps of a small height are as steep as coarse ones of a large.
TEST(EqualMaterials, FineNoiseIsNotCut) {
    auto noise = [](double frequency, double strength) {
        return Meaning(material(fmt::format(
            R"({{ "layers": [ {{ "kind": "noise", "function": "perlin", "frequency": {}, "strength": {} }} ] }})",
            frequency, strength)));
    };
    const Meaning coarse = noise(2, 0.05), fine = noise(1e6, 1e-7);
    int bumped = 0;
    for (ir::PixelInputs pixel : pixels()) {
        for (dvec3* v : {&pixel.object.dx, &pixel.object.dy}) *v *= 1e-3;
        const dvec3 normal = coarse.normal(pixel);
        for (dvec3* v : {&pixel.object.p, &pixel.object.dx, &pixel.object.dy}) *v *= 2e-6;
        EXPECT_LT(glm::distance(normal, fine.normal(pixel)), 1e-8);  // 1e6 times 2e-6 is rounded
        bumped += glm::distance(normal, glm::normalize(pixel.vertex_normal)) > 1e-3;
    }
    EXPECT_GT(bumped, 100);
}

const std::string kFirst =
    R"({ "id": "first", "layers": [ { "kind": "normal_map", "texture": "n", "strength": 0.2 } ] })";
const std::string kSecond =
    R"(, { "id": "second", "layers": [ { "kind": "normal_map", "texture": "n", "uv": 1, "strength": 0.2 } ] })";

std::string back_to(const std::string& field, const std::string& mask = "1") {
    return R"(, { "layers": [ { "kind": "earlier_normal", "mask": )" + mask + field + " } ] }";
}

TEST(EqualMaterials, AnEarlierNormalComesBack) {
    const std::string first = R"(, "entry": "first")", second = R"(, "entry": "second")";
    const Meaning one(material(kFirst)), two(material(kFirst + kSecond));
    EXPECT_GT(same(one, Meaning(material(kFirst + kSecond + back_to(first)))), 100);
    EXPECT_GT(same(two, Meaning(material(kFirst + kSecond + back_to(second)))), 100);
    EXPECT_GT(same(two, Meaning(material(kFirst + kSecond + back_to(first, "0")))), 100);
    EXPECT_EQ(
        same(
            Meaning(material(R"({ "layers": [ { "kind": "normal_map", "texture": "n", "strength": 0 } ] })")),
            Meaning(material(kFirst + kSecond + back_to("")))),
        0);
}

// A share m of the way, in the plane that touches the unit sphere at n: (1 - m) n + m d / (n d).
TEST(EqualMaterials, AMaskMixesAnEarlierNormalIn) {
    const Meaning earlier(material(kFirst)), later(material(kFirst + kSecond));
    const Meaning mixed(material(kFirst + kSecond + back_to(R"(, "entry": "first")", "0.25")));
    int turned = 0;
    for (const ir::PixelInputs& pixel : pixels()) {
        const dvec3 n = later.normal(pixel), d = earlier.normal(pixel);
        if (glm::dot(n, d) < 0.2) continue;  // steep ones are limited
        EXPECT_LT(glm::distance(mixed.normal(pixel), glm::normalize(0.75 * n + 0.25 * d / glm::dot(n, d))),
                  1e-12);
        turned += glm::distance(n, d) > 1e-3;
    }
    EXPECT_GT(turned, 100);
}

// A plane of z, whose map is `length` units wide. The height 1 counts `strength` texels, or units.
TEST(EqualMaterials, SlopesDoNotSeeTilingNorSize) {
    const Ramp ramp;
    for (const std::string method : {"forward", "hq"}) {
        for (const double tiling : {1.0, 3.0}) {
            for (const double length : {1.0, 7.0}) {
                ir::PixelInputs pixel;
                pixel.dpdx = {0.001, 0, 0}, pixel.dpdy = {0, -0.001, 0};
                pixel.uvs[0] = {{0.5, 0.5}, {0.001 / length, 0}, {0, 0.001 / length}};
                auto slope = [&](const std::string& scale) {
                    const Meaning meaning(
                        material(
                            R"({ "layers": [ { "kind": "height_map", "texture": "h", "strength": 2, "method": ")" +
                            method + R"(", "tiling": )" + std::to_string(tiling) + R"(, "scale": ")" + scale +
                            R"(" } ] })"),
                        &ramp);
                    const dvec3 n = meaning.normal(pixel);
                    EXPECT_NEAR(n.y, 0, 1e-9);
                    return -n.x / n.z;
                };
                EXPECT_NEAR(slope("slope"), 2 * Ramp::kRise, 1e-9) << method << tiling << length;
                EXPECT_NEAR(slope("displacement"), 2 * Ramp::kRise * Ramp::kSide * tiling / length, 1e-9)
                    << method << tiling << length;
            }
        }
    }
}

// Slopes up to 1.
struct Slopes : ref::TextureSource {
    static constexpr int kSide = 16;
    glm::dvec4 fetch(glm::ivec2 texel, int) const override {
        const double s = 0.8 * std::sin(0.7 * texel.x + 0.4),
                     t = 0.6 * std::cos(0.4 * texel.x - 1.1 * texel.y);
        return {0.5 + 0.5 * glm::normalize(dvec3(s, t, 1)), 1};
    }
    glm::ivec2 size(int) const override { return {kSide, kSide}; }
    int levels() const override { return 1; }
};

std::string blend(const std::string& method, const std::string& second_uv) {
    return material(
        R"({ "layers": [ { "kind": "normal_blend", "texture": "n", "second_texture": "n", "second_tiling": [3, 2],
             "method": ")" +
        method + R"(", "second_uv": )" + second_uv + " } ] }");
}

// A whole turn changes nothing but the way: without a common tangent space for sure, in shading space.
TEST(EqualMaterials, ReorientedMapsOfOneUvSetMayBlendInEitherSpace) {
    const Slopes slopes;
    Meaning tangent(blend("rnm", "0"), &slopes), space(blend("rnm", R"({ "rotation": 360 })"), &slopes);
    auto has = [](Meaning& meaning, ir::Op op) {
        const auto& values = meaning.module().values;
        return std::any_of(values.begin(), values.end(), [&](const ir::Value& v) { return v.op == op; });
    };
    EXPECT_TRUE(has(tangent, ir::Op::combine_rnm) && !has(tangent, ir::Op::combine_reoriented));
    EXPECT_TRUE(has(space, ir::Op::combine_reoriented) && !has(space, ir::Op::combine_rnm));
    EXPECT_GT(same(tangent, space), 100);
    EXPECT_GT(different(tangent, Meaning(blend("pd", "0"), &slopes)), 100);
}

// Across uv sets the normal that one map alone gives is the one that the other stands on.
TEST(EqualMaterials, ReorientedMapsOfTwoUvSetsTurnOneByTheOther) {
    const Slopes slopes;
    auto map = [](const std::string& place) {
        return material(R"({ "layers": [ { "kind": "normal_map", "texture": "n", )" + place + " } ] }");
    };
    const Meaning first(map(R"("uv": 0)"), &slopes), second(map(R"("uv": 1, "tiling": [3, 2])"), &slopes);
    const Meaning both(blend("rnm", "1"), &slopes);
    int turned = 0;
    for (const ir::PixelInputs& pixel : pixels()) {
        const dvec3 n = glm::normalize(pixel.vertex_normal), a = first.normal(pixel),
                    b = second.normal(pixel);
        // Two half turns, about n and about the middle between n and a, are the shortest turn from n to a.
        const dvec3 half = glm::normalize(n + a), once = 2 * glm::dot(n, b) * n - b;
        const dvec3 want = 2 * glm::dot(half, once) * half - once;
        if (glm::dot(want, n) < 0.01) continue;  // inward, or so steep that it is limited
        EXPECT_LT(glm::distance(both.normal(pixel), want), 1e-9);
        turned += glm::distance(n, a) > 1e-3 && glm::distance(n, b) > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(turned, 100);
}

// ---- behind parallax ----

const std::string kParallax =
    R"("parallax": { "kind": "occlusion", "texture": "h", "strength": 0.3, "mesh": "flat", "min_steps": 8, "max_steps": 8 }, )";

std::string entry(const std::string& layers, const std::string& parallax = "") {
    return "{ " + parallax + R"("layers": [ )" + layers + " ] }";
}

// Layers with FOLLOW wherever something is looked up.
constexpr const char* kLookups[] = {
    R"({ "kind": "normal_map", "texture": "n", "uv": 1, "tiling": 3, "strength": 0.2 FOLLOW })",
    R"({ "kind": "normal_map", "texture": "n", "basis": "vertex", "strength": 0.2 FOLLOW })",
    R"({ "kind": "normal_map", "texture": "n", "scale": "displacement", "strength": 0.001 FOLLOW })",
    R"({ "kind": "height_map", "texture": "h", "uv": { "set": 2, "rotation": 30 }, "strength": 0.01 FOLLOW })",
    R"({ "kind": "height_map", "texture": "h", "method": "screen", "strength": 0.01 FOLLOW })",
    R"({ "kind": "object_normal_map", "texture": "o", "tiling": 2, "strength": 0.2 FOLLOW })",
    R"({ "kind": "noise", "frequency": 2, "strength": 0.2 FOLLOW })",
    R"({ "kind": "noise", "function": "perlin", "space": "world", "strength": 0.2 FOLLOW })",
    R"({ "kind": "triplanar", "texture": "n", "strength": 0.2 FOLLOW })",
    R"({ "kind": "planar", "texture": "n", "space": "world", "strength": 0.2 FOLLOW })",
    R"({ "kind": "decal", "texture": "n", "size": [3, 3, 3], "strength": 0.2 FOLLOW })",
    R"({ "kind": "normal_blend", "method": "whiteout", "texture": "n", "second_texture": "n", "second_uv": 1, "strength": 0.2 FOLLOW })",
    R"({ "kind": "noise", "strength": 0.5 FOLLOW, "mask": { "texture": "h", "channel": "r" FOLLOW } })",
    R"({ "kind": "noise", "strength": 0.5 FOLLOW, "mask": { "op": "height", "range": [-2, 2] FOLLOW } })",
    R"({ "kind": "noise", "strength": 0.5 FOLLOW, "mask": { "op": "distance", "range": [2, 8] FOLLOW } })",
    R"({ "kind": "noise", "strength": 0.5 FOLLOW, "mask": { "op": "noise", "range": [-1, 1] FOLLOW } })",
    R"({ "kind": "noise", "strength": 0.5 FOLLOW, "mask": { "op": "decal_mask", "size": [4, 4, 4], "edge": 1 FOLLOW } })",
};

std::string with(std::string layer, const std::string& field) {
    const std::string place = " FOLLOW";
    for (std::size_t at = layer.find(place); at != std::string::npos; at = layer.find(place))
        layer.replace(at, place.size(), field);
    return layer;
}
const std::string kStays = R"(, "follow_parallax": false)";

// What does not follow is what it would be without the parallax; what follows is not.
TEST(EqualMaterials, ALayerThatDoesNotFollowParallaxIsTheMeshs) {
    for (const std::string layer : kLookups) {
        const Meaning mesh(material(entry(with(layer, ""))));
        const Meaning stays(material(entry(with(layer, kStays), kParallax)));
        const Meaning follows(material(entry(with(layer, ""), kParallax)));
        EXPECT_GT(same(mesh, stays), 50) << layer;
        EXPECT_GT(different(stays, follows), 50) << layer;
    }
}

TEST(EqualMaterials, ALaterLayerThatDoesNotFollowParallaxIsTheMeshs) {
    const std::string first = kLookups[0];
    for (const std::string layer : kLookups) {
        const Meaning mesh(material(entry(with(first, "")) + ", " + entry(with(layer, ""))));
        const Meaning stays(
            material(entry(with(first, kStays), kParallax) + ", " + entry(with(layer, kStays))));
        const Meaning follows(
            material(entry(with(first, kStays), kParallax) + ", " + entry(with(layer, ""))));
        EXPECT_GT(same(mesh, stays), 50) << layer;
        EXPECT_GT(different(stays, follows), 50) << layer;
    }
}

// Beside layers that follow it adds its gradient: g = n - n' / (n n') of each.
TEST(EqualMaterials, LayersThatFollowParallaxAndThoseThatDoNotAdd) {
    const std::string scratch = kLookups[0], stone = kLookups[8];
    const Meaning mesh(material(entry(with(scratch, "")))), seen(material(entry(with(stone, ""), kParallax)));
    const Meaning both(material(entry(with(scratch, kStays) + ", " + with(stone, ""), kParallax)));
    int bumped = 0;
    for (const ir::PixelInputs& pixel : pixels()) {
        const dvec3 n = glm::normalize(pixel.vertex_normal), a = mesh.normal(pixel), b = seen.normal(pixel);
        if (glm::dot(n, a) < 0.2 || glm::dot(n, b) < 0.2) continue;
        const dvec3 sum = a / glm::dot(n, a) + b / glm::dot(n, b) - n;
        EXPECT_LT(glm::distance(both.normal(pixel), glm::normalize(sum)), 1e-12);
        bumped += glm::distance(n, a) > 1e-3 && glm::distance(n, b) > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(bumped, 100);
}

// The surface moves once: entries behind the first that follows keep the footprint that its frame has. One of
// their own, on the plane of their normal, would be another.
TEST(EqualMaterials, LaterEntriesKeepTheFootprintBehindParallax) {
    const std::string first = with(kLookups[0], ""), grain = with(kLookups[7], "");
    Meaning kept(material(entry(first, kParallax) + ", " + entry(grain) + ", " + entry(first)));
    Meaning rebuilt = kept;
    int rebuilds = 0, resolved = 0, volumes = 0;
    for (std::size_t i = 0; i < kept.module().values.size(); ++i) {
        const ir::Value& value = kept.module().values[i];
        rebuilds += value.op == ir::Op::frame_rebuilt;
        volumes += value.op == ir::Op::volume_world_at;
        if (value.op != ir::Op::frame_resolved) continue;
        const ir::Value& plane = kept.module().at(value.operands[0]);
        EXPECT_EQ(plane.op, ir::Op::frame_rebuilt);
        ir::Value& own = rebuilt.module().values[i];
        own.op = ir::Op::frame_rebuilt;
        own.operands = {plane.operands[0], value.operands[1], plane.operands[2]};
        ++resolved;
    }
    EXPECT_EQ(rebuilds, 1);
    EXPECT_EQ(volumes, 1);
    EXPECT_EQ(resolved, 1);
    EXPECT_GT(different(kept, rebuilt), 100);
}

}  // namespace
}  // namespace sg::oracle
