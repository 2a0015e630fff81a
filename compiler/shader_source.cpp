#include "shader_source.hpp"

#include <fmt/core.h>

#include "base/ice.hpp"

namespace sg {

const target::Words& ShaderSource::words(const target::Target& target) {
    auto [at, fresh] = compiled_.try_emplace(target.prelude);
    if (fresh) {
        std::string fault, text = target::with_prelude(text_, target);
        auto words =
            target::compile_glsl(text, name_, stage_, library_, {.optimise = target::Optimise::none}, fault);
        if (!words)
            SG_UNREACHABLE(fmt::format("GLSL for {} does not compile: {}\n{}", target.name, fault, text));
        at->second = std::move(*words);
    }
    return at->second;
}

}  // namespace sg
