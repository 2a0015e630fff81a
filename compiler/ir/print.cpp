#include <fmt/format.h>

#include "ir/lighting.hpp"

namespace sg::ir {
namespace {

std::string quoted(std::string_view text, char quote) {
    std::string out(1, quote);
    for (char c : text) {
        if (c == quote || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20u) {
            out += fmt::format("\\x{:02x}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
    }
    return out + quote;
}

std::string attribute_text(const Value& value) {
    Attribute attribute = info(value.op).attribute;
    if (is_index(attribute)) return fmt::format(" {}", value.index);
    std::size_t count = attribute == Attribute::Zero     ? 1
                        : attribute == Attribute::Number ? component_count(value.type)
                                                         : 0;
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += fmt::format(" {}", value.number[i]);
    return out;
}

std::string value_line(std::size_t i, const Value& value) {
    std::string line = fmt::format("%{} = {}{}", i, info(value.op).name, attribute_text(value));
    for (ValueId operand : value.operands) line += fmt::format(" %{}", operand.index);
    line += fmt::format(" : {}", info(value.type).name);
    if (!value.name.empty()) line += " " + quoted(value.name, value.is_node ? '"' : '\'');
    return line + "\n";
}

std::string layer_line(const Layer& layer) {
    const std::string within = layer.group.empty() ? "" : " in " + quoted(layer.group, '"');
    return fmt::format("layer {} {}{}\n", quoted(layer.id, '"'), layer.kind, within);
}

}  // namespace

std::string print(const Module& module) {
    std::string out = "module " + quoted(module.name, '"') + "\n";
    if (module.lighting != 0)
        out += fmt::format("lighting {}\n", all_lighting_models()[module.lighting].name);
    for (std::size_t i = 0; i < module.textures.size(); ++i) {
        const Texture& texture = module.textures[i];
        out +=
            fmt::format("texture {} {} {}\n", i, quoted(texture.name, '"'), encoding_name(texture.encoding));
    }
    for (std::size_t i = 0; i < module.parameters.size(); ++i) {
        const Parameter& parameter = module.parameters[i];
        out += fmt::format("parameter {} {} : {}", i, quoted(parameter.name, '"'), info(parameter.type).name);
        if (parameter.range) out += fmt::format(" {} {}", (*parameter.range)[0], (*parameter.range)[1]);
        out += "\n";
    }
    for (std::size_t i = 0; i < module.host.size(); ++i) out += "host " + value_line(i, module.host[i]);
    for (std::size_t i = 0; i < module.derived.size(); ++i) {
        const Derived& derived = module.derived[i];
        out += fmt::format("derived {} {} : {} = %{}{}\n", i, quoted(derived.name, '"'),
                           info(derived.type).name, derived.host.index, derived.positive ? " positive" : "");
    }
    for (std::size_t i = 0; i < module.shaders.size(); ++i)
        out += fmt::format("shader {} {}\n", i, quoted(module.shaders[i].file, '"'));
    for (std::size_t i = 0; i < module.functions.size(); ++i) {
        const Function& function = module.functions[i];
        out += fmt::format("function {} {} {}", i, quoted(function.name, '"'), function.shader);
        for (const Argument& argument : function.arguments) {
            out += argument.texture.valid() ? fmt::format(" texture {}", argument.texture.index)
                                            : fmt::format(" {}", info(argument.type).name);
        }
        out += "\n";
    }
    LayerId current;
    for (std::size_t i = 0; i < module.values.size(); ++i) {
        const Value& value = module.values[i];
        if (value.layer != current) {
            current = value.layer;
            out += current.valid() ? layer_line(module.layers[current.index]) : "layer none\n";
        }
        out += value_line(i, value);
    }
    for (const OutputBinding& binding : module.outputs) {
        std::string set = is_numbered(binding.output) ? fmt::format(" {}", binding.set) : "";
        if (binding.output == Output::layer) {
            const Layer& layer = module.layers[binding.set];
            set = fmt::format(" {} {}", quoted(layer.id, '"'), layer.kind);
        }
        out += fmt::format("output {}{} = %{}\n", output_name(binding.output), set, binding.value.index);
    }
    return out;
}

}  // namespace sg::ir
