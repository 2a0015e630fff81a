#include "asset/gltf_parse.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <exception>

namespace sg::asset {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestJson = 64;  // nesting; the parser of extras is recursive

// What tinygltf's callbacks need: our files, and the one folder in which it may look.
struct Folder {
    Files& files;
    std::string prefix;
};

// Pictures in files are not touched here.
bool is_picture(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::string_view kExtensions[] = {".png",  ".jpg", ".jpeg", ".webp",
                                                ".ktx2", ".ktx", ".dds",  ".basis"};
    return std::find(std::begin(kExtensions), std::end(kExtensions), extension) != std::end(kExtensions);
}

bool file_exists(const std::string& path, void* user) {
    auto* folder = static_cast<Folder*>(user);
    return path.starts_with(folder->prefix) && !is_picture(path) && folder->files.exists(path);
}

bool read_whole_file(std::vector<unsigned char>* out, std::string* error, const std::string& path,
                     void* user) {
    Files::ReadResult result = static_cast<Folder*>(user)->files.read(path);
    if (result.status != Files::Status::ok) {
        if (error) *error = result.status == Files::Status::missing ? "it does not exist" : result.reason;
        return false;
    }
    out->assign(result.bytes.begin(), result.bytes.end());
    return true;
}

// Only what a data URI holds is kept: pictures in files and in buffers are read by whoever wants them, with
// every bound checked.
bool keep_embedded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                   const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

// Deepest nesting of brackets outside of strings; text that is no JSON gives some number, too.
int nesting(std::string_view text) {
    int depth = 0, deepest = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') in_string = !in_string;
        if (c == '\\' && in_string) ++i;
        if (in_string) continue;
        if (c == '{' || c == '[') deepest = std::max(deepest, ++depth);
        if (c == '}' || c == ']') --depth;
    }
    return deepest;
}

// The JSON part of a .glb, or the whole text of a .gltf.
std::string_view json_part(std::string_view bytes) {
    if (!bytes.starts_with("glTF") || bytes.size() < 20) return bytes;
    std::uint32_t length = 0;
    for (int i = 3; i >= 0; --i)
        length = length << 8 | static_cast<unsigned char>(bytes[12 + static_cast<unsigned>(i)]);
    return bytes.substr(20, length);
}

// tinygltf's first line, ready to stand in a message.
std::string first_line(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    return line.empty() ? "no reason given" : printable(line);
}

// "" or why not.
std::string parse(const std::string& bytes, Folder& folder, tinygltf::Model& model) {
    if (bytes.size() > 0x7fffffffu) return "expected less than 2 GiB";
    if (nesting(json_part(bytes)) > kDeepestJson)
        return fmt::format("nested deeper than {} levels", kDeepestJson);
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_embedded, nullptr);
    tinygltf::FsCallbacks callbacks{};
    callbacks.FileExists = file_exists;
    callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
    callbacks.ReadWholeFile = read_whole_file;
    callbacks.user_data = &folder;
    loader.SetFsCallbacks(callbacks);
    std::string error, warning;
    const auto size = static_cast<unsigned>(bytes.size());
    try {
        const bool ok =
            bytes.starts_with("glTF")
                ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                              reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                              folder.prefix)
                : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder.prefix);
        return ok ? "" : first_line(error);
    } catch (const std::exception& failure) {  // the parser's own, on values of a wrong type
        return first_line(failure.what());
    }
}

}  // namespace

void report_gltf(const fs::path& path, std::string_view reason, Diags& diags) {
    diags.error(Code::mesh_format,
                fmt::format("cannot read '{}' as glTF 2.0: {}", printable(path.string()), reason));
}

std::optional<tinygltf::Model> parse_gltf(Files& files, const fs::path& path, Diags& diags) {
    const std::optional<std::string> bytes = read_or_report(files, path, diags);
    if (!bytes) return std::nullopt;
    Folder folder{files, path.parent_path().string()};
    tinygltf::Model model;
    if (const std::string reason = parse(*bytes, folder, model); !reason.empty()) {
        report_gltf(path, reason, diags);
        return std::nullopt;
    }
    return model;
}

}  // namespace sg::asset
