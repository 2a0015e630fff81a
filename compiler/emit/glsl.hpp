// From a module to GLSL 4.50 for Vulkan that reads as if written by hand: includes, declarations, main; a
// comment and a named local per layer; nothing that is used once gets a name unless the line would grow too
// long.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "emit/interface.hpp"
#include "ir/ir.hpp"

namespace sg::emit {

// One float4 that the fragment stage writes.
struct Attachment {
    std::string_view name;
    std::string_view format;  // that holds it; "" where the view decides
    std::string_view meaning;
};

// An entry point: one row per row of this table (glsl.cpp).
struct EntryPoint {
    std::string_view name;
    std::string_view doc;
    std::vector<Attachment> attachments;     // by location
    std::vector<ir::Output> outputs;         // of the module
    std::vector<std::string_view> includes;  // that the entry's own lines need
    bool lit = false;                        // by the module's lighting model
    bool reads_frame_block = false;          // in the fragment stage
    bool shows_opacity = false;              // else it is there for the alpha test alone
};
// Those of its outputs that the entry point needs of this module.
std::vector<ir::Output> needed_outputs(const EntryPoint& entry, const ir::Module& module);
std::span<const EntryPoint> all_entry_points();
const EntryPoint* find_entry_point(std::string_view name);

struct Shaders {
    std::string vertex;
    std::string fragment;
    EntryInterface interface;
    bool has_user_glsl = false;
};

// The vertex shader that hands over these varyings.
std::string emit_vertex(const ir::Module& module, const EntryPoint& entry,
                        const std::vector<Varying>& varyings);

// `module` holds the outputs of the entry point alone (opt::select_outputs) and is verified.
Shaders emit_glsl(const ir::Module& module, const EntryPoint& entry, const MaterialInterface& material);

}  // namespace sg::emit
