#include "cross_entry.hpp"

#include <fmt/core.h>

#include <map>

#include "base/ice.hpp"

namespace sg {
namespace {

// One shader as SPIR-V with names and whole functions, once per prelude that a target puts in front.
class ShaderSource {
public:
    ShaderSource(const std::string& text, std::string name, target::Stage stage,
                 const target::ShaderLibrary& library)
        : text_(text), name_(std::move(name)), stage_(stage), library_(library) {}

    const target::Words& words(const target::Target& target) {
        auto [at, fresh] = compiled_.try_emplace(target.prelude);
        if (fresh) {
            std::string fault, text = target::with_prelude(text_, target);
            auto words = target::compile_glsl(text, name_, stage_, library_,
                                              {.optimise = target::Optimise::none}, fault);
            if (!words)
                SG_UNREACHABLE(fmt::format("GLSL for {} does not compile: {}\n{}", target.name, fault, text));
            at->second = std::move(*words);
        }
        return at->second;
    }
    const target::Words& plain_words() { return words({}); }
    [[nodiscard]] target::Stage stage() const { return stage_; }

private:
    const std::string& text_;
    std::string name_;
    target::Stage stage_;
    const target::ShaderLibrary& library_;
    std::map<std::string_view, target::Words> compiled_;
};

}  // namespace

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
                out.push_back({source->stage(), target,
                               target::cross_compile(words, source->stage(), *target, interface)});
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
