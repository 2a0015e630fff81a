// Every diagnostic code is met by a whole message: a line of a file of expected output, or a text that a test
// compares a message with from its first word to its code.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/diag.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;

// What stands in front of "error: " in a message: nothing, or FILE:LINE:COLUMN and a blank.
bool is_place(std::string_view text) {
    if (text.empty()) return true;
    return text.size() >= 6 && text.ends_with(": ") && text.find(' ') == text.size() - 1 &&
           std::count(text.begin(), text.end(), ':') >= 3 && text[text.size() - 3] >= '0' &&
           text[text.size() - 3] <= '9';
}

// The code of a line that is a message from its first word to its code; 0 of any other.
int code_of(std::string_view line) {
    constexpr std::size_t kTag = std::string_view(" [SG1234]").size();
    const std::size_t severity = std::min(line.find("error: "), line.find("warning: "));
    if (severity == line.npos || !is_place(line.substr(0, severity)) || line.size() < severity + kTag)
        return 0;
    const std::string_view tag = line.substr(line.size() - kTag);
    if (!tag.starts_with(" [SG") || !tag.ends_with("]")) return 0;
    return std::atoi(std::string(tag.substr(4, 4)).c_str());
}

void add_codes(std::string_view text, std::set<int>& found) {
    for (std::size_t end = 0; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1))
        found.insert(code_of(text.substr(0, end)));
}

// The text of a string literal that begins at `at`, which is moved behind it.
std::string literal(const std::string& code, std::size_t& at) {
    std::string out;
    if (code[at] == 'R') {
        const std::size_t open = code.find('(', at);
        const std::string close = ")" + code.substr(at + 2, open - at - 2) + "\"";
        const std::size_t end = std::min(code.find(close, open), code.size());
        out = code.substr(open + 1, end - open - 1);
        at = std::min(end + close.size(), code.size());
        return out;
    }
    for (++at; at < code.size() && code[at] != '"'; ++at) {
        if (code[at] != '\\') {
            out += code[at];
        } else if (++at < code.size()) {
            out += code[at] == 'n' ? '\n' : code[at];
        }
    }
    ++at;
    return out;
}

bool begins_literal(const std::string& code, std::size_t at) {
    return code[at] == '"' || code.compare(at, 2, "R\"") == 0;
}

// A text as the code builds it: literals one behind the other, or with values between two "+", which count as
// a word. `at` is moved behind it.
std::string built_text(const std::string& code, std::size_t& at) {
    std::string out = literal(code, at);
    while (true) {
        std::size_t next = code.find_first_not_of(" \n", at);
        const bool joined = next != code.npos && code[next] == '+';
        if (joined) {
            int depth = 0;
            for (++next; next < code.size() && !begins_literal(code, next) && code[next] != ';'; ++next) {
                depth += code[next] == '(' ? 1 : code[next] == ')' ? -1 : 0;
                if (depth < 0 || (depth == 0 && code[next] == ',')) return out;
            }
        }
        if (next >= code.size() || !begins_literal(code, next)) return out;
        if (joined && code.substr(at, next - at).find_first_not_of(" \n+") != std::string::npos) out += "...";
        at = next;
        out += literal(code, at);
    }
}

// Texts that are only looked for in a message, or compared with a part of it, do not count.
bool is_searched_for(const std::string& code, std::size_t at) {
    for (const std::string_view call : {"find(", "starts_with(", "ends_with(", "HasSubstr("}) {
        if (at >= call.size() && code.compare(at - call.size(), call.size(), call) == 0) return true;
    }
    return false;
}

void add_codes_of_test(const std::string& code, std::set<int>& found) {
    for (std::size_t at = 0; at < code.size();) {
        if (code.compare(at, 2, "//") == 0) {
            at = std::min(code.find('\n', at), code.size());
        } else if (code[at] == '\'' && at + 2 < code.size()) {
            at = std::min(code.find('\'', at + (code[at + 1] == '\\' ? 3 : 2)), code.size() - 1) + 1;
        } else if (!begins_literal(code, at)) {
            ++at;
        } else {
            const bool searched = is_searched_for(code, at);
            const std::string text = built_text(code, at);
            if (!searched) add_codes(text, found);
        }
    }
}

std::set<int> asserted_codes() {
    std::set<int> found;
    for (const auto& entry : fs::recursive_directory_iterator(test::source_dir() / "tests")) {
        if (entry.path().extension() == ".txt") add_codes(test::read_file(entry.path()), found);
        if (entry.path().extension() == ".cpp" && entry.path().filename() != "exercised_test.cpp")
            add_codes_of_test(test::read_file(entry.path()), found);
    }
    return found;
}

TEST(Exercised, EveryCodeHasAWholeMessage) {
    const std::set<int> found = asserted_codes();
    for (const CodeInfo& info : all_codes()) {
        EXPECT_TRUE(found.contains(static_cast<int>(info.code)))
            << "SG" << static_cast<int>(info.code) << " (" << info.identifier
            << "): no test compares a whole message with this code";
    }
}

TEST(Exercised, APartOfAMessageDoesNotCount) {
    auto counts = [](const std::string& code) {
        std::set<int> found;
        add_codes_of_test(code, found);
        return found.contains(1234);
    };
    EXPECT_TRUE(counts(R"--(EXPECT_EQ(x, "error: no " "good [SG1234]\n");)--"));
    EXPECT_TRUE(counts(R"--(EXPECT_EQ(x, "a.json:1:22: warning: no good [SG1234]\n" "{\n^\n");)--"));
    EXPECT_TRUE(counts(R"--(EXPECT_EQ(x, "error: no " + name(1, 2) + " good [SG1234]\n");)--"));
    EXPECT_TRUE(counts(R"--(c == '"'; EXPECT_EQ(x, R"(error: no good [SG1234]
)");)--"));
    EXPECT_FALSE(counts(R"--(EXPECT_NE(x.find("[SG1234]"), npos);)--"));
    EXPECT_FALSE(counts(R"--(EXPECT_NE(x.find("error: no good [SG1234]\n"), npos);)--"));
    EXPECT_FALSE(counts(R"--(EXPECT_EQ(x.substr(3), "r: no good [SG1234]\n");)--"));
    EXPECT_FALSE(counts(R"--(EXPECT_EQ(first_line, "error: no good [SG1234]");)--"));
    EXPECT_FALSE(counts(R"--(EXPECT_EQ(x, "error: no good"); EXPECT_EQ(y, "a [SG1234]\n");)--"));
    EXPECT_FALSE(counts(R"--(// "error: no good [SG1234]\n")--"));
}

}  // namespace
}  // namespace sg
