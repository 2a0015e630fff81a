// A text with a name, and places in it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace sg {

// Half-open range of bytes [begin, end) of a Source's text.
struct Span {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool operator==(const Span&) const = default;
};

struct Source {
    std::string name;  // as the user wrote it; printed in front of each message
    std::string text;  // bytes, expected to be UTF-8
};
using SourcePtr = std::shared_ptr<const Source>;

// Line and column, both from 1. A column counts code points of UTF-8, not bytes; a tab is one column.
struct LineColumn {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};
LineColumn line_column(std::string_view text, std::uint32_t offset);

// A place that a message can point at. An empty source means "no place" (a missing device, say).
struct Place {
    SourcePtr source;
    Span span;
    std::string pointer;  // JSON pointer (RFC 6901) of the value, "" for the root or for text that is no JSON
};

}  // namespace sg
