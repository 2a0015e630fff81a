#include "library_index.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "glsl.hpp"

namespace sg::proof {
namespace {

// "vec3 sg_reject(vec3 v, vec3 n) { ... }" -> "sg_reject"; "" for any other line. Definitions begin in
// column 1.
std::string defined_function(const std::string& line) {
    std::size_t blank = line.find(' ');
    std::size_t open = line.find('(');
    if (blank == std::string::npos || open == std::string::npos || blank > open) return "";
    std::string name = line.substr(blank + 1, open - blank - 1);
    bool plain = std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
    return plain && name.starts_with("sg_") ? name : "";
}

}  // namespace

std::vector<std::string> library_files() {
    std::vector<std::string> out;
    for (const std::string folder : {"lighting", "surfgrad"}) {
        for (const auto& entry : std::filesystem::directory_iterator(SG_SOURCE_DIR "/shader_lib/" + folder)) {
            if (entry.path().extension() == ".glsl")
                out.push_back(folder + "/" + entry.path().filename().string());
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::map<std::string, std::string> library_functions() {
    std::map<std::string, std::string> out;
    for (const std::string& file : library_files()) {
        std::istringstream lines(library_text(file));
        for (std::string line; std::getline(lines, line);) {
            std::string name = defined_function(line);
            if (!name.empty()) out.emplace(name, file);
        }
    }
    return out;
}

std::string doc_comment(const std::string& file, const std::string& function) {
    std::istringstream lines(library_text(file));
    std::string comment;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("//")) {
            comment += line + "\n";
        } else {
            if (defined_function(line) == function) return comment;
            comment.clear();
        }
    }
    return "";
}

std::string definition(const std::string& file, const std::string& function) {
    std::istringstream lines(library_text(file));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        if (text.empty() && defined_function(line) != function) continue;
        text += (text.empty() ? "" : "\n") + line;
        if (line[0] == '}' || (line[0] != ' ' && line.ends_with("}"))) return text;
    }
    return text;
}

}  // namespace sg::proof
