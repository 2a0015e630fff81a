// What the files of rules share.
#pragma once

#include <vector>

#include "opt/optimise.hpp"

namespace sg::opt {

// A value like this one without its name: for the parts of a sum, which belong to no layer's name.
inline ir::Value unnamed(const ir::Value& value) {
    ir::Value like = value;
    like.name = "";
    like.is_node = false;
    return like;
}

inline bool is_constant(const ir::Value* value, double number) {
    return value && value->op == ir::Op::constant && value->number[0] == number;
}

// Those of numbers, colours, coordinates and frames (value_rules.cpp).
std::vector<Rule> rules_of_values();

}  // namespace sg::opt
