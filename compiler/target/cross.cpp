#include "target/cross.hpp"

#include <fmt/core.h>

#include <algorithm>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <spirv_cross/spirv_hlsl.hpp>
#include <spirv_cross/spirv_msl.hpp>
#pragma GCC diagnostic pop

#include "base/ice.hpp"
#include "target/function_text.hpp"

namespace sg::target {
namespace {

using emit::BindingKind;
using spirv_cross::Compiler;

spv::ExecutionModel model(Stage stage) {
    SG_ASSERT(stage != Stage::compute);
    return stage == Stage::vertex ? spv::ExecutionModelVertex : spv::ExecutionModelFragment;
}

// Blocks are numbered by their set, textures and samplers by their place among the material's.
std::uint32_t material_number(const Slot& slot, const emit::MaterialInterface& material) {
    auto place = [&](const auto& slots) {
        auto it = std::find_if(slots.begin(), slots.end(),
                               [&](const auto& s) { return s.binding == slot.binding; });
        SG_ASSERT(slot.set == 1 && it != slots.end());
        return static_cast<std::uint32_t>(it - slots.begin());
    };
    if (slot.kind == BindingKind::texture) return place(material.textures);
    if (slot.kind == BindingKind::sampler) return place(material.samplers);
    SG_ASSERT(slot.binding == 0);  // one block per set
    return slot.set;
}

void sort_slots(std::vector<Slot>& slots) {
    std::sort(slots.begin(), slots.end(), [](const Slot& a, const Slot& b) {
        return std::pair(a.set, a.binding) < std::pair(b.set, b.binding);
    });
}

// What the shader uses, and a declaration of nothing else. Inputs and outputs stay whole, so that the stages
// match.
std::vector<Slot> used_slots(Compiler& compiler, const emit::MaterialInterface& material) {
    auto active = compiler.get_active_interface_variables();
    spirv_cross::ShaderResources all = compiler.get_shader_resources();
    for (const auto& list : {all.stage_inputs, all.stage_outputs}) {
        for (const auto& variable : list) active.insert(variable.id);
    }
    for (const auto& list : {all.builtin_inputs, all.builtin_outputs}) {
        for (const auto& builtin : list) active.insert(builtin.resource.id);
    }
    spirv_cross::ShaderResources used = compiler.get_shader_resources(active);
    std::vector<Slot> out;
    auto add = [&](const auto& resources, BindingKind kind) {
        for (const spirv_cross::Resource& r : resources) {
            Slot slot{.kind = kind, .name = r.name};
            slot.set = compiler.get_decoration(r.id, spv::DecorationDescriptorSet);
            slot.binding = compiler.get_decoration(r.id, spv::DecorationBinding);
            slot.index = material_number(slot, material);
            out.push_back(std::move(slot));
        }
    };
    add(used.uniform_buffers, BindingKind::uniform_buffer);
    add(used.separate_images, BindingKind::texture);
    add(used.separate_samplers, BindingKind::sampler);
    compiler.set_enabled_interface_variables(std::move(active));
    sort_slots(out);
    return out;
}

std::vector<Attribute> attributes_of(const Compiler& compiler, Stage stage, Language language) {
    std::vector<Attribute> out;
    if (stage != Stage::vertex) return out;
    for (const spirv_cross::Resource& r : compiler.get_shader_resources().stage_inputs) {
        std::uint32_t location = compiler.get_decoration(r.id, spv::DecorationLocation);
        out.push_back({location, language == Language::hlsl ? fmt::format("TEXCOORD{}", location) : r.name});
    }
    std::sort(out.begin(), out.end(),
              [](const Attribute& a, const Attribute& b) { return a.location < b.location; });
    return out;
}

// The engine fills the same blocks for every target; each vertex shader turns Vulkan's clip space into its
// own.
void convert_clip_space(spirv_cross::CompilerGLSL& compiler, Language language) {
    auto options = compiler.get_common_options();
    options.vertex.flip_vert_y = true;
    options.vertex.fixup_clipspace = language == Language::glsl || language == Language::essl;
    compiler.set_common_options(options);
}

// ---- HLSL ----

// Shader model 5.0 has no spaces: the numbers of the material. From 5.1 on, register and space are binding
// and set.
CrossText to_hlsl(const Words& words, Stage stage, const Target& target,
                  const emit::MaterialInterface& material) {
    spirv_cross::CompilerHLSL compiler(words);
    CrossText out{.function = "main", .slots = used_slots(compiler, material)};
    for (Slot& slot : out.slots) {
        if (target.version > 50) {
            slot.index = slot.binding;
            slot.space = slot.set;
        }
        spirv_cross::HLSLResourceBinding row;
        row.stage = model(stage);
        row.desc_set = slot.set;
        row.binding = slot.binding;
        for (auto* place : {&row.cbv, &row.srv, &row.sampler}) *place = {slot.space, slot.index};
        compiler.add_hlsl_resource_binding(row);
    }
    auto options = compiler.get_hlsl_options();
    options.shader_model = target.version;
    compiler.set_hlsl_options(options);
    convert_clip_space(compiler, target.language);
    out.attributes = attributes_of(compiler, stage, target.language);
    out.text = compiler.compile();
    return out;
}

// ---- Metal ----

CrossText to_msl(const Words& words, Stage stage, const Target& target,
                 const emit::MaterialInterface& material) {
    spirv_cross::CompilerMSL compiler(words);
    CrossText out{.slots = used_slots(compiler, material)};
    for (const Slot& slot : out.slots) {
        spirv_cross::MSLResourceBinding row;
        row.stage = model(stage);
        row.desc_set = slot.set;
        row.binding = slot.binding;
        row.count = 1;
        row.msl_buffer = row.msl_texture = row.msl_sampler = slot.index;
        compiler.add_msl_resource_binding(row);
    }
    auto options = compiler.get_msl_options();
    options.msl_version = target.version;
    compiler.set_msl_options(options);
    convert_clip_space(compiler, target.language);
    out.attributes = attributes_of(compiler, stage, target.language);
    out.text = compiler.compile();
    out.function = compiler.get_cleansed_entry_point_name("main", model(stage));
    return out;
}

// ---- GLSL and ESSL ----

class GlslWriter : public spirv_cross::CompilerGLSL {
public:
    using CompilerGLSL::CompilerGLSL;

