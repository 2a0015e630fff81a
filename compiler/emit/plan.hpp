// Which values of a module get a local variable in the generated text, and in which order these stand.
//
// A value gets one where it is used more than once, where the author of the material knows it by a name (what
// a layer gives, a node with a name), and where it must be computed in front of control flow that would spoil
// it. All others are written where they are used.
//
// First come screen derivatives, the normal of the mesh, and what they stand on; then layer by layer, each in
// one piece; in front of each layer what it needs of values that belong to no layer; behind the last layer
// the rest.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ir/ir.hpp"

namespace sg::emit {

// How an operation is written, and the file of the library that this needs, as in ops.def.
struct Wording {
    std::string_view glsl, include;
};
// The table's own: between the stages of a pipeline.
Wording stage_wording(ir::Op op);

struct Local {
    std::size_t value = 0;  // into Module::values
    ir::LayerId layer;      // whose lines it stands among; invalid: no layer's
};

struct Plan {
    std::vector<Local> locals;  // in the order of the text
    // By value:
    std::vector<bool> layer_result;    // what its layer gives; one for each layer at most
    std::vector<bool> hardware_level;  // a texture read whose level of detail is left to the hardware
};

// Linear in the module. `wording` as for the text.
Plan plan_of(const ir::Module& module, Wording (*wording)(ir::Op));

// A longer expression gets a local in any case: what reads it, a person or a parser, need not go deeper. It
// is counted in letters before names are known. No sample comes near (tests/golden).
inline constexpr std::size_t kLongestExpression = 1000;

}  // namespace sg::emit
