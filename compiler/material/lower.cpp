#include <algorithm>

#include "base/ice.hpp"
#include "ir/lighting.hpp"
#include "layers/lower_context.hpp"
#include "material/checked.hpp"

namespace sg::material {
namespace {

using ir::Op;
using ir::ValueId;

class Lowering {
public:
    Lowering(const CheckedMaterial& material, Custom custom, layers::Numbers numbers)
        : material_(material),
          custom_(custom),
          module_(declarations(material)),
          builder_(module_),
          context_(builder_, facts(material), material.nodes,
                   static_cast<layers::Sides>(material.surface.two_sided), numbers),
          // What is known to leave the surface where it is is not lowered.
          moves_(material.parallax &&
                 !(numbers == layers::Numbers::baked && layers::moves_nothing(material.parallax->values))) {}

    ir::Module run() {
        ValueId gradient, normal;
        if (moves_) parallax(*material_.parallax);
        for (std::size_t i = 0; i < material_.stages.size(); ++i) {
            if (i > 0) context_.begin_entry(normal, material_.stage_ids[i - 1]);
            ValueId g = sum(material_.stages[i]);
            normal = builder_.add(Op::resolve, {context_.normal(), g}, normal_of(material_.stage_ids[i]));
            if (i == 0) gradient = g;
        }
        if (!gradient.valid()) gradient = builder_.add(Op::zero_surfgrad);
        if (!normal.valid()) normal = builder_.add(Op::resolve, {context_.normal(), gradient}, "normal");
        if (material_.surface.two_sided == TwoSided::flip)
            normal = builder_.add(Op::flip, {normal, context_.facing()}, "normal");
        context_.begin_surface();
        surface(normal);
        inputs(gradient);
        return moves_ ? derivatives_first(std::move(module_)) : std::move(module_);
    }

private:
    static ir::Module declarations(const CheckedMaterial& material) {
        ir::Module module;
        module.name = material.name;
        module.lighting = material.surface.lighting;
        for (const CheckedParameter& p : material.parameters)
            module.parameters.push_back({p.name, ir_type(p.type), p.range});
        for (const CheckedTexture& t : material.textures) module.textures.push_back({t.name, t.encoding});
        for (const CheckedShader& s : material.shaders) module.shaders.push_back({s.file, s.text, s.names});
        return module;
    }

    static std::vector<layers::TextureFacts> facts(const CheckedMaterial& material) {
        std::vector<layers::TextureFacts> out;
        for (const CheckedTexture& t : material.textures) out.push_back(t.facts);
        return out;
    }

    // What is replaced is not known: its equivalent is. `group`: that it stands in.
    ir::LayerId declared(const CheckedLayer& layer, ir::LayerId group) {
        if (replaced(layer)) return {};
        return declared(layer.id, layer.kind ? layer.kind->name : "group", group);
    }
    [[nodiscard]] bool replaced(const CheckedLayer& layer) const {
        return custom_ == Custom::replaced && !layer.equivalent.empty();
    }
    ir::LayerId declared(const std::string& id, std::string_view kind, ir::LayerId group = {}) {
        std::string of;
        if (group.valid()) {
            const ir::Layer& outer = module_.layers[group.index];
            of = outer.group + (outer.group.empty() ? "" : "/") + outer.id;
        }
        module_.layers.push_back({id, std::string(kind), std::move(of)});
        return {static_cast<std::uint32_t>(module_.layers.size() - 1)};
    }

    void parallax(const CheckedParallax& parallax) {
        context_.set_layer(declared("parallax", parallax.kind->name));
        parallax.kind->lower(context_, parallax.values);
        context_.set_layer({});
    }

    // What the normal of an entry is called, beside those of the mesh and of what parallax shows.
    static std::string normal_of(const std::string& id) {
        if (id.empty()) return "normal";
        const bool taken = id == "base" || id == "moved" || id == "viewed";
        return id + (taken ? "_entry_normal" : "_normal");
    }

