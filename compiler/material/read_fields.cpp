#include <fmt/core.h>

#include <cmath>

#include "material/reader.hpp"

namespace sg::material {

using json::Kind;
using json::Value;
using layers::Field;
using layers::FieldKind;

// Numbers, "$parameter" and, where `nodes`, "@node" or a node in place.
std::optional<Expression> Reader::expression(ObjectReader& reader, std::string_view key, std::size_t count,
                                             Range range, bool spread, bool nodes) {
    const Value* value = reader.get(key);
    if (!value) return std::nullopt;
    Expression found{.at = reader.at(key, *value)};
    if (value->kind == Kind::string && value->string.starts_with('$')) {
        found.kind = Expression::Kind::parameter;
        found.name = value->string.substr(1);
        return found;
    }
    if (nodes && value->kind == Kind::string && value->string.starts_with('@')) {
        found.kind = Expression::Kind::node_name;
        found.name = value->string.substr(1);
        return found;
    }
    if (nodes && value->kind == Kind::object) {
        found.kind = Expression::Kind::node;
        found.node = out.nodes.size();
        out.nodes.emplace_back();
        const bool unchannelled = count == 1 && !value->find("op") && !value->find("channel");
        if (unchannelled && value->find("texture"))
            reader.error(Code::node_type, found.at,
                         fmt::format("the colour of a texture for '{}', expected a number: add \"channel\": "
                                     "\"r\", \"g\", \"b\" or \"a\"",
                                     key));
        node(*value, found.at.pointer, found.node, count == 1);
        return found;
    }
    auto numbers = reader.numbers(key, count, range, spread,
                                  nodes ? "a \"$parameter\", a \"@node\" or a node" : "a \"$parameter\"");
    if (!numbers) return std::nullopt;
    found.numbers = std::move(*numbers);
    return found;
}

std::optional<layers::Coordinate> Reader::coordinate(ObjectReader& reader, std::string_view key) {
    const Value* value = reader.get(key);
    layers::Coordinate found;
    if (value->kind != Kind::object) {
        auto set = reader.integer(key, {0, 7}, false, "a uv set or an object");
        if (!set) return std::nullopt;
        found.set = *set;
        return found;
    }
    std::vector<std::string_view> keys;
    for (const layers::CoordinateKey& row : layers::coordinate_keys()) keys.push_back(row.name);
    ObjectReader inner = object(*value, reader.at(key, *value).pointer, "a coordinate", keys);
    auto range = [](const layers::CoordinateKey& row) { return Range{row.minimum, row.maximum}; };
    auto pair = [&](layers::CoordinateKeyIndex index, std::array<double, 2>& slot) {
        const layers::CoordinateKey& row = layers::coordinate_keys()[index];
        if (auto numbers = inner.numbers(row.name, 2, range(row), true, ""))
            slot = {(*numbers)[0], (*numbers)[1]};
    };
    const layers::CoordinateKey &set = layers::coordinate_keys()[layers::kSet],
                                &rotation = layers::coordinate_keys()[layers::kUvRotation];
    found.set = inner.integer(set.name, range(set)).value_or(0);
    found.rotation = inner.number(rotation.name, range(rotation)).value_or(0);
    pair(layers::kUvScale, found.scale);
    pair(layers::kUvOffset, found.offset);
    pair(layers::kUvSpeed, found.speed);
    return found;
}

std::optional<FieldEntry> Reader::field(ObjectReader& reader, const Field& row, std::size_t index) {
    const Value* value = reader.get(row.name, row.required);
    if (!value) return std::nullopt;
    FieldEntry entry{.field = index, .at = reader.at(row.name, *value)};
    Range range{row.minimum, row.maximum};
    auto take = [&](auto found, auto& slot) {
        if (found) slot = std::move(*found);
        return found.has_value() ? std::optional(entry) : std::nullopt;
    };
    switch (row.kind) {
        case FieldKind::texture:
            return take(reader.name(row.name), entry.word);
        case FieldKind::uv:
            return take(coordinate(reader, row.name), entry.uv);
        case FieldKind::choice:
            if (auto choice = reader.choice(row.name, row.choices, false)) {
                entry.index = static_cast<std::uint32_t>(*choice);
                return entry;
            }
            return std::nullopt;
        case FieldKind::flag:
            return take(reader.boolean(row.name), entry.index);
        case FieldKind::integer:
            return take(reader.integer(row.name, range), entry.index);
        case FieldKind::number:
            return take(expression(reader, row.name, 1, range, false, true), entry.expression);
        case FieldKind::pair:
            return take(expression(reader, row.name, 2, range, true, false), entry.expression);
        case FieldKind::color:
            return take(expression(reader, row.name, 3, range, true, true), entry.expression);
        case FieldKind::range:
            return take(reader.numbers(row.name, 2, range, false, ""), entry.expression.numbers);
        case FieldKind::matrix:
            if (value->kind != Kind::string || !value->string.starts_with('$')) {
                reader.error(Code::wrong_type, entry.at,
                             fmt::format("expected a \"$parameter\" of type 'mat4' for '{}', found {}",
                                         row.name, json::kind_name(value->kind)));
                return std::nullopt;
            }
            return take(expression(reader, row.name, 16, range, false, false), entry.expression);
        case FieldKind::entry:
            return take(reader.name(row.name), entry.word);
        case FieldKind::vector:
            return take(reader.numbers(row.name, 3, range, false, ""), entry.expression.numbers);
        case FieldKind::file:
            return take(reader.string(row.name), entry.word);
        case FieldKind::identifier:
            return take(reader.name(row.name), entry.word);
        case FieldKind::arguments:
            entry.arguments = arguments(reader, row.name);
            return entry;
        case FieldKind::layer:
            return std::nullopt;  // read with the layer, which holds it
        case FieldKind::direction:
            break;
    }
    auto numbers = reader.numbers(row.name, 3, {-1e6, 1e6}, false, "");
    if (!numbers) return std::nullopt;
    double length = std::hypot((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    if (!(length > 0)) {
        reader.error(Code::out_of_range, entry.at,
                     fmt::format("'{}' is 0, 0, 0, expected a direction", row.name));
        return std::nullopt;
    }
    for (double& n : *numbers) n /= length;
    entry.expression.numbers = std::move(*numbers);
    return entry;
}

std::vector<FieldEntry> Reader::entries(ObjectReader& reader, std::span<const Field> fields) {
    std::vector<FieldEntry> found;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (auto entry = field(reader, fields[i], i)) found.push_back(std::move(*entry));
    }
    return found;
}

}  // namespace sg::material
