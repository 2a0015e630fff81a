#include "cross_entry.hpp"

#include <fmt/core.h>

#include "shader_source.hpp"
#include "target/lacks.hpp"

namespace sg {
std::optional<std::vector<CrossFile>> cross_entry(const emit::Shaders& shaders, const std::string& name,
                                                  std::span<const target::Target* const> targets,
                                                  const emit::MaterialInterface& interface,
                                                  const target::ShaderLibrary& library, Diags& diags) {
    ShaderSource vertex(shaders.vertex, name + ".vert", target::Stage::vertex, library);
    ShaderSource fragment(shaders.fragment, name + ".frag", target::Stage::fragment, library);
    std::vector<CrossFile> out;
    const std::size_t before = diags.error_count();
    for (ShaderSource* source : {&vertex, &fragment}) {
        for (const target::Target* target : targets) {
            if (target->language == target::Language::spirv) continue;
            std::string missing = target::missing_feature(source->plain_words(), *target);
            if (missing.empty()) {
                const target::Words& words = source->words(*target);
                std::string fault;
                auto text = target::cross_compile(words, source->stage(), *target, interface, fault);
                if (text) {
                    out.push_back({source->stage(), target, std::move(*text)});
                    continue;
                }
                cannot_write(name, *target, shaders.has_user_glsl, fault, diags);
            } else {
                diags.error(Code::target_lacks,
                            fmt::format("'{}' {}, which {} cannot express", name, missing, target->name));
            }
        }
    }
    if (diags.error_count() != before) return std::nullopt;
    return out;
}

}  // namespace sg
