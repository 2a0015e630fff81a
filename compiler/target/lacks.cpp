#include "target/lacks.hpp"

#include <algorithm>
#include <initializer_list>

namespace sg::target {
namespace {

// Numbers of the SPIR-V specification, section 3.52, and of GLSL.std.450.
constexpr std::uint32_t kOpExtInst = 12, kOpTypeFloat = 22, kOpConstant = 43;
constexpr std::uint32_t kGather = 96, kDrefGather = 97, kQueryLod = 105, kQueryLevels = 106;
constexpr std::uint32_t kOffset = 0x10, kConstOffsets = 0x20;

struct Instruction {
    std::span<const std::uint32_t> words;  // of the module
    std::size_t at = 0;
    [[nodiscard]] std::uint32_t op() const { return words[at] & 0xFFFFu; }
    [[nodiscard]] std::uint32_t length() const { return words[at] >> 16u; }
    [[nodiscard]] std::uint32_t operand(std::size_t i) const { return i < length() ? words[at + i] : 0; }
};

// The number of an OpConstant; 0 for anything else.
std::uint32_t constant(std::span<const std::uint32_t> words, std::uint32_t id) {
    for (std::size_t i = 5; i + 3 < words.size(); i += std::max<std::uint32_t>(1, words[i] >> 16u)) {
        if ((words[i] & 0xFFFFu) == kOpConstant && words[i + 2] == id) return words[i + 3];
    }
    return 0;
}

// The image operands of a gather: their mask stands sixth.
bool gathers_with(const Instruction& i, std::uint32_t mask) {
    return (i.op() == kGather || i.op() == kDrefGather) && (i.operand(6) & mask) != 0;
}
// ESSL 3.00 has no gather; the prelude stands for that of red without offsets.
bool gathers_other(const Instruction& i) {
    if (i.op() == kDrefGather) return true;
    return i.op() == kGather && (i.length() > 6 || constant(i.words, i.operand(5)) != 0);
}
bool gathers_with_four_offsets(const Instruction& i) {
    return gathers_with(i, kConstOffsets);
}
bool gathers_with_computed_offset(const Instruction& i) {
    return gathers_with(i, kOffset);
}
bool compares_gathered(const Instruction& i) {
    return i.op() == kDrefGather;
}
bool asks_level(const Instruction& i) {
    return i.op() == kQueryLod;
}
bool asks_levels(const Instruction& i) {
    return i.op() == kQueryLevels;
}
bool is_double(const Instruction& i) {
    return i.op() == kOpTypeFloat && i.operand(2) == 64;
}
bool carries(const Instruction& i) {
    return i.op() == 149 || i.op() == 150;  // OpIAddCarry, OpISubBorrow
}
bool multiplies_long(const Instruction& i) {
    return i.op() == 151 || i.op() == 152;  // OpUMulExtended, OpSMulExtended
}
bool works_on_bits(const Instruction& i) {
    return i.op() >= 201 && i.op() <= 205;  // OpBitFieldInsert to OpBitCount
}
bool is_extended(const Instruction& i, std::initializer_list<std::uint32_t> numbers) {
    return i.op() == kOpExtInst && std::find(numbers.begin(), numbers.end(), i.operand(4)) != numbers.end();
}
bool packs_bytes(const Instruction& i) {
    return is_extended(i, {54, 55, 63, 64});  // PackSnorm4x8, PackUnorm4x8 and back
}
bool splits_exponents(const Instruction& i) {
    return is_extended(i, {51, 52, 53});  // Frexp, FrexpStruct, Ldexp
}
bool is_area_function(const Instruction& i) {
    return is_extended(i, {22, 23, 24});  // Asinh, Acosh, Atanh
}

struct Lack {
    Language language;
    std::uint32_t before;  // the first version that has it; kNever
    bool (*is)(const Instruction&);
    const char* what;
};
constexpr std::uint32_t kNever = ~0u;

constexpr Lack kLacks[] = {
    {Language::essl, kNever, asks_level, "asks for the level of detail of a texture (textureQueryLod)"},
    {Language::essl, kNever, asks_levels, "asks for the number of levels of a texture (textureQueryLevels)"},
    {Language::essl, 310, gathers_other,
     "gathers texels of another channel than red, with offsets or with a comparison (textureGather)"},
    {Language::essl, 320, gathers_with_four_offsets,
     "gathers texels with four offsets (textureGatherOffsets)"},
    {Language::essl, 320, gathers_with_computed_offset,
     "gathers texels with a computed offset (textureGatherOffset)"},
    {Language::essl, 310, carries, "adds or subtracts with a carry (uaddCarry, usubBorrow)"},
    {Language::essl, 310, multiplies_long, "multiplies to 64 bits (umulExtended, imulExtended)"},
    {Language::essl, 310, works_on_bits, "works on single bits (bitfieldExtract and its kin)"},
    {Language::essl, 310, packs_bytes, "packs four numbers into one (packUnorm4x8 and its kin)"},
    {Language::essl, 310, splits_exponents, "takes numbers apart (frexp, ldexp)"},
    {Language::essl, kNever, is_double, "computes in double precision"},
    {Language::msl, kNever, is_double, "computes in double precision"},
    {Language::msl, 20200, asks_level, "asks for the level of detail of a texture (textureQueryLod)"},
    {Language::msl, kNever, gathers_with_four_offsets,
     "gathers texels with four offsets (textureGatherOffsets)"},
    {Language::hlsl, kNever, gathers_with_four_offsets,
     "gathers texels with four offsets (textureGatherOffsets)"},
    {Language::hlsl, kNever, compares_gathered, "gathers and compares texels (textureGather of a shadow)"},
    {Language::hlsl, kNever, carries, "adds or subtracts with a carry (uaddCarry, usubBorrow)"},
    {Language::hlsl, kNever, is_area_function, "asks for an area hyperbolic function (asinh, acosh, atanh)"},
};

}  // namespace

std::string missing_feature(std::span<const std::uint32_t> words, const Target& target) {
    for (std::size_t i = 5; i < words.size(); i += std::max<std::uint32_t>(1, words[i] >> 16u)) {
        for (const Lack& lack : kLacks) {
            bool lacks = lack.language == target.language && target.version < lack.before;
            if (lacks && lack.is({words, i})) return lack.what;
        }
    }
    return "";
}

}  // namespace sg::target
