#include "schema.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/ice.hpp"
#include "ir/lighting.hpp"
#include "layers/kind.hpp"
#include "material/checked.hpp"

namespace sg {
namespace {

using Json = nlohmann::ordered_json;
using layers::Field;
using layers::FieldKind;

Json reference(const std::string& name) {
    return {{"$ref", "#/definitions/" + name}};
}
Json number(double minimum, double maximum) {
    return {{"type", "number"}, {"minimum", minimum}, {"maximum", maximum}};
}
Json numbers(std::size_t count, const Json& item) {
    return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
}
Json words(std::span<const std::string_view> choices) {
    Json list = Json::array();
    for (std::string_view word : choices) list.push_back(word);
    return {{"enum", list}};
}

Json object(Json properties, std::vector<std::string> required = {}) {
    Json out = {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    if (!required.empty()) out["required"] = required;
    return out;
}

Json value_of(const Field& field) {
    Json bounded = number(field.minimum, field.maximum);
    switch (field.kind) {
        case FieldKind::texture:
            return reference("name");
        case FieldKind::uv:
            return reference("uv");
        case FieldKind::choice:
            return words(field.choices);
        case FieldKind::flag:
            return {{"type", "boolean"}};
        case FieldKind::integer:
            return {{"type", "integer"}, {"minimum", field.minimum}, {"maximum", field.maximum}};
        case FieldKind::number:
            return {{"anyOf",
                     {bounded, reference("parameter_reference"), reference("node_reference"),
                      reference("node")}}};
        case FieldKind::pair:
            return {{"anyOf", {bounded, numbers(2, bounded), reference("parameter_reference")}}};
        case FieldKind::color:
            return {{"anyOf",
                     {numbers(3, bounded), reference("parameter_reference"), reference("node_reference"),
                      reference("node")}}};
        case FieldKind::vector:
            return numbers(3, bounded);
        case FieldKind::matrix:
            return reference("parameter_reference");
        case FieldKind::direction:
            return numbers(3, number(-1e6, 1e6));
        case FieldKind::range:
            return numbers(2, bounded);
        case FieldKind::file:
            return {{"type", "string"}, {"minLength", 1}};
        case FieldKind::identifier:
        case FieldKind::entry:
            return reference("name");
        case FieldKind::arguments:
            return {
                {"type", "array"}, {"items", reference("argument")}, {"maxItems", material::kMaxArguments}};
        case FieldKind::layer:
            return reference("layer");
    }
    SG_UNREACHABLE("a field of no kind");
}

Json described(const Field& field) {
    Json out = value_of(field);
    std::string unit = field.unit.empty() ? "" : fmt::format(" ({})", field.unit);
    out["description"] = std::string(field.doc) + unit;
    constexpr FieldKind kNone[] = {FieldKind::texture,   FieldKind::range,  FieldKind::direction,
                                   FieldKind::arguments, FieldKind::file,   FieldKind::identifier,
                                   FieldKind::layer,     FieldKind::matrix, FieldKind::entry};
    if (field.required || std::find(std::begin(kNone), std::end(kNone), field.kind) != std::end(kNone))
        return out;
    if (field.kind == FieldKind::choice) {
        out["default"] = field.choices[static_cast<std::size_t>(field.fallback)];
    } else if (field.kind == FieldKind::flag) {
        out["default"] = field.fallback != 0;
    } else if (field.kind == FieldKind::vector || field.kind == FieldKind::color) {
        out["default"] = {field.fallback, field.fallback, field.fallback};
    } else {
        out["default"] = field.fallback;
    }
    return out;
}

void add_fields(Json& properties, std::vector<std::string>& required, std::span<const Field> fields) {
    for (const Field& field : fields) {
        properties[std::string(field.name)] = described(field);
        if (field.required) required.emplace_back(field.name);
    }
}

Json layer_schema(const layers::LayerKind& kind) {
    Json properties = {{"id", reference("name")}, {"kind", {{"const", kind.name}}}};
    std::vector<std::string> required = {"kind"};
    add_fields(properties, required, kind.fields);
    add_fields(properties, required, layers::common_fields());
    Json out = object(properties, required);
    out["description"] = kind.doc;
    return out;
}

Json group_schema() {
    Json properties = {{"id", reference("name")},
                       {"kind", {{"const", "group"}}},
                       {"layers", {{"type", "array"}, {"items", reference("layer")}}}};
    std::vector<std::string> required = {"kind", "layers"};
    add_fields(properties, required, layers::common_fields());
    return object(properties, required);
}

// `shorthand`: without "op".
Json node_schema(const layers::NodeKind& kind, bool shorthand) {
    Json properties = Json::object();
    std::vector<std::string> required;
    if (!shorthand) {
        properties["op"] = {{"const", kind.name}};
        required.emplace_back("op");
    }
    add_fields(properties, required, kind.fields);
    if (shorthand && kind.name == "texture") required.emplace_back("channel");
    Json out = object(properties, required);
    out["description"] = kind.doc;
    return out;
}

Json parallax_definition() {
    Json any = Json::array();
    for (const layers::ParallaxKind& kind : layers::all_parallax_kinds()) {
        Json properties = {{"kind", {{"const", kind.name}}}};
        std::vector<std::string> required = {"kind"};
        add_fields(properties, required, kind.fields);
        any.push_back(object(properties, required));
        any.back()["description"] = kind.doc;
    }
    return {{"anyOf", any}};
}

Json layer_definition() {
    Json any = Json::array({group_schema()});
    for (const layers::LayerKind* kind : layers::all_kinds()) any.push_back(layer_schema(*kind));
    return {{"anyOf", any}};
}

Json node_definition() {
    Json any = Json::array();
    for (const layers::NodeKind& kind : layers::all_node_kinds()) any.push_back(node_schema(kind, false));
    for (std::string_view name : {"texture", "texture_color"})
        any.push_back(node_schema(*layers::find_node_kind(name), true));
    return {{"anyOf", any}};
}

// Under a name, a value alone is a node as well.
Json named_node_definition() {
    const Field& constant = layers::find_node_kind("constant")->fields.front();
    const Field& color = layers::find_node_kind("constant_color")->fields.front();
    return {{"anyOf",
             {reference("node"), number(constant.minimum, constant.maximum),
              numbers(3, number(color.minimum, color.maximum)), reference("parameter_reference")}}};
}

// What a user's function is handed.
Json argument_definition() {
    Json any = Json::array();
    std::vector<std::string_view> names;
    for (const layers::SurfaceArgument& row : layers::surface_arguments()) names.push_back(row.name);
    Json four = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 4}};
    any.push_back(words(names));
    any.push_back({{"type", "number"}});
    any.push_back(four);
    any.push_back(object({{"uv", reference("uv")}}, {"uv"}));
    any.push_back(object({{"texture", reference("name")}}, {"texture"}));
    for (const char* name : {"parameter_reference", "node_reference", "node"}) any.push_back(reference(name));
    return {{"anyOf", any}};
}

Json uv_definition() {
    Json pair = {{"anyOf", {number(-10000, 10000), numbers(2, number(-10000, 10000))}}};
    Json speed = {{"anyOf", {number(-1000, 1000), numbers(2, number(-1000, 1000))}}};
    Json set = {{"type", "integer"}, {"minimum", 0}, {"maximum", 7}};
    return {{"anyOf",
             {set, object({{"set", set},
                           {"scale", pair},
                           {"rotation", number(-3600, 3600)},
                           {"offset", pair},
                           {"speed", speed}})}}};
}

Json texture_definition() {
    constexpr std::string_view kGreen[] = {"up", "down"}, kSpace[] = {"linear", "srgb"},
                               kWrap[] = {"repeat", "clamp", "mirror"}, kFilter[] = {"nearest", "linear"};
    Json sampler = object({{"wrap", words(kWrap)},
                           {"wrap_s", words(kWrap)},
                           {"wrap_t", words(kWrap)},
                           {"filter", words(kFilter)},
                           {"mip_filter", words(kFilter)},
                           {"anisotropy", {{"type", "integer"}, {"minimum", 1}, {"maximum", 16}}}});
    return object({{"file", {{"type", "string"}, {"minLength", 1}}},
                   {"encoding", words(ir::encoding_names())},
                   {"swizzle", {{"type", "string"}, {"pattern", "^[rgba]{1,4}$"}}},
                   {"green", words(kGreen)},
                   {"zero", {{"enum", {127, 127.5, 128}}}},
                   {"range", number(1e-6, 128)},
                   {"color_space", words(kSpace)},
                   {"sampler", sampler}},
                  {"file", "encoding"});
}

Json parameter_value() {
    return {{"anyOf",
             {{{"type", "number"}},
              {{"type", "boolean"}},
              {{"type", "string"}, {"minLength", 1}},
              {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 16}}}}};
}

