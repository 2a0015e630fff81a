#include "target/targets.hpp"

#include <algorithm>

namespace sg::target {
namespace {

// The screen's y points up in GL: towards the other neighbour. A macro is not expanded within itself.
#define SG_DOWNWARD(NAME) "#define " NAME "(P) (-" NAME "(P))\n"
#define SG_DOWNWARD_DERIVATIVES SG_DOWNWARD("dFdy") SG_DOWNWARD("dFdyFine") SG_DOWNWARD("dFdyCoarse")

// ESSL has no fine and no coarse derivatives: its dFdx may be either, as the driver likes.
#define SG_PLAIN_DERIVATIVES                                                    \
    "#define dFdxFine dFdx\n#define dFdyFine dFdy\n#define fwidthFine fwidth\n" \
    "#define dFdxCoarse dFdx\n#define dFdyCoarse dFdy\n#define fwidthCoarse fwidth\n" SG_DOWNWARD("dFdy")

// A gather of red is four reads of level 0 at the centres of the texels around P, lower left
// counter-clockwise.
#define SG_GATHER_AS_READS                                                                              \
    "#define SG_GATHER_READ(S, P, X, Y) textureLod(S, (floor((P) * vec2(textureSize(S, 0)) - 0.5) + "   \
    "vec2(X, Y)) "                                                                                      \
    "/ vec2(textureSize(S, 0)), 0.0).x\n"                                                               \
    "#define textureGather(S, P) vec4(SG_GATHER_READ(S, P, 0.5, 1.5), SG_GATHER_READ(S, P, 1.5, 1.5), " \
    "SG_GATHER_READ(S, P, 1.5, 0.5), SG_GATHER_READ(S, P, 0.5, 0.5))\n"

constexpr Target kTargets[] = {
    {"spirv", "spirv", "spv", Language::spirv, 0, "", "SPIR-V 1.3 for Vulkan 1.1"},
    {"hlsl50", "hlsl", "hlsl", Language::hlsl, 50, "", "HLSL, shader model 5.0 (Direct3D 11)"},
    {"hlsl60", "hlsl", "hlsl", Language::hlsl, 60, "", "HLSL, shader model 6.0 (Direct3D 12)"},
    {"msl21", "msl", "metal", Language::msl, 20100, "", "Metal 2.1"},
    {"msl23", "msl", "metal", Language::msl, 20300, "", "Metal 2.3"},
    {"glsl450", "glsl", "glsl", Language::glsl, 450, SG_DOWNWARD_DERIVATIVES, "GLSL 4.50 for OpenGL"},
    {"essl300", "essl", "glsl", Language::essl, 300, SG_PLAIN_DERIVATIVES SG_GATHER_AS_READS,
     "ESSL 3.00 (OpenGL ES 3.0, WebGL 2)"},
    {"essl310", "essl", "glsl", Language::essl, 310, SG_PLAIN_DERIVATIVES, "ESSL 3.10 (OpenGL ES 3.1)"},
};

}  // namespace

std::span<const Target> all_targets() {
    return kTargets;
}

const Target* find_target(std::string_view name) {
    auto it = std::find_if(std::begin(kTargets), std::end(kTargets),
                           [&](const Target& t) { return t.name == name; });
    return it == std::end(kTargets) ? nullptr : it;
}

std::vector<std::string> target_words() {
    std::vector<std::string> out;
    for (const Target& target : kTargets) {
        for (std::string_view word : {target.name, target.group}) {
            if (std::find(out.begin(), out.end(), word) == out.end()) out.emplace_back(word);
        }
    }
    return out;
}

std::vector<const Target*> select_targets(std::span<const std::string> words) {
    std::vector<const Target*> out;
    for (const Target& target : kTargets) {
        bool wanted = std::any_of(words.begin(), words.end(), [&](const std::string& word) {
            return word == target.name || word == target.group;
        });
        if (wanted) out.push_back(&target);
    }
    return out;
}

std::string with_prelude(std::string_view glsl, const Target& target) {
    std::size_t at = 0;
    while (at < glsl.size() && glsl[at] == '#' && !glsl.substr(at).starts_with("#include"))
        at = glsl.find('\n', at) + 1;
    return std::string(glsl.substr(0, at)) + std::string(target.prelude) + std::string(glsl.substr(at));
}

}  // namespace sg::target
