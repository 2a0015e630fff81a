// GLSL text to tokens: comments go, places stay. Stricter than GLSL where compilers differ about what a line
// or a comment is, so that they cannot see other tokens than we do.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/source.hpp"

namespace sg::custom {

struct Fault {
    Span span;
    std::string message;
};

enum class TokenKind { identifier, number, punctuation, string };
struct Token {
    TokenKind kind{};
    Span span;
    std::string_view text;
    std::uint32_t directive = 0;  // 0: in no directive; else its number, from 1
};

struct Tokens {
    std::vector<Token> list;
    std::vector<Fault> faults;
};

// `text` must outlive the tokens.
Tokens tokenise(std::string_view text);

}  // namespace sg::custom