Json parameter_of(std::span<const std::string_view> types, Json value, bool ranged) {
    Json properties = {{"type", words(types)}, {"default", std::move(value)}};
    if (ranged) properties["range"] = numbers(2, {{"type", "number"}});
    properties["label"] = {{"type", "string"}};
    properties["unit"] = {{"type", "string"}};
    return object(properties, {"type", "default"});
}

Json parameter_definition() {
    constexpr std::string_view kFloat[] = {"float"}, kVec2[] = {"vec2"}, kThree[] = {"vec3", "color"},
                               kVec4[] = {"vec4"}, kBool[] = {"bool"}, kInt[] = {"int"}, kMatrix[] = {"mat4"},
                               kTexture[] = {"texture"};
    Json any = {{"type", "number"}};
    return {
        {"anyOf",
         {parameter_of(kFloat, any, true), parameter_of(kVec2, numbers(2, any), true),
          parameter_of(kThree, numbers(3, any), true), parameter_of(kVec4, numbers(4, any), true),
          parameter_of(kInt, {{"type", "integer"}}, true), parameter_of(kBool, {{"type", "boolean"}}, false),
          parameter_of(kMatrix, numbers(16, any), false), parameter_of(kTexture, reference("name"), false)}}};
}

// One for each lighting model; a surface that names none has the first.
Json surface_definition() {
    constexpr std::string_view kSides[] = {"off", "mirror", "flip"};
    Json any = Json::array();
    for (const ir::LightingModel& model : ir::all_lighting_models()) {
        Json properties = {{"lighting", {{"const", model.name}, {"description", model.doc}}}};
        std::vector<std::string> required;
        if (!any.empty()) required.emplace_back("lighting");
        for (const Field& field : layers::surface_fields()) {
            if (ir::has_input(model, layers::surface_output(field)))
                properties[std::string(field.name)] = described(field);
        }
        properties["alpha_test"] = number(0, 1);
        properties["two_sided"] = words(kSides);
        any.push_back(object(properties, required));
    }
    return {{"anyOf", any}};
}

