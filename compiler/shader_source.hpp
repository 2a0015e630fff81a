// GLSL on its way to other languages.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "base/diag.hpp"
#include "target/spirv.hpp"
#include "target/targets.hpp"

namespace sg {

// One shader as SPIR-V with names and whole functions, once per prelude that a target puts in front.
class ShaderSource {
public:
    // `text` and `library` must outlive it.
    ShaderSource(const std::string& text, std::string name, target::Stage stage,
                 const target::ShaderLibrary& library)
        : text_(text), name_(std::move(name)), stage_(stage), library_(library) {}

    // A fault in the text is our bug and ends the process.
    const target::Words& words(const target::Target& target);
    const target::Words& plain_words() { return words({}); }
    [[nodiscard]] target::Stage stage() const { return stage_; }

private:
    const std::string& text_;
    std::string name_;
    target::Stage stage_;
    const target::ShaderLibrary& library_;
    std::map<std::string_view, target::Words> compiled_;
};

// What the cross-compiler cannot do and missing_feature does not know: the user's GLSL may say it, ours not.
void cannot_write(const std::string& name, const target::Target& target, bool has_user_glsl,
                  const std::string& fault, Diags& diags);

}  // namespace sg