    // Functions that take a texture and a sampler take both as one, under the name and in the order of the
    // textures; the order of their use decided before.
    void name_joined_parameters() {
        ir.for_each_typed_id<spirv_cross::SPIRFunction>([&](std::uint32_t,
                                                            spirv_cross::SPIRFunction& function) {
            auto& joined_parameters = function.combined_parameters;
            std::sort(joined_parameters.begin(), joined_parameters.end(), [](const auto& a, const auto& b) {
                return std::uint32_t{a.image_id} < std::uint32_t{b.image_id};
            });
            auto place = [&](const spirv_cross::SPIRFunction::Parameter& parameter) {
                return std::find_if(joined_parameters.begin(), joined_parameters.end(),
                                    [&](const auto& joined) { return joined.id == parameter.id; });
            };
            std::sort(function.shadow_arguments.begin(), function.shadow_arguments.end(),
                      [&](const auto& a, const auto& b) { return place(a) < place(b); });
            for (const auto& joined : joined_parameters) {
                std::uint32_t image = joined.image_id;
                set_name(joined.id,
                         get_name(joined.global_image ? image : std::uint32_t{function.arguments[image].id}));
            }
        });
    }
};

// GL matches the stages' variables by name.
void name_varyings(GlslWriter& compiler, Stage stage) {
    auto resources = compiler.get_shader_resources();
    std::string_view prefix = stage == Stage::vertex ? "sg_out_" : "sg_in_";
    for (const auto& r : stage == Stage::vertex ? resources.stage_outputs : resources.stage_inputs) {
        SG_ASSERT(std::string_view(r.name).starts_with(prefix));
        compiler.set_name(r.id, "sg_varying_" + r.name.substr(prefix.size()));
    }
}

// Textures and samplers become one, named as the texture.
void join_samplers(GlslWriter& compiler, std::vector<Slot>& slots) {
    compiler.build_combined_image_samplers();
    compiler.name_joined_parameters();
    std::vector<Slot> joined;
    for (const auto& pair : compiler.get_combined_image_samplers()) {
        auto is_texture = [&](const Slot& s) {
            return s.set == compiler.get_decoration(pair.image_id, spv::DecorationDescriptorSet) &&
                   s.binding == compiler.get_decoration(pair.image_id, spv::DecorationBinding);
        };
        auto texture = std::find_if(slots.begin(), slots.end(), is_texture);
        SG_ASSERT(texture != slots.end());
        // A unit per texture: units must not depend on which entry point reads it, so no texture has two
        // samplers.
        SG_ASSERT(std::none_of(joined.begin(), joined.end(), is_texture));
        joined.push_back(*texture);
        joined.back().sampler_binding = compiler.get_decoration(pair.sampler_id, spv::DecorationBinding);
        compiler.set_name(pair.combined_id, texture->name);
        compiler.set_decoration(pair.combined_id, spv::DecorationBinding, texture->index);
    }
    std::erase_if(slots, [](const Slot& s) { return s.kind != BindingKind::uniform_buffer; });
    slots.insert(slots.end(), joined.begin(), joined.end());
    sort_slots(slots);
}

spirv_cross::CompilerGLSL::Options glsl_options(const GlslWriter& compiler, const Target& target) {
    auto options = compiler.get_common_options();
    options.version = target.version;
    options.es = target.language == Language::essl;
    options.fragment.default_float_precision = spirv_cross::CompilerGLSL::Options::Highp;
    return options;
}

CrossText to_glsl(const Words& words, Stage stage, const Target& target,
                  const emit::MaterialInterface& material) {
    GlslWriter compiler(words);
    CrossText out{.function = "main", .slots = used_slots(compiler, material)};
    for (const auto& block : compiler.get_shader_resources().uniform_buffers) {
        compiler.set_decoration(block.id, spv::DecorationBinding,
                                compiler.get_decoration(block.id, spv::DecorationDescriptorSet));
    }
    join_samplers(compiler, out.slots);
    name_varyings(compiler, stage);
    compiler.set_common_options(glsl_options(compiler, target));
    convert_clip_space(compiler, target.language);
    out.attributes = attributes_of(compiler, stage, target.language);
    out.text = compiler.compile();
    return out;
}

// ---- one function alone ----

// The names of what a text declares, told apart from those of every other text.
template <class Base>
class FunctionWriter final : public Base {
public:
    using Base::Base;

