#include "kinds.hpp"

#include <fmt/format.h>

#include "base/diag.hpp"
#include "base/ice.hpp"
#include "ir/lighting.hpp"
#include "layers/kind.hpp"

namespace sg {
namespace {

using layers::Field;
using layers::FieldKind;

std::string list(std::span<const std::string_view> words) {
    return fmt::format("`{}`", fmt::join(words, "`, `"));
}

// What may stand there.
std::string values(const Field& field) {
    std::string bounds = fmt::format("{} to {}", field.minimum, field.maximum);
    switch (field.kind) {
        case FieldKind::texture: {
            std::vector<std::string_view> names;
            for (auto encoding : field.encodings) names.push_back(ir::encoding_name(encoding));
            return fmt::format("a texture of encoding {}", list(names));
        }
        case FieldKind::uv:
            return "0 to 7, or an [object](#coordinates)";
        case FieldKind::choice:
            return list(field.choices);
        case FieldKind::flag:
            return "`true`, `false`";
        case FieldKind::integer:
            return fmt::format("{}, whole", bounds);
        case FieldKind::number:
            return fmt::format("{}, `$parameter`, `@node`, a node", bounds);
        case FieldKind::pair:
            return fmt::format("one or two numbers, {}, `$parameter`", bounds);
        case FieldKind::color:
            return fmt::format("one number (a grey) or three, {}, `$parameter`, `@node`, a node", bounds);
        case FieldKind::vector:
            return fmt::format("three numbers, {}", bounds);
        case FieldKind::matrix:
            return "`$parameter` of type `mat4`";
        case FieldKind::entry:
            return "the id of an earlier entry";
        case FieldKind::direction:
            return "three numbers, not all 0";
        case FieldKind::range:
            return "two numbers";
        case FieldKind::file:
            return "a path";
        case FieldKind::identifier:
            return "a name";
        case FieldKind::arguments:
            return "a list";
        case FieldKind::layer:
            return "a layer or a group";
    }
    SG_UNREACHABLE("a field of no kind");
}

std::string fallback(const Field& field) {
    if (field.required) return "required";
    switch (field.kind) {
        case FieldKind::choice:
            return fmt::format("`{}`", field.choices[static_cast<std::size_t>(field.fallback)]);
        case FieldKind::texture:
        case FieldKind::direction:
        case FieldKind::range:
        case FieldKind::file:
        case FieldKind::identifier:
        case FieldKind::arguments:
        case FieldKind::layer:
        case FieldKind::matrix:
        case FieldKind::entry:
            return "";
        case FieldKind::color:
        case FieldKind::vector:
            return fmt::format("{0}, {0}, {0}", field.fallback);
        case FieldKind::flag:
            return field.fallback != 0 ? "`true`" : "`false`";
        default:
            return fmt::format("{}", field.fallback);
    }
}

std::string table(std::span<const Field> fields) {
    if (fields.empty()) return "";
    std::string out = "\n| field | what | values | default |\n|---|---|---|---|\n";
    for (const Field& field : fields) {
        std::string unit = field.unit.empty() ? "" : fmt::format("; {}", field.unit);
        out += fmt::format("| `{}` | {} | {}{} | {} |\n", field.name, field.doc, values(field), unit,
                           fallback(field));
    }
    return out;
}

std::string rows(std::span<const Field> fields) {
    std::string out;
    for (const Field& field : fields) {
        std::string unit = field.unit.empty() ? "" : fmt::format("; {}", field.unit);
        std::string given = fallback(field);
        if (!given.empty() && !field.required) given = ", default " + given;
        if (field.required) given = "; required";
        std::string line = values(field) + given + unit;
        if (field.kind == FieldKind::uv) line = "0 to 7, or an object (see uv)" + given;
        std::erase(line, '`');
        out += fmt::format("  {:<10} {}\n             {}\n", field.name, line, field.doc);
    }
    return out;
}

// The object that may stand for a uv set: what a key may be, and what it is else.
std::string values(const layers::CoordinateKey& key) {
    return fmt::format("{}{} to {}{}{}", key.count == 2 ? "one or two numbers, " : "", key.minimum,
                       key.maximum, key.whole ? ", whole" : "",
                       key.unit.empty() ? "" : fmt::format("; {}", key.unit));
}
std::string fallback(const layers::CoordinateKey& key) {
    return key.count == 2 ? fmt::format("{0}, {0}", key.fallback) : fmt::format("{}", key.fallback);
}
constexpr std::string_view kCoordinateDoc =
    "st' = R (scale st) + offset + time speed, R the rotation; a field `tiling` multiplies the result";

std::string inputs_of(const ir::LightingModel& model) {
    std::string out;
    for (ir::Output input : model.inputs)
        out += fmt::format("{}{}", out.empty() ? "" : ", ", ir::output_name(input));
    return out;
}

}  // namespace

std::string kinds_text() {
    std::string out = "every layer, and a group of layers:\n" + rows(layers::common_fields());
    for (const layers::LayerKind* kind : layers::all_kinds())
        out += fmt::format("\n{}: {}\n{}", kind->name, kind->doc, rows(kind->fields));
    for (const layers::ParallaxKind& kind : layers::all_parallax_kinds())
        out += fmt::format("\nparallax {}: {}\n{}", kind.name, kind.doc, rows(kind.fields));
    for (const layers::NodeKind& kind : layers::all_node_kinds()) {
        out += fmt::format("\nnode {}: {}\n{}", kind.name, kind.doc, rows(kind.fields));
    }
    std::string coordinate(kCoordinateDoc);
    std::erase(coordinate, '`');
    out += fmt::format("\nuv, as an object: {}\n", coordinate);
    for (const layers::CoordinateKey& key : layers::coordinate_keys()) {
        std::string line = fmt::format("{}, default {}", values(key), fallback(key));
        std::erase(line, '`');
        out += fmt::format("  {:<10} {}\n             {}\n", key.name, line, key.doc);
    }
    out += "\nsurface:\n" + rows(layers::surface_fields());
    for (const ir::LightingModel& model : ir::all_lighting_models())
        out += fmt::format("\nlighting {}: {}\n  told of {}\n", model.name, model.doc, inputs_of(model));
    return out;
}

std::string kinds_markdown() {
    std::string out =
        "# Layer kinds, parallax kinds and node kinds\n\nMade from the compiler's tables (`make accept`); "
        "`surfgradc kinds` "
        "prints the same.\n\n"
        "## Layers\n\nEvery layer, and a group (`\"kind\": \"group\", \"layers\": [...]`, which sums its "
        "layers and then counts as one), has:\n";
    out += table(layers::common_fields());
    for (const layers::LayerKind* kind : layers::all_kinds()) {
        out += fmt::format("\n### `{}`\n\n{}; sample: [{}.json]({}.json).\n{}", kind->name, kind->doc,
                           kind->name, kind->name, table(kind->fields));
    }
    out +=
        "\n## Parallax\n\nThe first entry of `bump` may have a `\"parallax\": { \"kind\": KIND, ... }`, "
        "which "
        "moves the surface before its layers see it.\n";
    for (const layers::ParallaxKind& kind : layers::all_parallax_kinds()) {
        out += fmt::format("\n### `{}`\n\n{}; sample: [parallax_{}.json](parallax_{}.json).\n{}", kind.name,
                           kind.doc, kind.name, kind.name, table(kind.fields));
    }
    out +=
        "\n## Nodes\n\nA node is `{ \"op\": KIND, ... }`, under a name in `nodes` or in the place where its "
        "value is used.\n";
    for (const layers::NodeKind& kind : layers::all_node_kinds()) {
        std::string_view result = kind.result == ir::Type::Color ? "a colour" : "a number";
        out +=
            fmt::format("\n### `{}`\n\n{}; gives {}.\n{}", kind.name, kind.doc, result, table(kind.fields));
    }
    out += fmt::format(
        "\n## Coordinates\n\nA field `uv` is the number of a uv set, or an object of these keys: {}.\n\n"
        "| key | what | values | default |\n|---|---|---|---|\n",
        kCoordinateDoc);
    for (const layers::CoordinateKey& key : layers::coordinate_keys())
        out += fmt::format("| `{}` | {} | {} | {} |\n", key.name, key.doc, values(key), fallback(key));
    out += "\n## Surface\n\nBeside `lighting`, `alpha_test` and `two_sided`, `surface` has:\n";
    out += table(layers::surface_fields());
    out +=
        "\n## Lighting models\n\n`\"lighting\": NAME` in `surface`; a field that the model is not told is "
        "refused. Every "
        "surface has `opacity`.\n\n| name | what | fields |\n|---|---|---|\n";
    for (const ir::LightingModel& model : ir::all_lighting_models())
        out += fmt::format("| `{}` | {} | {} |\n", model.name, model.doc, inputs_of(model));
    return out;
}

}  // namespace sg
