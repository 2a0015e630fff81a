// Parts of a user's file, for messages to point at.
#pragma once

#include <vector>

#include "custom/user_glsl.hpp"

namespace sg::custom {

// Tokens [begin, end).
struct Piece {
    std::size_t begin = 0, end = 0;
};

// From the first of these tokens to the last.
Span span_of(const std::vector<Token>& tokens, const Piece& piece);

// The condition that the file does not end (#if without #endif), as a whole; nothing if all are ended.
Piece open_condition(const std::vector<Token>& tokens);

}  // namespace sg::custom
