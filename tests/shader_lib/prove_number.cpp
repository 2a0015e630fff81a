// Arithmetic that is defined everywhere (shader_lib/surfgrad/number.glsl) against double precision.
#include "harness.hpp"
#include "ir/reference/number.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/number.glsl";

double signed_magnitude(Random& random, double low, double high) {
    return random.sign() * random.magnitude(low, high);
}

Case divide() {
    return {.name = "divide",
            .include = kFile,
            .inputs = 2,
            .outputs = 1,
            .glsl = "put(0, sg_divide(f(0), f(1)));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.below(8) == 0 ? 0.0 : signed_magnitude(random, 1e-15, 1e15));
                    in.put(1, random.below(8) == 0 ? 0.0 : signed_magnitude(random, 1e-15, 1e15));
                },
            .reference = [](const In& in, Expect& out) { out.put(0, ref::divide(in[0], in[1])); },
            .bound = {.relative = 5 * kUlp},  // one quotient, 2.5 units in the last place by Vulkan's rules
            .mutants = {{kFile, "abs(b) > 0.0 ? a / b : 0.0", "a / b"},
                        {kFile, "abs(b) > 0.0 ? a / b", "b > 0.0 ? a / b"},
                        {kFile, "abs(b) > 0.0 ? a / b", "abs(b) > 0.0 ? b / a"},
                        {kFile, "abs(b) > 0.0 ? a / b", "abs(b) > 1.0 ? a / b"}}};
}

// By zeros of both signs and by not-a-number: 0, whatever is divided.
Case divide_by_nothing() {
    return {.name = "divide_by_nothing",
            .include = kFile,
            .inputs = 2,
            .outputs = 1,
            .glsl = "put(0, sg_divide(f(0), f(1)));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.wild());
                    in.put(1, random.coin() ? NAN : 0.0 * random.sign());
                },
            .property = [](const In&,
                           const In& out) { return std::string(out[0] == 0.0 ? "" : "something remains"); },
            .mutants = {{kFile, "abs(b) > 0.0 ? a / b", "b != 0.0 ? a / b"},
                        {kFile, "a / b : 0.0", "a / b : a"}}};
}

// pow(a, b) = exp2(b log2 a) on a GPU: log2 is off by 8 kUlp absolute and by one rounding of its size, the
// product rounds once, an error in the exponent is one relative in the result, exp2 adds 6 kUlp. Doubled.
Case power() {
    return {.name = "power",
            .include = kFile,
            .inputs = 2,
            .outputs = 1,
            .glsl = "put(0, sg_power(f(0), f(1)));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.magnitude(1e-3, 1e3));
                    if (random.below(8) == 0) in.put(0, -random.magnitude(1e-3, 1e3));
                    if (random.below(16) == 0) in.put(0, 0.0);
                    in.put(1, random.below(8) == 0 ? random.below(4) : random.uniform(-6.0, 6.0));
                },
            .reference = [](const In& in, Expect& out) { out.put(0, ref::positive_power(in[0], in[1])); },
            .bound = {.relative = 2 * kUlp},
            .condition =
                [](const In& in) {
                    const double log = in[0] > 0.0 ? std::abs(std::log2(in[0])) : 0.0;
                    return 6.0 + std::abs(in[1]) * (8.0 + 2.0 * log);
                },
            .mutants = {{kFile, "a > 0.0 ? pow(a, b)", "a > 0.0 ? pow(b, a)"},
                        {kFile, "a > 0.0 ? pow(a, b)", "a > 1.0 ? pow(a, b)"},
                        {kFile, "a > 0.0 ? pow(a, b)", "a > 0.0 ? pow(a, abs(b))"},
                        {kFile, "a > 0.0 ? pow(a, b) : 0.0", "pow(abs(a), b)"},
                        {kFile, "pow(a, b) : 0.0", "pow(a, b) : 1.0"}}};
}

// Of zero, of anything below it and of not-a-number: 0, whatever the exponent.
Case power_of_nothing() {
    return {.name = "power_of_nothing",
            .include = kFile,
            .inputs = 2,
            .outputs = 1,
            .glsl = "put(0, sg_power(f(0), f(1)));",
            .draw =
                [](Random& random, Draw& in) {
                    const float a = random.wild();
                    in.put(0, a > 0.0f ? -a : a);
                    in.put(1, random.wild());
                },
            .property = [](const In&,
                           const In& out) { return std::string(out[0] == 0.0 ? "" : "something remains"); },
            .mutants = {{kFile, "a > 0.0 ? pow(a, b)", "a != 0.0 ? pow(a, b)"},
                        {kFile, "a > 0.0 ? pow(a, b) : 0.0", "pow(a, b)"}}};
}

