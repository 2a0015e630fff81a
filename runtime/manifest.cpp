#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/limits.hpp"
#include "json/json.hpp"
#include "runtime/artefact.hpp"

namespace sg::runtime {
namespace {

// A value and where it stands; reads what is expected of it and reports what is not. After an error it hands
// out harmless values, so that the rest of the manifest is still read and all of its errors are found. Of a
// missing value, which has been reported, nothing more is said.
class Node {
public:
    Node(const json::Value* value, Place place, Diags& diags)
        : value_(value), place_(std::move(place)), diags_(&diags) {}

    void fail(std::string_view what) const {
        if (value_ == nullptr) return;
        std::string shown = printable(place_.pointer);
        diags_->error(Code::manifest_format, place_,
                      fmt::format("'{}' {}", shown.empty() ? "/" : shown, what));
    }
    [[nodiscard]] bool has(std::string_view key) const {
        return value_ != nullptr && value_->find(key) != nullptr;
    }
    [[nodiscard]] Node at(std::string_view key) const {
        if (!has(key)) {
            fail(fmt::format("has no '{}'", key));
            return {nullptr, place_, *diags_};
        }
        return child(*value_->find(key), key);
    }
    [[nodiscard]] std::optional<std::string> text() const {
        if (value_ != nullptr && value_->kind == json::Kind::string) return value_->string;
        fail("must be a text");
        return std::nullopt;
    }
    [[nodiscard]] std::string text_or_empty() const { return text().value_or(""); }
    [[nodiscard]] double number(double lowest, double highest) const {
        double out = value_ != nullptr && value_->kind == json::Kind::number ? value_->number : NAN;
        if (out >= lowest && out <= highest) return out;
        fail(fmt::format("must be a number from {} to {}", lowest, highest));
        return lowest;
    }
    [[nodiscard]] std::uint32_t integer(std::uint32_t lowest, std::uint32_t highest) const {
        double out = number(lowest, highest);
        if (out == std::floor(out)) return static_cast<std::uint32_t>(out);
        fail("must be a whole number");
        return lowest;
    }
    // The index of the text in `words`.
    [[nodiscard]] std::size_t choice(std::span<const std::string_view> words) const {
        auto word = text();
        if (!word) return 0;
        auto found = std::find(words.begin(), words.end(), *word);
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
        fail(fmt::format("is '{}', expected {}", printable(*word), one_of(words)));
        return 0;
    }
    [[nodiscard]] bool is_number() const { return value_ != nullptr && value_->kind == json::Kind::number; }
    [[nodiscard]] bool is_array() const { return value_ != nullptr && value_->kind == json::Kind::array; }
    [[nodiscard]] std::vector<Node> items() const {
        std::vector<Node> out;
        if (!is_array()) {
            fail("must be an array");
            return out;
        }
        for (const json::Value& item : value_->items) out.push_back(child(item, std::to_string(out.size())));
        return out;
    }
    // A file beside the manifest.
    [[nodiscard]] std::string plain_file() const {
        auto file = text();
        if (!file) return "";
        bool plain = !file->empty() && *file != "." && *file != ".." &&
                     file->find_first_of(std::string_view("/\\\0", 3)) == std::string::npos;
        if (!plain) fail("must be the name of a file beside the manifest");
        return *file;
    }

private:
    [[nodiscard]] Node child(const json::Value& value, std::string_view step) const {
        return {&value, {place_.source, value.span, place_.pointer + json::pointer_step(step)}, *diags_};
    }

