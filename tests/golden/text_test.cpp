// What becomes of small materials: their GLSL, word by word where that is what matters.
#include <gtest/gtest.h>

#include <algorithm>

#include "compile.hpp"
#include "tests/support/golden.hpp"
#include "text_faults.hpp"

namespace sg {
namespace {

// The texts of a material by name ("forward.frag"), each free of faults.
class Text {
public:
    explicit Text(const std::string& bump, const std::string& rest = "") {
        const std::string material = R"({ "version": 1, "textures": {
            "n": { "file": "textures/pebble_normal.png", "encoding": "tangent_normal" },
            "h": { "file": "textures/pebble_height.png", "encoding": "height" },
            "p": { "file": "textures/pebble_parallax.png", "encoding": "parallax_map" },
            "c": { "file": "textures/stone_color.png", "encoding": "color" },
            "m": { "file": "textures/moss_mask.png", "encoding": "mask" } },
            "bump": [ )" + bump + " ]" +
                                     rest + " }";
        CompileRequest request{.source = std::make_shared<Source>(Source{"small.json", material})};
        request.stem = "small";
        request.roots = {test::source_dir() / "materials"};
        RealFiles files;
        Diags diags;
        auto compiled = compile_material(request, files, target::embedded_library(), diags);
        EXPECT_TRUE(compiled) << render(diags);
        if (!compiled) return;
        texts_ = std::move(compiled->glsl);
        for (const NamedText& t : texts_) {
            EXPECT_EQ(test::idle_arithmetic(t.text), "") << t.text;
            EXPECT_EQ(test::computed_twice(t.text), "") << t.text;
            EXPECT_EQ(test::comment_twice(t.text), "") << t.text;
            EXPECT_EQ(test::stuttering_name(t.text), "") << t.text;
        }
    }

    [[nodiscard]] std::string of(std::string_view name) const {
        for (const NamedText& t : texts_) {
            if (t.name == name) return t.text;
        }
        ADD_FAILURE() << "no text " << name;
        return "";
    }
    // The lines of the forward shader's main().
    [[nodiscard]] std::string main() const {
        const std::string text = of("forward.frag");
        return text.substr(text.find("void main() {\n") + 14);
    }
    [[nodiscard]] bool has(std::string_view words) const {
        return std::any_of(texts_.begin(), texts_.end(),
                           [&](const NamedText& t) { return t.text.find(words) != std::string::npos; });
    }
    // As another material, but for its name.
    void expect_same(const Text& other) const {
        for (const NamedText& t : texts_) EXPECT_EQ(t.text, other.of(t.name));
    }

private:
    std::vector<NamedText> texts_;
};

std::string entry(const std::string& layers) {
    return R"({ "layers": [ )" + layers + " ] }";
}

const Text& plain() {
    static const Text kPlain(entry(""));
    return kPlain;
}

TEST(Text, LayersUnderAMaskOfNothingVanish) {
    const std::string decal = R"({ "kind": "decal", "texture": "n", "cutout": "m", "angle_fade": [50, 85], )";
    const std::string map = R"({ "kind": "normal_map", "texture": "n", "basis": "vertex", )";
    for (
        const char* rest :
        {R"("mask": 0 })", R"("mask": 0, "blend": "mix" })", R"("strength": 0 })",
         R"("strength": 0, "blend": "mix" })",
         R"("mask": { "op": "smoothstep", "low": 0, "high": 1, "x": -1 } })",
         R"("mask": { "op": "multiply", "a": { "op": "texture", "texture": "m" }, "b": 0 }, "blend": "mix" })",
         R"("mask": { "op": "select", "condition": 0, "a": 0.5, "b": 0 } })"}) {
        Text(entry(decal + rest)).expect_same(plain());
    }
    Text(entry(map + R"("mask": "@none" })"), R"(, "nodes": { "none": 0 })").expect_same(plain());
    EXPECT_TRUE(Text(entry(decal + R"("mask": 0.5 })")).has("sg_decal_box("));
}

TEST(Text, ColoursThatAreKnownAreFolded) {
    const Text text(entry(""), R"(, "surface": { "base_color": { "op": "mix_color", "a": [1, 0, 0],
        "b": { "op": "add_color", "a": [0.5, 0, 0], "b": { "op": "multiply_color", "a": [1, 1, 1], "b": [0, 0.25, 0] } },
        "t": 1 } })");
    EXPECT_NE(text.main().find("sg_surface.base_color = vec3(0.5, 0.25, 0.0);"), std::string::npos)
        << text.main();
}

TEST(Text, AnAlphaTestThatDropsNothingIsNone) {
    auto test_of = [](const char* surface) {
        const std::string text = Text(entry(""), R"(, "surface": { )" + std::string(surface) + " }").main();
        const std::size_t begin = text.find("if (");
        return begin == text.npos ? "" : text.substr(begin, text.find(';', begin) - begin);
    };
    EXPECT_EQ(test_of(R"("alpha_test": 0.5)"), "");
    EXPECT_EQ(test_of(R"("alpha_test": 1)"), "");
    const std::string map = entry(R"({ "kind": "normal_map", "texture": "n" })");
    EXPECT_EQ(Text(map, R"(, "surface": { "alpha_test": 1 })").main(), Text(map).main());
    EXPECT_EQ(test_of(R"("alpha_test": 0.5, "opacity": 0.5)"), "");
    EXPECT_EQ(test_of(R"("alpha_test": 0.5, "opacity": 0.25)"), "if (0.25 < 0.5) discard");
    EXPECT_EQ(test_of(R"("alpha_test": 0.5, "opacity": { "texture": "m", "channel": "r" })"),
              "if (m_opacity < 0.5) discard");
}

