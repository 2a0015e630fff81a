// Messages for what a user can mend: a place, what was found, what was expected.
//
//   wall.json:14:15: error: unknown layer kind 'normal_mpa', did you mean 'normal_map'? [SG1105]
//         "kind": "normal_mpa"
//                 ^^^^^^^^^^^^
//     at /bump/0/layers/0/kind: use a kind from `surfgradc kinds`
//
// Messages are lower case, have no full stop, quote the value that is wrong. Every stage reports all that it
// can, not the first. Our own bugs never come here (base/ice.hpp).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.hpp"

namespace sg {

enum class Code : std::uint16_t {
#define SG_DIAG(number, identifier, fault, cause, mend) identifier = number,
#include "base/diag_codes.def"
#undef SG_DIAG
};

// Who must act: the author of the input (exit code 1) or the keeper of the machine (exit code 4).
enum class Fault { input, system };

struct CodeInfo {
    Code code;
    std::string_view identifier;
    Fault fault;
    std::string_view cause;
    std::string_view mend;
};
std::span<const CodeInfo> all_codes();
const CodeInfo& code_info(Code code);

enum class Severity { error, warning };

struct Note {
    std::string text;
    Place place;  // optional: an empty source prints the text alone
};

struct Diagnostic {
    Severity severity = Severity::error;
    Code code{};
    std::string message;
    Place place;
    std::vector<Note> notes;
};

class Diags {
public:
    void error(Code code, Place place, std::string message, std::vector<Note> notes = {});
    void error(Code code, std::string message) { error(code, Place{}, std::move(message)); }
    void warning(Code code, Place place, std::string message);

    [[nodiscard]] bool has_errors() const { return errors_ > 0; }
    [[nodiscard]] std::size_t error_count() const { return errors_; }
    [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
    void append(const Diags& other);
    // Orders by source name and place, so that the reader walks down the file; placeless messages come first.
    void sort();

    // 0 without errors, 1 if any error is the input's fault, else 4.
    [[nodiscard]] int exit_code() const;

private:
    std::vector<Diagnostic> all_;
    std::size_t errors_ = 0;
};

enum class DiagFormat { human, json };

// Human form: the block above, one per diagnostic. JSON form: one object a line.
std::string render(const Diagnostic& diagnostic, DiagFormat format = DiagFormat::human, bool color = false);
std::string render(const Diags& diags, DiagFormat format = DiagFormat::human, bool color = false);

// The nearest of `candidates` within about a third of the word's length in edits (one in words of three or
// four letters, none in shorter ones), else "".
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);
// ", did you mean 'x'?" or "".
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);
// "'a', 'b' or 'c'".
std::string one_of(std::span<const std::string_view> words);
// A text from a user made safe for one line of a terminal: control characters as \xNN, cut at `longest`
// bytes.
std::string printable(std::string_view text, std::size_t longest = 60);

}  // namespace sg
