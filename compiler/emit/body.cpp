#include "emit/body.hpp"

#include <fmt/core.h>

#include "base/ice.hpp"

namespace sg::emit {
namespace {

using ir::Attribute;
using ir::Value;
using ir::ValueId;

// How tightly a row's text binds: sums, products, everything else. `a + t * b` counts as a sum.
enum class Tightness { sum, product, tight };
Tightness tightness_of(std::string_view glsl) {
    if (glsl.starts_with("{0} *") || glsl.starts_with("-{")) return Tightness::product;
    return glsl.starts_with("{0} ") ? Tightness::sum : Tightness::tight;
}

// For a value that no one named.
std::string_view hint_of(const Value& value) {
    switch (value.type) {
        case ir::Type::SurfGrad:
        case ir::Type::VolGrad:
        case ir::Type::LocalGrad:
            return "gradient";
        case ir::Type::Deriv:
            return "deriv";
        case ir::Type::Color:
            return "color";
        default:
            return ir::info(value.op).name;
    }
}

void replace_all(std::string& text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
}

// Where a text takes channels of a swizzle, `place`.xy of c.wzyx, it takes them of what was swizzled: c.wz.
void choose_channels(std::string& text, const std::string& place, std::string_view swizzled) {
    constexpr std::string_view kLetters = "xyzwrgba";
    const std::string part = place + ".";
    const std::size_t dot = swizzled.rfind('.');
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at)) {
        std::string chosen(swizzled.substr(0, dot + 1));
        std::size_t end = at + part.size();
        for (; end < text.size() && kLetters.find(text[end]) != kLetters.npos; ++end)
            chosen += swizzled[dot + 1 + kLetters.find(text[end]) % 4];
        text.replace(at, end - at, chosen);
    }
}

}  // namespace

Body::Body(const ir::Module& module, const MaterialInterface& material, Wording (*wording)(ir::Op))
    : module_(module),
      material_(material),
      wording_(wording),
      plan_(plan_of(module, wording)),
      expressions_(module.values.size()) {
    // Names are given in the order of the text, expressions are made in that of the module.
    std::vector<std::string> names(module_.values.size());
    for (const Local& local : plan_.locals)
        names[local.value] = names_.unique("m_", wanted_name(local.value));
    std::vector<std::string> statements(module_.values.size());
    for (std::size_t i = 0; i < module_.values.size(); ++i) {
        const Value& value = module_.values[i];
        std::string_view include = wording_of(i).include;
        if (!include.empty()) includes_.insert(include);
        expressions_[i] = expression(i);
        if (names[i].empty()) continue;
        statements[i] =
            fmt::format("    {} {} = {};\n", ir::info(value.type).glsl, names[i], expressions_[i]);
        expressions_[i] = std::move(names[i]);
    }
    write(statements);
}

// Paragraph by paragraph: the lines of a layer, or those of none.
void Body::write(const std::vector<std::string>& statements) {
    std::vector<bool> has_lines(module_.layers.size()), seen(module_.values.size());
    for (const Local& local : plan_.locals) {
        if (local.layer.valid()) has_lines[local.layer.index] = true;
    }
    const std::span<const Local> locals = plan_.locals;
    for (std::size_t begin = 0, end = 0; begin < locals.size(); begin = end) {
        while (end < locals.size() && locals[end].layer == locals[begin].layer) ++end;
        std::vector<ValueId> roots;
        for (std::size_t i = begin; i < end; ++i)
            roots.push_back({static_cast<std::uint32_t>(locals[i].value)});
        std::vector<ir::LayerId> layers = looks_without_lines(std::move(roots), has_lines, seen);
        if (locals[begin].layer.valid()) layers.push_back(locals[begin].layer);
        begin_paragraph(layers);
        for (std::size_t i = begin; i < end; ++i) text_ += statements[locals[i].value];
    }
    std::vector<ValueId> roots;
    for (const ir::OutputBinding& output : module_.outputs) roots.push_back(output.value);
    const std::vector<ir::LayerId> behind = looks_without_lines(std::move(roots), has_lines, seen);
    if (!behind.empty()) begin_paragraph(behind);
}