TEST(Text, AParallaxOfStrengthNothingIsNone) {
    const std::string color = R"(, "surface": { "base_color": { "texture": "c" } })";
    const std::string layers = R"("layers": [ { "id": "a", "kind": "normal_map", "texture": "n" } ] })";
    const Text without("{ " + layers, color);
    for (const char* kind : {R"("offset", "texture": "h")", R"("steps", "texture": "p")",
                             R"("occlusion", "texture": "h", "mesh": "flat")"}) {
        const std::string parallax = std::string(R"({ "parallax": { "kind": )") + kind + R"(, "strength": )";
        Text(parallax + "0 }, " + layers, color).expect_same(without);
        EXPECT_TRUE(Text(parallax + "0.1 }, " + layers, color).has("sg_parallax_"));
    }
}

TEST(Text, AnEmptyFirstEntryLeavesTheFrame) {
    const std::string map = R"({ "id": "a", "kind": "normal_map", "texture": "n" })";
    const std::string second = Text(entry("") + ", " + entry(map)).main(), only = Text(entry(map)).main();
    EXPECT_EQ(second, only);
}

TEST(Text, WhatIsOneIsNotWritten) {
    const std::string expected = R"(    // grain: noise
    vec3 m_grain = sg_stage_gradient_from_object(
        sg_volume_fractal_sum(sg_stage_volume(sg_in_object_position), 4).gradient);
)";
    EXPECT_EQ(Text(entry(R"({ "id": "grain", "kind": "noise" })")).main().substr(0, expected.size()),
              expected);
    EXPECT_FALSE(Text(entry(R"({ "kind": "noise", "function": "perlin", "power": 1 },
        { "kind": "decal", "texture": "n", "angle_fade": [50, 85] })"))
                     .has("sg_volume_scale("));
}

TEST(Text, NegationsReadAsSuch) {
    const std::string roughness = Text(entry(""), R"(, "surface": { "roughness": { "op": "multiply",
        "a": { "op": "multiply", "a": { "op": "distance" }, "b": -1 },
        "b": { "op": "subtract", "a": 0, "b": { "op": "height" } } } })")
                                      .main();
    EXPECT_NE(roughness.find("clamp(-length(sg_in_position) * "
                             "-sg_stage_volume(sg_in_object_position).p.y, 0.0,"),
              std::string::npos)
        << roughness;
}

// A layer that becomes a part of an operation on normals is still known by its name.
TEST(Text, AnEarlierNormalHasItsComment) {
    const std::string main =
        Text(entry(R"({ "id": "grain", "kind": "noise" })") + ", " +
             R"({ "id": "wet", "layers": [ { "id": "film", "kind": "earlier_normal", "mask": 0.5 } ] })")
            .main();
    EXPECT_NE(main.find("\n    // film: earlier_normal\n    vec3 m_film = sg_resolve_towards("),
              std::string::npos)
        << main;
}

TEST(Text, AGroupHasItsComment) {
    const std::string group =
        R"({ "id": "crust", "kind": "group", "strength": 0.5, "layers": [
            { "id": "a", "kind": "noise", "frequency": 3 }, { "id": "b", "kind": "noise", "frequency": 7 } ] })";
    const std::string main = Text(entry(R"({ "id": "c", "kind": "noise" }, )" + group)).main();
    const std::size_t a = main.find("    // a: noise in crust\n"),
                      b = main.find("    // b: noise in crust\n");
    const std::size_t crust = main.find("    // crust: group\n    vec3 m_crust = ");
    EXPECT_TRUE(a < b && b < crust && crust != std::string::npos) << main;
    EXPECT_NE(main.find("m_c + m_crust"), std::string::npos) << main;
    // A group of one has no value of its own.
    const std::string one = R"({ "id": "crust", "kind": "group", "mask": 0.5, "layers": [
        { "id": "inner", "kind": "group", "layers": [ { "id": "a", "kind": "noise" } ] } ] })";
    EXPECT_NE(Text(entry(one)).main().find("    // a: noise in crust/inner\n    vec3 m_a = "),
              std::string::npos);
}

TEST(Text, AParallaxHasItsComment) {
    const std::string color = R"(, "surface": { "base_color": { "texture": "c" } })";
    for (const std::string kind : {"offset", "steps", "occlusion"}) {
        const std::string parallax = R"({ "parallax": { "kind": ")" + kind +
                                     R"(", "mesh": "flat", "strength": 0.1,
            "texture": ")" + (kind == "steps" ? "p" : "h") +
                                     R"(" }, "layers": [] })";
        const std::string main = Text(parallax, color).main();
        const std::size_t comment = main.find("    // parallax: " + kind + "\n");
        EXPECT_LT(comment, main.find("sg_parallax_")) << main;
        EXPECT_EQ(main.find("_parallax_parallax_"), std::string::npos) << main;
    }
}

// An entry's normal is not mistaken for the mesh's.
TEST(Text, AnEntryCalledBaseHasANormalOfItsOwn) {
    const std::string map = R"({ "id": "a", "kind": "normal_map", "texture": "n" })";
    const std::string main = Text(R"({ "id": "base", "layers": [ )" + map + " ] }, " +
                                  entry(R"({ "id": "b", "kind": "normal_map", "texture": "n" })"))
                                 .main();
    EXPECT_NE(main.find("vec3 m_base_normal = sg_base_normal("), std::string::npos) << main;
    EXPECT_NE(main.find("vec3 m_base_entry_normal = sg_resolve("), std::string::npos) << main;
    EXPECT_EQ(main.find("m_base_normal_2"), std::string::npos) << main;
}

}  // namespace
}  // namespace sg
