// The manifest's expressions of parameters (compiler/artefacts.md), computed in double precision.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace sg::runtime {

// One to four numbers, or the 16 of a matrix by its columns, of which expressions only take rows. A single
// one stands for as many as are wanted.
struct Numbers {
    std::array<double, 16> at{};
    std::size_t count = 1;
    [[nodiscard]] double operator[](std::size_t i) const { return at[count == 1 ? 0 : i]; }
};

// A word of the grammar that computes each component from those of its operands.
struct ExpressionWord {
    std::string_view word;
    std::size_t operands = 0;  // at most 3
    double (*compute)(double a, double b, double c) = nullptr;
};
std::span<const ExpressionWord> expression_words();

struct Expression {
    enum class Kind { numbers, parameter, step, word, channel, rgb, row, unit };
    Kind kind = Kind::numbers;
    Numbers numbers;
    std::size_t index = 0;  // of the parameter, the step, the word, the channel or the row
    std::vector<Expression> operands;
};

// How many numbers it gives, when the parameters and the steps have these counts; 0 if its operands do not go
// together.
std::size_t expression_count(const Expression& expression, std::span<const std::size_t> parameters,
                             std::span<const std::size_t> steps);

Numbers evaluate(const Expression& expression, std::span<const Numbers> parameters,
                 std::span<const Numbers> steps);

// What a block holds: the nearest finite float, 0 for what is no number.
float stored(double value);

}  // namespace sg::runtime
