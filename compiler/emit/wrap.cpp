#include "emit/wrap.hpp"

#include <algorithm>
#include <vector>

namespace sg::emit {
namespace {

constexpr std::size_t kStep = 4;
constexpr std::size_t kLeastRoom = 50;  // for what stands in line behind a parenthesis

// The parts of an expression between separators outside of all parentheses. Each keeps its separator, without
// the blank behind it.
std::vector<std::string_view> split(std::string_view text,
                                    std::initializer_list<std::string_view> separators) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '(' || text[at] == '[') ++depth;
        if (text[at] == ')' || text[at] == ']') --depth;
        if (depth > 0) continue;
        for (std::string_view separator : separators) {
            if (!text.substr(at).starts_with(separator)) continue;
            at += separator.size() - 1;  // a blank
            parts.push_back(text.substr(begin, at - begin));
            begin = at + 1;
            break;
        }
    }
    parts.push_back(text.substr(begin));
    return parts;
}

// `before(inside)behind`
struct Call {
    std::string_view before, inside, behind;
};
// The first call of an expression without operators; `inside` is empty where there is none.
Call call_of(std::string_view text) {
    const std::size_t open = text.find('(');
    if (open == text.npos) return {text, {}, {}};
    int depth = 0;
    std::size_t close = open;
    for (; close < text.size(); ++close) {
        if (text[close] == '(') ++depth;
        if (text[close] == ')' && --depth == 0) break;
    }
    if (close == text.size()) return {text, {}, {}};
    return {text.substr(0, open + 1), text.substr(open + 1, close - open - 1), text.substr(close)};
}

// How many letters of `f(g(h(x, y)))` stand before the first place to break it.
std::size_t head_of(std::string_view text) {
    const Call call = call_of(text);
    const bool one = !call.inside.empty() && split(call.inside, {", ", " + ", " - ", " * "}).size() == 1;
    return call.before.size() + (one ? head_of(call.inside) : 0);
}

bool is_word(std::string_view part) {
    return part.find('(') == part.npos;
}

class Wrapper {
public:
    // A statement with its blanks in front.
    std::string run(std::string_view statement) {
        start_ = column_ = statement.find_first_not_of(' ');
        out_ = std::string(start_, ' ');
        put(statement.substr(start_), 0);
        return std::move(out_);
    }

private:
    // `behind`: letters that follow on the same line.
    static bool fits(std::string_view text, std::size_t column, std::size_t behind) {
        return column + text.size() + behind <= kLineLimit;
    }
    static bool each_fits(const std::vector<std::string_view>& parts, std::size_t column,
                          std::size_t behind) {
        for (const std::string_view& part : parts) {
            if (!fits(part, column, &part == &parts.back() ? behind : 0)) return false;
        }
        return true;
    }
    [[nodiscard]] bool on_fresh_line() const { return column_ == start_; }
    void write(std::string_view text) {
        out_ += text;
        column_ += text.size();
    }
    void new_line(std::size_t column) {
        while (out_.back() == ' ') out_.pop_back();
        out_ += '\n' + std::string(column, ' ');
        start_ = column_ = column;
    }

    void put(std::string_view text, std::size_t behind) {
        if (fits(text, column_, behind)) return write(text);
        const std::vector<std::string_view> sides = split(text, {" = "});
        if (sides.size() == 2) {
            write(sides[0]);
            write(" ");
            return put(sides[1], behind);
        }
        std::vector<std::string_view> parts = split(text, {" + ", " - "});
        const bool product = parts.size() == 1;
        if (product) parts = split(text, {" * "});
        if (parts.size() == 1) return put_call(call_of(text), behind);
        put_operands(parts, product, behind);
    }

    void put_operands(const std::vector<std::string_view>& parts, bool product, std::size_t behind) {
        const std::size_t inward = start_ + kStep;
        if (each_fits(parts, inward, behind)) {
            if (!on_fresh_line() && !fits(parts.front(), column_, 0)) new_line(inward);
            return fill(parts, inward, behind);
        }
        // factor * call(
        if (product) {
            const std::size_t factors = static_cast<std::size_t>(parts.back().data() - parts.front().data());
            if (each_fits({parts.begin(), parts.end() - 1}, inward, 0) &&
                column_ + factors + head_of(parts.back()) <= kLineLimit) {
                write({parts.front().data(), factors});
                return put(parts.back(), behind);
            }
        }
        const std::size_t column = on_fresh_line() ? start_ : inward;
        for (const std::string_view& part : parts) {
            if (column_ != column || !on_fresh_line()) new_line(column);
            put(part, &part == &parts.back() ? behind : 0);
        }
    }

    // As many to a line as go there.
    void fill(const std::vector<std::string_view>& parts, std::size_t column, std::size_t behind) {
        for (const std::string_view& part : parts) {
            const std::size_t follows = &part == &parts.back() ? behind : 0;
            if (&part != &parts.front()) {
                if (fits(part, column_ + 1, follows)) {
                    write(" ");
                } else {
                    new_line(column);
                }
            }
            put(part, follows);
        }
    }

    void put_call(const Call& call, std::size_t behind) {
        const std::size_t inward = start_ + kStep;
        write(call.before);
        if (call.inside.empty()) return write(call.behind);
        const std::vector<std::string_view> arguments = split(call.inside, {", "});
        const std::size_t follows = call.behind.size() + behind;
        if (arguments.size() > 1 && column_ + kLeastRoom <= kLineLimit &&
            each_fits(arguments, column_, follows)) {
            fill(arguments, column_, follows);
        } else if (arguments.size() == 1 && !fits(call.inside, inward, follows)) {
            put(call.inside, follows);  // f(g(h(
        } else {
            new_line(inward);
            if (each_fits(arguments, inward, follows)) {
                fill(arguments, inward, follows);
            } else {
                one_to_a_line(arguments, inward, follows);
            }
        }
        write(call.behind);
    }

    // But words stay together.
    void one_to_a_line(const std::vector<std::string_view>& arguments, std::size_t column,
                       std::size_t behind) {
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const std::size_t follows = i + 1 == arguments.size() ? behind : 0;
            const bool together = i > 0 && is_word(arguments[i]) && is_word(arguments[i - 1]) &&
                                  fits(arguments[i], column_ + 1, follows);
            if (together) {
                write(" ");
            } else if (i > 0) {
                new_line(column);
            }
            put(arguments[i], follows);
        }
    }

    std::string out_;
    std::size_t column_ = 0;  // where the next letter goes
    std::size_t start_ = 0;   // where the line's first letter stands
};

std::string wrapped_line(std::string_view line) {
    if (line.size() <= kLineLimit || line.find_first_not_of(' ') == line.npos) return std::string(line);
    const std::size_t comment = line.find("//");
    if (comment == line.npos) return Wrapper().run(line);
    const std::size_t indent = line.find_first_not_of(' ');
    if (comment == indent) return std::string(line);
    std::string_view statement = line.substr(0, comment);
    while (statement.back() == ' ') statement.remove_suffix(1);
    return std::string(indent, ' ') + std::string(line.substr(comment)) + "\n" + wrapped_line(statement);
}

}  // namespace

std::string wrapped(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        out += wrapped_line(text.substr(0, end));
        if (end < text.size()) out += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

}  // namespace sg::emit
