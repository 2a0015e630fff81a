// Long statements of generated text over several lines, as a person would break them.
#pragma once

#include <string>
#include <string_view>

namespace sg::emit {

inline constexpr std::size_t kLineLimit = 110;

// Lines of GLSL, each a whole statement or a comment. Those that are longer are broken behind commas and
// operators: what belongs to one call stands in line behind its parenthesis or, where that leaves too little
// room, four blanks farther in. Only a word that is longer than a line stays so. A comment behind a statement
// that fills its line goes in front of it.
std::string wrapped(std::string_view text);

}  // namespace sg::emit
