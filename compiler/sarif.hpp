// Messages as SARIF 2.1.0, which code hosts and editors read (OASIS, "Static Analysis Results Interchange
// Format", 2020).
#pragma once

#include <string>

#include "base/diag.hpp"

namespace sg {

// One log with one run: the codes that occur as rules, each message as a result with its place as line and
// column (code points, from 1), as bytes and as JSON pointer, and its notes as related locations.
std::string sarif(const Diags& diags);

}  // namespace sg
