#include "base/files.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace sg {
namespace fs = std::filesystem;

Files::ReadResult RealFiles::read(const fs::path& path) {
    std::error_code ec;
    fs::file_status status = fs::status(path, ec);
    if (status.type() == fs::file_type::not_found) return {Status::missing, "", ""};
    if (status.type() == fs::file_type::directory) return {Status::folder, "", "it is a folder"};
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return {Status::unreadable, "", std::strerror(errno)};
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    if (stream.bad()) return {Status::unreadable, "", std::strerror(errno)};
    return {Status::ok, std::move(bytes).str(), ""};
}

bool RealFiles::exists(const fs::path& path) {
    std::error_code ec;
    return fs::is_regular_file(path, ec);
}

std::vector<std::string> RealFiles::names(const fs::path& folder) {
    std::vector<std::string> out;
    std::error_code ec, of_entry;
    for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec)) {
        if (at->is_regular_file(of_entry)) out.push_back(at->path().filename().string());
    }
    std::sort(out.begin(), out.end());
    return out;
}

fs::path RealFiles::canonical(const fs::path& path) {
    std::error_code ec;
    // Absolute first: a relative path that does not exist yet would stay relative, and change once it exists.
    fs::path result = fs::weakly_canonical(fs::absolute(path, ec), ec);
    return ec ? path.lexically_normal() : result;
}

std::string RealFiles::write_all(const std::vector<std::pair<fs::path, std::string>>& files) {
    std::vector<fs::path> temporaries;
    std::error_code ec;
    auto give_up = [&](const fs::path& path, const std::string& reason) {
        for (const fs::path& t : temporaries) fs::remove(t, ec);
        return fmt::format("cannot write '{}': {}", path.string(), reason);
    };
    for (const auto& [path, bytes] : files) {
        if (path.has_parent_path()) fs::create_directories(path.parent_path(), ec);
        if (ec) return give_up(path, ec.message());
        if (fs::is_directory(path, ec)) return give_up(path, "it is a folder");
        fs::path temporary = path;
        temporary += fmt::format(".tmp{}", ::getpid());
        temporaries.push_back(temporary);
        errno = 0;
        std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        stream.close();
        if (!stream) return give_up(path, errno ? std::strerror(errno) : "the write failed");
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        fs::rename(temporaries[i], files[i].first, ec);
        if (ec) return give_up(files[i].first, ec.message());
    }
    return "";
}

Files::ReadResult MemoryFiles::read(const fs::path& path) {
    std::string key = path.lexically_normal().string();
    reads.push_back(key);
    auto it = contents.find(key);
    if (it == contents.end()) return {Status::missing, "", ""};
    return {Status::ok, it->second, ""};
}

bool MemoryFiles::exists(const fs::path& path) {
    return contents.count(path.lexically_normal().string()) > 0;
}

std::vector<std::string> MemoryFiles::names(const fs::path& folder) {
    std::vector<std::string> out;
    for (const auto& [path, bytes] : contents) {
        if (fs::path(path).parent_path() == folder.lexically_normal())
            out.push_back(fs::path(path).filename().string());
    }
    return out;
}

fs::path MemoryFiles::canonical(const fs::path& path) {
    return path.lexically_normal();
}

std::string MemoryFiles::write_all(const std::vector<std::pair<fs::path, std::string>>& files) {
    for (const auto& [path, bytes] : files) contents[path.lexically_normal().string()] = bytes;
    return "";
}

std::optional<std::string> read_or_report(Files& files, const fs::path& path, Diags& diags) {
    Files::ReadResult result = files.read(path);
    switch (result.status) {
        case Files::Status::ok:
            return std::move(result.bytes);
        case Files::Status::missing:
            diags.error(Code::file_missing,
                        fmt::format("file '{}' does not exist", printable(path.string())));
            break;
        case Files::Status::folder:
            diags.error(Code::file_missing,
                        fmt::format("'{}' is a folder, expected a file", printable(path.string())));
            break;
        case Files::Status::unreadable:
            diags.error(Code::file_unreadable,
                        fmt::format("cannot read '{}': {}", printable(path.string()), result.reason));
            break;
    }
    return std::nullopt;
}

bool write_or_report(Files& files, const std::vector<std::pair<fs::path, std::string>>& contents,
                     Diags& diags) {
    std::string reason = files.write_all(contents);
    if (!reason.empty()) diags.error(Code::file_unwritable, reason);
    return reason.empty();
}

std::string content_hash(std::string_view bytes) {
    XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return fmt::format("xxh3:{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace sg
