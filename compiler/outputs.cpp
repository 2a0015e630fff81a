#include "outputs.hpp"

#include <fmt/core.h>

namespace sg {
namespace {

const std::string kInput;  // owns the files that are read

}  // namespace

void Outputs::add_input(const std::filesystem::path& path) {
    owners_.emplace(files_.canonical(path), kInput);
}

bool Outputs::claim(const std::string& owner,
                    const std::vector<std::pair<std::filesystem::path, std::string>>& outputs, Diags& diags) {
    for (const auto& [path, bytes] : outputs) {
        auto [taken, fresh] = owners_.emplace(files_.canonical(path), owner);
        if (fresh) continue;
        std::string why = taken->second == kInput ? "which is an input"
                                                  : fmt::format("as '{}' does", printable(taken->second));
        diags.error(Code::output_clash,
                    fmt::format("'{}' would write '{}', {}; choose another folder with -o", printable(owner),
                                printable(path.string()), why));
        return false;
    }
    return true;
}

}  // namespace sg
