// Folders of published and of damaged files, where this machine has them: a value or an error, never a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "asset/image.hpp"
#include "asset/mesh.hpp"
#include "base/files.hpp"
#include "sha256.hpp"

namespace sg::asset {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(SG_SOURCE_DIR) / ".." / "shared" / "data";

bool present(const fs::path& path) {
    if (fs::exists(path)) return true;
    std::cout << "skipped: " << path.string() << " is not on this machine\n";
    return false;
}

std::string slurp(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return std::move(text).str();
}

std::vector<fs::path> files_below(const fs::path& folder,
                                  std::initializer_list<std::string_view> extensions) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (std::find(extensions.begin(), extensions.end(), entry.path().extension().string()) !=
            extensions.end())
            out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<std::vector<std::string>> rows_of(const fs::path& table) {
    std::vector<std::vector<std::string>> rows;
    std::ifstream stream(table);
    for (std::string line; std::getline(stream, line);) {
        std::istringstream cells(line);
        rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
    }
    return rows;
}

// As the table has it: "u8:" and the hash of the RGBA bytes, or "u16be:" and that of big-endian pairs.
std::string pixel_hash(const Image& image) {
    std::string bytes(image.bytes.begin(), image.bytes.end());
    if (image.format == TexelFormat::unorm8) return "u8:" + test::sha256(bytes);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
    return "u16be:" + test::sha256(bytes);
}

TEST(Corpus, Sha256KnowsItsPublishedVectors) {
    EXPECT_EQ(test::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(test::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Corpus, PngSuitePixelsAreRight) {
    if (!present(kData / "png" / "pngsuite-expected.tsv")) return;
    int checked = 0;
    for (const auto& row : rows_of(kData / "png" / "pngsuite-expected.tsv")) {
        if (row.size() < 2 || row[0] == "file") continue;
        Diags diags;
        const auto image = read_image(slurp(kData / "png" / "pngsuite" / row[0]), row[0], Place{}, diags);
        EXPECT_EQ(diags.error_count(), image ? 0u : 1u);
        ++checked;
        if (row[1] != "ok") {
            EXPECT_FALSE(image) << row[0];
            continue;
        }
        ASSERT_TRUE(image) << render(diags);
        EXPECT_EQ(pixel_hash(*image), row.at(6)) << row[0];
    }
    EXPECT_GT(checked, 100);
}

TEST(Corpus, ImagesGiveAValueOrAnError) {
    int values = 0, errors = 0;
    for (const char* folder :
         {"png", "jpeg", "made", "textures", "fuzz", "ktx2", "dds", "materialx", "decals"}) {
        if (!present(kData / folder)) continue;
        for (const fs::path& path :
             files_below(kData / folder, {".png", ".jpg", ".jpeg", ".tga", ".bmp", ".hdr", ".exr", ".pfm",
                                          ".dds", ".ktx2", ".json"})) {
            Diags diags;
            const auto image = read_image(slurp(path), path.filename().string(), Place{}, diags);
            EXPECT_EQ(diags.error_count(), image ? 0u : 1u) << path;
            ++(image ? values : errors);
        }
    }
    std::cout << values << " images, " << errors << " refused\n";
}

// Decoders may differ in how they interpolate colour, so single texels may be off by more than the mean.
TEST(Corpus, JpegsAreWithinAFewCodesOfTheirReference) {
    if (!present(kData / "made" / "jpeg")) return;
    for (const fs::path& path : files_below(kData / "made" / "jpeg", {".jpg"})) {
        Diags diags;
        const auto image = read_image(slurp(path), path.filename().string(), Place{}, diags);
        const auto expected = read_image(slurp(fs::path(path).replace_extension(".png")), "", Place{}, diags);
        ASSERT_TRUE(image && expected) << path << render(diags);
        ASSERT_EQ(image->bytes.size(), expected->bytes.size()) << path;
        double sum = 0;
        for (std::size_t i = 0; i < image->bytes.size(); ++i)
            sum += std::abs(double(image->bytes[i]) - expected->bytes[i]);
        EXPECT_LE(sum / double(image->bytes.size()), 2.0) << path;
    }
}

// Reads a file and checks what a mesh promises.
bool scene_is_sound(const fs::path& path, Diags& diags) {
    RealFiles files;
    const auto scene = read_gltf(files, path, diags);
    EXPECT_EQ(diags.has_errors(), !scene) << path;
    if (!scene) return false;
    for (const Mesh& mesh : scene->meshes) {
        const std::size_t count = mesh.positions.size();
        EXPECT_EQ(mesh.indices.size() % 3, 0u) << path;
        EXPECT_EQ(mesh.normals.size(), count) << path;
        EXPECT_TRUE(mesh.tangents.empty() || mesh.tangents.size() == count) << path;
        for (const auto& uv : mesh.uvs) EXPECT_TRUE(uv.empty() || uv.size() == count) << path;
        for (const std::uint32_t i : mesh.indices) EXPECT_LT(i, count) << path;
        for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-4f) << path;
    }
    for (const Instance& instance : scene->instances) EXPECT_LT(instance.mesh, scene->meshes.size()) << path;
    return true;
}

TEST(Corpus, DamagedMeshesGiveAValueOrAnError) {
    int values = 0, errors = 0;
    for (const fs::path& folder : {kData / "gltf-malformed", kData / "made" / "malformed"}) {
        if (!present(folder)) continue;
        for (const fs::path& path : files_below(folder, {".gltf", ".glb", ".json"})) {
            Diags diags;
            ++(scene_is_sound(path, diags) ? values : errors);
        }
    }
    std::cout << values << " scenes, " << errors << " refused\n";
}

TEST(Corpus, WholeMeshesAreRead) {
    for (const char* folder : {"gltf", "mikktspace", "made/mikktspace", "made/object-space"}) {
        if (!present(kData / folder)) continue;
        for (const fs::path& path : files_below(kData / folder, {".gltf", ".glb"})) {
            Diags diags;
            const bool ok = scene_is_sound(path, diags);
            if (!ok) std::cout << render(diags);
            EXPECT_TRUE(ok || diags.all()[0].code == Code::mesh_empty) << render(diags);
        }
    }
}

TEST(Corpus, ExpectedRejectionsAreRejections) {
    if (!present(kData / "made" / "malformed" / "expected.tsv")) return;
    for (const auto& row : rows_of(kData / "made" / "malformed" / "expected.tsv")) {
        if (row.size() < 2 || row[1].rfind("reject", 0) != 0) continue;
        const fs::path path = kData / "made" / row[0];
        const bool mesh = path.extension() == ".glb";
        Diags diags;
        const bool value =
            mesh ? scene_is_sound(path, diags) : read_image(slurp(path), row[0], Place{}, diags).has_value();
        EXPECT_FALSE(value) << row[0];
    }
}

}  // namespace
}  // namespace sg::asset