Json budget_definition() {
    Json properties = Json::object();
    for (std::string_view name : material::kCostNames) {
        properties[std::string(name)] = {{"type", "integer"}, {"minimum", 0}, {"maximum", 1e9}};
    }
    return object(properties);
}

// An object whose keys are names.
Json named(Json item) {
    return {
        {"type", "object"}, {"propertyNames", reference("name")}, {"additionalProperties", std::move(item)}};
}

}  // namespace

std::string schema_text() {
    Json definitions = {{"name", {{"type", "string"}, {"minLength", 1}, {"maxLength", 64}}},
                        {"parameter_reference", {{"type", "string"}, {"pattern", "^\\$.+"}}},
                        {"node_reference", {{"type", "string"}, {"pattern", "^@.+"}}},
                        {"uv", uv_definition()},
                        {"node", node_definition()},
                        {"named_node", named_node_definition()},
                        {"argument", argument_definition()},
                        {"parallax", parallax_definition()},
                        {"layer", layer_definition()}};
    Json stage = object({{"id", reference("name")},
                         {"parallax", reference("parallax")},
                         {"layers", {{"type", "array"}, {"items", reference("layer")}}}},
                        {"layers"});
    Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "surfgrad material"}};
    Json whole = object({{"$schema", {{"type", "string"}}},
                         {"version", {{"const", material::kVersion}}},
                         {"name", reference("name")},
                         {"description", {{"type", "string"}}},
                         {"parameters", named(parameter_definition())},
                         {"textures", named(texture_definition())},
                         {"nodes", named(reference("named_node"))},
                         {"bump", {{"type", "array"}, {"items", stage}, {"maxItems", 8}}},
                         {"surface", surface_definition()},
                         {"budget", budget_definition()}},
                        {"version"});
    Json instance = object({{"$schema", {{"type", "string"}}},
                            {"version", {{"const", material::kVersion}}},
                            {"name", reference("name")},
                            {"description", {{"type", "string"}}},
                            {"extends", {{"type", "string"}, {"minLength", 1}}},
                            {"parameters", named(parameter_value())}},
                           {"version", "extends"});
    out["if"] = {{"type", "object"}, {"required", {"extends"}}};
    out["then"] = instance;
    out["else"] = whole;
    out["definitions"] = definitions;
    return out.dump(2) + "\n";
}

}  // namespace sg
