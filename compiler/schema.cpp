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

// A part with its description and, unless it is null, its default.
Json said(Json part, std::string_view description, Json fallback = nullptr) {
    part["description"] = description;
    if (!fallback.is_null()) part["default"] = std::move(fallback);
    return part;
}
Json whole(double minimum, double maximum) {
    return {{"type", "integer"}, {"minimum", minimum}, {"maximum", maximum}};
}
// A part that is defined elsewhere; draft-07 ignores what stands beside "$ref" itself.
Json referred(const std::string& name, std::string_view description, Json fallback = nullptr) {
    return said({{"allOf", Json::array({reference(name)})}}, description, std::move(fallback));
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
            return whole(field.minimum, field.maximum);
        case FieldKind::number:
            return {{"anyOf",
                     {bounded, reference("parameter_reference"), reference("node_reference"),
                      reference("node")}}};
        case FieldKind::pair:
            return {{"anyOf", {bounded, numbers(2, bounded), reference("parameter_reference")}}};
        case FieldKind::color:
            return {{"anyOf",
                     {bounded, numbers(3, bounded), reference("parameter_reference"),
                      reference("node_reference"), reference("node")}}};
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
    if (out.contains("$ref")) out = {{"allOf", Json::array({out})}};
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

// What one field asks of another, as "if" and "then".
Json rule_schema(const layers::Rule& rule, std::span<const Field> fields) {
    auto row = [&](std::string_view name) -> const Field& {
        return *std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
    };
    auto by_default = [&](std::string_view name, std::string_view word) {
        const Field& field = row(name);
        return !field.required && field.choices[static_cast<std::size_t>(field.fallback)] == word;
    };
    const std::string field(rule.field), other(rule.other);
    Json when = Json::object(), then;
    if (!rule.word.empty()) when["properties"] = {{field, {{"const", rule.word}}}};
    if (rule.word.empty() || !by_default(field, rule.word)) when["required"] = {field};
    switch (rule.asks) {
        case layers::Rule::Asks::choice:
            then["properties"] = {{other, words(rule.words)}};
            if (std::none_of(rule.words.begin(), rule.words.end(),
                             [&](std::string_view word) { return by_default(other, word); }))
                then["required"] = {other};
            break;
        case layers::Rule::Asks::absence:
            then["not"] = {{"required", {other}}};
            break;
        case layers::Rule::Asks::plain_uv: {
            const Json zero = {{"const", 0}};
            Json still = {{"type", "object"}, {"properties", {{"set", zero}, {"rotation", zero}}}};
            then["properties"] = {{other, {{"anyOf", Json::array({zero, still})}}}};
        }
    }
    return {{"if", when}, {"then", then}};
}

// An object of these fields, and what they ask of each other.
template <class Kind>
Json kind_object(const Kind& kind, const Json& properties, const std::vector<std::string>& required) {
    Json out = object(properties, required);
    out["description"] = kind.doc;
    for (const layers::Rule& rule : kind.rules) out["allOf"].push_back(rule_schema(rule, kind.fields));
    return out;
}

Json own_id(std::string_view of) {
    return referred("own_name", fmt::format("the name of the {} in messages, views and generated text", of));
}

void add_fields(Json& properties, std::vector<std::string>& required, std::span<const Field> fields) {
    for (const Field& field : fields) {
        properties[std::string(field.name)] = described(field);
        if (field.required) required.emplace_back(field.name);
    }
}

Json layer_schema(const layers::LayerKind& kind) {
    Json properties = {{"id", own_id("layer")}, {"kind", said({{"const", kind.name}}, kind.doc)}};
    std::vector<std::string> required = {"kind"};
    add_fields(properties, required, kind.fields);
    add_fields(properties, required, layers::common_fields());
    return kind_object(kind, properties, required);
}

Json layer_list(std::string_view description) {
    return said({{"type", "array"}, {"items", reference("layer")}}, description);
}

Json group_schema() {
    constexpr std::string_view kDoc = "layers that are summed first and then count as one";
    Json properties = {{"id", own_id("group")},
                       {"kind", said({{"const", "group"}}, kDoc)},
                       {"layers", layer_list("what the group sums")}};
    std::vector<std::string> required = {"kind", "layers"};
    add_fields(properties, required, layers::common_fields());
    return said(object(properties, required), kDoc);
}

// `shorthand`: without "op".
Json node_schema(const layers::NodeKind& kind, bool shorthand) {
    Json properties = Json::object();
    std::vector<std::string> required;
    if (!shorthand) {
        properties["op"] = said({{"const", kind.name}}, kind.doc);
        required.emplace_back("op");
    }
    add_fields(properties, required, kind.fields);
    if (shorthand && kind.name == "texture") required.emplace_back("channel");
    return kind_object(kind, properties, required);
}

Json parallax_definition() {
    Json any = Json::array();
    for (const layers::ParallaxKind& kind : layers::all_parallax_kinds()) {
        Json properties = {{"kind", said({{"const", kind.name}}, kind.doc)}};
        std::vector<std::string> required = {"kind"};
        add_fields(properties, required, kind.fields);
        any.push_back(kind_object(kind, properties, required));
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
    any.push_back(object({{"uv", referred("uv", "a coordinate with its derivatives (SgUv)")}}, {"uv"}));
    any.push_back(object({{"texture", referred("name", "a texture and its sampler")}}, {"texture"}));
    for (const char* name : {"parameter_reference", "node_reference", "node"}) any.push_back(reference(name));
    return {{"anyOf", any}};
}

Json uv_definition() {
    Json properties = Json::object();
    for (const layers::CoordinateKey& key : layers::coordinate_keys()) {
        Json one = key.whole ? whole(key.minimum, key.maximum) : number(key.minimum, key.maximum);
        Json value = key.count == 1 ? one : Json{{"anyOf", Json::array({one, numbers(key.count, one)})}};
        std::string unit = key.unit.empty() ? "" : fmt::format(" ({})", key.unit);
        properties[std::string(key.name)] = said(value, std::string(key.doc) + unit, key.fallback);
    }
    const layers::CoordinateKey& set = layers::coordinate_keys()[layers::kSet];
    return {{"anyOf", Json::array({whole(set.minimum, set.maximum), object(properties)})}};
}

Json sampler_definition() {
    constexpr std::string_view kWrap[] = {"repeat", "clamp", "mirror"}, kFilter[] = {"nearest", "linear"};
    return object({{"wrap", said(words(kWrap), "beyond the image, along s and t", "repeat")},
                   {"wrap_s", said(words(kWrap), "along s; left out: as wrap", "repeat")},
                   {"wrap_t", said(words(kWrap), "along t; left out: as wrap", "repeat")},
                   {"filter", said(words(kFilter), "between texels", "linear")},
                   {"mip_filter", said(words(kFilter), "between levels of detail", "linear")},
                   {"anisotropy", said(whole(1, 16), "how many texels along a slanted footprint", 1)}});
}

// Beside each encoding: no setting that means nothing for it, as many letters of a swizzle as it has
// channels.
Json encoding_rule(ir::TextureEncoding encoding) {
    Json then = Json::object(), none = Json::array();
    for (std::string_view setting : {"green", "zero", "range", "swizzle"}) {
        if (!material::setting_counts(setting, encoding)) none.push_back({{"required", {setting}}});
    }
    if (!none.empty()) then["not"] = {{"anyOf", none}};
    if (encoding != ir::TextureEncoding::color) then["properties"]["color_space"] = {{"const", "linear"}};
    std::size_t count = material::channel_count(encoding);
    if (count > 0 && encoding != ir::TextureEncoding::mask)
        then["properties"]["swizzle"] = {{"pattern", fmt::format("^(?!.*(.).*\\1)[rgba]{{{}}}$", count)}};
    Json when = {{"properties", {{"encoding", {{"const", ir::encoding_name(encoding)}}}}},
                 {"required", {"encoding"}}};
    return {{"if", when}, {"then", then}};
}

Json texture_definition() {
    constexpr std::string_view kGreen[] = {"up", "down"}, kSpace[] = {"linear", "srgb"};
    Json path = {{"type", "string"}, {"minLength", 1}};
    Json swizzle = {{"type", "string"}, {"pattern", "^[rgba]{1,4}$"}};
    Json out =
        object({{"file", said(path, "the image: a path below the material's folder or an -I root")},
                {"encoding", said(words(ir::encoding_names()), "what the channels hold")},
                {"swizzle",
                 said(swizzle, "which stored channels stand for x, y, z or r, g, b, a; left out: in order")},
                {"green", said(words(kGreen), "where positive green points on the picture", "up")},
                {"zero", said({{"enum", {127, 127.5, 128}}}, "the 8-bit code that means 0", 127.5)},
                {"range", said(number(1e-6, 128), "of a derivative map: the slope that 1 means", 1)},
                {"color_space",
                 said(words(kSpace), "of the stored numbers; left out: srgb for a color, else linear")},
                {"sampler", said(sampler_definition(), "how it is filtered")}},
               {"file", "encoding"});
    for (std::size_t i = 0; i < ir::encoding_names().size(); ++i)
        out["allOf"].push_back(encoding_rule(static_cast<ir::TextureEncoding>(i)));
    return out;
}

Json parameter_value() {
    return {{"anyOf",
             {{{"type", "number"}},
              {{"type", "boolean"}},
              {{"type", "string"}, {"minLength", 1}},
              {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 16}}}}};
}

Json parameter_of(std::span<const std::string_view> types, Json value, bool ranged,
                  std::string_view end = "number") {
    Json properties = {
        {"type", said(words(types), "what it is")},
        {"default", said(std::move(value), "its value where the engine sets none")},
    };
    if (ranged)
        properties["range"] =
            said(numbers(2, {{"type", end}}), "the bounds of each component; left out: none");
    properties["label"] = said({{"type", "string"}}, "its name in an editor", "");
    properties["unit"] = said({{"type", "string"}}, "of its numbers, for an editor", "");
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
          parameter_of(kInt, {{"type", "integer"}}, true, "integer"),
          parameter_of(kBool, {{"type", "boolean"}}, false), parameter_of(kMatrix, numbers(16, any), false),
          parameter_of(kTexture, reference("name"), false)}}};
}

