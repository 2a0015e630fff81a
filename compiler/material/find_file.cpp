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

}  // namespace

std::optional<FoundFile> find_file(const std::string& written, const At& at, const SourcePtr& source,
                                   const Roots& roots, Files& files, Diags& diags) {
    auto error = [&](Code code, std::string message) {
        diags.error(code, {source, at.span, at.pointer}, std::move(message));
        return std::nullopt;
    };
    const fs::path relative(written);
    std::vector<fs::path> folders;
    for (const fs::path& folder : roots.folders)
        folders.push_back(files.canonical(folder.empty() ? fs::path(".") : folder));
    bool below = false, linked_away = false;
    for (const fs::path& folder : folders) {
        if (relative.is_absolute() || written.find('\0') != std::string::npos) break;
        fs::path path = files.canonical(folder / relative);
        if (!inside(path, folders)) {
            linked_away = linked_away || inside((folder / relative).lexically_normal(), folders);
            continue;
        }
        below = true;
        if (!files.exists(path)) continue;
        Files::ReadResult result = files.read(path);
        if (result.status == Files::Status::ok) return FoundFile{std::move(result.bytes), std::move(path)};
        return error(Code::file_unreadable,
                     fmt::format("cannot read '{}': {}", printable(written), result.reason));
    }
    if (below) {
        return error(Code::file_missing,
                     fmt::format("file '{}' does not exist, looked below the material's folder{}",
                                 printable(written), roots.folders.size() > 1 ? " and every -I root" : ""));
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
