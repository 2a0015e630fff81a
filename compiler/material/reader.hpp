// The reader's state: what the files read*.cpp share.
#pragma once

#include "material/material.hpp"
#include "material/object_reader.hpp"

namespace sg::material {

struct Reader {
    SourcePtr source;
    Diags& diags;
    Material out{};

    ObjectReader object(const json::Value& value, std::string pointer, std::string what,
                        std::vector<std::string_view> keys) {
        return {source, value, std::move(pointer), std::move(what), std::move(keys), diags};
    }

    void header(ObjectReader& reader);
    void parameter(const json::Member& member, const std::string& pointer);
    // What the key holds as the parameter's value.
    void parameter_value(ObjectReader& reader, std::string_view key, ParameterDecl& decl);
    void texture(const json::Member& member, const std::string& pointer);
    SamplerDecl sampler(const json::Value& value, const std::string& pointer);
    void surface(const json::Value& value, const std::string& pointer);
    void budget(const json::Value& value, const std::string& pointer);
    static bool means_an_instance(const json::Value& root);
    void document(const json::Value& root);

    // instance.cpp
    ObjectReader instance(const json::Value& root);
    // `folder`: of this material, seen from the outermost one.
    void override_parameters(ObjectReader& reader, const std::string& folder, Material& base);

    // read_layers.cpp
    void stage(const json::Value& value, const std::string& pointer);
    std::optional<LayerDecl> layer(const json::Value& value, const std::string& pointer);
    void equivalent(ObjectReader& reader, const layers::Field& row, LayerDecl& decl);
    std::optional<LayerDecl> group(const json::Value& value, const std::string& pointer);
    ParallaxDecl parallax(const json::Value& value, const std::string& pointer);
    void named_nodes(ObjectReader& reader);
    bool constant_node(ObjectReader& nodes, const json::Member& member, std::size_t index);
    // `number`: one is wanted, so that a texture without "op" is read for a channel.
    void node(const json::Value& value, const std::string& pointer, std::size_t index, bool number = false);

    // read_fields.cpp
    std::vector<FieldEntry> entries(ObjectReader& reader, std::span<const layers::Field> fields);
    std::optional<FieldEntry> field(ObjectReader& reader, const layers::Field& row, std::size_t index);
    std::optional<Expression> expression(ObjectReader& reader, std::string_view key, std::size_t count,
                                         Range range, bool spread, bool nodes);
    std::optional<layers::Coordinate> coordinate(ObjectReader& reader, std::string_view key);

    // read_arguments.cpp
    std::vector<ArgumentDecl> arguments(ObjectReader& reader, std::string_view key);
    std::optional<ArgumentDecl> argument(const json::Value& value, const std::string& pointer);
};

constexpr Range kAnyNumber{-3.0e38, 3.0e38};  // what a 32-bit float can hold

}  // namespace sg::material