    // The layers of a stage or group from first to last (Eq 13 and 14). `own`: the group's.
    ValueId sum(const std::vector<CheckedLayer>& layers, ir::LayerId own = {}) {
        ValueId total;
        for (const CheckedLayer& layer : layers) {
            const ir::LayerId known = declared(layer, own);
            auto [g, coverage] = scaled(layer, known);
            ValueId share = share_of(layer, coverage);
            ValueId masked = share.valid() ? builder_.add(Op::mask_surfgrad, {g, share}) : g;
            // One layer alone, for the debug entry; likewise a group.
            if (known.valid()) builder_.output(ir::Output::layer, masked, known.index);
            if (layer.common[layers::kBlend].index == layers::kBlendMix) {
                if (!total.valid()) total = builder_.add(Op::zero_surfgrad);
                if (!share.valid()) share = context_.constant(1);
                total = of_group(own, Op::mix_surfgrad, {total, g, share});
                continue;
            }
            total = total.valid() ? of_group(own, Op::add_surfgrad, {total, masked}) : masked;
        }
        return total.valid() ? total : builder_.add(Op::zero_surfgrad);
    }

    // What joins a group's layers is known by the group's name.
    ValueId of_group(ir::LayerId group, Op op, std::vector<ValueId> operands) {
        context_.set_layer(group);
        ValueId joined = builder_.add(op, std::move(operands));
        context_.set_layer({});
        return joined;
    }

    // How much of a layer shows: its mask times what it covers by itself; invalid where it shows wholly.
    ValueId share_of(const CheckedLayer& layer, ValueId coverage) {
        const layers::FieldValue& mask = layer.common[layers::kMask];
        if (!mask.given) return coverage;
        ValueId share = context_.number(mask);
        return coverage.valid() ? builder_.add(Op::multiply, {share, coverage}) : share;
    }

    // A layer's gradient times its strength, and what it covers. `own`: what it is declared as.
    layers::Covered scaled(const CheckedLayer& layer, ir::LayerId own) {
        layers::Covered made;
        if (replaced(layer)) {
            made.gradient = sum(layer.equivalent);
        } else if (layer.kind) {
            context_.set_layer(own);
            const layers::LayerKind& kind = *layer.kind;
            context_.follow_parallax(layers::follows_parallax(layer.values));
            made = kind.lower ? layers::Covered{kind.lower(context_, layer.values), {}}
                              : kind.lower_covered(context_, layer.values);
            context_.follow_parallax(true);
        } else {
            made.gradient = sum(layer.group, own);
        }
        const layers::FieldValue& strength = layer.common[layers::kStrength];
        if (strength.given) made.gradient = times(made.gradient, strength);
        context_.set_layer({});
        return made;
    }

    // A gradient times a strength: of a volume bump before its projection, which cuts what is too long.
    ValueId times(ValueId gradient, const layers::FieldValue& strength) {
        const ir::Value made = module_.at(gradient);
        if (made.op != Op::surfgrad_from_volume)
            return builder_.add(Op::scale_surfgrad, {context_.number(strength), gradient});
        if (gradient.index + 1 == module_.values.size() && !is_shown(gradient)) module_.values.pop_back();
        const ValueId scaled = builder_.add(Op::scale_volgrad, {context_.number(strength), made.operands[1]});
        return builder_.add(Op::surfgrad_from_volume, {made.operands[0], scaled}, made.name);
    }

    [[nodiscard]] bool is_shown(ValueId id) const {
        return std::any_of(module_.outputs.begin(), module_.outputs.end(),
                           [&](const ir::OutputBinding& o) { return o.value == id; });
    }

    void surface(ValueId normal) {
        const CheckedSurface& s = material_.surface;
        const ir::LightingModel& model = ir::all_lighting_models()[module_.lighting];
        builder_.output(ir::Output::normal, normal);
        // What a surface's nodes see is the stage that the layers ended with.
        for (std::size_t i = 0; i < s.values.size(); ++i) {
            const layers::Field& field = layers::surface_fields()[i];
            const ir::Output output = layers::surface_output(field);
            if (!ir::has_input(model, output)) continue;
            const bool color = field.kind == layers::FieldKind::color;
            name_output(output, color ? context_.color(s.values[i]) : within(field, output, s.values[i]));
        }
        without_microfacets();
        if (s.alpha_test)
            builder_.output(ir::Output::cutoff,
                            context_.written(*s.alpha_test, "alpha_test", {&s.alpha_test}));
    }

    // A number that is computed, or a parameter, kept within what the field means.
    ValueId within(const layers::Field& field, ir::Output output, const layers::FieldValue& value) {
        const ValueId number = context_.number(value);
        if (!value.node.valid() && !value.parameter.valid()) return number;
        name(number, output);
        return builder_.add(Op::clamp,
                            {number, context_.constant(field.minimum), context_.constant(field.maximum)});
    }