// The layers that find what the eye sees, have no line of their own, and are written for the first time in
// what these values are computed from.
std::vector<ir::LayerId> Body::looks_without_lines(std::vector<ValueId> open, std::vector<bool>& has_lines,
                                                   std::vector<bool>& seen) const {
    std::vector<ir::LayerId> out;
    while (!open.empty()) {
        const ValueId id = open.back();
        open.pop_back();
        if (seen[id.index]) continue;
        seen[id.index] = true;
        const Value& value = module_.at(id);
        if (ir::looks_along_ray(value.op) && value.layer.valid() && !has_lines[value.layer.index]) {
            has_lines[value.layer.index] = true;
            out.push_back(value.layer);
        }
        open.insert(open.end(), value.operands.begin(), value.operands.end());
    }
    return out;
}

// A call of a user's function. A texture is two arguments, as everywhere in the library.
std::string Body::call(const Value& value) const {
    const ir::Function& function = module_.functions[value.index];
    std::string arguments;
    std::size_t operand = 0;
    for (const ir::Argument& argument : function.arguments) {
        if (!arguments.empty()) arguments += ", ";
        if (!argument.texture.valid()) {
            arguments += expressions_[value.operands[operand++].index];
            continue;
        }
        const TextureSlot* slot = material_.texture(argument.texture.index);
        SG_ASSERT(slot != nullptr);
        arguments += fmt::format("{}, {}", slot->variable, material_.samplers[slot->sampler].variable);
    }
    return fmt::format("{}{}({})", ir::shader_prefix(function.shader), function.name, arguments);
}

std::string Body::attribute(const Value& value) const {
    switch (ir::info(value.op).attribute) {
        case Attribute::Set:
            return fmt::format("{}", value.index);
        case Attribute::Parameter:
            return "sg_material." + material_.parameters[value.index].member;
        case Attribute::Derived:
            return "sg_material." + material_.parameters[material_.first_derived + value.index].member;
        case Attribute::Zero:
            return float_literal(value.number[0]);
        case Attribute::Number: {
            std::size_t count = ir::component_count(value.type);
            if (count == 1) return float_literal(value.number[0]);
            bool same = true;
            std::string list;
            for (std::size_t i = 0; i < count; ++i) {
                same = same && value.number[i] == value.number[0];
                list += (i > 0 ? ", " : "") + float_literal(value.number[i]);
            }
            return fmt::format("{}({})", ir::info(value.type).glsl,
                               same ? float_literal(value.number[0]) : list);
        }
        case Attribute::Count:
            return fmt::format("{}", value.index);
        case Attribute::Channel:
        case Attribute::Axis:
            return std::string(1, "xyzw"[value.index]);
        case Attribute::Swizzle: {
            std::string letters;
            for (std::uint32_t channel : ir::swizzle_channels(value.index)) letters += "xyzw"[channel];
            return letters;
        }
        case Attribute::Corner:
            return fmt::format("{}, {}", value.index < 2 ? "SG_RIGHT_HAND" : "SG_LEFT_HAND",
                               value.index % 2 == 0 ? "SG_UPPER_LEFT" : "SG_LOWER_LEFT");
        case Attribute::Function:
            return call(value);
        case Attribute::Texture:
        case Attribute::None:
            break;
    }
    return "";
}

// Parentheses where the tree would not survive being printed without them. Below a name no operand binds
// loosely.
std::string Body::operand_of(std::size_t parent, std::size_t index) const {
    const std::size_t operand = module_.values[parent].operands[index].index;
    const std::string& text = expressions_[operand];
    const std::string_view glsl = wording_of(parent).glsl;
    if (glsl.starts_with('-') && text.starts_with('-')) return "(" + text + ")";  // no decrement
    bool is_name = text.find(' ') == std::string::npos;
    Tightness child = tightness_of(wording_of(operand).glsl), outer = tightness_of(glsl);
    bool member = glsl.starts_with("{0}.") && index == 0;
    if (is_name || (child == Tightness::tight)) return text;
    bool looser = child < outer || (child == outer && index > 0) || (outer == Tightness::sum && index > 1);
    return member || (outer != Tightness::tight && looser) ? "(" + text + ")" : text;
}

