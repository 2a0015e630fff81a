// Steps of the pipeline that more than one command takes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "compile.hpp"
#include "emit/glsl.hpp"
#include "material/checked.hpp"
#include "target/spirv.hpp"

namespace sg {

// JSON text to a material without faults. Empty exactly when it added an error.
std::optional<material::CheckedMaterial> read_and_check(const SourcePtr& source, const material::Roots& roots,
                                                        Files& files, Diags& diags);

// The same, and the user's GLSL verified and made safe to be put into a shader.
std::optional<material::CheckedMaterial> read_and_verify(const CompileRequest& request, Files& files,
                                                         const target::ShaderLibrary& library, Diags& diags);

// Textures that sample alike share a sampler: the settings by group, and the group of each texture.
struct SamplerGroups {
    std::vector<material::SamplerDecl> settings;
    std::vector<std::uint32_t> group;
};
SamplerGroups group_samplers(const material::CheckedMaterial& material);

// A text of our own: a fault in it is our bug and ends the process.
target::Words to_spirv(const std::string& text, const std::string& name, target::Stage stage,
                       const target::ShaderLibrary& library, const target::SpirvOptions& options);

// What the forward entry point's fragment shader costs, by material::Cost: all of the SPIR-V as shipped.
using ForwardCost = std::array<std::uint32_t, material::kCostNames.size()>;
ForwardCost forward_cost(const target::Words& fragment);
// The same for a module with all its outputs.
ForwardCost forward_cost(const ir::Module& module, const emit::MaterialInterface& interface,
                         const std::string& stem, const target::ShaderLibrary& library,
                         const target::SpirvOptions& options);

// An error for each limit that is exceeded, at the limit's place; one without a place was given on the
// command line.
void hold_to_budget(const ForwardCost& cost, const material::Budget& budget, const SourcePtr& source,
                    Diags& diags);

}  // namespace sg
