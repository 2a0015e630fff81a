// glTF text or binary to tinygltf's model, through our files. Internal to this folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "base/diag.hpp"
#include "base/files.hpp"

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace sg::asset {

// Reads the file and the buffers below its folder; pictures are not read, but those of data URIs stand in
// Image::image as bytes. Damage adds an error (mesh_format) and gives nothing.
std::optional<tinygltf::Model> parse_gltf(Files& files, const std::filesystem::path& path, Diags& diags);
// The error of parse_gltf, for what its callers find.
void report_gltf(const std::filesystem::path& path, std::string_view reason, Diags& diags);

}  // namespace sg::asset