    const json::Value* value_;  // null: missing
    Place place_;
    Diags* diags_;
};

constexpr std::uint32_t kMaxBinding = 1023;
constexpr std::array<std::string_view, 2> kStages = {"vert", "frag"};

ShaderStage read_shader(const Node& node) {
    return {node.at("file").plain_file(), node.at("hash").text_or_empty(), {}};
}

void read_stages(const Node& node, EntryPoint& entry) {
    std::array<bool, 2> seen{};
    for (const Node& stage : node.items()) {
        std::size_t which = stage.at("stage").choice(kStages);
        if (seen[which]) stage.fail("repeats a stage");
        seen[which] = true;
        (which == 0 ? entry.vertex : entry.fragment) = read_shader(stage);
    }
    if (node.is_array() && !(seen[0] && seen[1])) node.fail("must hold a 'vert' and a 'frag' stage");
}

VertexInput read_input(const Node& node) {
    struct KnownInput {
        std::string_view name;
        std::uint32_t location, components;
    };
    static constexpr std::array<KnownInput, 12> kKnown = {{{"position", 0, 3},
                                                           {"normal", 1, 3},
                                                           {"tangent", 2, 4},
                                                           {"color", 3, 4},
                                                           {"uv0", 4, 2},
                                                           {"uv1", 5, 2},
                                                           {"uv2", 6, 2},
                                                           {"uv3", 7, 2},
                                                           {"uv4", 8, 2},
                                                           {"uv5", 9, 2},
                                                           {"uv6", 10, 2},
                                                           {"uv7", 11, 2}}};
    static constexpr std::array<std::string_view, 3> kFormats = {"float2", "float3", "float4"};
    VertexInput input{node.at("name").text_or_empty(), node.at("location").integer(0, 11),
                      static_cast<std::uint32_t>(node.at("format").choice(kFormats)) + 2};
    for (const KnownInput& known : kKnown) {
        if (known.name != input.name) continue;
        if (known.location != input.location || known.components != input.components) {
            node.fail(fmt::format("must be float{} at location {}", known.components, known.location));
        }
        return input;
    }
    node.fail(fmt::format("is an unknown vertex input '{}'", printable(input.name)));
    return input;
}

BindingSlot read_binding(const Node& node) {
    static constexpr std::array<std::string_view, 3> kKinds = {"uniform_buffer", "texture", "sampler"};
    BindingSlot slot;
    slot.set = node.at("set").integer(0, 2);
    slot.binding = node.at("binding").integer(0, kMaxBinding);
    slot.kind = static_cast<BindingSlot::Kind>(node.at("kind").choice(kKinds));
    for (const Node& stage : node.at("stages").items()) {
        (stage.choice(kStages) == 0 ? slot.in_vertex : slot.in_fragment) = true;
    }
    return slot;
}

DebugView read_view(const Node& node) {
    static constexpr std::array<std::string_view, 4> kKinds = {"direction", "position", "uv", "vector"};
    static constexpr std::array kValues = {ViewKind::direction, ViewKind::position, ViewKind::uv,
                                           ViewKind::vector};
    return {node.at("name").text_or_empty(), node.at("number").integer(0, 1u << 20),
            node.at("components").integer(1, 4), kValues[node.at("kind").choice(kKinds)]};
}

EntryPoint read_entry(const Node& node) {
    EntryPoint entry;
    entry.name = node.at("name").text_or_empty();
    read_stages(node.at("stages"), entry);
    for (const Node& input : node.at("vertex_inputs").items()) entry.inputs.push_back(read_input(input));
    for (const Node& binding : node.at("bindings").items()) entry.bindings.push_back(read_binding(binding));
    for (const Node& output : node.at("outputs").items())
        entry.outputs.push_back(output.at("name").text_or_empty());
    if (entry.outputs.size() > 8) node.at("outputs").fail("must hold at most 8");
    if (node.has("views")) {
        for (const Node& view : node.at("views").items()) entry.views.push_back(read_view(view));
    }
    return entry;
}

Parameter read_parameter(const Node& node, std::size_t block_size) {
    static constexpr std::array<std::string_view, 8> kTypes = {"float", "vec2", "vec3", "vec4",
                                                               "color", "bool", "int",  "mat4"};
    static constexpr std::array<std::size_t, 8> kComponents = {1, 2, 3, 4, 3, 1, 1, 16};
    constexpr double kFloatMax = 3.4028234663852886e38;
    Parameter parameter;
    parameter.name = node.at("name").text_or_empty();
    std::size_t type = node.at("type").choice(kTypes);
    parameter.type = kTypes[type];
    parameter.offset = node.at("offset").integer(0, kMaxBlockBytes);
    for (const Node& value : node.at("default").items()) {
        parameter.initial.push_back(static_cast<float>(value.number(-kFloatMax, kFloatMax)));
    }
    if (parameter.initial.size() != kComponents[type]) {
        node.fail(fmt::format("must have a default of {} numbers", kComponents[type]));
    }
    if (parameter.offset % sizeof(float) != 0 ||
        parameter.offset + kComponents[type] * sizeof(float) > block_size) {
        node.fail("lies outside its block");
    }
    if (node.has("range")) {
        auto ends = node.at("range").items();
        if (ends.size() != 2) node.at("range").fail("must hold two numbers");
        if (ends.size() == 2) {
            parameter.range = {ends[0].number(-kFloatMax, kFloatMax), ends[1].number(-kFloatMax, kFloatMax)};
        }
    }
    return parameter;
}

// What an expression may refer to.
struct Known {
    std::vector<std::string> parameters;
    std::vector<std::size_t> parameter_counts;
    std::vector<std::size_t> step_counts;
};

// `row`: of a matrix, as only ["row", matrix, number] takes one.
Expression read_reference(const Node& node, const Known& known, bool row) {
    Expression out;
    const std::string text = node.text_or_empty();
    if (text.starts_with('$')) {
        auto at = std::find(known.parameters.begin(), known.parameters.end(), text.substr(1));
        out.index = static_cast<std::size_t>(at - known.parameters.begin());
        out.kind = Expression::Kind::parameter;
        if (at != known.parameters.end()) {
            const bool matrix = known.parameter_counts[out.index] > 4;
            if (matrix && !row)
                node.fail(fmt::format("is '{}', a matrix, of which an expression only takes a 'row'",
                                      printable(text)));
            if (!matrix && row)
                node.fail(fmt::format("is '{}', expected a parameter that is a matrix", printable(text)));
            return out;
        }
    }
    for (out.index = 0; out.index < known.step_counts.size(); ++out.index) {
        out.kind = Expression::Kind::step;
        if (text == fmt::format("#{}", out.index)) return out;
    }
    node.fail(
        fmt::format("is '{}', neither '$' with a parameter nor '#' with an earlier step", printable(text)));
    return {};
}

Expression read_expression(const Node& node, const Known& known);

// What reads as a word and is none that computes each component: ["channel", vector, number] and so on.
struct Form {
    std::string_view word;
    Expression::Kind kind{};
    std::optional<std::uint32_t> last = std::nullopt;  // the largest number behind the operand
};
constexpr Form kForms[] = {{"channel", Expression::Kind::channel, 3},
                           {"rgb", Expression::Kind::rgb},
                           {"row", Expression::Kind::row, 2},
                           {"unit", Expression::Kind::unit}};

// [word, operand...] or a form.
Expression read_call(const std::vector<Node>& items, const Known& known) {
    std::vector<std::string_view> words;
    for (const ExpressionWord& row : expression_words()) words.push_back(row.word);
    const std::size_t own = words.size();
    for (const Form& form : kForms) words.push_back(form.word);
    Expression out{.kind = Expression::Kind::word, .index = items[0].choice(words)};
    const Form* form = out.index >= own ? &kForms[out.index - own] : nullptr;
    const std::size_t operands = form ? 1 : expression_words()[out.index].operands;
    const std::size_t behind = operands + (form && form->last ? 1 : 0);
    if (items.size() != behind + 1) {
        items[0].fail(fmt::format("must have {} behind it", behind));
        return {};
    }
    if (form) {
        out.kind = form->kind;
        out.index = form->last ? items[2].integer(0, *form->last) : 0;
        const bool row = form->kind == Expression::Kind::row;
        out.operands.push_back(row ? read_reference(items[1], known, true)
                                   : read_expression(items[1], known));
        return out;
    }
    for (std::size_t i = 1; i <= operands; ++i) out.operands.push_back(read_expression(items[i], known));
    return out;
}

Expression read_expression(const Node& node, const Known& known) {
    constexpr double kMax = 1e300;
    if (node.is_number()) return {.numbers = {{stored(node.number(-kMax, kMax))}, 1}};
    if (!node.is_array()) return read_reference(node, known, false);
    const std::vector<Node> items = node.items();
    if (items.empty() || items.size() > 4) {
        node.fail("must hold one to four values");
        return {};
    }
    if (!items[0].is_number()) return read_call(items, known);
    Expression out;
    out.numbers.count = items.size();
    for (std::size_t i = 0; i < items.size(); ++i) out.numbers.at[i] = stored(items[i].number(-kMax, kMax));
    return out;
}

// The expression and how many numbers it gives.
std::pair<Expression, std::size_t> read_counted(const Node& node, const Known& known) {
    Expression out = read_expression(node, known);
    const std::size_t count = expression_count(out, known.parameter_counts, known.step_counts);
    if (count == 0) node.fail("mixes vectors of different lengths");
    return {std::move(out), std::max<std::size_t>(count, 1)};
}

void read_derived(const Node& node, ParameterBlock& block) {
    static constexpr std::array<std::string_view, 5> kTypes = {"float", "vec2", "vec3", "vec4", "color"};
    static constexpr std::array<std::size_t, 5> kComponents = {1, 2, 3, 4, 3};
    Known known;
    for (const Parameter& parameter : block.parameters) {
        known.parameters.push_back(parameter.name);
        known.parameter_counts.push_back(parameter.initial.size());
    }
    if (node.has("steps")) {
        for (const Node& step : node.at("steps").items()) {
            auto [expression, count] = read_counted(step, known);
            block.steps.push_back(std::move(expression));
            known.step_counts.push_back(count);
        }
    }
    if (!node.has("derived")) return;
    for (const Node& row : node.at("derived").items()) {
        DerivedParameter derived;
        derived.count = kComponents[row.at("type").choice(kTypes)];
        derived.offset = row.at("offset").integer(0, kMaxBlockBytes);
        if (derived.offset % sizeof(float) != 0 ||
            derived.offset + derived.count * sizeof(float) > block.size)
            row.fail("lies outside its block");
        auto [expression, count] = read_counted(row.at("expression"), known);
        if (count != 1 && count != derived.count)
            row.fail(fmt::format("is of {} numbers, expected {}", count, derived.count));
        derived.expression = std::move(expression);
        block.derived.push_back(std::move(derived));
    }
}

ParameterBlock read_block(const Node& node) {
    ParameterBlock block;
    if (node.at("set").integer(0, 2) != 1 || node.at("binding").integer(0, kMaxBinding) != 0) {
        node.fail("must be binding 0 of set 1");
    }
    block.size = node.at("size").integer(4, kMaxBlockBytes);
    for (const Node& parameter : node.at("parameters").items()) {
        block.parameters.push_back(read_parameter(parameter, block.size));
    }
    read_derived(node, block);
    return block;
}

// The channels of x, y and, if stored, z as the letters say; the others behind them.
std::array<int, 4> read_swizzle(const Node& node, TextureSlot::Encoding encoding) {
    constexpr std::string_view kLetters = "rgba";
    const std::string letters = node.text_or_empty();
    std::vector<int> order;
    const std::size_t stored = encoding == TextureSlot::Encoding::normal_xy ? 2 : 3;
    bool good = letters.size() == 4 && letters.find_first_not_of(kLetters) == std::string::npos;
    for (std::size_t i = 0; good && i < stored; ++i)
        order.push_back(static_cast<int>(kLetters.find(letters[i])));
    for (int c = 0; c < 4; ++c) {
        if (std::find(order.begin(), order.end(), c) == order.end()) order.push_back(c);
    }
    if (!good) node.fail("must be four of the letters r, g, b and a");
    if (encoding == TextureSlot::Encoding::plain || !good) return {0, 1, 2, 3};
    if (order.size() != 4) node.fail("repeats a channel of a normal");
    return {order[0], order[1], order[2], order[3]};
}

TextureSlot read_texture(const Node& node) {
    // The first two average slopes; all others mean what they say at every level.
    static constexpr std::array<std::string_view, 9> kEncodings = {"tangent_normal", "tangent_normal_xy",
                                                                   "derivative",     "object_normal",
                                                                   "world_normal",   "height",
                                                                   "color",          "mask",
                                                                   "parallax_map"};
    static constexpr std::array<std::string_view, 2> kSpaces = {"linear", "srgb"};
    TextureSlot slot{node.at("name").text_or_empty(), node.at("file").text_or_empty(),
                     node.at("hash").text_or_empty(), node.at("binding").integer(0, kMaxBinding)};
    if (node.at("set").integer(0, 2) != 1) node.fail("must be in set 1");
    std::size_t encoding = node.at("encoding").choice(kEncodings);
    if (encoding == 0) slot.encoding = TextureSlot::Encoding::normal_xyz;
    if (encoding == 1) slot.encoding = TextureSlot::Encoding::normal_xy;
    if (slot.encoding != TextureSlot::Encoding::plain) slot.zero = node.at("zero").number(127, 128);
    slot.srgb = node.at("color_space").choice(kSpaces) == 1;
    if (node.has("parameter")) slot.parameter = node.at("parameter").text_or_empty();
    if (node.has("swizzle")) slot.channels = read_swizzle(node.at("swizzle"), slot.encoding);
    if (node.has("sampler_binding"))
        slot.sampler_binding = node.at("sampler_binding").integer(0, kMaxBinding);
    return slot;
}

SamplerSlot read_sampler(const Node& node) {
    static constexpr std::array<std::string_view, 3> kWraps = {"repeat", "mirror", "clamp"};
    static constexpr std::array<std::string_view, 2> kFilters = {"nearest", "linear"};
    static constexpr std::array<std::string_view, 3> kMips = {"none", "nearest", "linear"};
    SamplerSlot slot;
    if (node.at("set").integer(0, 2) != 1) node.fail("must be in set 1");
    slot.binding = node.at("binding").integer(0, kMaxBinding);
    slot.state.wrap_s = static_cast<gpu::Wrap>(node.at("wrap_s").choice(kWraps));
    slot.state.wrap_t = static_cast<gpu::Wrap>(node.at("wrap_t").choice(kWraps));
    slot.state.linear = node.at("filter").choice(kFilters) == 1;
    slot.state.mip_filter = static_cast<gpu::MipFilter>(node.at("mip_filter").choice(kMips));
    slot.state.anisotropy = node.at("anisotropy").number(1, 16);
    return slot;
}

// Whether something of the artefact can stand at the slot.
bool is_filled(const Artefact& artefact, const BindingSlot& slot) {
    auto same = [&](const auto& other) { return slot.set == 1 && other.binding == slot.binding; };
    switch (slot.kind) {
        case BindingSlot::Kind::uniform_buffer:
            return slot.binding == 0 && (slot.set != 1 || artefact.parameters.has_value());
        case BindingSlot::Kind::texture:
            return std::any_of(artefact.textures.begin(), artefact.textures.end(), same);
        case BindingSlot::Kind::sampler:
            return std::any_of(artefact.samplers.begin(), artefact.samplers.end(), same);
    }
    return false;
}

void check_bindings(const Artefact& artefact, const Node& root) {
    for (const EntryPoint& entry : artefact.entries) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;
        for (const BindingSlot& slot : entry.bindings) {
            std::pair place(slot.set, slot.binding);
            bool again = std::find(seen.begin(), seen.end(), place) != seen.end();
            seen.push_back(place);
            if (!again && is_filled(artefact, slot)) continue;
            root.at("entry_points")
                .fail(fmt::format("uses binding {} of set {} {}", slot.binding, slot.set,
                                  again ? "twice" : "for something that the manifest does not describe"));
        }
    }
}

Artefact read_root(const Node& root) {
    static constexpr std::array<std::string_view, 3> kSides = {"off", "mirror", "flip"};
    Artefact artefact;
    artefact.name = root.at("name").text_or_empty();
    artefact.two_sided = root.at("two_sided").choice(kSides) != 0;
    for (const Node& entry : root.at("entry_points").items()) artefact.entries.push_back(read_entry(entry));
    if (root.has("parameter_block")) artefact.parameters = read_block(root.at("parameter_block"));
    for (const Node& texture : root.at("textures").items())
        artefact.textures.push_back(read_texture(texture));
    for (const Node& sampler : root.at("samplers").items())
        artefact.samplers.push_back(read_sampler(sampler));
    check_bindings(artefact, root);
    return artefact;
}

}  // namespace

