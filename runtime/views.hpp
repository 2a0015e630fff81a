// The views of a material that can be drawn, by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diag.hpp"
#include "runtime/artefact.hpp"

namespace sg::runtime {

// `entry` is the entry point that draws the view; `view.number` goes into its frame block.
struct View {
    std::string entry;
    DebugView view;
};

// "lit" (entry forward), "normal" (entry normal), "gbuffer:NAME" for each of that entry's outputs, "depth"
// (what the depth buffer holds, 0 near to 1 far), then the debug views in the manifest's order, without those
// whose name is taken.
std::vector<View> all_views(const Artefact& artefact);
// The debug views alone, all of them.
std::vector<View> debug_views(const Artefact& artefact);

// Fails with unknown_view, which lists what there is.
std::optional<View> find_view(const Artefact& artefact, std::string_view name, Diags& diags);

}  // namespace sg::runtime
