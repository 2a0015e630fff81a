#include <fmt/core.h>

#include <algorithm>

#include "ir/lighting.hpp"
#include "material/checker.hpp"

namespace sg::material {

// A written name starts with no '$' or '@', but may be any of those that are made up.
std::string Checker::made_up_id(std::string id) const {
    while (ids_by_name.contains(id)) id.insert(0, "unnamed ");
    return id;
}

CheckedLayer Checker::layer(const LayerDecl& decl, bool counts) {
    // What stands for a function of the user's is in no shader beside it: it names and bounds nothing.
    const std::size_t number = counts ? ++layer_count : ++equivalent_count;
    if (counts && number == kMaxLayers + 1) layer_too_many = decl.at;
    CheckedLayer checked{.id = decl.id.value, .kind = decl.kind};
    if (checked.id.empty())
        checked.id = made_up_id(fmt::format("{} {}", counts ? "layer" : "equivalent", number));
    checked.common = values("a layer", layers::common_fields(), decl.common);
    if (decl.kind) {
        checked.values =
            values(fmt::format("a layer of kind '{}'", decl.kind->name), decl.kind->fields, decl.entries);
        together(*decl.kind, decl.at, decl.entries, checked.values);
        if (decl.kind->result) shader_call(decl, checked);
    }
    for (const LayerDecl& inner : decl.group.layers) checked.group.push_back(layer(inner, counts));
    for (const LayerDecl& inner : decl.equivalent) checked.equivalent.push_back(layer(inner, false));
    return checked;
}

// Layers before it would have been looked up where the mesh is, not where the eye looks.
void Checker::parallax() {
    for (std::size_t i = 0; i < in.bump.size(); ++i) {
        const std::optional<ParallaxDecl>& decl = in.bump[i].parallax;
        if (!decl || !decl->kind) continue;
        CheckedParallax checked{.kind = decl->kind};
        checked.values = values(fmt::format("a parallax of kind '{}'", decl->kind->name), decl->kind->fields,
                                decl->entries);
        together(*decl->kind, decl->at, decl->entries, checked.values);
        if (i > 0) {
            error(Code::parallax_place, decl->at,
                  "a parallax behind a resolve, expected it in the first entry of 'bump'",
                  {note("that entry is here", in.bump[0].at)});
        }
        out.parallax = std::move(checked);
    }
}

void Checker::claim(const Located<std::string>& id) {
    if (id.value.empty()) return;
    auto [first, fresh] = ids_by_name.try_emplace(id.value, id.at);
    if (fresh) return;
    error(Code::duplicate_id, id.at, fmt::format("id '{}' is taken", printable(id.value)),
          {note("the first is here", first->second)});
}

void Checker::claim_layers(const std::vector<LayerDecl>& decls) {
    for (const LayerDecl& decl : decls) {
        claim(decl.id);
        claim_layers(decl.group.layers);
        claim_layers(decl.equivalent);
    }
}

void Checker::index_names() {
    auto fill = [](Index& index, const auto& decls) {
        for (std::size_t i = 0; i < decls.size(); ++i) {
            if (!decls[i].name.value.empty()) index.emplace(decls[i].name.value, i);
        }
    };
    fill(textures_by_name, in.textures);
    fill(parameters_by_name, in.parameters);
    fill(nodes_by_name, in.nodes);
}

// Stages and layers share one space of names: messages, generated text and views use them.
void Checker::ids() {
    for (const StageDecl& stage : in.bump) {
        claim(stage.id);
        claim_layers(stage.layers);
    }
}

// Those of type texture are no numbers: they stand for a texture.
void Checker::parameters() {
    std::uint32_t bytes = 0;
    const ParameterDecl* first_beyond = nullptr;
    for (const ParameterDecl& p : in.parameters) {
        if (p.type == ParameterType::texture) {
            parameter_index.emplace_back();
            continue;
        }
        parameter_index.push_back({static_cast<std::uint32_t>(out.parameters.size())});
        out.parameters.push_back({p.name.value, p.type, p.fallback, p.range, p.label, p.unit});
        const ir::Std140 layout = ir::std140(ir_type(p.type));
        bytes = ir::aligned(bytes, layout.alignment) + layout.size;
        if (bytes > kMaxParameterBytes && !first_beyond) first_beyond = &p;
    }
    if (first_beyond)
        error(Code::too_many, first_beyond->name.at,
              fmt::format("{} bytes of parameters, expected at most {}", bytes, kMaxParameterBytes));
}

void Checker::surface() {
    const SurfaceDecl& s = in.surface;
    out.surface = {s.lighting, values("'surface'", layers::surface_fields(), s.entries), s.alpha_test,
                   s.two_sided};
    const ir::LightingModel& model = ir::all_lighting_models()[s.lighting];
    for (const FieldEntry& entry : s.entries) {
        const layers::Field& field = layers::surface_fields()[entry.field];
        const ir::Output input = layers::surface_output(field);
        if (s.unlit || ir::has_input(model, input)) continue;
        std::vector<std::string_view> others;
        for (const ir::LightingModel& other : ir::all_lighting_models()) {
            if (ir::has_input(other, input)) others.push_back(other.name);
        }
        error(Code::unused_setting, entry.at,
              fmt::format("'{}' means nothing for the lighting '{}', expected it beside the lighting {} only",
                          field.name, model.name, one_of(others)));
    }
}

std::string_view parameter_type_name(ParameterType type) {
    constexpr std::string_view kNames[] = {"float", "vec2", "vec3", "vec4",   "color",
                                           "bool",  "int",  "mat4", "texture"};
    return kNames[static_cast<std::size_t>(type)];
}

ir::Type ir_type(ParameterType type) {
    constexpr ir::Type kTypes[] = {ir::Type::Scalar, ir::Type::Vec2,   ir::Type::Vec3,   ir::Type::Vec4,
                                   ir::Type::Color,  ir::Type::Scalar, ir::Type::Scalar, ir::Type::Projector};
    return kTypes[static_cast<std::size_t>(type)];
}

std::size_t number_count(ParameterType type) {
    return type == ParameterType::matrix ? 16 : ir::component_count(ir_type(type));
}

std::optional<CheckedMaterial> check(const Material& material, Files& files, const Roots& roots,
                                     Diags& diags) {
    std::size_t before = diags.error_count();
    Checker checker{material, files, roots, diags};
    checker.out.name =
        material.name.empty() ? std::filesystem::path(material.source->name).stem().string() : material.name;
    checker.out.bases = material.bases;
    checker.parameters();
    checker.out.budget = material.budget;
    checker.out.source = material.source;
    checker.index_names();
    checker.ids();
    checker.textures();
    checker.nodes();
    checker.parallax();
    for (const StageDecl& stage : material.bump) {
        checker.current_entry = checker.out.stages.size();
        checker.out.stages.emplace_back();
        checker.out.stage_ids.push_back(stage.id.value);
        for (const LayerDecl& decl : stage.layers)
            checker.out.stages.back().push_back(checker.layer(decl, true));
    }
    checker.surface();
    auto limit = [&](std::size_t count, std::size_t most, std::string_view things, const At& at) {
        if (count > most)
            checker.error(Code::too_many, at, fmt::format("{} {}, expected at most {}", count, things, most));
    };
    if (material.bump.size() > kMaxStages) {
        checker.error(
            Code::too_many, material.bump[kMaxStages].at,
            fmt::format("{} entries of 'bump', expected at most {}", material.bump.size(), kMaxStages));
    }
    limit(checker.layer_count, kMaxLayers, "layers", checker.layer_too_many);
    limit(checker.out.textures.size(), kMaxTextures, "textures that are used", checker.texture_too_many);
    if (diags.error_count() > before) return std::nullopt;
    return std::move(checker.out);
}

}  // namespace sg::material
