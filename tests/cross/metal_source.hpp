// One C++ file out of many Metal texts.
#pragma once

#include <string>
#include <vector>

namespace sg::cross {

// Each text in a namespace of its own, called "text<i>.metal" in messages; with `callable`, each also as an
// extern "C" function "sg_call_<i>" of driver.hpp's types.
std::string metal_source(const std::vector<std::string>& texts, bool callable);

}  // namespace sg::cross
