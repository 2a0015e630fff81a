// Where a run writes: no output may take the place of an input, or of another material's output.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/diag.hpp"
#include "base/files.hpp"

namespace sg {

class Outputs {
public:
    explicit Outputs(Files& files) : files_(files) {}

    void add_input(const std::filesystem::path& path);
    // Whether all of these may be written for the material `owner`; adds errors (output_clash) where not.
    bool claim(const std::string& owner,
               const std::vector<std::pair<std::filesystem::path, std::string>>& outputs, Diags& diags);

private:
    Files& files_;
    std::map<std::filesystem::path, std::string> owners_;  // canonical path to what it belongs to
};

}  // namespace sg
