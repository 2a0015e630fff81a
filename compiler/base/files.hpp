// The world behind one small interface: the compiler and the renderer read and write through it, tests run in
// memory and can assert what was read.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diag.hpp"

namespace sg {

class Files {
public:
    virtual ~Files() = default;
    enum class Status { ok, missing, folder, unreadable };
    struct ReadResult {
        Status status = Status::missing;
        std::string bytes;
        std::string reason;  // system's words when unreadable
    };
    virtual ReadResult read(const std::filesystem::path& path) = 0;
    virtual bool exists(const std::filesystem::path& path) = 0;  // a regular file
    // Of the regular files in a folder, in order; none where it cannot be read.
    virtual std::vector<std::string> names(const std::filesystem::path& folder) = 0;
    // The path with symbolic links followed and dots removed; of a missing tail, as written.
    virtual std::filesystem::path canonical(const std::filesystem::path& path) = 0;
    // All files appear whole (temporary name, then rename) or, on an error, none: folders are made as needed.
    // Returns "" or the reason why not.
    virtual std::string write_all(
        const std::vector<std::pair<std::filesystem::path, std::string>>& files) = 0;
};

class RealFiles final : public Files {
public:
    ReadResult read(const std::filesystem::path& path) override;
    bool exists(const std::filesystem::path& path) override;
    std::vector<std::string> names(const std::filesystem::path& folder) override;
    std::filesystem::path canonical(const std::filesystem::path& path) override;
    std::string write_all(const std::vector<std::pair<std::filesystem::path, std::string>>& files) override;
};

class MemoryFiles final : public Files {
public:
    std::map<std::string, std::string> contents;  // by normalised path
    std::vector<std::string> reads;               // every path that was read, in order

    ReadResult read(const std::filesystem::path& path) override;
    bool exists(const std::filesystem::path& path) override;
    std::vector<std::string> names(const std::filesystem::path& folder) override;
    std::filesystem::path canonical(const std::filesystem::path& path) override;
    std::string write_all(const std::vector<std::pair<std::filesystem::path, std::string>>& files) override;
};

// Reads a file that the user named on the command line; a failure adds a placeless error and gives nothing.
std::optional<std::string> read_or_report(Files& files, const std::filesystem::path& path, Diags& diags);
// Writes, or adds an error (file_unwritable).
bool write_or_report(Files& files, const std::vector<std::pair<std::filesystem::path, std::string>>& contents,
                     Diags& diags);

// "xxh3:" and 32 hex digits of the 128-bit XXH3 hash of the bytes: for change detection, not for security.
std::string content_hash(std::string_view bytes);

}  // namespace sg
