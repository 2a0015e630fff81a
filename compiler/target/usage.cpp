#include "target/usage.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace sg::target {
namespace {

// Numbers of the SPIR-V specification, sections 3.52 (instructions), 3.7 (storage classes), 3.20
// (decorations).
constexpr std::uint32_t kHeader = 5, kOpVariable = 59, kOpDecorate = 71;
constexpr std::uint32_t kOpTypeInt = 21, kOpTypeFloat = 22, kOpTypeVector = 23, kOpTypePointer = 32;
// OpImageSampleImplicitLod to OpImageDrefGather, and the same with the residency of the texels.
constexpr std::uint32_t kFirstRead = 87, kLastRead = 97, kFirstSparseRead = 305, kLastSparseRead = 315;
constexpr std::uint32_t kUniformConstant = 0, kInput = 1, kUniform = 2;
constexpr std::uint32_t kLocation = 30, kBinding = 33, kDescriptorSet = 34;

struct Decorations {
    std::optional<std::uint32_t> location, binding, set;
};

bool reads_texels(std::uint32_t op) {
    return (op >= kFirstRead && op <= kLastRead) || (op >= kFirstSparseRead && op <= kLastSparseRead);
}

// How many numbers a type holds, or what it points to; 0 for one that no stage input has.
class Sizes {
public:
    void declare(std::span<const std::uint32_t> instruction) {
        const std::uint32_t op = instruction[0] & 0xFFFFu;
        if (op == kOpTypeInt || op == kOpTypeFloat) of_[instruction[1]] = 1;
        if (op == kOpTypeVector) of_[instruction[1]] = instruction[3];
        if (op == kOpTypePointer) of_[instruction[1]] = of_[instruction[3]];
    }
    [[nodiscard]] std::uint32_t of(std::uint32_t type) { return of_[type]; }

private:
    std::map<std::uint32_t, std::uint32_t> of_;  // by id
};

}  // namespace

std::uint32_t Usage::input_numbers() const {
    std::uint32_t out = 0;
    for (const auto& [location, numbers] : inputs) out += numbers;
    return out;
}

Usage usage(std::span<const std::uint32_t> words) {
    std::map<std::uint32_t, Decorations> decorations;
    Sizes sizes;
    Usage out;
    for (std::size_t i = kHeader; i < words.size(); i += std::max<std::uint32_t>(1, words[i] >> 16u)) {
        const std::uint32_t op = words[i] & 0xFFFFu, count = words[i] >> 16u;
        if (op == kOpDecorate && count == 4) {
            Decorations& at = decorations[words[i + 1]];
            if (words[i + 2] == kLocation) at.location = words[i + 3];
            if (words[i + 2] == kBinding) at.binding = words[i + 3];
            if (words[i + 2] == kDescriptorSet) at.set = words[i + 3];
        }
        sizes.declare(words.subspan(i));
        if (reads_texels(op)) ++out.texture_reads;
        if (op != kOpVariable) continue;
        const Decorations& at = decorations[words[i + 2]];
        const std::uint32_t storage = words[i + 3];
        if (storage == kInput && at.location) out.inputs.emplace(*at.location, sizes.of(words[i + 1]));
        const bool resource = storage == kUniformConstant || storage == kUniform;
        if (resource && at.set && at.binding) out.bindings.emplace(*at.set, *at.binding);
    }
    return out;
}

}  // namespace sg::target
