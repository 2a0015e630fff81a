#include "runtime/parameters.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <cstring>

namespace sg::runtime {
namespace {

void store(std::vector<std::byte>& block, const Parameter& parameter, std::span<const float> values) {
    std::memcpy(block.data() + parameter.offset, values.data(), values.size_bytes());
}

const Parameter* find(const Artefact& artefact, std::string_view name, Diags& diags) {
    std::vector<std::string_view> names;
    if (artefact.parameters) {
        for (const Parameter& parameter : artefact.parameters->parameters) {
            if (parameter.name == name) return &parameter;
            names.push_back(parameter.name);
        }
    }
    for (const TextureSlot& slot : artefact.textures) {
        if (!slot.parameter.empty()) names.push_back(slot.parameter);
    }
    std::string known = names.empty() ? "it has none" : fmt::format("it has {}", one_of(names));
    diags.error(Code::unknown_material_parameter,
                fmt::format("material '{}' has no parameter '{}'{} ({})", printable(artefact.name),
                            printable(name), did_you_mean(name, names), known));
    return nullptr;
}

std::optional<std::vector<float>> values_of(const Parameter& parameter, std::string_view text, Diags& diags) {
    const bool is_bool = parameter.type == "bool";
    if (is_bool && (text == "true" || text == "false")) text = text == "true" ? "1" : "0";
    auto numbers = parse_numbers(text);
    if (numbers && is_bool && *numbers != std::vector{0.0} && *numbers != std::vector{1.0}) numbers.reset();
    if (numbers && parameter.type == "int" && numbers->size() == 1 &&
        std::floor((*numbers)[0]) != (*numbers)[0])
        numbers.reset();
    if (!numbers && (is_bool || parameter.type == "int")) {
        diags.error(
            Code::bad_argument,
            fmt::format("parameter '{}' is {}, not '{}'", printable(parameter.name),
                        is_bool ? "a bool: expected true or false" : "an int: expected a whole number",
                        printable(text)));
        return std::nullopt;
    }
    if (!numbers || numbers->size() != parameter.initial.size()) {
        diags.error(Code::bad_argument,
                    fmt::format("parameter '{}' is a {}: expected {} number{} separated by commas, not '{}'",
                                printable(parameter.name), parameter.type, parameter.initial.size(),
                                parameter.initial.size() == 1 ? "" : "s", printable(text)));
        return std::nullopt;
    }
    std::vector<float> out;
    for (double value : *numbers) {
        if (parameter.range && !(value >= (*parameter.range)[0] && value <= (*parameter.range)[1])) {
            diags.error(Code::bad_argument,
                        fmt::format("parameter '{}' must be from {} to {}, not {}", printable(parameter.name),
                                    (*parameter.range)[0], (*parameter.range)[1], value));
            return std::nullopt;
        }
        out.push_back(static_cast<float>(value));
    }
    return out;
}

// Behind all settings: what depends on them.
void store_derived(std::vector<std::byte>& bytes, const ParameterBlock& block) {
    std::vector<Numbers> parameters;
    for (const Parameter& parameter : block.parameters) {
        Numbers values{.count = parameter.initial.size()};
        for (std::size_t i = 0; i < values.count; ++i) {
            float number = 0;
            std::memcpy(&number, bytes.data() + parameter.offset + i * sizeof(float), sizeof(float));
            values.at[i] = double{number};
        }
        parameters.push_back(values);
    }
    const std::vector<Numbers> derived = derived_numbers(block, parameters);
    for (std::size_t k = 0; k < derived.size(); ++k) {
        for (std::size_t i = 0; i < block.derived[k].count; ++i) {
            const float number = stored(derived[k][i]);
            std::memcpy(bytes.data() + block.derived[k].offset + i * sizeof(float), &number, sizeof(float));
        }
    }
}

}  // namespace

std::vector<Numbers> derived_numbers(const ParameterBlock& block, std::span<const Numbers> parameters) {
    std::vector<Numbers> steps, out;
    for (const Expression& step : block.steps) steps.push_back(evaluate(step, parameters, steps));
    for (const DerivedParameter& derived : block.derived)
        out.push_back(evaluate(derived.expression, parameters, steps));
    return out;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
    std::vector<double> out;
    while (true) {
        double value = 0;
        auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        out.push_back(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (text.empty()) return out;
        if (text.front() != ',') return std::nullopt;
        text.remove_prefix(1);
    }
}

std::optional<std::vector<std::byte>> pack_parameters(const Artefact& artefact,
                                                      std::span<const std::string> settings, Diags& diags) {
    std::vector<std::byte> block;
    if (artefact.parameters) {
        block.resize(artefact.parameters->size);
        for (const Parameter& parameter : artefact.parameters->parameters)
            store(block, parameter, parameter.initial);
    }
    bool ok = true;
    for (const std::string& setting : settings) {
        std::size_t equals = setting.find('=');
        if (equals == std::string::npos) {
            diags.error(Code::bad_argument,
                        fmt::format("'{}' is not of the form NAME=VALUE", printable(setting)));
            ok = false;
            continue;
        }
        const Parameter* parameter = find(artefact, std::string_view(setting).substr(0, equals), diags);
        auto values = parameter == nullptr
                          ? std::nullopt
                          : values_of(*parameter, std::string_view(setting).substr(equals + 1), diags);
        if (values) store(block, *parameter, *values);
        ok = ok && values;
    }
    if (!ok) return std::nullopt;
    if (artefact.parameters) store_derived(block, *artefact.parameters);
    return block;
}

}  // namespace sg::runtime