// low, high, x: rising, falling and without any width; x before, between and behind them, and on `low`.
void draw_step(Random& random, Draw& in) {
    const double low = random.uniform(-4.0, 4.0);
    const double width = random.below(8) == 0 ? 0.0 : signed_magnitude(random, 1e-3, 8.0);
    in.put(0, low);
    in.put(1, low + width);
    in.put(2, random.below(8) == 0 ? low : low + random.uniform(-0.5, 1.5) * (width == 0.0 ? 1.0 : width));
}

std::string in_range(const In& in, const In& out) {
    if (!(out[0] >= 0.0 && out[0] <= 1.0)) return "beyond 0..1";
    const bool number = !std::isnan(in[0]) && !std::isnan(in[1]) && !std::isnan(in[2]);
    return !number && out[0] != 0.0 ? "not-a-number is no step" : "";
}

Case step() {
    return {.name = "smoothstep",
            .include = kFile,
            .inputs = 3,
            .outputs = 1,
            .glsl = "put(0, sg_smoothstep(f(0), f(1), f(2)));",
            .draw = draw_step,
            .reference = [](const In& in, Expect& out) { out.put(0, ref::smoothstep(in[0], in[1], in[2])); },
            // t: two differences of what was read and a quotient, 3 roundings of at most 1, times the cubic's
            // slope of 1.5; the cubic itself 2 products, a doubling and a difference below 3: 5. Doubled.
            .bound = {.absolute = 20 * kUlp},
            .property = in_range,
            .mutants = {{kFile, "(x - low) / width", "(x - high) / width"},
                        {kFile, "float width = high - low;", "float width = abs(high - low);"},
                        {kFile, "abs(width) > 0.0 ?", "width > 0.0 ?"},
                        {kFile, "x >= low && x >= high", "x > low && x > high"},
                        {kFile, "(x >= low && x >= high ? 1.0 : 0.0)", "0.0"},
                        {kFile, "t < 1.0 ? t : 1.0", "t"},
                        {kFile, "t > 0.0 ? inside : 0.0", "inside"},
                        {kFile, "(3.0 - 2.0 * clamped)", "(2.0 - 1.0 * clamped)"},
                        {kFile, "clamped * clamped * (", "clamped * ("}}};
}

Case wild_step() {
    Case item = step();
    item.name = "smoothstep_any_input";
    item.draw = [](Random& random, Draw& in) {
        for (std::size_t k = 0; k < 3; ++k) in.put(k, random.wild());
    };
    item.reference = {};
    item.mutants = {{kFile, "t > 0.0 ? inside : 0.0", "t < 0.0 ? 0.0 : inside"},
                    {kFile, "x >= low && x >= high", "x >= low"},
                    {kFile, "t < 1.0 ? t : 1.0", "t"}};
    return item;
}

std::vector<Case> cases() {
    return {divide(), divide_by_nothing(), power(), power_of_nothing(), step(), wild_step()};
}

SG_PROVE(Number, cases());

// The cubic is settled by its ends: its values there, and that it leaves them flat.
TEST(NumberReference, TheStepIsTheCubicFlatAtBothEnds) {
    constexpr double kStep = 1e-6;
    auto slope = [](double x) {
        return (ref::smoothstep(2.0, 4.0, x + kStep) - ref::smoothstep(2.0, 4.0, x - kStep)) / (2.0 * kStep);
    };
    EXPECT_EQ(ref::smoothstep(2.0, 4.0, 2.0), 0.0);
    EXPECT_EQ(ref::smoothstep(2.0, 4.0, 4.0), 1.0);
    EXPECT_EQ(ref::smoothstep(2.0, 4.0, 3.0), 0.5);
    EXPECT_NEAR(ref::smoothstep(2.0, 4.0, 2.5), 0.15625, 1e-15);
    EXPECT_NEAR(slope(2.0), 0.0, 2e-6);
    EXPECT_NEAR(slope(3.0), 0.75, 1e-9);
    EXPECT_NEAR(slope(4.0), 0.0, 2e-6);
}

TEST(NumberReference, WhatHasNoAnswerIsZero) {
    EXPECT_EQ(ref::divide(3.0, 0.0), 0.0);
    EXPECT_EQ(ref::divide(3.0, -0.0), 0.0);
    EXPECT_EQ(ref::divide(3.0, NAN), 0.0);
    EXPECT_EQ(ref::positive_power(0.0, 0.0), 0.0);
    EXPECT_EQ(ref::positive_power(-2.0, 2.0), 0.0);
    EXPECT_EQ(ref::positive_power(NAN, 2.0), 0.0);
    EXPECT_EQ(ref::smoothstep(0.0, 1.0, NAN), 0.0);
    EXPECT_EQ(ref::smoothstep(1.0, 1.0, NAN), 0.0);
    EXPECT_EQ(ref::smoothstep(0.0, NAN, 1.0), 0.0);
    EXPECT_EQ(ref::smoothstep(NAN, 1.0, 2.0), 0.0);
}

}  // namespace
}  // namespace sg::proof
