#include <algorithm>

#include "base/ice.hpp"
#include "layers/lower_context.hpp"
#include "material/checked.hpp"

namespace sg::material {
namespace {

using ir::Op;
using ir::ValueId;

ir::Module declarations(const CheckedMaterial& material) {
    ir::Module module;
    module.name = material.name;
    for (const CheckedParameter& p : material.parameters) module.parameters.push_back({p.name, ir_type(p.type)});
    for (const CheckedTexture& t : material.textures) module.textures.push_back({t.name, t.encoding});
    for (const CheckedLayer& layer : material.layers) module.layers.push_back({layer.id, std::string(layer.kind->name)});
    return module;
}

// The sum of all layers, in the order of the file (Eq 14).
ValueId gradient(ir::Builder& builder, layers::LowerContext& context, const CheckedMaterial& material) {
    ValueId sum;
    for (std::size_t i = 0; i < material.layers.size(); ++i) {
        const CheckedLayer& layer = material.layers[i];
        context.set_layer({static_cast<std::uint32_t>(i)});
        ValueId g = layer.kind->lower(context, layer.values);
        context.set_layer({});
        sum = sum.valid() ? builder.add(Op::add_surfgrad, {sum, g}) : g;
    }
    return sum.valid() ? sum : builder.add(Op::zero_surfgrad);
}

ValueId surface_value(ir::Builder& builder, const CheckedNumber& number, ir::Type type) {
    if (!number.parameter.valid()) return builder.constant(type, number.numbers);
    ValueId parameter = builder.parameter(number.parameter);
    bool same = builder.module().at(parameter).type == type;
    return same ? parameter : builder.add(Op::color, {parameter});
}

}  // namespace

ir::Module lower(const CheckedMaterial& material) {
    ir::Module module = declarations(material);
    ir::Builder builder(module);
    std::vector<layers::TextureFacts> facts;
    for (const CheckedTexture& t : material.textures) facts.push_back({t.green_up, t.zero});
    layers::LowerContext context(builder, std::move(facts), material.two_sided == TwoSided::mirror);

    ValueId g = gradient(builder, context, material);
    ValueId normal = builder.add(Op::resolve, {context.normal(), g}, "normal");
    if (material.two_sided == TwoSided::flip) normal = builder.add(Op::flip, {normal, context.facing()}, "normal");

    builder.output(ir::Output::normal, normal);
    builder.output(ir::Output::base_color, surface_value(builder, material.base_color, ir::Type::Color));
    builder.output(ir::Output::metallic, surface_value(builder, material.metallic, ir::Type::Scalar));
    builder.output(ir::Output::roughness, surface_value(builder, material.roughness, ir::Type::Scalar));
    builder.output(ir::Output::frame, context.frame());
    builder.output(ir::Output::gradient, g);
    if (context.has_basis_vertex()) builder.output(ir::Output::basis_vertex, context.basis_vertex());
    for (const auto& [set, value] : context.uvs()) builder.output(ir::Output::uv, value, set);

    std::string faults = ir::verify(module);
    if (!faults.empty()) SG_UNREACHABLE("lowering made a bad module:\n" + faults);
    return module;
}

}  // namespace sg::material
