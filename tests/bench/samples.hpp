// The materials of materials/, as benchmarks take them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/source.hpp"

namespace sg::bench {

inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::filesystem::path sample_folder() {
    return std::filesystem::path(SG_SOURCE_DIR) / "materials";
}

inline std::vector<std::filesystem::path> samples() {
    std::vector<std::filesystem::path> out;
    for (const auto& entry : std::filesystem::directory_iterator(sample_folder())) {
        if (entry.path().extension() == ".json") out.push_back(entry.path());
    }
    std::sort(out.begin(), out.end());
    return out;
}

inline SourcePtr source_of(const std::filesystem::path& path) {
    return std::make_shared<Source>(Source{path.filename().string(), text_of(path)});
}

}  // namespace sg::bench
