#include "target/usage.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace sg::target {
namespace {

// Numbers of the SPIR-V specification, sections 3.52 (instructions), 3.7 (storage classes), 3.20
// (decorations).
constexpr std::uint32_t kHeader = 5, kOpVariable = 59, kOpDecorate = 71;
constexpr std::uint32_t kUniformConstant = 0, kInput = 1, kUniform = 2;
constexpr std::uint32_t kLocation = 30, kBinding = 33, kDescriptorSet = 34;

struct Decorations {
    std::optional<std::uint32_t> location, binding, set;
};

}  // namespace

Usage usage(std::span<const std::uint32_t> words) {
    std::map<std::uint32_t, Decorations> decorations;
    Usage out;
    for (std::size_t i = kHeader; i < words.size(); i += std::max<std::uint32_t>(1, words[i] >> 16u)) {
        const std::uint32_t op = words[i] & 0xFFFFu, count = words[i] >> 16u;
        if (op == kOpDecorate && count == 4) {
            Decorations& at = decorations[words[i + 1]];
            if (words[i + 2] == kLocation) at.location = words[i + 3];
            if (words[i + 2] == kBinding) at.binding = words[i + 3];
            if (words[i + 2] == kDescriptorSet) at.set = words[i + 3];
        }
        if (op != kOpVariable) continue;
        const Decorations& at = decorations[words[i + 2]];
        const std::uint32_t storage = words[i + 3];
        if (storage == kInput && at.location) out.inputs.insert(*at.location);
        const bool resource = storage == kUniformConstant || storage == kUniform;
        if (resource && at.set && at.binding) out.bindings.emplace(*at.set, *at.binding);
    }
    return out;
}

}  // namespace sg::target
