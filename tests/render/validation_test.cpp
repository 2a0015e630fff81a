// At the end of all tests of this binary: the validation layers said nothing, whatever was drawn.
#include <gtest/gtest.h>

#include "tests/render/workshop.hpp"

namespace sg::truth {
namespace {

class Silence : public testing::Environment {
    void TearDown() override { EXPECT_EQ(validation_messages(), std::vector<std::string>{}); }
};
[[maybe_unused]] const auto* const kSilence = testing::AddGlobalTestEnvironment(new Silence);

}  // namespace
}  // namespace sg::truth
