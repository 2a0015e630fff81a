#include "custom/pieces.hpp"

#include <algorithm>

namespace sg::custom {
namespace {

bool is_operator(const Token& token) {
    constexpr std::string_view kApart = "()[]{},;.";
    return token.kind == TokenKind::punctuation && kApart.find(token.text) == kApart.npos;
}

// The token in front of the bracket that belongs to the closing one at `close`; `close` where there is none.
std::size_t before_bracket(const std::vector<Token>& tokens, std::size_t close) {
    int depth = 0;
    for (std::size_t i = close + 1; i-- > 1;) {
        if (tokens[i].text == ")") ++depth;
        if (tokens[i].text == "(") --depth;
        if (depth == 0) return i - 1;
    }
    return close;
}

}  // namespace

Piece tokens_of_line(std::string_view text, const std::vector<Token>& tokens, std::size_t line) {
    std::size_t begin = 0, number = 1;
    for (; number < line && begin < text.size(); ++begin) {
        bool ends = text[begin] == '\n' || (text[begin] == '\r' && text.substr(begin + 1, 1) != "\n");
        if (ends) ++number;
    }
    if (number < line) return {};
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    Piece out;
    while (out.begin < tokens.size() && tokens[out.begin].span.begin < begin) ++out.begin;
    out.end = out.begin;
    while (out.end < tokens.size() && tokens[out.end].span.begin < end) ++out.end;
    return out;
}

std::vector<Piece> pieces(const std::vector<Token>& tokens, const Piece& line) {
    std::vector<Piece> out;
    for (std::size_t i = line.begin; i < line.end; ++i) {
        bool joined = i > line.begin &&
                      (tokens[i].directive != 0 || (is_operator(tokens[i - 1]) && is_operator(tokens[i]) &&
                                                    tokens[i - 1].span.end == tokens[i].span.begin));
        if (joined) {
            out.back().end = i + 1;
        } else {
            out.push_back({i, i + 1});
        }
    }
    return out;
}

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

Span named_at(const std::vector<Token>& tokens, const Piece& piece, std::string_view named) {
    for (std::size_t i = piece.begin; i < piece.end; ++i) {
        if (tokens[i].text == named) return tokens[i].span;
    }
    if (tokens[piece.begin].text == ")") {
        const Token& called = tokens[before_bracket(tokens, piece.begin)];
        if (called.text == named) return called.span;
    }
    for (std::size_t i = piece.end; named == "=" && i < tokens.size() && tokens[i].text != ";"; ++i) {
        if (tokens[i].text == named) return tokens[i].span;
    }
    return span_of(tokens, piece);
}

}  // namespace sg::custom
