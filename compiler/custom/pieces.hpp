// One line of a user's file taken apart. A compiler that tells lines alone tells where on a line something is
// wrong if each piece of it stands on a line of its own.
#pragma once

#include <string_view>
#include <vector>

#include "custom/user_glsl.hpp"

namespace sg::custom {

// Tokens [begin, end), between which no line may be broken.
struct Piece {
    std::size_t begin = 0, end = 0;
};

// The tokens of a line (from 1), none where it has none.
Piece tokens_of_line(std::string_view text, const std::vector<Token>& tokens, std::size_t line);

// The pieces of such a line: operators that touch may be one (+=, <<), a directive cannot be broken.
std::vector<Piece> pieces(const std::vector<Token>& tokens, const Piece& line);

// From the first of these tokens to the last.
Span span_of(const std::vector<Token>& tokens, const Piece& piece);

// The condition that the file does not end (#if without #endif), as a whole; nothing if all are ended.
Piece open_condition(const std::vector<Token>& tokens);

// What glslang names `named` (may be "") at a piece: the token of that name there; of a call, which stands at
// the bracket that closes it, in front of the one that opens; of the '=' of a declaration, which stands at
// the name, behind that; else the piece.
Span named_at(const std::vector<Token>& tokens, const Piece& piece, std::string_view named);

}  // namespace sg::custom
