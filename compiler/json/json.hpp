// JSON text to values that each know their place in it. Strict RFC 8259: no comments, no trailing commas.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diag.hpp"
#include "base/source.hpp"

namespace sg::json {

enum class Kind { null, boolean, number, string, array, object };
std::string_view kind_name(Kind kind);  // with its article: "a number", "an object"

struct Member;

struct Value {
    Kind kind = Kind::null;
    Span span;  // from the first to past the last byte, brackets and quotes included
    bool boolean = false;
    double number = 0;            // always finite
    std::string string;           // escapes resolved, valid UTF-8
    std::vector<Value> items;     // of an array
    std::vector<Member> members;  // of an object, in the order of the text

    [[nodiscard]] const Value* find(std::string_view key) const;
};

struct Member {
    std::string key;
    Span key_span;
    Value value;
};

struct Document {
    SourcePtr source;
    Value root;
};

inline constexpr std::size_t kMaxDepth = 128;         // nested arrays and objects
inline constexpr std::size_t kMaxBytes = 64u << 20u;  // of the text

// Errors: json_syntax, json_encoding, json_limit, json_duplicate_key (the last for every key, all at once).
std::optional<Document> parse(SourcePtr source, Diags& diags);

// One step of a JSON pointer (RFC 6901): "/" and the key with ~ and / escaped.
std::string pointer_step(std::string_view key);

}  // namespace sg::json
