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

void cannot_write(const std::string& name, const target::Target& target, bool has_user_glsl,
                  const std::string& fault, Diags& diags) {
    if (!has_user_glsl) SG_UNREACHABLE(fmt::format("{} cannot be written: {}", target.name, fault));
    diags.error(Code::target_lacks,
                fmt::format("'{}' cannot be written as {}: {}", name, target.name, printable(fault)));
}

}  // namespace sg