// One for each lighting model; a surface that names none has the first.
Json surface_definition() {
    constexpr std::string_view kSides[] = {"off", "mirror", "flip"};
    Json any = Json::array();
    for (const ir::LightingModel& model : ir::all_lighting_models()) {
        Json properties = {{"lighting", said({{"const", model.name}}, model.doc)}};
        if (any.empty()) properties["lighting"]["default"] = model.name;
        std::vector<std::string> required;
        if (!any.empty()) required.emplace_back("lighting");
        for (const Field& field : layers::surface_fields()) {
            if (ir::has_input(model, layers::surface_output(field)))
                properties[std::string(field.name)] = described(field);
        }
        properties["alpha_test"] =
            said(number(0, 1), "below this opacity nothing is drawn; left out: no test");
        properties["two_sided"] =
            said(words(kSides),
                 "off; mirror: the base normal turns to the visible side; flip: the whole bumped normal does",
                 "off");
        any.push_back(object(properties, required));
    }
    return {{"anyOf", any}};
}

Json budget_definition() {
    constexpr std::string_view kDocs[] = {
        "SPIR-V instructions that do work, as shipped",
        "SPIR-V instructions that sample, gather or fetch texels, as shipped (queries are none)",
        "numbers in the inputs from the vertex stage that the shipped SPIR-V has"};
    static_assert(std::size(kDocs) == material::kCostNames.size());
    Json properties = Json::object();
    for (std::size_t i = 0; i < std::size(kDocs); ++i)
        properties[std::string(material::kCostNames[i])] =
            said(whole(0, 1e9), fmt::format("at most so many {}; left out: no bound", kDocs[i]));
    return object(properties);
}

