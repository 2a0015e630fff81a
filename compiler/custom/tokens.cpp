#include "custom/tokens.hpp"

#include <cctype>

namespace sg::custom {
namespace {

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
bool is_newline(char c) {
    return c == '\n' || c == '\r';
}
bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

class Tokeniser {
public:
    explicit Tokeniser(std::string_view text) : text_(text) {}

    Tokens run() {
        while (at_ < text_.size()) step();
        return std::move(out_);
    }

private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }

    void fault(std::size_t begin, std::size_t end, std::string message) {
        out_.faults.push_back(
            {{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}, std::move(message)});
    }

    void newline() {
        line_is_fresh_ = true;
        in_directive_ = false;
        ++at_;
    }

    void step() {
        char c = peek();
        if (is_newline(c)) return newline();
        if (is_blank(c)) {
            ++at_;
        } else if (c == '\\') {
            backslash();
        } else if (c == '/' && peek(1) == '/') {
            line_comment();
        } else if (c == '/' && peek(1) == '*') {
            block_comment();
        } else if (static_cast<unsigned char>(c) < 0x20u || static_cast<unsigned char>(c) >= 0x7Fu) {
            other_character();
        } else {
            token(c);
        }
    }

    // A line may go on behind a backslash if nothing is glued together by that.
    void backslash() {
        bool apart = at_ > 0 && is_blank(text_[at_ - 1]) && is_newline(peek(1));
        if (!apart)
            fault(at_, at_ + 1, "a backslash, expected one only at the end of a line, behind a blank");
        at_ += apart && peek(1) == '\r' && peek(2) == '\n' ? 3 : apart ? 2 : 1;
    }

    void line_comment() {
        while (at_ < text_.size() && !is_newline(peek())) {
            if (peek() == '\\' && is_newline(peek(1)))
                fault(at_, at_ + 1, "a comment that goes on behind a backslash");
            if (peek() == '\0') fault(at_, at_ + 1, "a zero byte");
            ++at_;
        }
    }

    void block_comment() {
        std::size_t end = text_.find("*/", at_ + 2);
        if (end == text_.npos) {
            fault(at_, at_ + 2, "a comment that does not end");
            at_ = text_.size();
            return;
        }
        std::string_view body = text_.substr(at_, end - at_);
        for (std::size_t i = 0; i < body.size(); ++i) {
            bool splices = body[i] == '\\' && i + 1 < body.size() && is_newline(body[i + 1]);
            if (splices) fault(at_ + i, at_ + i + 1, "a comment that goes on behind a backslash");
            if (body[i] == '\0') fault(at_ + i, at_ + i + 1, "a zero byte");
        }
        if (in_directive_ && body.find_first_of("\n\r") != body.npos)
            fault(at_, at_ + 2, "a comment of several lines in a directive");
        at_ = end + 2;
    }

    void other_character() {
        std::size_t begin = at_++;
        while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) & 0xC0u) == 0x80u) ++at_;
        fault(begin, at_, "a character that GLSL does not have");
    }

    void push(TokenKind kind, std::size_t begin) {
        out_.list.push_back({kind,
                             {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)},
                             text_.substr(begin, at_ - begin),
                             in_directive_ ? directive_ : 0});
    }

    void token(char c) {
        std::size_t begin = at_;
        if (c == '#') {
            if (line_is_fresh_) {
                ++directive_;
                in_directive_ = true;
            } else {
                fault(at_, at_ + 1, "'#' within a line");
            }
        }
        line_is_fresh_ = false;
        if (std::isdigit(static_cast<unsigned char>(c)) ||
            (c == '.' && std::isdigit(static_cast<unsigned char>(peek(1))))) {
            number();
            return push(TokenKind::number, begin);
        }
        if (is_word(c)) {
            while (is_word(peek())) ++at_;
            return push(TokenKind::identifier, begin);
        }
        if (c == '"') {
            ++at_;
            while (at_ < text_.size() && !is_newline(peek()) && peek() != '"') ++at_;
            if (peek() == '"') ++at_;
            return push(TokenKind::string, begin);
        }
        ++at_;
        push(TokenKind::punctuation, begin);
    }

    void number() {
        while (is_word(peek()) || peek() == '.') {
            bool exponent = peek() == 'e' || peek() == 'E';
            ++at_;
            if (exponent && (peek() == '+' || peek() == '-')) ++at_;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    bool line_is_fresh_ = true;
    bool in_directive_ = false;
    std::uint32_t directive_ = 0;
    Tokens out_;
};

}  // namespace

Tokens tokenise(std::string_view text) {
    return Tokeniser(text).run();
}

}  // namespace sg::custom
