// The tables of layer and node kinds as documentation.
#pragma once

#include <string>

namespace sg {

// For a terminal: what `surfgradc kinds` prints.
std::string kinds_text();
// The same as a page: materials/kinds.md.
std::string kinds_markdown();

}  // namespace sg