    // A g-buffer and who calls the function know metallic and roughness. A model without them is no metal,
    // and as rough as the GGX highlight that is as wide as its own: cos^s of the angle to the mirrored light
    // is about cos^4s of half of it, and alpha^2 = 2 / (4 s + 2) (Walter et al. 2007, section 5.2).
    void without_microfacets() {
        using enum ir::Output;
        if (!module_.output(metallic).valid()) builder_.output(metallic, context_.constant(0));
        if (module_.output(roughness).valid()) return;
        ValueId shine = module_.output(shininess);
        if (!shine.valid()) return builder_.output(roughness, context_.constant(0.5));
        ValueId sharpness = builder_.add(
            Op::add, {builder_.add(Op::multiply, {context_.constant(2), shine}), context_.constant(1)});
        builder_.output(roughness, builder_.add(Op::power, {sharpness, context_.constant(-0.25)}));
    }

    // A value without a name is named after what it is here.
    void name_output(ir::Output which, ValueId id) {
        builder_.output(which, id);
        name(id, which);
    }
    void name(ValueId id, ir::Output which) {
        ir::Value& value = module_.values[id.index];
        if (value.name.empty() && !value.operands.empty()) value.name = ir::output_name(which);
    }

    // What the debug entry shows of the inputs.
    void inputs(ValueId gradient) {
        builder_.output(ir::Output::frame, context_.first_frame());
        builder_.output(ir::Output::gradient, gradient);
        if (context_.has_basis_vertex())
            builder_.output(ir::Output::basis_vertex, context_.vertex_tangents());
        if (context_.made_vertex_color().valid())
            builder_.output(ir::Output::vertex_color, context_.made_vertex_color());
        for (const auto& [set, value] : context_.uv_sets()) builder_.output(ir::Output::uv, value, set);
        for (auto space : {layers::Space::object, layers::Space::world}) {
            if (context_.made_volume(space).valid())
                builder_.output(ir::Output::volume, context_.made_volume(space),
                                static_cast<std::uint32_t>(space));
        }
        if (context_.made_normal_derivatives().valid())
            builder_.output(ir::Output::normal_derivatives, context_.made_normal_derivatives());
        if (context_.moved_position().valid())
            builder_.output(ir::Output::moved_position, context_.moved_position());
        for (const auto& [set, value] : context_.moved_uvs())
            builder_.output(ir::Output::moved_uv, value, set);
    }

    // Screen derivatives, and what they are taken of, stand in front of parallax. (They depend on the mesh
    // alone.)
    static ir::Module derivatives_first(ir::Module module) {
        std::vector<bool> early(module.values.size(), false);
        for (std::size_t i = module.values.size(); i-- > 0;) {
            if (ir::takes_screen_derivatives(module.values[i].op)) early[i] = true;
            if (!early[i]) continue;
            for (ValueId operand : module.values[i].operands) early[operand.index] = true;
        }
        std::vector<ValueId> place(module.values.size());
        std::vector<ir::Value> sorted;
        for (bool wanted : {true, false}) {
            for (std::size_t i = 0; i < module.values.size(); ++i) {
                if (early[i] != wanted) continue;
                place[i] = {static_cast<std::uint32_t>(sorted.size())};
                sorted.push_back(std::move(module.values[i]));
            }
        }
        for (ir::Value& value : sorted) {
            for (ValueId& operand : value.operands) operand = place[operand.index];
        }
        for (ir::OutputBinding& output : module.outputs) output.value = place[output.value.index];
        module.values = std::move(sorted);
        return module;
    }

    const CheckedMaterial& material_;
    Custom custom_;
    ir::Module module_;
    ir::Builder builder_;
    layers::LowerContext context_;
    bool moves_;  // by parallax
};

}  // namespace

bool has_reference(const CheckedMaterial& material) {
    auto known = [](const auto& self, const std::vector<CheckedLayer>& layers) -> bool {
        return std::all_of(layers.begin(), layers.end(), [&](const CheckedLayer& layer) {
            bool calls = std::any_of(layer.values.begin(), layer.values.end(),
                                     [](const layers::FieldValue& v) { return !v.word.empty(); });
            return (!calls || !layer.equivalent.empty()) && self(self, layer.group);
        });
    };
    return std::all_of(material.stages.begin(), material.stages.end(),
                       [&](const auto& stage) { return known(known, stage); });
}

ir::Module lower(const CheckedMaterial& material, Custom custom, layers::Numbers numbers) {
    ir::Module module = Lowering(material, custom, numbers).run();
    std::string faults = ir::verify(module);
    if (!faults.empty()) SG_UNREACHABLE("lowering made a bad module:\n" + faults);
    return module;
}

}  // namespace sg::material