// An entry of `bump`; only the first may have a parallax.
Json stage(bool first) {
    Json properties = {{"id", own_id("entry")}};
    if (first)
        properties["parallax"] =
            referred("parallax", "a texture that displaces the surface before the layers see it");
    properties["layers"] = layer_list("their surface gradients are summed and resolved");
    return object(properties, {"layers"});
}

// An object whose keys are names.
Json named(Json item) {
    return {{"type", "object"},
            {"propertyNames", reference("own_name")},
            {"additionalProperties", std::move(item)}};
}

// What a material and one that extends another both say of themselves.
Json header() {
    return {{"$schema", said({{"type", "string"}}, "for editors; ignored")},
            {"version", said({{"const", material::kVersion}}, "of the format")},
            {"name", referred("name", "for people and the manifest; left out: the file's name")},
            {"description", said({{"type", "string"}}, "for people")}};
}

Json material_schema() {
    Json properties = header();
    properties["parameters"] = said(named(parameter_definition()), "what the engine may set, by name");
    properties["textures"] = said(named(texture_definition()), "images, by name");
    properties["nodes"] =
        said(named(reference("named_node")), "values that layers and the surface refer to as \"@name\"");
    properties["bump"] =
        said({{"type", "array"},
              {"items", Json::array({stage(true)})},
              {"additionalItems", stage(false)},
              {"maxItems", material::kMaxStages}},
             "bump layers: each entry ends in a resolve, and the next starts from its normal");
    properties["surface"] = said(surface_definition(), "colour and lighting");
    properties["budget"] = said(budget_definition(), "what the forward fragment shader may cost at most");
    return object(properties, {"version"});
}

Json instance_schema() {
    Json properties = header();
    properties["extends"] = said({{"type", "string"}, {"minLength", 1}}, "the path of another material");
    properties["parameters"] = said(named(parameter_value()), "other defaults for its parameters");
    return object(properties, {"version", "extends"});
}

}  // namespace

std::string schema_text() {
    // ECMA 262; letters are counted as code points here and as bytes by the compiler.
    Json name = {
        {"type", "string"}, {"minLength", 1}, {"maxLength", 64}, {"pattern", "^[^\\u0000-\\u001f\\u007f]*$"}};
    Json own_name = name;
    own_name["pattern"] = "^[^$@\\u0000-\\u001f\\u007f][^\\u0000-\\u001f\\u007f]*$";
    Json definitions = {{"name", name},
                        {"own_name", own_name},
                        {"parameter_reference", {{"type", "string"}, {"pattern", "^\\$.+"}}},
                        {"node_reference", {{"type", "string"}, {"pattern", "^@.+"}}},
                        {"uv", uv_definition()},
                        {"node", node_definition()},
                        {"named_node", named_node_definition()},
                        {"argument", argument_definition()},
                        {"parallax", parallax_definition()},
                        {"layer", layer_definition()}};
    Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "surfgrad material"}};
    out["if"] = {{"type", "object"}, {"required", {"extends"}}};
    out["then"] = instance_schema();
    out["else"] = material_schema();
    out["definitions"] = definitions;
    return out.dump(2) + "\n";
}

}  // namespace sg
