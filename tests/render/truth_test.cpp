// Rendered normals against calculus, case by case.
#include "tests/render/truth.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace sg::truth {
namespace {

class AnalyticTruth : public testing::TestWithParam<Case> {};

TEST_P(AnalyticTruth, HoldsWithinItsBound) {
    const Outcome o = run_case(GetParam(), target::embedded_library());
    const std::string report = fmt::format(
        "{:46} median {:.4f} (bound {:.4f})  p99 {:.4f} (bound {:.4f} = filter {:.4f} + quantisation {:.4f} "
        "+ tessellation "
        "{:.4f} + basis {:.4f} + arithmetic {:.4f})  max {:.4f}  of {} pixels\n",
        GetParam().name, o.error.median, o.bound.median(), o.error.p99, o.bound.p99(), o.bound.filter,
        o.bound.quantisation, o.bound.tessellation, o.bound.basis, o.bound.arithmetic, o.error.max,
        o.error.count);
    fmt::print("{}", report);
    EXPECT_TRUE(o.holds()) << report;
    EXPECT_LT(o.bound.p99(), 0.3);  // a bound that says nothing would not be worth its derivation
}

INSTANTIATE_TEST_SUITE_P(Cases, AnalyticTruth, testing::ValuesIn(all_cases()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace sg::truth
