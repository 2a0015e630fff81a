#include "base/diag.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "base/ice.hpp"

namespace sg {
namespace {

constexpr auto kCodes = std::to_array<CodeInfo>({
#define SG_DIAG(number, identifier, fault, cause, mend) \
    {Code::identifier, #identifier, Fault::fault, cause, mend},
#include "base/diag_codes.def"
#undef SG_DIAG
});

// Letters that are put in, left out, exchanged for another, or swapped with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> earlier, last(b.size() + 1), row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        earlier = std::exchange(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], earlier[j - 2] + 1);
        }
    }
    return row[b.size()];
}

// The line that holds `offset`, without its line break.
std::string_view line_at(std::string_view text, std::uint32_t offset, std::uint32_t& line_begin) {
    std::size_t at = std::min<std::size_t>(offset, text.size());
    std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1);
    begin = begin == std::string_view::npos ? 0 : (at == 0 ? 0 : begin + 1);
    std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) end = text.size();
    if (end > begin && text[end - 1] == '\r') --end;
    line_begin = static_cast<std::uint32_t>(begin);
    return text.substr(begin, end - begin);
}

std::size_t code_points(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

// How many bytes the character takes that a text starts with; 0: it is none of UTF-8.
std::size_t character_size(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    const std::size_t size = lead < 0x80u   ? 1u
                             : lead < 0xC2u ? 0u
                             : lead < 0xE0u ? 2u
                             : lead < 0xF0u ? 3u
                             : lead < 0xF5u ? 4u
                                            : 0u;
    if (size > text.size()) return 0;
    return code_points(text.substr(0, size)) == 1 ? size : 0;
}

// Control characters become blanks so that columns stay true, bytes that are no UTF-8 question marks.
std::string shown(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        const bool control = size == 1 && (static_cast<unsigned char>(text[0]) < 0x20u || text[0] == 0x7F);
        out += size == 0 ? "?" : control ? " " : std::string(text.substr(0, size));
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return out;
}

// The source line and the carets under it; a long line is cut to a window around the place.
std::string caret_block(const Place& place) {
    std::uint32_t line_begin = 0;
    std::string_view line = line_at(place.source->text, place.span.begin, line_begin);
    std::size_t from = std::min<std::size_t>(place.span.begin - line_begin, line.size());
    std::size_t to =
        std::clamp<std::size_t>(place.span.end - std::min(place.span.end, line_begin), from, line.size());
    constexpr std::size_t kWindow = 120;
    std::size_t cut = from > kWindow / 2 && line.size() > kWindow ? from - kWindow / 2 : 0;
    while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xC0u) == 0x80u) --cut;
    std::size_t shown_end = std::min(line.size(), cut + kWindow);
    while (shown_end < line.size() && (static_cast<unsigned char>(line[shown_end]) & 0xC0u) == 0x80u)
        ++shown_end;
    const std::string before = shown(line.substr(cut, from - cut));
    const std::string marked = shown(line.substr(from, std::min(to, shown_end) - from));
    const std::string behind =
        shown(line.substr(std::min(to, shown_end), shown_end - std::min(to, shown_end)));
    const std::size_t width = std::max<std::size_t>(1, code_points(marked));
    return fmt::format("{}{}{}\n{}{}\n", before, marked, behind, std::string(code_points(before), ' '),
                       std::string(width, '^'));
}

// Where in the document, and what mends it.
std::string mend_line(const Diagnostic& d) {
    constexpr std::size_t kLongest = 240;
    const std::string_view mend = code_info(d.code).mend;
    if (d.place.pointer.empty()) return fmt::format("    {}\n", mend);
    return fmt::format("    at {}: {}\n", printable(d.place.pointer, kLongest), mend);
}

std::string where(const Place& place) {
    if (!place.source) return "";
    LineColumn at = line_column(place.source->text, place.span.begin);
    return fmt::format("{}:{}:{}: ", place.source->name, at.line, at.column);
}

std::string json_string(std::string_view text) {
    std::string out = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20u) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        } else {
            out += c;
        }
    }
    return out + "\"";
}

