// A material instead of an artefact: runs the surfgradc beside this program.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diag.hpp"

namespace sg::runtime {

// A folder under the system's one for temporary files, removed with all it holds at the end of its life.
class TemporaryFolder {
public:
    static std::optional<TemporaryFolder> create(Diags& diags);  // fails with file_unwritable
    TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
    TemporaryFolder& operator=(TemporaryFolder&& other) noexcept {
        std::swap(path_, other.path_);
        return *this;
    }
    ~TemporaryFolder();
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
    std::filesystem::path path_;
};

// Runs "surfgradc compile MATERIAL -o FOLDER" with further options; its messages go to our stderr. Gives its
// exit code, or nothing and compiler_missing if it could not be started or was ended by a signal. `compiler`
// is the program's path.
std::optional<int> compile_material(const std::filesystem::path& compiler,
                                    const std::filesystem::path& material,
                                    const std::filesystem::path& folder, Diags& diags,
                                    const std::vector<std::string>& options = {});

// The surfgradc in the folder of the running program.
std::filesystem::path compiler_beside_us();

}  // namespace sg::runtime
