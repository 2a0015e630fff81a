// Which values get a local, in what order they stand, and how long statements are broken.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "emit/body.hpp"
#include "emit/wrap.hpp"
#include "ir/text.hpp"

namespace sg::emit {
namespace {

std::string text_of(std::string_view module_text) {
    std::string fault;
    auto module = ir::parse(module_text, fault);
    EXPECT_TRUE(module) << fault;
    std::vector<std::uint32_t> groups(module->textures.size(), 0);
    MaterialInterface material = material_interface(*module, groups);
    return Body(*module, material).text();
}

constexpr std::string_view kHead =
    "%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\n%2 = volume_object : Volume\n";

TEST(EmitText, AValueThatIsUsedOnceStandsWhereItIsUsed) {
    EXPECT_EQ(text_of(std::string(kHead) + "%3 = noise_perlin %2 : Noise\n%4 = noise_value %3 : Scalar\n"
                                           "%5 = add %4 %4 : Scalar\noutput metallic = %5\n"),
              "    SgNoise m_noise_perlin = sg_volume_perlin(sg_stage_volume(sg_in_object_position));\n");
}

TEST(EmitText, ChannelsOfASwizzleAreThoseOfTheTexel) {
    std::string fault;
    auto module = ir::parse(
        "texture 0 \"t\" tangent_normal_xy\n%0 = uv_set 0 : Uv\n%1 = sample 0 %0 : Texel\n"
        "%2 = swizzle 91 %1 : Texel\n%3 = rgb %2 : Color\noutput base_color = %3\n",
        fault);
    ASSERT_TRUE(module) << fault;
    const std::uint32_t group = 0;
    MaterialInterface material = material_interface(*module, {&group, 1});
    EXPECT_EQ(ir::swizzle_of({3, 2, 1, 1}), 91u);
    EXPECT_EQ(Body(*module, material).operand({3}), "sg_stage_sample(t_t, s_0, sg_stage_uv(sg_in_uv0)).wzy");
}

// 0 - x and -1 x are negations; two of them are no decrement, and a sum stays together.
TEST(EmitText, NegationsReadAsSuch) {
    auto negated = [](const std::string& rest) {
        const std::string text = text_of(
            "%0 = time : Scalar\n%1 = facing : Scalar\n%2 = constant 0 : Scalar\n"
            "%3 = constant -1 : Scalar\n" +
            rest + "%8 = add %7 %7 : Scalar 'x'\noutput metallic = %8\n");
        const std::size_t begin = text.find(" m_multiply = ") + 14;
        return text.substr(begin, text.find(';', begin) - begin);
    };
    EXPECT_EQ(negated("%4 = subtract %2 %0 : Scalar\n%5 = multiply %4 %1 : Scalar\n%6 = multiply %5 %3 : "
                      "Scalar\n%7 = multiply %6 %1 : Scalar\n"),
              "-(-sg_stage_time() * m_facing) * m_facing");
    EXPECT_EQ(negated("%4 = add %0 %1 : Scalar\n%5 = multiply %3 %4 : Scalar\n%6 = subtract %2 %5 : Scalar\n"
                      "%7 = multiply %1 %6 : Scalar\n"),
              "m_facing * (-(-(sg_stage_time() + m_facing)))");
    EXPECT_EQ(text_of(std::string(kHead) +
                      "layer \"a\" noise\n%3 = constant 1 : Scalar\n%4 = noise_perlin %2 : Noise\n"
                      "%5 = noise_gradient %3 %4 : LocalGrad\n%6 = gradient_from_object %5 : VolGrad\n"
                      "layer none\n%7 = surfgrad_from_volume %1 %6 : SurfGrad\noutput gradient = %7\n"),
              "    // a: noise\n    vec3 m_a = sg_stage_gradient_from_object("
              "sg_volume_perlin(sg_stage_volume(sg_in_object_position)).gradient);\n");
}

TEST(EmitText, ASumTakesTheSignOfItsSecondOperand) {
    auto sum = [](const std::string& rest) {
        const std::string text = text_of(
            "%0 = time : Scalar\n%1 = facing : Scalar\n%2 = constant -0.25 : Scalar\n"
            "%3 = constant 0 : Scalar\n%4 = subtract %3 %1 : Scalar\n" +
            rest + "%7 = multiply %6 %6 : Scalar 'x'\noutput metallic = %7\n");
        const std::size_t begin = text.rfind(" = ") + 3;
        return text.substr(begin, text.find(';', begin) - begin);
    };
    const std::string nothing = "%5 = constant 7 : Scalar\n";
    EXPECT_EQ(sum(nothing + "%6 = subtract %0 %2 : Scalar\n"), "sg_stage_time() + 0.25");
    EXPECT_EQ(sum(nothing + "%6 = add %0 %2 : Scalar\n"), "sg_stage_time() - 0.25");
    EXPECT_EQ(sum(nothing + "%6 = add %2 %0 : Scalar\n"), "-0.25 + sg_stage_time()");
    EXPECT_EQ(sum(nothing + "%6 = add %0 %4 : Scalar\n"), "sg_stage_time() - sg_stage_facing()");
    EXPECT_EQ(sum("%5 = multiply %4 %0 : Scalar\n%6 = subtract %2 %5 : Scalar\n"),
              "-0.25 + sg_stage_facing() * sg_stage_time()");
    EXPECT_EQ(sum("%5 = subtract %4 %0 : Scalar\n%6 = subtract %2 %5 : Scalar\n"),
              "-0.25 - (-sg_stage_facing() - sg_stage_time())");
}

TEST(EmitText, ANodeKeepsItsName) {
    EXPECT_EQ(text_of("%0 = time : Scalar\n%1 = add %0 %0 : Scalar \"two times\"\n"
                      "%2 = multiply %1 %0 : Scalar 'a hint'\noutput metallic = %2\n"),
              "    float m_time = sg_stage_time();\n    float m_two_times = m_time + m_time;\n");
}

// The lines of a layer stand together, behind all that they need of others, with what is no layer's in front.
TEST(EmitText, LayersThatInterleaveAreTakenApart) {
    EXPECT_EQ(text_of(std::string(kHead) + R"(layer "a" noise
%3 = noise_perlin %2 : Noise 'noise'
layer "b" noise
%4 = noise_turbulence 3 %2 : Noise 'noise'
layer none
%5 = time : Scalar 'time'
layer "a" noise
%6 = noise_value %3 : Scalar
%7 = noise_gradient %6 %3 : LocalGrad
%8 = gradient_from_object %7 : VolGrad
%9 = scale_volgrad %5 %8 : VolGrad
layer "b" noise
%10 = noise_value %4 : Scalar
%11 = noise_gradient %10 %4 : LocalGrad
%12 = gradient_from_object %11 : VolGrad
%13 = scale_volgrad %5 %12 : VolGrad
layer none
%14 = add_volgrad %9 %13 : VolGrad
%15 = surfgrad_from_volume %1 %14 : SurfGrad
%16 = resolve %1 %15 : Normal 'normal'
output normal = %16
)"),
              R"(    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgVolume m_volume_object = sg_stage_volume(sg_in_object_position);
    float m_time = sg_stage_time();

    // a: noise
    SgNoise m_a_noise = sg_volume_perlin(m_volume_object);
    vec3 m_a = m_time * sg_stage_gradient_from_object(m_a_noise.value * m_a_noise.gradient);

    // b: noise
    SgNoise m_b_noise = sg_volume_turbulence(m_volume_object, 3);
    vec3 m_b = m_time * sg_stage_gradient_from_object(m_b_noise.value * m_b_noise.gradient);
)");
}

// What is no layer's, but made of a layer's value for another one of it, stands among that layer's lines.
TEST(EmitText, AValueBetweenTwoOfALayerStandsAmongThem) {
    EXPECT_EQ(text_of(std::string(kHead) + R"(layer "a" noise
%3 = noise_perlin %2 : Noise 'noise'
%4 = noise_value %3 : Scalar
layer none
%5 = power %4 %4 : Scalar 'share'
layer "a" noise
%6 = noise_gradient %5 %3 : LocalGrad
%7 = gradient_from_object %6 : VolGrad
%8 = scale_volgrad %5 %7 : VolGrad
layer none
%9 = surfgrad_from_volume %1 %8 : SurfGrad
output gradient = %9
)"),
              R"(    // a: noise
    SgNoise m_a_noise = sg_volume_perlin(sg_stage_volume(sg_in_object_position));
    float m_share = sg_power(m_a_noise.value, m_a_noise.value);
    vec3 m_a = m_share * sg_stage_gradient_from_object(m_share * m_a_noise.gradient);
)");
}

TEST(EmitText, DerivativesStandInFrontOfParallaxAndAlphaTests) {
    const std::string once = std::string(kHead) + "%3 = height %2 : Scalar\noutput opacity = %3\n";
    EXPECT_EQ(text_of(once), "");
    EXPECT_EQ(text_of(once + "output cutoff = %3\n"),
              "    SgVolume m_volume_object = sg_stage_volume(sg_in_object_position);\n");
}

// No expression grows without bounds: neither readers nor parsers have to follow it.
TEST(EmitText, AnExpressionOfThousandsOfValuesIsTakenApart) {
    std::string module = "%0 = time : Scalar\n%1 = facing : Scalar\n";
    for (int i = 2; i < 5000; ++i)
        module += fmt::format("%{} = clamp %{} %{} %{} : Scalar\n", i, 0, i - 1, 1);
    const std::string text = text_of(module + "output metallic = %4999\n");
    std::size_t longest = 0, lines = 0;
    for (std::size_t at = 0; at < text.size(); ++lines) {
        const std::size_t end = text.find('\n', at);
        longest = std::max(longest, end - at);
        at = end + 1;
    }
    EXPECT_LE(longest, kLongestExpression + 100);
    EXPECT_LE(lines, 5000u / 10);
}

TEST(Wrap, BreaksWhereAPersonWould) {
    // Short lines, comments and empty lines stay.
    const std::string comment = "    // " + std::string(120, 'x') + "\n";
    EXPECT_EQ(wrapped("    x = f(a, b);\n\n" + comment), "    x = f(a, b);\n\n" + comment);
    const std::string a(40, 'a'), b(40, 'b'), c(40, 'c'), d(60, 'd');
    // In line behind the parenthesis.
    EXPECT_EQ(wrapped("    x = f(" + a + ", " + b + ", " + c + ");\n"),
              "    x = f(" + a + ", " + b + ",\n          " + c + ");\n");
    // Farther in where that leaves too little room, and one to a line where one of them is broken itself.
    EXPECT_EQ(wrapped("    " + d + " = f(" + a + ", g(" + b + "));\n"),
              "    " + d + " = f(\n        " + a + ", g(" + b + "));\n");
    EXPECT_EQ(wrapped("    x = f(g(" + a + ", " + b + ", " + c + "), u, v);\n"),
              "    x = f(\n        g(" + a + ", " + b + ",\n          " + c + "),\n        u, v);\n");
    // Calls of one argument open together.
    EXPECT_EQ(wrapped("    x = f(g(h(" + a + ", " + b + ", " + c + ").xyz));\n"),
              "    x = f(g(h(" + a + ", " + b + ",\n              " + c + ").xyz));\n");
    // Sums and products.
    EXPECT_EQ(wrapped("    x = " + a + " + " + b + " - " + c + ";\n"),
              "    x = " + a + " + " + b + " -\n        " + c + ";\n");
    EXPECT_EQ(wrapped("    x = 2.0 * f(" + a + ", " + b + ", g(" + c + "));\n"),
              "    x = 2.0 * f(" + a + ", " + b + ",\n                g(" + c + "));\n");
    // A comment behind a statement goes in front of it.
    EXPECT_EQ(wrapped("    x = f(" + a + ", " + b + ");  // the view's name\n"),
              "    // the view's name\n    x = f(" + a + ", " + b + ");\n");
    // A word without a place to break stays as it is.
    EXPECT_EQ(wrapped("    x = " + std::string(150, 'w') + ";\n"),
              "    x = " + std::string(150, 'w') + ";\n");
}

// Whatever the text, wrapping changes blanks and line breaks alone, and no line is longer than need be.
TEST(Wrap, ChangesNothingButBlanks) {
    auto dense = [](std::string text) {
        std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
        return text;
    };
    std::uint32_t state = 1;
    auto below = [&](std::uint32_t n) { return (state = state * 1664525u + 1013904223u) / 65536u % n; };
    for (int round = 0; round < 2000; ++round) {
        std::string line = "    vec3 m_x = ";
        int open = 0;
        for (std::uint32_t words = 5 + below(60); words > 0; --words) {
            line += std::string(1 + below(20), 'w');
            switch (below(open > 0 ? 5 : 3)) {
                case 0:
                    line += '(';
                    ++open;
                    continue;
                case 1:
                    line += " + ";
                    continue;
                case 2:
                    line += " * ";
                    continue;
                case 3:
                    line += ", ";
                    continue;
                default:
                    line += ')';
                    --open;
                    line += " - ";
                    continue;
            }
        }
        line += 'e' + std::string(static_cast<std::size_t>(open), ')') + ";\n";
        const std::string out = wrapped(line);
        EXPECT_EQ(dense(out), dense(line));
        for (std::size_t at = 0; at < out.size();) {
            const std::size_t end = out.find('\n', at), first = out.find_first_not_of(' ', at);
            const std::string words = out.substr(first, end - first);
            EXPECT_TRUE(end - at <= kLineLimit || words.find(", ") == words.npos) << out;
            at = end + 1;
        }
    }
}

}  // namespace
}  // namespace sg::emit