namespace {

bool is_manifest(const json::Document& document) {
    const json::Value* format = document.root.find("format");
    return format != nullptr && format->kind == json::Kind::string && format->string == "surfgrad-artefact";
}

std::optional<json::Document> parse(std::string_view text, std::string_view file, Diags& diags) {
    return json::parse(std::make_shared<const Source>(Source{std::string(file), std::string(text)}), diags);
}

}  // namespace

bool is_manifest(std::string_view text) {
    Diags unheard;  // a text that is no JSON is no manifest; whoever reads it as something else says what is
                    // wrong
    auto document = parse(text, "", unheard);
    return document && is_manifest(*document);
}

std::optional<Artefact> read_manifest(std::string_view text, std::string_view file, Diags& diags) {
    auto document = parse(text, file, diags);
    if (!document) return std::nullopt;
    Node root(&document->root, {document->source, document->root.span, ""}, diags);
    std::size_t before = diags.error_count();
    if (!is_manifest(*document)) {
        diags.error(Code::manifest_format, fmt::format("'{}' is not a surfgrad manifest", printable(file)));
        return std::nullopt;
    }
    Node version = root.at("version");
    if (version.number(0, 1e9) != 1) version.fail("must be 1, the version that this program reads");
    if (diags.error_count() != before) return std::nullopt;
    Artefact artefact = read_root(root);
    if (diags.error_count() != before) return std::nullopt;
    return artefact;
}

}  // namespace sg::runtime
