#include "emit/body.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/ice.hpp"
#include "emit/levels.hpp"

namespace sg::emit {
namespace {

using ir::Attribute;
using ir::Value;
using ir::ValueId;

constexpr std::size_t kLongExpression = 90;

// Values that are as short as a name: they are written out at each use.
bool is_trivial(const Value& value) {
    switch (value.op) {
        case ir::Op::position:
        case ir::Op::vertex_normal:
        case ir::Op::vertex_tangent:
        case ir::Op::constant:
        case ir::Op::parameter:
        case ir::Op::derived:
        case ir::Op::vertex_color:
        case ir::Op::splat:
        case ir::Op::color:
        case ir::Op::zero_surfgrad:
        case ir::Op::gradient_from_world:
        case ir::Op::direction_of:
        case ir::Op::swizzle:
        case ir::Op::channel_of:
        case ir::Op::rgb_of:
        case ir::Op::noise_value:
        case ir::Op::triplanar_axis:
        case ir::Op::planar_weights:
        case ir::Op::decal_uv:
        case ir::Op::hit_offset:
        case ir::Op::hit_height:
        case ir::Op::pair_first:
        case ir::Op::pair_second:
            return true;
        default:
            return false;
    }
}

// How tightly a row's text binds: sums, products, everything else. `a + t * b` counts as a sum.
enum class Tightness { sum, product, tight };
Tightness tightness_of(const Value& value) {
    std::string_view glsl = ir::info(value.op).glsl;
    if (!glsl.starts_with("{0} ")) return Tightness::tight;
    return glsl.starts_with("{0} *") ? Tightness::product : Tightness::sum;
}

// How often a row's text writes an operand.
std::uint32_t times_written(std::string_view glsl, std::size_t operand) {
    std::string place = fmt::format("{{{}}}", operand);
    std::uint32_t times = 0;
    for (std::size_t at = glsl.find(place); at != std::string_view::npos; at = glsl.find(place, at + 1))
        ++times;
    return times;
}

void replace_all(std::string& text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
}

}  // namespace

Wording stage_wording(ir::Op op) {
    return {ir::info(op).glsl, ir::info(op).include};
}

Body::Body(const ir::Module& module, const MaterialInterface& material, Wording (*wording)(ir::Op))
    : module_(module),
      material_(material),
      wording_(wording),
      looks_along_ray_(std::any_of(module.values.begin(), module.values.end(),
                                   [](const Value& v) { return ir::looks_along_ray(v.op); })) {
    // A function is called from anywhere: it knows no neighbouring pixels.
    if (wording_ == stage_wording) follows_the_pixels_ = follows_the_pixels(module_);
    count_uses();
    for (std::size_t i = 0; i < module_.values.size(); ++i) {
        std::string_view include = wording_of(module_.values[i]).include;
        if (!include.empty()) includes_.insert(include);
        std::string text = expression(module_.values[i]);
        bool named = wants_name(i, text);
        expressions_.push_back(std::move(text));
        if (named) statement(i);
    }
    begin_layer({});
}

void Body::count_uses() {
    uses_.assign(module_.values.size(), 0);
    layer_result_.assign(module_.values.size(), false);
    for (const Value& value : module_.values) {
        for (ValueId operand : value.operands) {
            const Value& used = module_.at(operand);
            bool leaves_layer = used.layer.valid() && used.layer != value.layer;
            if (leaves_layer && used.type == ir::Type::SurfGrad) layer_result_[operand.index] = true;
        }
    }
    // What an alpha test compares is an output as well; a function leaves the test to its caller.
    bool tested_and_shown = wording_ == stage_wording && module_.output(ir::Output::cutoff).valid() &&
                            module_.output(ir::Output::base_color).valid();
    for (const ir::OutputBinding& output : module_.outputs) {
        bool taken_apart = output.output == ir::Output::frame || is_numbered(output.output) ||
                           output.output == ir::Output::normal_derivatives;
        if (output.output == ir::Output::opacity) taken_apart = tested_and_shown;
        uses_[output.value.index] += taken_apart ? 2 : 1;
        if (module_.at(output.value).layer.valid()) layer_result_[output.value.index] = true;
    }
    // A trivial value is written out at each use, and its operands with it.
    for (std::size_t i = module_.values.size(); i-- > 0;) {
        const Value& value = module_.values[i];
        std::uint32_t times = is_trivial(value) ? std::min(uses_[i], 2u) : 1;
        for (std::size_t k = 0; k < value.operands.size(); ++k) {
            bool called = ir::info(value.op).attribute == Attribute::Function;
            uses_[value.operands[k].index] += called ? 1 : times * times_written(wording_(value.op).glsl, k);
        }
    }
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
std::string Body::operand_of(const Value& parent, std::size_t index) const {
    const std::string& text = expressions_[parent.operands[index].index];
    bool is_name = text.find(' ') == std::string::npos;
    Tightness child = tightness_of(module_.at(parent.operands[index]));
    Tightness outer = tightness_of(parent);
    std::string_view glsl = ir::info(parent.op).glsl;
    bool member = glsl.starts_with("{0}.") && index == 0;
    if (is_name || (child == Tightness::tight)) return text;
    bool looser = child < outer || (child == outer && index > 0) || (outer == Tightness::sum && index > 1);
    return member || (outer != Tightness::tight && looser) ? "(" + text + ")" : text;
}

bool Body::leaves_level_to_hardware(const Value& value) const {
    return value.op == ir::Op::sample && !follows_the_pixels_.empty() &&
           follows_the_pixels_[value.operands[0].index];
}

Wording Body::wording_of(const Value& value) const {
    if (leaves_level_to_hardware(value)) return {"sg_stage_sample({t}, {s}, {0})", "stage/fragment.glsl"};
    return wording_(value.op);
}

std::string Body::expression(const Value& value) const {
    std::string text(wording_of(value).glsl);
    replace_all(text, "{a}", attribute(value));
    if (ir::info(value.op).attribute == Attribute::Texture) {
        const TextureSlot* slot = material_.texture(value.index);
        SG_ASSERT(slot != nullptr);
        replace_all(text, "{t}", slot->variable);
        replace_all(text, "{s}", material_.samplers[slot->sampler].variable);
    }
    for (std::size_t i = 0; i < value.operands.size(); ++i) {
        replace_all(text, fmt::format("{{{}}}", i), operand_of(value, i));
    }
    return text;
}

bool Body::wants_name(std::size_t i, const std::string& expression) const {
    const Value& value = module_.values[i];
    if (is_trivial(value)) return false;
    // Derivatives are taken where they stand, not where they are used behind parallax.
    // Nor behind an alpha test, which ends the neighbours.
    const bool ends = module_.output(ir::Output::cutoff).valid();
    if ((looks_along_ray_ || ends) && ir::takes_screen_derivatives(value.op)) return true;
    if (ends && leaves_level_to_hardware(value)) return true;
    return uses_[i] > 1 || layer_result_[i] || value.type == ir::Type::Frame ||
           expression.size() > kLongExpression;
}

std::string Body::wanted_name(std::size_t i) const {
    const Value& value = module_.values[i];
    std::string_view hint = value.name.empty() ? ir::info(value.op).name : std::string_view(value.name);
    if (!value.layer.valid()) return std::string(hint);
    const std::string& id = module_.layers[value.layer.index].id;
    return layer_result_[i] ? id : fmt::format("{}_{}", id, hint);
}

// A blank line and a comment in front of each layer's lines, a blank line behind them.
void Body::begin_layer(ir::LayerId layer) {
    if (layer == current_layer_) return;
    current_layer_ = layer;
    if (!text_.empty()) text_ += "\n";
    if (!layer.valid()) return;
    const ir::Layer& info = module_.layers[layer.index];
    text_ += fmt::format("    // {}: {}\n", comment_text(info.id), info.kind);
}

void Body::statement(std::size_t i) {
    const Value& value = module_.values[i];
    begin_layer(value.layer);
    std::string name = names_.unique("m_", wanted_name(i));
    text_ += fmt::format("    {} {} = {};\n", ir::info(value.type).glsl, name, expressions_[i]);
    expressions_[i] = name;
}

}  // namespace sg::emit
