#include <fmt/core.h>

#include <algorithm>

#include "base/ice.hpp"
#include "material/checker.hpp"

namespace sg::material {

using layers::Field;
using layers::FieldKind;
using layers::FieldValue;

namespace {

// ", did you mean 'x'?" or ", expected 'x' or 'y'" or ", the material declares no things".
template <class Decl>
std::string hint(std::string_view name, const std::vector<Decl>& decls, std::string_view things) {
    std::vector<std::string_view> names;
    for (const Decl& decl : decls) {
        if (!decl.name.value.empty()) names.push_back(decl.name.value);
    }
    std::string near = did_you_mean(name, names);
    if (!near.empty()) return near;
    return names.empty() ? fmt::format(", the material declares no {}", things)
                         : fmt::format(", expected {}", one_of(names));
}

std::string other_sign(char sign, std::string_view name) {
    return fmt::format(", did you mean \"{}{}\"?", sign, printable(name));
}

std::span<const ParameterType> types_for(FieldKind kind) {
    using enum ParameterType;
    static constexpr ParameterType kNumber[] = {scalar, integer, boolean}, kPair[] = {scalar, vec2, integer},
                                   kColor[] = {color, vec3}, kMatrix[] = {matrix};
    if (kind == FieldKind::pair) return kPair;
    if (kind == FieldKind::matrix) return kMatrix;
    return kind == FieldKind::color ? std::span<const ParameterType>(kColor) : kNumber;
}

}  // namespace

std::optional<layers::FieldFault> broken_rule(std::span<const Field> fields,
                                              std::span<const layers::Rule> rules,
                                              layers::FieldValues found) {
    auto index_of = [&](std::string_view name) {
        auto row = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
        SG_ASSERT(row != fields.end());
        return static_cast<std::size_t>(row - fields.begin());
    };
    auto word_of = [&](std::size_t i) { return fields[i].choices[found[i].index]; };
    for (const layers::Rule& rule : rules) {
        const std::size_t field = index_of(rule.field), other = index_of(rule.other);
        if (rule.word.empty() ? !found[field].given : word_of(field) != rule.word) continue;
        bool holds = true;
        switch (rule.asks) {
            case layers::Rule::Asks::choice:
                holds = std::find(rule.words.begin(), rule.words.end(), word_of(other)) != rule.words.end();
                break;
            case layers::Rule::Asks::absence:
                holds = !found[other].given;
                break;
            case layers::Rule::Asks::plain_uv:
                holds = found[other].uv.set == 0 && found[other].uv.rotation == 0;
                break;
        }
        if (!holds) return layers::FieldFault{field, std::string(rule.message)};
    }
    return std::nullopt;
}

std::optional<std::size_t> Checker::find_texture(const std::string& name, const At& at) {
    if (auto found = textures_by_name.find(name); found != textures_by_name.end()) return found->second;
    if (name.starts_with('$')) {
        static constexpr ParameterType kTexture[] = {ParameterType::texture};
        find_parameter(name.substr(1), at, kTexture);  // says what is wrong
        return std::nullopt;
    }
    error(Code::unknown_texture, at,
          fmt::format("unknown texture '{}'{}", printable(name), hint(name, in.textures, "textures")));
    return std::nullopt;
}

const ParameterDecl* Checker::find_parameter(const std::string& name, const At& at,
                                             std::span<const ParameterType> types) {
    auto found = parameters_by_name.find(name);
    if (found == parameters_by_name.end()) {
        error(Code::unknown_parameter, at,
              fmt::format("unknown parameter '{}'{}", printable(name),
                          nodes_by_name.contains(name) ? other_sign('@', name)
                                                       : hint(name, in.parameters, "parameters")));
        return nullptr;
    }
    const ParameterDecl& decl = in.parameters[found->second];
    if (!decl.faulty && std::find(types.begin(), types.end(), decl.type) == types.end()) {
        std::vector<std::string_view> expected;
        for (ParameterType type : types) expected.push_back(parameter_type_name(type));
        error(Code::parameter_type, at,
              fmt::format("parameter '{}' is of type '{}', expected {}", printable(name),
                          parameter_type_name(decl.type), one_of(expected)),
              {note("it is declared here", decl.name.at)});
    }
    return &decl;
}

ir::ParameterId Checker::id_of(const ParameterDecl& decl) const {
    return parameter_index[static_cast<std::size_t>(&decl - in.parameters.data())];
}

void Checker::parameter_limits(const ParameterDecl& decl, const At& at, Range limits,
                               std::vector<Note> notes) {
    if (decl.faulty || decl.type == ParameterType::texture) return;
    auto outside = [&](double x) { return x < limits.minimum || x > limits.maximum; };
    std::string found;
    if (decl.type == ParameterType::boolean && (outside(0) || outside(1))) {
        found = "may be 0 (false) or 1 (true)";
    } else if (decl.range && (outside((*decl.range)[0]) || outside((*decl.range)[1]))) {
        found = fmt::format("may be {} to {}", (*decl.range)[0], (*decl.range)[1]);
    } else {
        std::size_t count = number_count(decl.type);
        auto bad = std::find_if(decl.fallback.begin(),
                                decl.fallback.begin() + static_cast<std::ptrdiff_t>(count), outside);
        if (bad == decl.fallback.begin() + static_cast<std::ptrdiff_t>(count)) return;
        if (decl.set_in) return instance_limits(decl, *bad, at, limits);
        found = fmt::format("is {} by default", *bad);
    }
    notes.insert(notes.begin(), note("it is declared here", decl.name.at));
    error(Code::out_of_range, at,
          fmt::format("parameter '{}' {}, expected {} to {} here", printable(decl.name.value), found,
                      limits.minimum, limits.maximum),
          std::move(notes));
}

// The base is right, and does not know of the instance: that is told, once for however many uses.
void Checker::instance_limits(const ParameterDecl& decl, double bad, const At& use, Range limits) {
    if (!told_of_instance.insert({&decl, limits.minimum, limits.maximum}).second) return;
    diags.error(Code::out_of_range, {decl.set_in, decl.set_at.span, decl.set_at.pointer},
                fmt::format("parameter '{}' is {}, expected {} to {} where it is used",
                            printable(decl.name.value), bad, limits.minimum, limits.maximum),
                {note("it is used here", use)});
}

// Each node is walked over once, however many lead to it. Constants that lead to each other in a circle hold
// nothing, which is told elsewhere.
const Expression* Checker::constant_value(std::size_t node) {
    constant_values.resize(in.nodes.size());
    std::vector<std::size_t> path;
    const Expression* held = nullptr;
    while (node < in.nodes.size()) {
        if (constant_values[node]) {
            held = *constant_values[node];
            break;
        }
        const NodeDecl& decl = in.nodes[node];
        constant_values[node] = nullptr;
        path.push_back(node);
        if (!decl.kind || !decl.kind->name.starts_with("constant") || decl.entries.empty()) break;
        const Expression& value = decl.entries.front().expression;
        node = value.node;
        if (value.kind == Expression::Kind::node) continue;
        if (value.kind != Expression::Kind::node_name) held = &value;
        auto named = nodes_by_name.find(value.name);
        if (held || named == nodes_by_name.end()) break;
        node = named->second;
    }
    for (std::size_t passed : path) constant_values[passed] = held;
    return held;
}

// What stands for one number, or colour, is bounded like that: a parameter, and a constant, however many
// names lead to it. What is wrong is told where it stands, or where a name leads away from there.
void Checker::constant_limits(const Expression& written, std::size_t node, Range limits) {
    const Expression* held = constant_value(node);
    if (!held) return;
    const Expression* use = &written;
    std::string who;
    while (use->kind == Expression::Kind::node) {
        const NodeDecl& inner = in.nodes[use->node];
        who = fmt::format("'{}'", inner.kind->fields[inner.entries.front().field].name);
        use = &inner.entries.front().expression;
    }
    std::vector<Note> notes;
    if (use->kind == Expression::Kind::node_name) {
        who = fmt::format("node '{}'", printable(use->name));
        notes.push_back(
            note(fmt::format("{} is declared here", who), in.nodes[nodes_by_name.at(use->name)].name.at));
    }
    if (held->kind == Expression::Kind::parameter) {
        auto found = parameters_by_name.find(held->name);
        if (found != parameters_by_name.end())
            parameter_limits(in.parameters[found->second], use->at, limits, std::move(notes));
        return;
    }
    auto outside = [&](double x) { return x < limits.minimum || x > limits.maximum; };
    auto bad = std::find_if(held->numbers.begin(), held->numbers.end(), outside);
    if (bad == held->numbers.end()) return;
    error(Code::out_of_range, use->at,
          fmt::format("{} is {}, expected {} to {} here", who, *bad, limits.minimum, limits.maximum),
          std::move(notes));
}

// It was told that its texture holds no colour.
bool Checker::misread(const NodeDecl& decl) const {
    for (const FieldEntry& entry : decl.entries) {
        const Field& row = decl.kind->fields[entry.field];
        auto texture = textures_by_name.find(entry.word);
        if (row.kind != FieldKind::texture || texture == textures_by_name.end()) continue;
        auto encoding = in.textures[texture->second].encoding;
        if (std::find(row.encodings.begin(), row.encodings.end(), encoding) == row.encodings.end())
            return true;
    }
    return false;
}

void Checker::expression(const Expression& written, FieldKind kind, Range limits, FieldValue& value) {
    std::size_t node = written.node;
    switch (written.kind) {
        case Expression::Kind::numbers:
            std::copy(written.numbers.begin(), written.numbers.end(), value.number.begin());
            return;
        case Expression::Kind::parameter:
            if (const ParameterDecl* decl = find_parameter(written.name, written.at, types_for(kind))) {
                value.parameter = id_of(*decl);
                parameter_limits(*decl, written.at, limits);
            }
            return;
        case Expression::Kind::node_name: {
            auto named = nodes_by_name.find(written.name);
            if (named == nodes_by_name.end()) {
                error(Code::unknown_node, written.at,
                      fmt::format("unknown node '{}'{}", printable(written.name),
                                  parameters_by_name.contains(written.name)
                                      ? other_sign('$', written.name)
                                      : hint(written.name, in.nodes, "nodes")));
                return;
            }
            node = named->second;
            break;
        }
        case Expression::Kind::node:
            break;
    }
    value.node = {static_cast<std::uint32_t>(node)};
    const layers::NodeKind* found = in.nodes[node].kind;
    constant_limits(written, node, limits);
    if (found && found->result == ir::Type::Color && kind == FieldKind::number && !misread(in.nodes[node])) {
        std::string who = written.kind == Expression::Kind::node_name
                              ? fmt::format("node '{}'", printable(written.name))
                              : fmt::format("'{}'", found->name);
        error(Code::node_type, written.at, fmt::format("{} gives a colour, expected a number", who));
    }
}

std::uint32_t Checker::earlier_entry(const std::string& id, const At& at) {
    std::vector<std::string_view> earlier;
    for (std::size_t i = 0; i < in.bump.size(); ++i) {
        const Located<std::string>& found = in.bump[i].id;
        if (i < current_entry && found.value == id) return static_cast<std::uint32_t>(i);
        if (i < current_entry && !found.value.empty()) earlier.push_back(found.value);
        if (i >= current_entry && found.value == id) {
            error(Code::unknown_entry, at,
                  fmt::format("entry '{}' of 'bump' does not stand before this one", printable(id)),
                  {note("it is here", found.at)});
            return 0;
        }
    }
    std::string near = did_you_mean(id, earlier);
    if (near.empty())
        near = earlier.empty() ? ", no entry before this one has an id"
                               : fmt::format(", expected {}", one_of(earlier));
    error(Code::unknown_entry, at, fmt::format("unknown entry '{}' of 'bump'{}", printable(id), near));
    return 0;
}

void Checker::without_parallax(const Field& row, const At& at) {
    if (std::any_of(in.bump.begin(), in.bump.end(),
                    [](const StageDecl& stage) { return stage.parallax.has_value(); }))
        return;
    error(Code::unused_setting, at,
          fmt::format("'{}' means nothing without a parallax, expected one in the first entry of 'bump'",
                      row.name));
}

std::vector<FieldValue> Checker::values(std::string_view owner, std::span<const Field> fields,
                                        std::span<const FieldEntry> entries) {
    std::vector<FieldValue> out_values;
    for (const Field& row : fields) {
        FieldValue value{.number = {row.fallback, row.fallback, row.fallback}, .field = row.name};
        if (row.kind == FieldKind::choice || row.kind == FieldKind::integer || row.kind == FieldKind::flag)
            value.index = static_cast<std::uint32_t>(row.fallback);
        out_values.push_back(value);
    }
    for (const FieldEntry& entry : entries) {
        const Field& row = fields[entry.field];
        FieldValue& value = out_values[entry.field];
        value.given = true;
        value.index = entry.index;
        value.uv = entry.uv;
        if (row.kind == FieldKind::identifier) value.word = entry.word;
        if (layers::is_follow_parallax(row)) without_parallax(row, entry.at);
        if (row.kind == FieldKind::entry) {
            value.index = earlier_entry(entry.word, entry.at);
            continue;
        }
        if (row.kind != FieldKind::texture) {
            expression(entry.expression, row.kind, {row.minimum, row.maximum}, value);
            continue;
        }
        auto index = find_texture(entry.word, entry.at);
        if (!index) continue;
        const TextureDecl& decl = in.textures[*index];
        if (!decl.faulty &&
            std::find(row.encodings.begin(), row.encodings.end(), decl.encoding) == row.encodings.end()) {
            std::vector<std::string_view> expected;
            for (ir::TextureEncoding encoding : row.encodings)
                expected.push_back(ir::encoding_name(encoding));
            const bool holds_number =
                decl.encoding == ir::TextureEncoding::mask || decl.encoding == ir::TextureEncoding::height;
            const bool colors_only =
                row.encodings == std::vector<ir::TextureEncoding>{ir::TextureEncoding::color};
            error(Code::wrong_encoding, entry.at,
                  fmt::format("{} cannot read texture '{}' of encoding '{}', expected {}{}", owner,
                              printable(entry.word), ir::encoding_name(decl.encoding), one_of(expected),
                              holds_number && colors_only
                                  ? ", or add \"channel\": \"r\" (without an \"op\") to read a number of it"
                                  : ""),
                  {note("it is declared here", decl.name.at)});
        }
        value.index = texture_index[*index];
    }
    return out_values;
}

void Checker::nodes() {
    for (const NodeDecl& decl : in.nodes) {
        layers::NodeInstance instance{.kind = decl.kind, .name = decl.name.value};
        if (decl.kind) {
            instance.values =
                values(fmt::format("a node of kind '{}'", decl.kind->name), decl.kind->fields, decl.entries);
            together(*decl.kind, decl.at, decl.entries, instance.values);
        }
        out.nodes.push_back(std::move(instance));
    }
    node_cycles();
}

// Walks from every node with a stack of its own; each cycle is reported once, with its path.
void Checker::node_cycles() {
    enum class State : std::uint8_t { fresh, open, done };
    std::vector<State> state(out.nodes.size(), State::fresh);
    struct Step {
        std::uint32_t node;
        std::size_t next_field;
    };
    for (std::uint32_t start = 0; start < out.nodes.size(); ++start) {
        std::vector<Step> path;
        if (state[start] == State::fresh) path.push_back({start, 0});
        while (!path.empty()) {
            Step& step = path.back();
            state[step.node] = State::open;
            const auto& fields = out.nodes[step.node].values;
            while (step.next_field < fields.size() && !fields[step.next_field].node.valid())
                ++step.next_field;
            if (step.next_field == fields.size()) {
                state[step.node] = State::done;
                path.pop_back();
                continue;
            }
            std::uint32_t next = fields[step.next_field++].node.index;
            if (state[next] == State::fresh) {
                path.push_back({next, 0});
            } else if (state[next] == State::open) {
                auto from =
                    std::find_if(path.begin(), path.end(), [&](const Step& s) { return s.node == next; });
                std::string names;
                for (auto it = from; it != path.end(); ++it) {
                    const std::string& name = out.nodes[it->node].name;
                    if (!name.empty()) names += fmt::format("'{}' -> ", printable(name));
                }
                error(Code::node_cycle, in.nodes[next].name.at,
                      fmt::format("nodes form a cycle: {}'{}'", names, printable(out.nodes[next].name)));
            }
        }
    }
}

}  // namespace sg::material