std::string render_json(const Diagnostic& d) {
    std::string out = fmt::format("{{\"severity\":\"{}\",\"code\":\"SG{}\",\"message\":{}",
                                  d.severity == Severity::error ? "error" : "warning",
                                  static_cast<int>(d.code), json_string(d.message));
    if (d.place.source) {
        LineColumn at = line_column(d.place.source->text, d.place.span.begin);
        LineColumn end = line_column(d.place.source->text, d.place.span.end);
        out += fmt::format(
            ",\"file\":{},\"line\":{},\"column\":{},\"end_line\":{},\"end_column\":{},\"byte_begin\":{},"
            "\"byte_end\":{},\"pointer\":{}",
            json_string(d.place.source->name), at.line, at.column, end.line, end.column, d.place.span.begin,
            d.place.span.end, json_string(d.place.pointer));
    }
    std::string notes;
    for (const Note& note : d.notes) {
        notes += fmt::format("{}{{\"message\":{}", notes.empty() ? "" : ",", json_string(note.text));
        if (note.place.source) {
            LineColumn at = line_column(note.place.source->text, note.place.span.begin);
            notes += fmt::format(",\"file\":{},\"line\":{},\"column\":{},\"pointer\":{}",
                                 json_string(note.place.source->name), at.line, at.column,
                                 json_string(note.place.pointer));
        }
        notes += "}";
    }
    if (!notes.empty()) out += fmt::format(",\"notes\":[{}]", notes);
    return out + fmt::format(",\"mend\":{}}}\n", json_string(code_info(d.code).mend));
}

}  // namespace

std::span<const CodeInfo> all_codes() {
    return kCodes;
}

const CodeInfo& code_info(Code code) {
    for (const CodeInfo& info : kCodes) {
        if (info.code == code) return info;
    }
    SG_UNREACHABLE("a diagnostic code without a row");
}

void Diags::error(Code code, Place place, std::string message, std::vector<Note> notes) {
    all_.push_back({Severity::error, code, std::move(message), std::move(place), std::move(notes)});
    ++errors_;
}

void Diags::warning(Code code, Place place, std::string message) {
    all_.push_back({Severity::warning, code, std::move(message), std::move(place), {}});
}

void Diags::append(const Diags& other) {
    all_.insert(all_.end(), other.all_.begin(), other.all_.end());
    errors_ += other.errors_;
}

void Diags::sort() {
    std::stable_sort(all_.begin(), all_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        std::string_view a_name =
            a.place.source ? std::string_view(a.place.source->name) : std::string_view();
        std::string_view b_name =
            b.place.source ? std::string_view(b.place.source->name) : std::string_view();
        return std::pair(a_name, a.place.span.begin) < std::pair(b_name, b.place.span.begin);
    });
}

int Diags::exit_code() const {
    int code = 0;
    for (const Diagnostic& d : all_) {
        if (d.severity != Severity::error) continue;
        if (code_info(d.code).fault == Fault::input) return 1;
        code = 4;
    }
    return code;
}

std::string render(const Diagnostic& d, DiagFormat format, bool color) {
    if (format == DiagFormat::json) return render_json(d);
    bool is_error = d.severity == Severity::error;
    std::string_view word = is_error ? "error" : "warning";
    std::string head = color ? fmt::format("\x1b[{}m{}:\x1b[0m", is_error ? "1;31" : "1;35", word)
                             : fmt::format("{}:", word);
    std::string out =
        fmt::format("{}{} {} [SG{}]\n", where(d.place), head, d.message, static_cast<int>(d.code));
    if (d.place.source) out += caret_block(d.place) + mend_line(d);
    for (const Note& note : d.notes) {
        out += fmt::format("{}note: {}\n", where(note.place), note.text);
        if (note.place.source) out += caret_block(note.place);
    }
    return out;
}

std::string render(const Diags& diags, DiagFormat format, bool color) {
    std::string out;
    for (const Diagnostic& d : diags.all()) out += render(d, format, color);
    return out;
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
    std::size_t best_distance = (word.size() < 5 ? 1 : (word.size() + 2) / 3) + 1;
    std::string_view best;
    for (std::string_view candidate : candidates) {
        const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
        if (word.size() > 200 || longer - shorter >= best_distance) continue;
        std::size_t distance = edit_distance(word, candidate);
        // A word of which half is another is another word.
        if (distance < best_distance && 2 * distance < longer) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
    std::string_view near = nearest(word, candidates);
    return near.empty() ? "" : fmt::format(", did you mean '{}'?", near);
}

std::string one_of(std::span<const std::string_view> words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
        out += fmt::format("'{}'", words[i]);
    }
    return out;
}

std::string printable(std::string_view text, std::size_t longest) {
    std::string out;
    for (char c : text) {
        if (out.size() >= longest && (static_cast<unsigned char>(c) & 0xC0u) != 0x80u) return out + "...";
        if (static_cast<unsigned char>(c) < 0x20u || c == 0x7F) {
            out += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace sg