    void set_apart(std::string_view suffix, std::span<const std::string_view> shared) {
        auto rename = [&](std::uint32_t id) {
            std::string name = this->get_name(id);
            name.resize(std::min(name.size(), name.find('(')));  // functions are called "sg_reject(vf3;vf3;"
            // The library's names may end like a material's: sg_parallax_occlusion.
            bool own = name.ends_with(suffix) &&
                       (!name.starts_with("sg_") || name == "sg_material" + std::string(suffix));
            bool stays = name.empty() || name == "main" || own ||
                         std::find(shared.begin(), shared.end(), name) != shared.end();
            if (!stays) this->set_name(id, name + std::string(suffix));
        };
        using namespace spirv_cross;
        this->ir.template for_each_typed_id<SPIRFunction>(
            [&](std::uint32_t id, SPIRFunction&) { rename(id); });
        this->ir.template for_each_typed_id<SPIRType>([&](std::uint32_t id, SPIRType& type) {
            if (type.basetype == SPIRType::Struct) rename(id);
        });
        // Tables and structs that never change become constants of the text.
        int constants = 0;
        this->ir.template for_each_typed_id<SPIRConstant>([&](std::uint32_t id, SPIRConstant& constant) {
            const SPIRType& type = this->get_type(constant.constant_type);
            if (!type.array.empty() || type.basetype == SPIRType::Struct)
                this->set_name(id, fmt::format("sg_constant{}{}", constants++, suffix));
        });
    }
};

std::string function_in_hlsl(const Words& words, const Target& target, std::string_view suffix,
                             std::span<const std::string_view> shared) {
    FunctionWriter<spirv_cross::CompilerHLSL> compiler(words);
    compiler.set_apart(suffix, shared);
    auto options = compiler.get_hlsl_options();
    options.shader_model = target.version;
    compiler.set_hlsl_options(options);
    return compiler.compile();
}

std::string function_in_msl(const Words& words, const Target& target, std::string_view suffix,
                            std::span<const std::string_view> shared) {
    FunctionWriter<spirv_cross::CompilerMSL> compiler(words);
    compiler.set_apart(suffix, shared);
    auto options = compiler.get_msl_options();
    options.msl_version = target.version;
    compiler.set_msl_options(options);
    return compiler.compile();
}

std::string function_in_glsl(const Words& words, const Target& target, std::string_view suffix,
                             std::span<const std::string_view> shared) {
    FunctionWriter<GlslWriter> compiler(words);
    compiler.set_apart(suffix, shared);
    compiler.build_combined_image_samplers();
    compiler.name_joined_parameters();
    compiler.set_common_options(glsl_options(compiler, target));
    return compiler.compile();
}

}  // namespace

namespace {

// `write()`, or nothing and the cross-compiler's words.
template <class Write>
auto written(std::string& fault, Write write) -> std::optional<decltype(write())> {
    try {
        return write();
    } catch (const spirv_cross::CompilerError& error) {
        fault = error.what();
        return std::nullopt;
    }
}

}  // namespace

std::optional<std::string> cross_compile_function(const Words& words, const Target& target,
                                                  std::string_view suffix,
                                                  std::span<const std::string_view> shared,
                                                  std::string& fault) {
    return written(fault, [&] {
        std::string text = target.language == Language::hlsl ? function_in_hlsl(words, target, suffix, shared)
                           : target.language == Language::msl
                               ? function_in_msl(words, target, suffix, shared)
                               : function_in_glsl(words, target, suffix, shared);
        return declarations_for_inclusion(text, suffix);
    });
}

std::optional<CrossText> cross_compile(const Words& words, Stage stage, const Target& target,
                                       const emit::MaterialInterface& material, std::string& fault) {
    return written(fault, [&] {
        switch (target.language) {
            case Language::hlsl:
                return to_hlsl(words, stage, target, material);
            case Language::msl:
                return to_msl(words, stage, target, material);
            case Language::glsl:
            case Language::essl:
                return to_glsl(words, stage, target, material);
            case Language::spirv:
                break;
        }
        SG_UNREACHABLE("a target that is no text");
    });
}

}  // namespace sg::target
