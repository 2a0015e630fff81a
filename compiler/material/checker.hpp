// The checker's state: what the files check*.cpp share.
#pragma once

#include <map>
#include <set>
#include <tuple>

#include "material/checked.hpp"
#include "material/object_reader.hpp"

namespace sg::material {

inline constexpr Range kAnyRange{-3.0e38, 3.0e38};

// The first rule that does not hold, as a fault of its field.
std::optional<layers::FieldFault> broken_rule(std::span<const layers::Field> fields,
                                              std::span<const layers::Rule> rules, layers::FieldValues found);

struct Checker {
    const Material& in;
    Files& files;
    const Roots& roots;
    Diags& diags;
    CheckedMaterial out{};
    std::vector<std::uint32_t> texture_index;      // from Material::textures to CheckedMaterial::textures
    std::vector<ir::ParameterId> parameter_index;  // from Material::parameters; invalid for textures

    // Names to indexes; the first of two alike.
    using Index = std::map<std::string_view, std::size_t>;
    Index textures_by_name, parameters_by_name, nodes_by_name;

    void error(Code code, const At& at, std::string message, std::vector<Note> notes = {}) {
        diags.error(code, {in.source, at.span, at.pointer}, std::move(message), std::move(notes));
    }
    Note note(std::string text, const At& at) { return {std::move(text), {in.source, at.span, at.pointer}}; }

    // check.cpp
    void index_names();
    void ids();
    void claim(const Located<std::string>& id);
    void claim_layers(const std::vector<LayerDecl>& layers);
    [[nodiscard]] std::string made_up_id(std::string id) const;
    // `counts`: it is no equivalent of another, nor within one.
    CheckedLayer layer(const LayerDecl& decl, bool counts);
    void parallax();
    void surface();
    void parameters();
    std::map<std::string, At, std::less<>> ids_by_name;  // that are written
    std::size_t layer_count = 0, equivalent_count = 0;
    At layer_too_many, texture_too_many;  // the first beyond the limit
    std::size_t current_entry = 0;        // of bump

    // check_fields.cpp
    std::optional<std::size_t> find_texture(const std::string& name, const At& at);
    // Null if there is none; one of another type is reported as well.
    const ParameterDecl* find_parameter(const std::string& name, const At& at,
                                        std::span<const ParameterType> types);
    [[nodiscard]] ir::ParameterId id_of(const ParameterDecl& decl) const;
    void expression(const Expression& written, layers::FieldKind kind, Range limits,
                    layers::FieldValue& value);
    // The numbers or the parameter that a constant holds; null for a node that computes.
    const Expression* constant_value(std::size_t node);
    std::vector<std::optional<const Expression*>> constant_values;  // by node, as far as it was asked
    void constant_limits(const Expression& written, std::size_t node, Range limits);
    [[nodiscard]] bool misread(const NodeDecl& decl) const;
    // What a parameter is by default, and may be by its range, must be fit for the use.
    void parameter_limits(const ParameterDecl& decl, const At& at, Range limits,
                          std::vector<Note> notes = {});
    void instance_limits(const ParameterDecl& decl, double bad, const At& use, Range limits);
    std::set<std::tuple<const ParameterDecl*, double, double>> told_of_instance;
    // The number of an entry of bump that stands before the current one.
    std::uint32_t earlier_entry(const std::string& id, const At& at);
    // Reports a field that only means something behind a parallax.
    void without_parallax(const layers::Field& row, const At& at);
    std::vector<layers::FieldValue> values(std::string_view owner, std::span<const layers::Field> fields,
                                           std::span<const FieldEntry> entries);
    template <class Kind>
    void together(const Kind& kind, const At& at, std::span<const FieldEntry> entries,
                  layers::FieldValues found);
    void nodes();
    void node_cycles();

    // check_shaders.cpp
    void shader_call(const LayerDecl& decl, CheckedLayer& layer);
    void knows_the_normal(const At& layer, const At& returns, std::span<const layers::Argument> arguments);
    std::optional<std::size_t> shader(const std::string& file, const At& at);
    layers::Argument argument(const ArgumentDecl& decl);

    // check_textures.cpp
    // The bytes of a file below the roots; reports why not.
    std::optional<std::string> file_below_roots(const std::string& file, const At& at);
    [[nodiscard]] std::string from_material(const std::string& file) const;
    void textures();
    std::vector<bool> used_textures() const;
    void texture_settings(const TextureDecl& decl);
    void swizzle(const TextureDecl& decl, layers::TextureFacts& facts);
    void color_space(const TextureDecl& decl, const SourcePtr& source, std::string_view bytes);
};

// A fault of fields that are each valid alone; at most one is told.
template <class Kind>
void Checker::together(const Kind& kind, const At& at, std::span<const FieldEntry> entries,
                       layers::FieldValues found) {
    std::optional<layers::FieldFault> fault = broken_rule(kind.fields, kind.rules, found);
    if (!fault && kind.check) fault = kind.check(found);
    if (!fault) return;
    At place = at;
    for (const FieldEntry& entry : entries) {
        if (entry.field == fault->field) place = entry.at;
    }
    error(Code::unused_setting, place, fault->message);
}

}  // namespace sg::material