Wording Body::wording_of(std::size_t index) const {
    if (plan_.hardware_level[index]) return {"sg_stage_sample({t}, {s}, {0})", "stage/fragment.glsl"};
    const Value& value = module_.values[index];
    const std::string_view plainer = plainer_wording(value);
    return plainer.empty() ? wording_(value.op) : Wording{plainer, ""};
}

// 0 - x and -1 x are written as negations, and a frequency of 1 is not written; "" for all else.
std::string_view Body::plainer_wording(const Value& value) const {
    auto is = [&](std::size_t operand, double number) {
        const Value& given = module_.at(value.operands[operand]);
        return given.op == ir::Op::constant && given.number[0] == number;
    };
    switch (value.op) {
        case ir::Op::subtract:
            return is(0, 0) ? "-{1}" : "";
        case ir::Op::multiply:
            if (is(1, -1)) return "-{0}";
            [[fallthrough]];
        case ir::Op::scale_deriv:
        case ir::Op::scale_surfgrad:
        case ir::Op::scale_volgrad:
            return is(0, -1) ? "-{1}" : "";
        case ir::Op::noise_gradient:
            return is(0, 1) ? "{1}.gradient" : is(0, -1) ? "-{1}.gradient" : "";
        default:
            return "";
    }
}

std::string Body::expression(std::size_t index) const {
    const Value& value = module_.values[index];
    std::string text(wording_of(index).glsl);
    const bool is_sum = text == "{0} + {1}" || text == "{0} - {1}";
    replace_all(text, "{a}", attribute(value));
    if (ir::info(value.op).attribute == Attribute::Texture) {
        const TextureSlot* slot = material_.texture(value.index);
        SG_ASSERT(slot != nullptr);
        replace_all(text, "{t}", slot->variable);
        replace_all(text, "{s}", material_.samplers[slot->sampler].variable);
    }
    for (std::size_t i = 0; i < value.operands.size(); ++i) {
        const std::string place = fmt::format("{{{}}}", i);
        std::string operand = operand_of(index, i);
        if (is_sum && i == 1 && operand.starts_with('-')) {  // a - -b is a + b, and a + -b is a - b
            operand.erase(0, 1);
            char& sign = text[text.rfind(" {1}") - 1];
            sign = sign == '+' ? '-' : '+';
        }
        const Value& given = module_.at(value.operands[i]);
        if (given.op == ir::Op::constant)  // a count
            replace_all(text, "int(" + place + ")", fmt::format("{}", static_cast<int>(given.number[0])));
        if (given.op == ir::Op::swizzle) choose_channels(text, place, operand);
        replace_all(text, place, operand);
    }
    return text;
}

std::string Body::wanted_name(std::size_t i) const {
    const Value& value = module_.values[i];
    std::string_view hint = value.name.empty() ? hint_of(value) : std::string_view(value.name);
    if (!value.layer.valid()) return std::string(hint);
    const std::string& id = module_.layers[value.layer.index].id;
    return plan_.layer_result[i] ? id : fmt::format("{}_{}", id, hint);
}

// A blank line, and in front of layers' lines their comments.
void Body::begin_paragraph(std::span<const ir::LayerId> layers) {
    if (!text_.empty()) text_ += "\n";
    for (ir::LayerId layer : layers) {
        const ir::Layer& info = module_.layers[layer.index];
        const std::string within = info.group.empty() ? "" : " in " + comment_text(info.group);
        text_ += fmt::format("    // {}: {}{}\n", comment_text(info.id), info.kind, within);
    }
}

}  // namespace sg::emit
