// What is written where: the manifest and the shader files of one material. The fields are documented in
// compiler/artefacts.md; this is the only file that knows their spelling on the compiler's side.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emit/glsl.hpp"
#include "function_entry.hpp"
#include "material/checked.hpp"
#include "target/cross.hpp"
#include "target/spirv.hpp"

namespace sg {

// A shader in one of the other languages.
struct CrossFile {
    target::Stage stage{};
    const target::Target* target = nullptr;
    target::CrossText cross;
};

struct CompiledEntry {
    const emit::EntryPoint* entry = nullptr;
    emit::Shaders shaders;
    target::Words vertex;
    target::Words fragment;
    std::vector<CrossFile> texts;  // vertex first, in the order of the targets
};

struct ArtefactInput {
    std::string stem;         // of every file's name
    std::string source_file;  // name without folders
    std::string source_hash;
    const material::CheckedMaterial* material = nullptr;
    const ir::Module* module = nullptr;  // as emitted
    const emit::MaterialInterface* interface = nullptr;
    const std::vector<material::SamplerDecl>* samplers = nullptr;  // by group
    const std::vector<CompiledEntry>* entries = nullptr;
    const CompiledFunction* function = nullptr;  // may be absent
    bool ships_spirv = true;
};

// File name and bytes of everything, the manifest last. Same input, same bytes.
std::vector<std::pair<std::string, std::string>> artefact_files(const ArtefactInput& input);

// "surfgrad 0.1.0"
std::string_view generator_name();

}  // namespace sg
