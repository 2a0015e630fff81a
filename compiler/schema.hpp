// The material language as JSON Schema (draft-07), made from the same tables that the reader uses.
#pragma once

#include <string>

namespace sg {

// What `surfgradc schema` prints: strict on unknown keys, with descriptions, defaults and ranges. What only
// the checker knows (names that must be declared, cycles, files) is not in it.
std::string schema_text();

}  // namespace sg
