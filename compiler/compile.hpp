// The whole pipeline on one screen: JSON text in, an artefact's files out, every intermediate text on
// request.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diag.hpp"
#include "base/files.hpp"
#include "layers/lower_context.hpp"
#include "material/material.hpp"
#include "target/shader_library.hpp"
#include "target/spirv.hpp"
#include "target/targets.hpp"

namespace sg {

struct CompileRequest {
    SourcePtr source;                          // the material's text; its name stands in messages
    std::string stem;                          // of every file's name, and the material's name if it has none
    std::vector<std::filesystem::path> roots;  // where textures may be: the material's folder, then -I roots
    std::vector<std::string> entries;          // names of entry points; empty: all
    std::vector<const target::Target*> targets{target::find_target("spirv")};
    target::SpirvOptions spirv;
    bool optimise_ir = true;
    layers::Numbers numbers = layers::Numbers::baked;
    std::vector<std::pair<std::string, std::string>> defines;  // macros of the user's GLSL: name and value
    material::Budget budget;   // beside the material's own; its places count for nothing
    std::string skipped_rule;  // of the optimiser; for measurements
};

struct NamedText {
    std::string name;  // "forward.frag"
    std::string text;
};

struct Compiled {
    std::string ir;            // as lowered
    std::string reference_ir;  // with custom layers replaced by their equivalents; "" where one has none
    std::string optimised_ir;
    std::vector<NamedText> glsl;                             // by entry point and stage
    std::vector<NamedText> spirv_assembly;                   // of what is shipped
    std::vector<std::pair<std::string, std::string>> files;  // the artefact: name and bytes, manifest last
};

// Reads and checks alone: true without errors.
bool check_material(const CompileRequest& request, Files& files, const target::ShaderLibrary& library,
                    Diags& diags);

// Empty exactly when it added an error. A failure behind the check is our own bug and ends the process
// with 3.
std::optional<Compiled> compile_material(const CompileRequest& request, Files& files,
                                         const target::ShaderLibrary& library, Diags& diags);

}  // namespace sg
