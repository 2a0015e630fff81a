#include <fmt/core.h>

#include <algorithm>

#include "material/reader.hpp"

namespace sg::material {

using json::Value;
using layers::Field;
using layers::LayerKind;
using layers::NodeKind;

namespace {

constexpr std::string_view kGroup = "group";

void add_names(std::vector<std::string_view>& keys, std::span<const Field> fields) {
    for (const Field& row : fields) keys.push_back(row.name);
}

}  // namespace

std::optional<LayerDecl> Reader::group(const Value& value, const std::string& pointer) {
    std::vector<std::string_view> keys = {"id", "kind", "layers"};
    add_names(keys, layers::common_fields());
    ObjectReader reader = object(value, pointer, "a group", keys);
    LayerDecl decl{.at = reader.at()};
    decl.id = reader.id();
    decl.common = entries(reader, layers::common_fields());
    for (const auto& [item, item_pointer] : reader.array("layers", true)) {
        if (auto found = layer(*item, item_pointer)) decl.group.layers.push_back(std::move(*found));
    }
    return decl;
}

std::optional<LayerDecl> Reader::layer(const Value& value, const std::string& pointer) {
    // The kind decides which keys there are, so it is looked up first.
    const Value* kind_value = value.kind == json::Kind::object ? value.find("kind") : nullptr;
    const LayerKind* kind = nullptr;
    if (kind_value && kind_value->kind == json::Kind::string) {
        if (kind_value->string == kGroup) return group(value, pointer);
        kind = layers::find_kind(kind_value->string);
        if (!kind) {
            std::vector<std::string_view> names = {kGroup};
            for (const LayerKind* k : layers::all_kinds()) names.push_back(k->name);
            std::string hint = did_you_mean(kind_value->string, names);
            if (hint.empty()) hint = fmt::format(", expected {}", one_of(names));
            diags.error(Code::unknown_kind, {source, kind_value->span, pointer + "/kind"},
                        fmt::format("unknown layer kind '{}'{}", printable(kind_value->string), hint));
            return std::nullopt;
        }
    }
    std::vector<std::string_view> keys = {"id", "kind"};
    if (kind) {
        add_names(keys, kind->fields);
        add_names(keys, layers::common_fields());
    } else if (value.kind == json::Kind::object) {
        keys = {};  // unknowable without a kind
    }
    ObjectReader reader =
        object(value, pointer, kind ? fmt::format("a layer of kind '{}'", kind->name) : "a layer", keys);
    if (!reader.string("kind", true) || !kind) return std::nullopt;
    LayerDecl decl{.kind = kind, .at = reader.at()};
    decl.id = reader.id();
    decl.entries = entries(reader, kind->fields);
    decl.common = entries(reader, layers::common_fields());
    for (const Field& row : kind->fields) {
        if (row.kind == layers::FieldKind::layer) equivalent(reader, row, decl);
    }
    return decl;
}

// The layer that a user's function must amount to.
void Reader::equivalent(ObjectReader& reader, const Field& row, LayerDecl& decl) {
    const Value* written = reader.get(row.name);
    if (!written) return;
    At at = reader.at(row.name, *written);
    auto found = layer(*written, at.pointer);
    if (!found) return;
    auto calls = [](const auto& self, const LayerDecl& layer) -> bool {
        return !layer.equivalent.empty() ||
               (layer.kind &&
                std::any_of(layer.kind->fields.begin(), layer.kind->fields.end(),
                            [](const Field& f) { return f.kind == layers::FieldKind::file; })) ||
               std::any_of(layer.group.layers.begin(), layer.group.layers.end(),
                           [&](const LayerDecl& inner) { return self(self, inner); });
    };
    if (calls(calls, *found)) {
        reader.error(Code::unused_setting, at,
                     fmt::format("'{}' calls GLSL itself, expected layers of other kinds", row.name));
        return;
    }
    decl.equivalent.push_back(std::move(*found));
}

ParallaxDecl Reader::parallax(const Value& value, const std::string& pointer) {
    const Value* kind_value = value.kind == json::Kind::object ? value.find("kind") : nullptr;
    const layers::ParallaxKind* kind = nullptr;
    if (kind_value && kind_value->kind == json::Kind::string) {
        kind = layers::find_parallax_kind(kind_value->string);
        if (!kind) {
            std::vector<std::string_view> names;
            for (const layers::ParallaxKind& k : layers::all_parallax_kinds()) names.push_back(k.name);
            std::string hint = did_you_mean(kind_value->string, names);
            if (hint.empty()) hint = fmt::format(", expected {}", one_of(names));
            diags.error(Code::unknown_kind, {source, kind_value->span, pointer + "/kind"},
                        fmt::format("unknown parallax kind '{}'{}", printable(kind_value->string), hint));
            return {.at = {value.span, pointer}};
        }
    }
    std::vector<std::string_view> keys = {"kind"};
    if (kind) {
        add_names(keys, kind->fields);
    } else if (value.kind == json::Kind::object) {
        keys = {};
    }
    ObjectReader reader = object(
        value, pointer, kind ? fmt::format("a parallax of kind '{}'", kind->name) : "a parallax", keys);
    if (!reader.string("kind", true) || !kind) return {.at = reader.at()};
    return {kind, reader.at(), entries(reader, kind->fields)};
}

void Reader::stage(const Value& value, const std::string& pointer) {
    ObjectReader reader = object(value, pointer, "an entry of 'bump'", {"id", "parallax", "layers"});
    if (!reader.ok()) return;
    StageDecl decl{.at = reader.at()};
    decl.id = reader.id();
    if (const Value* found = reader.get("parallax")) decl.parallax = parallax(*found, pointer + "/parallax");
    for (const auto& [item, item_pointer] : reader.array("layers", true)) {
        if (auto found = layer(*item, item_pointer)) decl.layers.push_back(std::move(*found));
    }
    out.bump.push_back(std::move(decl));
}

// A node without "op" that names a texture is short for reading it: its channel, or its colour.
void Reader::node(const Value& value, const std::string& pointer, std::size_t index, bool number) {
    out.nodes[index].at = {value.span, pointer};
    const Value* op = value.kind == json::Kind::object ? value.find("op") : nullptr;
    const NodeKind* kind = nullptr;
    if (op && op->kind == json::Kind::string) {
        kind = layers::find_node_kind(op->string);
        if (!kind) {
            std::vector<std::string_view> names;
            for (const NodeKind& k : layers::all_node_kinds()) names.push_back(k.name);
            std::string hint = did_you_mean(op->string, names);
            if (hint.empty()) hint = fmt::format(", expected {}", one_of(names));
            diags.error(Code::unknown_kind, {source, op->span, pointer + "/op"},
                        fmt::format("unknown node '{}'{}", printable(op->string), hint));
            return;
        }
    } else if (!op && value.kind == json::Kind::object && value.find("texture")) {
        kind = layers::find_node_kind(number || value.find("channel") ? "texture" : "texture_color");
    }
    std::vector<std::string_view> keys = {"op"};
    if (kind) {
        add_names(keys, kind->fields);
    } else if (value.kind == json::Kind::object) {
        keys = {};
    }
    ObjectReader reader =
        object(value, pointer, kind ? fmt::format("a node of kind '{}'", kind->name) : "a node", keys);
    if (!kind) {
        reader.string("op", true);
        return;
    }
    std::vector<FieldEntry> found =
        entries(reader, kind->fields);  // may add nodes: no reference is held across it
    out.nodes[index].kind = kind;
    out.nodes[index].entries = std::move(found);
}

// A named node that is a number, a colour or a "$parameter" is short for one that has this value.
bool Reader::constant_node(ObjectReader& nodes, const json::Member& member, std::size_t index) {
    const Value& value = member.value;
    bool reference = value.kind == json::Kind::string && value.string.starts_with('$');
    bool color = value.kind == json::Kind::array;
    if (value.kind == json::Kind::object) return false;
    if (!reference && !color && value.kind != json::Kind::number) {
        nodes.error(
            Code::wrong_type, nodes.at(member.key, value),
            fmt::format("expected a number, an array of 3 numbers, a \"$parameter\" or a node for '{}', "
                        "found {}",
                        printable(member.key),
                        value.kind == json::Kind::string && value.string.starts_with('@')
                            ? fmt::format("\"{}\" (a node needs no second name)", printable(value.string))
                            : std::string(json::kind_name(value.kind))));
        return true;
    }
    for (const ParameterDecl& p : out.parameters) {
        if (reference && p.name.value == value.string.substr(1))
            color = p.type == ParameterType::color || p.type == ParameterType::vec3;
    }
    const NodeKind* kind = layers::find_node_kind(color ? "constant_color" : "constant");
    const Field& field = kind->fields.front();
    FieldEntry entry{.field = 0, .at = nodes.at(member.key, value)};
    out.nodes[index].at = entry.expression.at = entry.at;
    if (reference) {
        entry.expression.kind = Expression::Kind::parameter;
        entry.expression.name = value.string.substr(1);
    } else if (auto numbers = nodes.numbers(member.key, color ? 3 : 1, {field.minimum, field.maximum}, false,
                                            "a number, a \"$parameter\" or a node")) {
        entry.expression.numbers = std::move(*numbers);
    } else {
        return true;
    }
    out.nodes[index].kind = kind;
    out.nodes[index].entries.push_back(std::move(entry));
    return true;
}

// All names are known before any node is read, so that nodes written in place come behind them.
void Reader::named_nodes(ObjectReader& reader) {
    auto members = reader.named("nodes");
    if (members.empty()) return;
    const Value& whole = *reader.get("nodes");
    ObjectReader nodes = object(whole, reader.at("nodes", whole).pointer, "nodes", {});
    for (const auto& [member, pointer] : members) {
        out.nodes.push_back({.name = {member->key, {member->key_span, pointer}}});
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (!constant_node(nodes, *members[i].first, i)) node(members[i].first->value, members[i].second, i);
    }
}

}  // namespace sg::material
