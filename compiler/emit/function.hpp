// The entry point `function`: a material as one function that an engine calls from a shader of its own. It
// reads no stage inputs, blocks or built-ins and takes no screen derivatives: all comes through its
// arguments.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emit/interface.hpp"
#include "ir/ir.hpp"

namespace sg::emit {

inline constexpr std::string_view kFunctionEntry = "function";
// The outputs of a module that the function returns.
std::span<const ir::Output> function_outputs();

// How the function writes an operation that the entry points with stages take from the stage.
struct FunctionWording {
    ir::Op op;
    std::string_view glsl, include;  // as in ops.def
};
std::span<const FunctionWording> function_wordings();

// A field of SgMaterialInputs or SgMaterialResult. Both are alike for all materials.
struct FunctionField {
    std::string name;
    std::string_view type;  // GLSL
    std::string meaning;    // with space and unit
};
std::span<const FunctionField> function_inputs();
std::span<const FunctionField> function_results();

// A texture or a sampler that the function takes, in the order of the arguments.
struct FunctionResource {
    BindingKind kind{};
    std::string argument;
    std::uint32_t binding = 0;          // that the manifest knows it by, in set 1
    std::uint32_t sampler_binding = 0;  // of a texture
};

struct MaterialFunction {
    bool has_user_glsl = false;
    std::string name;                 // "sg_material_brick"
    std::string suffix;               // "_brick": of everything that belongs to this material alone
    std::string parameters_type;      // "SgMaterialParameters_brick"; "" without parameters
    std::vector<std::string> inputs;  // names of the fields that it reads
    std::vector<FunctionResource> resources;
    std::string comment;  // what the function is and reads, as lines of `//`: right for every language
    std::string text;     // GLSL, with includes, without #version
    std::string
        caller;  // GLSL: a fragment shader's declarations and main() that call it, to compile it alone
};

// `module` holds the function's outputs alone and is verified.
MaterialFunction emit_function(const ir::Module& module, const MaterialInterface& material,
                               std::string_view stem);

}  // namespace sg::emit
