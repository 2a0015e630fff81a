// Golden files: `expect_golden(path, text)` compares with the file, or writes it when SG_ACCEPT is set.
#pragma once

#include <filesystem>
#include <string>

namespace sg::test {

// The repository's root.
std::filesystem::path source_dir();
std::string read_file(const std::filesystem::path& path);  // "" if missing
// path: below tests/. A difference fails the test with the first line that differs.
void expect_golden(const std::filesystem::path& path, const std::string& text);

}  // namespace sg::test
