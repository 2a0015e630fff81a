#include "base/source.hpp"

#include <algorithm>

namespace sg {

LineColumn line_column(std::string_view text, std::uint32_t offset) {
    LineColumn at;
    std::size_t end = std::min<std::size_t>(offset, text.size());
    for (std::size_t i = 0; i < end; ++i) {
        auto byte = static_cast<unsigned char>(text[i]);
        if (byte == '\n') {
            ++at.line;
            at.column = 1;
        } else if ((byte & 0xC0u) != 0x80u) {  // a continuation byte of UTF-8 is no column of its own
            ++at.column;
        }
    }
    return at;
}

}  // namespace sg
