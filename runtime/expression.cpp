#include "runtime/expression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sg::runtime {
namespace {

double smoothstep(double low, double high, double x) {
    if (low == high) return x >= low ? 1 : 0;
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Numbers unit(const Numbers& v) {
    const double length = std::max(std::hypot(v[0], v[1], v[2]), 1e-15);
    return {{v[0] / length, v[1] / length, v[2] / length}, 3};
}

constexpr ExpressionWord kWords[] = {
    {"add", 2, [](double a, double b, double) { return a + b; }},
    {"subtract", 2, [](double a, double b, double) { return a - b; }},
    {"multiply", 2, [](double a, double b, double) { return a * b; }},
    {"divide", 2, [](double a, double b, double) { return b == 0 ? 0 : a / b; }},
    {"minimum", 2, [](double a, double b, double) { return std::min(a, b); }},
    {"maximum", 2, [](double a, double b, double) { return std::max(a, b); }},
    {"mix", 3, [](double a, double b, double t) { return a + t * (b - a); }},
    {"clamp", 3, [](double x, double low, double high) { return std::min(std::max(x, low), high); }},
    {"smoothstep", 3, smoothstep},
    {"power", 2, [](double a, double b, double) { return a > 0 ? std::pow(a, b) : 0; }},
};

}  // namespace

std::span<const ExpressionWord> expression_words() {
    return kWords;
}

std::size_t expression_count(const Expression& expression, std::span<const std::size_t> parameters,
                             std::span<const std::size_t> steps) {
    auto of = [&](const Expression& operand) { return expression_count(operand, parameters, steps); };
    switch (expression.kind) {
        case Expression::Kind::numbers:
            return expression.numbers.count;
        case Expression::Kind::parameter:
            return parameters[expression.index];
        case Expression::Kind::step:
            return steps[expression.index];
        case Expression::Kind::channel:
            return expression.index < of(expression.operands[0]) ? 1 : 0;
        case Expression::Kind::rgb:
            return of(expression.operands[0]) >= 3 ? 3 : 0;
        case Expression::Kind::row:
            return of(expression.operands[0]) == 16 && expression.index < 3 ? 3 : 0;
        case Expression::Kind::unit:
            return of(expression.operands[0]) == 3 ? 3 : 0;
        case Expression::Kind::word:
            break;
    }
    std::size_t count = 1;
    for (const Expression& operand : expression.operands) {
        const std::size_t own = of(operand);
        if (own == 0 || (own != 1 && count != 1 && own != count)) return 0;
        count = std::max(count, own);
    }
    return count;
}

Numbers evaluate(const Expression& expression, std::span<const Numbers> parameters,
                 std::span<const Numbers> steps) {
    switch (expression.kind) {
        case Expression::Kind::numbers:
            return expression.numbers;
        case Expression::Kind::parameter:
            return parameters[expression.index];
        case Expression::Kind::step:
            return steps[expression.index];
        case Expression::Kind::channel:
            return {{evaluate(expression.operands[0], parameters, steps)[expression.index]}, 1};
        case Expression::Kind::rgb: {
            Numbers out = evaluate(expression.operands[0], parameters, steps);
            out.count = 3;
            return out;
        }
        case Expression::Kind::row: {
            const Numbers matrix = evaluate(expression.operands[0], parameters, steps);
            const std::size_t row = expression.index;
            return {{matrix[row], matrix[4 + row], matrix[8 + row]}, 3};
        }
        case Expression::Kind::unit:
            return unit(evaluate(expression.operands[0], parameters, steps));
        case Expression::Kind::word:
            break;
    }
    std::array<Numbers, 3> operands;
    Numbers out;
    for (std::size_t i = 0; i < expression.operands.size(); ++i) {
        operands[i] = evaluate(expression.operands[i], parameters, steps);
        out.count = std::max(out.count, operands[i].count);
    }
    const ExpressionWord& word = kWords[expression.index];
    for (std::size_t c = 0; c < out.count; ++c)
        out.at[c] = word.compute(operands[0][c], operands[1][c], operands[2][c]);
    return out;
}

float stored(double value) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return std::isnan(value) ? 0.0F : static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

}  // namespace sg::runtime
