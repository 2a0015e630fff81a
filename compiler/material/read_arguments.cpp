#include <fmt/core.h>

#include <algorithm>

#include "material/reader.hpp"

namespace sg::material {

using json::Kind;
using json::Value;

// A word of layers::surface_arguments(), { "uv": ... }, { "texture": ... }, one to four numbers,
// "$parameter",
// "@node" or a node. A texture with anything beside it is the node that reads it.
std::optional<ArgumentDecl> Reader::argument(const Value& value, const std::string& pointer) {
    ArgumentDecl decl{.at = {value.span, pointer}};
    bool word =
        value.kind == Kind::string && !value.string.starts_with('$') && !value.string.starts_with('@');
    auto fail = [&](Code code, std::string message) {
        diags.error(code, {source, value.span, pointer}, std::move(message));
        return std::nullopt;
    };
    if (word) {
        std::vector<std::string_view> names;
        for (const layers::SurfaceArgument& row : layers::surface_arguments()) names.push_back(row.name);
        auto found = std::find(names.begin(), names.end(), value.string);
        if (found == names.end()) {
            std::string hint = did_you_mean(value.string, names);
            if (hint.empty()) hint = fmt::format(", expected {}", one_of(names));
            return fail(Code::unknown_choice,
                        fmt::format("unknown argument '{}'{}", printable(value.string), hint));
        }
        decl.kind = ArgumentDecl::Kind::surface;
        decl.surface = static_cast<std::size_t>(found - names.begin());
        return decl;
    }
    const bool reads = value.kind == Kind::object && value.find("texture") && value.members.size() > 1;
    if (value.kind == Kind::object && !value.find("op") && !reads) {
        ObjectReader reader = object(value, pointer, "an argument", {"uv", "texture"});
        if (value.find("uv")) {
            decl.kind = ArgumentDecl::Kind::uv;
            auto uv = coordinate(reader, "uv");
            if (!uv) return std::nullopt;
            decl.uv = *uv;
            return decl;
        }
        decl.kind = ArgumentDecl::Kind::texture;
        auto name = reader.name("texture", true);
        if (!name) return std::nullopt;
        decl.texture = *name;
        return decl;
    }
    decl.expression.at = decl.at;
    if (value.kind == Kind::object) {
        decl.expression.kind = Expression::Kind::node;
        decl.expression.node = out.nodes.size();
        out.nodes.emplace_back();
        node(value, pointer, decl.expression.node);
        return decl;
    }
    if (value.kind == Kind::string) {
        decl.expression.kind =
            value.string.starts_with('$') ? Expression::Kind::parameter : Expression::Kind::node_name;
        decl.expression.name = value.string.substr(1);
        return decl;
    }
    std::vector<const Value*> numbers;
    if (value.kind == Kind::number) numbers.push_back(&value);
    for (const Value& item : value.items) numbers.push_back(&item);
    bool good =
        !numbers.empty() && numbers.size() <= 4 && (value.kind == Kind::number || numbers.size() >= 2);
    for (const Value* n : numbers) good = good && n->kind == Kind::number;
    if (!good) {
        return fail(
            Code::wrong_type,
            fmt::format(
                "expected a word, one to four numbers, an object with 'uv' or 'texture', a \"$parameter\", "
                "a \"@node\" or a node as an argument, found {}",
                json::kind_name(value.kind)));
    }
    for (const Value* n : numbers) {
        if (n->number < kAnyNumber.minimum || n->number > kAnyNumber.maximum) {
            return fail(Code::out_of_range, fmt::format("an argument is {}, expected {} to {}", n->number,
                                                        kAnyNumber.minimum, kAnyNumber.maximum));
        }
        decl.expression.numbers.push_back(n->number);
    }
    return decl;
}

std::vector<ArgumentDecl> Reader::arguments(ObjectReader& reader, std::string_view key) {
    std::vector<ArgumentDecl> found;
    for (const auto& [item, pointer] : reader.array(key)) {
        if (auto decl = argument(*item, pointer)) found.push_back(std::move(*decl));
    }
    return found;
}

}  // namespace sg::material
