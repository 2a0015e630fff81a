#include "tests/support/golden.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace sg::test {

std::filesystem::path source_dir() {
    return SG_SOURCE_DIR;
}

std::string read_file(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void expect_golden(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::path file = source_dir() / "tests" / path;
    if (std::getenv("SG_ACCEPT")) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return;
    }
    std::string golden = read_file(file);
    if (golden == text) return;
    std::istringstream want(golden), have(text);
    std::string want_line, have_line;
    for (int line = 1;; ++line) {
        bool more_want = static_cast<bool>(std::getline(want, want_line));
        bool more_have = static_cast<bool>(std::getline(have, have_line));
        if (!more_want) want_line = "<end of file>";
        if (!more_have) have_line = "<end of file>";
        if (want_line == have_line && more_want) continue;
        ADD_FAILURE()
            << path.string() << ":" << line << "\n  golden: " << want_line << "\n  now:    " << have_line
            << "\nIf the change is meant: cmake --build build/release --target accept, then review the diff.";
        return;
    }
}

}  // namespace sg::test
