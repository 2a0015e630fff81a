// The table of layer kinds: one row per kind, one file per row. Reading, checking, defaults, ranges, the
// documentation table and lowering all come from the row; nothing else in the compiler names a kind.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/ir.hpp"

namespace sg::layers {

enum class FieldKind {
    texture,  // the name of a declared texture
    uv_set,   // 0..7
    choice,   // one of `choices`
    number,   // a number or "$parameter" of type float
    pair,     // a number (for both), two numbers, or "$parameter" of type float or vec2
};

struct Field {
    std::string_view name;
    FieldKind kind{};
    bool required = false;
    double fallback = 0;  // number, pair (both), uv_set; for a choice: the index of the default
    double minimum = 0;   // number, pair
    double maximum = 0;
    std::vector<std::string_view> choices;              // choice
    std::string_view unit;                              // of numbers; "" for a plain factor
    std::string_view doc;
};

// The checked value of a field: which member counts follows from the field's kind.
struct FieldValue {
    std::array<double, 2> number{};  // number, pair
    ir::ParameterId parameter;       // number, pair: valid when a parameter stands there instead
    std::uint32_t index = 0;         // texture: into the module's textures; uv_set; choice
};

// A fault that only shows when fields are seen together.
struct FieldFault {
    std::size_t field = 0;
    std::string message;
};

class LowerContext;

struct LayerKind {
    std::string_view name;
    std::string_view doc;
    std::vector<Field> fields;
    // At most one fault of the values together; every single value is valid already.
    std::optional<FieldFault> (*check)(std::span<const FieldValue> values);
    // The layer's surface gradient. Cannot fail: everything that a user can get wrong was found before.
    ir::ValueId (*lower)(LowerContext& context, std::span<const FieldValue> values);
};

// All kinds, by name. The registry is an explicit list (layer_kinds.cpp).
std::span<const LayerKind* const> all_kinds();
const LayerKind* find_kind(std::string_view name);

}  // namespace sg::layers
