#include "json/json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

namespace sg::json {
namespace {

// nlohmann's lexer decides what is valid; this cursor walks the same text beside its events and gives each
// its span.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    }

    // The span of the next token, which the caller knows to be valid.
    Span next() {
        while (at_ < text_.size() && std::string_view(" \t\r\n,:").find(text_[at_]) != std::string_view::npos)
            ++at_;
        std::size_t begin = at_;
        if (begin < text_.size()) at_ = end_of_token(begin);
        return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
    }

private:
    [[nodiscard]] std::size_t end_of_token(std::size_t begin) const {
        char c = text_[begin];
        std::size_t end = begin + 1;
        if (c == '"') {
            while (end < text_.size() && text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
            return std::min(end + 1, text_.size());
        }
        if (std::string_view("[]{}").find(c) != std::string_view::npos) return end;
        while (end < text_.size() &&
               std::string_view(" \t\r\n,:[]{}\"").find(text_[end]) == std::string_view::npos)
            ++end;
        return end;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

std::string without_prefix(std::string_view what) {
    // "[json.exception.parse_error.101] parse error at line 2, column 5: syntax error while ... - unexpected
    // ..."
    std::size_t at = what.find("syntax error");
    if (at == what.npos) at = what.find("number overflow");
    if (at == what.npos) at = what.find("] ") + 2;
    std::string text(what.substr(at));
    if (std::size_t last = text.find("; last read: "); last != text.npos) {
        std::size_t expected = text.find("; expected", last);
        text.erase(last, expected == text.npos ? text.npos : expected - last);
    }
    return text;
}

class Handler {
public:
    using json = nlohmann::json;
    Handler(const SourcePtr& source, Diags& diags) : source_(source), diags_(diags), cursor_(source->text) {}

    bool null() { return scalar(Value{.kind = Kind::null}); }
    bool boolean(bool value) { return scalar(Value{.kind = Kind::boolean, .boolean = value}); }
    bool number_integer(json::number_integer_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(json::number_unsigned_t value) { return number(static_cast<double>(value)); }
    bool number_float(json::number_float_t value, const std::string&) { return number(value); }
    bool string(std::string& value) {
        return scalar(Value{.kind = Kind::string, .string = std::move(value)});
    }
    bool binary(json::binary_t&) { return false; }  // JSON text has none

    bool start_object(std::size_t) { return open(Kind::object); }
    bool end_object() { return close(); }
    bool start_array(std::size_t) { return open(Kind::array); }
    bool end_array() { return close(); }

    bool key(std::string& name) {
        pending_key_ = std::move(name);
        pending_key_span_ = cursor_.next();
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
        std::string what = without_prefix(error.what());
        bool encoding = what.find("UTF-8") != what.npos;
        diags_.error(encoding ? Code::json_encoding : Code::json_syntax,
                     {source_, offending(position, encoding), ""}, printable_long(what));
        return false;
    }

    Value root;

private:
    // The token that the parser stopped in, `position` bytes into the text; one byte where that is at fault
    // itself.
    [[nodiscard]] Span offending(std::size_t position, bool one_byte) const {
        std::string_view text = source_->text;
        if (position > text.size() || text.empty()) {
            auto end = static_cast<std::uint32_t>(text.size());
            return {end, end};
        }
        std::size_t begin = position > 0 ? position - 1 : 0;
        std::size_t end = begin + 1;
        auto in_word = [&](std::size_t i) {
            return std::string_view("{}[],: \t\r\n").find(text[i]) == std::string_view::npos;
        };
        if (!one_byte && in_word(begin)) {
            while (begin > 0 && in_word(begin - 1)) --begin;
            while (end < text.size() && in_word(end)) ++end;
        }
        return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    }

    static std::string printable_long(std::string_view text) {
        std::string out;
        while (!text.empty()) {  // `printable` cuts, so feed it pieces
            out += printable(text.substr(0, 50));
            text.remove_prefix(std::min<std::size_t>(50, text.size()));
        }
        return out;
    }

    bool number(double value) { return scalar(Value{.kind = Kind::number, .number = value}); }

    bool scalar(Value value) {
        value.span = cursor_.next();
        place(std::move(value));
        return true;
    }

    Value* place(Value value) {
        if (stack_.empty()) {
            root = std::move(value);
            return &root;
        }
        Value& parent = *stack_.back();
        if (parent.kind == Kind::array) {
            parent.items.push_back(std::move(value));
            return &parent.items.back();
        }
        parent.members.push_back({std::move(pending_key_), pending_key_span_, std::move(value)});
        return &parent.members.back().value;
    }

    bool open(Kind kind) {
        Value value{.kind = kind};
        value.span = cursor_.next();
        if (stack_.size() >= kMaxDepth) {
            diags_.error(Code::json_limit, {source_, value.span, ""},
                         fmt::format("nested deeper than {} levels", kMaxDepth));
            return false;
        }
        stack_.push_back(place(std::move(value)));
        return true;
    }

    bool close() {
        stack_.back()->span.end = cursor_.next().end;
        if (stack_.back()->kind == Kind::object) report_duplicates(*stack_.back());
        stack_.pop_back();
        return true;
    }

    void report_duplicates(const Value& object) {
        std::unordered_map<std::string_view, Span> seen;
        for (const Member& member : object.members) {
            auto [first, fresh] = seen.try_emplace(member.key, member.key_span);
            if (fresh) continue;
            diags_.error(Code::json_duplicate_key, {source_, member.key_span, ""},
                         fmt::format("key '{}' appears twice in one object", printable(member.key)),
                         {{"the first is here", {source_, first->second, ""}}});
        }
    }

    const SourcePtr& source_;
    Diags& diags_;
    Cursor cursor_;
    std::vector<Value*> stack_;
    std::string pending_key_;
    Span pending_key_span_;
};

}  // namespace

std::string_view kind_name(Kind kind) {
    constexpr std::string_view kNames[] = {"null",     "a boolean", "a number",
                                           "a string", "an array",  "an object"};
    return kNames[static_cast<std::size_t>(kind)];
}

const Value* Value::find(std::string_view key) const {
    for (const Member& member : members) {
        if (member.key == key) return &member.value;
    }
    return nullptr;
}

std::optional<Document> parse(SourcePtr source, Diags& diags) {
    if (source->text.size() > kMaxBytes) {
        diags.error(Code::json_limit, {source, {0, 0}, ""},
                    fmt::format("the file is larger than {} MiB", kMaxBytes >> 20u));
        return std::nullopt;
    }
    std::size_t nul = source->text.find('\0');  // the parser would take it for the end of the text
    if (nul != std::string::npos) {
        auto at = static_cast<std::uint32_t>(nul);
        diags.error(Code::json_syntax, {source, {at, at + 1}, ""}, "the text holds a NUL byte");
        return std::nullopt;
    }
    std::size_t before = diags.error_count();
    Handler handler(source, diags);
    nlohmann::json::sax_parse(source->text, &handler);
    if (diags.error_count() > before) return std::nullopt;
    return Document{std::move(source), std::move(handler.root)};
}

std::string pointer_step(std::string_view key) {
    std::string out = "/";
    for (char c : key) {
        if (c == '~') {
            out += "~0";
        } else if (c == '/') {
            out += "~1";
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace sg::json
