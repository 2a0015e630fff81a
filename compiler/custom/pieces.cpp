#include "custom/pieces.hpp"

namespace sg::custom {

Span span_of(const std::vector<Token>& tokens, const Piece& piece) {
    return {tokens[piece.begin].span.begin, tokens[piece.end - 1].span.end};
}

Piece open_condition(const std::vector<Token>& tokens) {
    std::vector<Piece> open;
    for (std::size_t i = 0; i < tokens.size();) {
        std::size_t end = i + 1;
        while (tokens[i].directive != 0 && end < tokens.size() &&
               tokens[end].directive == tokens[i].directive)
            ++end;
        std::string_view word = tokens[i].directive != 0 && end > i + 1 ? tokens[i + 1].text : "";
        if (word == "if" || word == "ifdef" || word == "ifndef") open.push_back({i, end});
        if (word == "endif" && !open.empty()) open.pop_back();
        i = end;
    }
    return open.empty() ? Piece{} : open.back();
}

}  // namespace sg::custom
