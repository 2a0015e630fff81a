#include "glsl.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <fstream>
#include <map>
#include <sstream>

#include "base/ice.hpp"

namespace sg::proof {
namespace {

class LibraryIncluder : public glslang::TShader::Includer {
public:
    explicit LibraryIncluder(const Mutant* mutant) : mutant_(mutant) {}

    IncludeResult* includeLocal(const char* header, const char*, std::size_t) override {
        std::string name = header;
        auto [place, fresh] = texts_.try_emplace(name);
        if (fresh) place->second = read(name);
        return new IncludeResult(name, place->second.data(), place->second.size(), nullptr);
    }
    void releaseInclude(IncludeResult* result) override { delete result; }

private:
    std::string read(const std::string& name) const {
        if (mutant_ == nullptr || mutant_->file != name) return library_text(name);
        std::optional<std::string> text = mutated_text(*mutant_);
        SG_ASSERT(text);
        return *text;
    }

    const Mutant* mutant_;
    std::map<std::string, std::string> texts_;
};

// Initialised once and never finalised: the built-in declarations take 0.1 s to parse again.
void start_glslang() {
    static const bool started = glslang::InitializeProcess();
    SG_ASSERT(started);
}

}  // namespace

std::string library_text(const std::string& file) {
    std::ifstream stream(std::string(SG_SOURCE_DIR "/shader_lib/") + file, std::ios::binary);
    SG_ASSERT(stream.is_open());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::optional<std::string> mutated_text(const Mutant& mutant) {
    std::string text = library_text(mutant.file);
    std::size_t at = text.find(mutant.find);
    if (at == std::string::npos || text.find(mutant.find, at + 1) != std::string::npos) return std::nullopt;
    return text.replace(at, mutant.find.size(), mutant.replace);
}

Compiled compile_glsl(const std::string& text, Stage stage, const Mutant* mutant) {
    start_glslang();
    std::string whole = "#version 450\n#extension GL_GOOGLE_include_directive : require\n" + text;
    const char* source = whole.c_str();
    EShLanguage language = stage == Stage::compute ? EShLangCompute : EShLangFragment;
    glslang::TShader shader(language);
    shader.setStrings(&source, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    LibraryIncluder includer(mutant);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    if (!shader.parse(GetDefaultResources(), 450, false, messages, includer))
        return {{}, shader.getInfoLog()};
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) return {{}, program.getInfoLog()};
    Compiled out;
    glslang::GlslangToSpv(*program.getIntermediate(language), out.words);
    return out;
}

}  // namespace sg::proof
