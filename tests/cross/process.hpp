// Other programs, by the shell; and a folder for what they read.
#pragma once

#include <filesystem>
#include <string>

namespace sg::cross {

struct Outcome {
    int exit_code = -1;  // -1: it was ended by a signal
    std::string text;    // standard output
};
Outcome run(const std::string& command);
bool has_program(const std::string& name);  // on PATH

// Emptied when the test starts, removed when it ends.
const std::filesystem::path& scratch();
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace sg::cross
