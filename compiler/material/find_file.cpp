#include "material/find_file.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace sg::material {

namespace fs = std::filesystem;

namespace {

bool inside(const fs::path& path, const std::vector<fs::path>& roots) {
    return std::any_of(roots.begin(), roots.end(), [&](const fs::path& root) {
        auto [root_end, path_at] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
        return root_end == root.end();
    });
}

// ", did you mean 'textures/bricks.png'?" of what lies where a file was looked for, or "".
std::string beside(const fs::path& written, const std::vector<fs::path>& missing, Files& files) {
    for (const fs::path& path : missing) {
        const std::vector<std::string> names = files.names(path.parent_path());
        const std::string near{
            nearest(written.filename().string(), std::vector<std::string_view>(names.begin(), names.end()))};
        if (!near.empty())
            return fmt::format(", did you mean '{}'?",
                               printable((written.parent_path() / near).generic_string()));
    }
    return "";
}

constexpr std::size_t kMostSearched = 64;  // files that are missing: a folder may be large

}  // namespace

std::optional<FoundFile> find_file(const std::string& written, const At& at, const SourcePtr& source,
                                   const Roots& roots, Files& files, Diags& diags) {
    auto error = [&](Code code, std::string message) {
        diags.error(code, {source, at.span, at.pointer}, std::move(message));
        return std::nullopt;
    };
    const fs::path relative(written);
    std::vector<fs::path> folders, missing;
    for (const fs::path& folder : roots.folders)
        folders.push_back(files.canonical(folder.empty() ? fs::path(".") : folder));
    bool linked_away = false;
    for (const fs::path& folder : folders) {
        if (relative.is_absolute() || written.find('\0') != std::string::npos) break;
        fs::path path = files.canonical(folder / relative);
        if (!inside(path, folders)) {
            linked_away = linked_away || inside((folder / relative).lexically_normal(), folders);
            continue;
        }
        missing.push_back(path);
        if (!files.exists(path)) continue;
        Files::ReadResult result = files.read(path);
        if (result.status == Files::Status::ok) return FoundFile{std::move(result.bytes), std::move(path)};
        return error(Code::file_unreadable,
                     fmt::format("cannot read '{}': {}", printable(written), result.reason));
    }
    if (!missing.empty()) {
        const std::string near = diags.error_count() < kMostSearched ? beside(relative, missing, files) : "";
        return error(
            Code::file_missing,
            fmt::format("file '{}' does not exist, looked below the material's folder{}{}",
                        printable(written), roots.folders.size() > 1 ? " and every -I root" : "", near));
    }
    if (linked_away) {
        return error(Code::path_escapes,
                     fmt::format("'{}' is, or lies behind, a symbolic link that leads out of the "
                                 "material's folder, expected a file below it or below an -I root",
                                 printable(written)));
    }
    return error(Code::path_escapes,
                 fmt::format("path '{}' leaves the material's folder, expected a relative path below "
                             "it or below an -I root",
                             printable(written)));
}

}  // namespace sg::material
