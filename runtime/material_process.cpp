#include "runtime/material_process.hpp"

#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace sg::runtime {

std::optional<TemporaryFolder> TemporaryFolder::create(Diags& diags) {
    std::error_code error;
    std::filesystem::path base = std::filesystem::temp_directory_path(error);
    std::string name = (base / "surfgrad-XXXXXX").string();
    if (!error && mkdtemp(name.data()) != nullptr) return TemporaryFolder(name);
    std::string reason = error ? error.message() : std::strerror(errno);
    diags.error(Code::file_unwritable, fmt::format("no temporary folder can be made: {}", reason));
    return std::nullopt;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;  // nothing can be done about a folder that stays
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path compiler_beside_us() {
    std::error_code error;
    std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    return self.parent_path() / "surfgradc";
}

std::optional<int> compile_material(const std::filesystem::path& compiler,
                                    const std::filesystem::path& material,
                                    const std::filesystem::path& folder, Diags& diags,
                                    const std::vector<std::string>& options) {
    // A name that starts with a dash must not be read as an option.
    std::string file = material.string().starts_with('-') ? "./" + material.string() : material.string();
    std::vector<std::string> words = {compiler.string(), "compile", file, "-o", folder.string()};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    int failure = posix_spawn(&child, words[0].c_str(), nullptr, nullptr, arguments.data(), environ);
    if (failure != 0) {
        diags.error(Code::compiler_missing,
                    fmt::format("'{}' cannot be started: {}", printable(words[0]), std::strerror(failure)));
        return std::nullopt;
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno == EINTR) continue;
        diags.error(Code::compiler_missing,
                    fmt::format("surfgradc cannot be waited for: {}", std::strerror(errno)));
        return std::nullopt;
    }
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    diags.error(Code::compiler_missing, fmt::format("surfgradc was ended by signal {}", WTERMSIG(status)));
    return std::nullopt;
}

}  // namespace sg::runtime
