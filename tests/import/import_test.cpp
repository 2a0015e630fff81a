// glTF in, materials out: whole texts, whole messages, and every glTF file that is at hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "compile.hpp"
#include "import/gltf_import.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;

const std::string kPng = "\x89PNG and so on", kJpeg = "\xFF\xD8\xFF and so on";

std::optional<import::ImportedFiles> run(MemoryFiles& files, const std::string& json, Diags& diags) {
    files.contents["models/a.gltf"] = json;
    return import::import_gltf(files, "models/a.gltf", diags);
}

// The messages for a file that is refused, or warned of.
std::string messages(const std::string& json) {
    MemoryFiles files;
    files.contents["models/a.png"] = kPng;
    files.contents["models/text.png"] = "no picture";
    files.contents["secret.png"] = kPng;
    Diags diags;
    auto imported = run(files, json, diags);
    EXPECT_EQ(imported.has_value(), !diags.has_errors());
    for (const std::string& read : files.reads) EXPECT_NE(read, "secret.png");
    return render(diags);
}

// What stands between the braces of a glTF file whose material 0 has these members and picture 0 this source.
std::string gltf(const std::string& material, const std::string& image = R"("uri":"a.png")") {
    return R"({"asset":{"version":"2.0"},"images":[{)" + image +
           R"(}],"textures":[{"source":0}],"materials":[{)" + material + "}]}";
}
const std::string kColored = R"("name":"m","pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";

const char* const kEverything = R"({
  "asset": { "version": "2.0" },
  "images": [ { "uri": "maps/base%20color.png" }, { "uri": "a.jpg" }, { "uri": "other/a.jpg" },
              { "uri": "unused.png" } ],
  "samplers": [ { "magFilter": 9728, "minFilter": 9984, "wrapS": 33071, "wrapT": 33648 } ],
  "textures": [ { "source": 0 }, { "source": 1 }, { "source": 2, "sampler": 0 }, { "source": 3 } ],
  "materials": [
    { "name": "all of it",
      "pbrMetallicRoughness": {
        "baseColorFactor": [0.5, 0.25, 1, 0.75], "metallicFactor": 0.2, "roughnessFactor": 0.9,
        "baseColorTexture": { "index": 0 }, "metallicRoughnessTexture": { "index": 1, "texCoord": 1 } },
      "normalTexture": { "index": 2, "scale": 0.5, "texCoord": 3, "extensions": { "KHR_texture_transform": {
        "offset": [0.5, 0.25], "rotation": 0.5235987755982988, "scale": [2, -3], "texCoord": 2 } } },
      "occlusionTexture": { "index": 1, "texCoord": 1, "strength": 0.5 },
      "emissiveTexture": { "index": 0 }, "emissiveFactor": [1, 0.5, 0],
      "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 4 } },
      "alphaMode": "MASK", "alphaCutoff": 0.4, "doubleSided": true },
    { "name": "All Of It", "pbrMetallicRoughness": { "metallicFactor": 0 }, "normalTexture": { "index": 1 } },
    { "name": "../\"x\"", "alphaMode": "BLEND" },
    {}
  ]
})";

TEST(Import, WholeTexts) {
    MemoryFiles files;
    files.contents["models/maps/base color.png"] = kPng;
    files.contents["models/a.jpg"] = kJpeg;
    files.contents["models/other/a.jpg"] = kJpeg + "else";
    Diags diags;
    auto imported = run(files, kEverything, diags);
    ASSERT_TRUE(imported) << render(diags);
    EXPECT_EQ(render(diags), "");
    std::string names;
    for (const auto& [name, bytes] : *imported) {
        names += name.generic_string() + "\n";
        if (name.extension() == ".json") test::expect_golden("import/golden/" + name.string(), bytes);
    }
    EXPECT_EQ(names,
              "textures/base_color.png\ntextures/a.jpg\ntextures/a_2.jpg\n"
              "all_of_it.json\nAll_Of_It_2.json\n_.__x_.json\nmaterial_3.json\n");
    EXPECT_EQ((*imported)[2].second, kJpeg + "else");
}

// Every text that import writes is a material.
void expect_materials(const import::ImportedFiles& imported, const fs::path& from) {
    MemoryFiles files;
    for (const auto& [name, bytes] : imported) files.contents["in/" + name.generic_string()] = bytes;
    for (const auto& [name, bytes] : imported) {
        if (name.extension() != ".json") continue;
        CompileRequest request{.source = std::make_shared<Source>(Source{name.string(), bytes})};
        request.stem = "case";
        request.roots = {"in"};
        Diags diags;
        EXPECT_TRUE(check_material(request, files, target::embedded_library(), diags)) << from << "\n"
                                                                                       << render(diags);
    }
}

TEST(Import, WritesMaterials) {
    MemoryFiles files;
    files.contents["models/maps/base color.png"] = kPng;
    files.contents["models/a.jpg"] = kJpeg;
    files.contents["models/other/a.jpg"] = kJpeg;
    Diags diags;
    auto imported = run(files, kEverything, diags);
    ASSERT_TRUE(imported);
    expect_materials(*imported, "in memory");
}

TEST(Import, VertexColorsAreAFactor) {
    MemoryFiles files;
    Diags diags;
    const std::string meshes = R"(,"accessors":[{"componentType":5126,"type":"VEC3","count":3}],"meshes":[)"
                               R"({"primitives":[{"material":0,"attributes":{"POSITION":0,"COLOR_0":0}}]}])";
    auto imported = run(
        files, R"({"asset":{"version":"2.0"},"materials":[{"name":"m","alphaMode":"BLEND"}])" + meshes + "}",
        diags);
    ASSERT_TRUE(imported) << render(diags);
    test::expect_golden("import/golden/vertex_color.json", imported->back().second);
}

TEST(Import, DataUris) {
    MemoryFiles files;
    Diags diags;
    auto imported = run(files, gltf(kColored, R"("uri":"data:image/png;base64,iVBORw0KGgo=")"), diags);
    ASSERT_TRUE(imported) << render(diags);
    EXPECT_EQ((*imported)[0].first, "textures/image_0.png");
    EXPECT_EQ((*imported)[0].second, "\x89PNG\r\n\x1a\n");
}

TEST(Import, WarnsOfWhatIsLeftOut) {
    EXPECT_EQ(messages(gltf(R"("name":"coat","extensions":{"KHR_materials_clearcoat":{}})")),
              "warning: 'models/a.gltf': extension 'KHR_materials_clearcoat' of material 'coat' is left out "
              "[SG1501]\n");
}

TEST(Import, PicturesThatCannotBeTaken) {
    EXPECT_EQ(messages(gltf(kColored, R"("uri":"b.png")")),
              "error: 'models/a.gltf' names the picture 'b.png', which does not exist [SG1301]\n");
    EXPECT_EQ(messages(gltf(kColored, R"("uri":"%2e%2e/secret.png")")),
              "error: 'models/a.gltf' names the picture '%2e%2e/secret.png', which leaves its folder "
              "[SG1302]\n");
    EXPECT_EQ(messages(gltf(kColored, R"("uri":"/secret.png")")),
              "error: 'models/a.gltf' names the picture '/secret.png', which leaves its folder [SG1302]\n");
    EXPECT_EQ(messages(gltf(kColored, R"("uri":"text.png")")),
              "error: 'models/a.gltf': image 0 ('text') is neither PNG nor JPEG [SG2001]\n");
    EXPECT_EQ(messages(gltf(kColored, R"("bufferView":0,"mimeType":"image/png")")).substr(0, 44),
              "error: cannot read 'models/a.gltf' as glTF 2");
}

TEST(Import, NumbersAndIndicesThatCannotBe) {
    const std::string head = "error: cannot read 'models/a.gltf' as glTF 2.0: ";
    EXPECT_EQ(messages(gltf(R"("pbrMetallicRoughness":{"metallicFactor":1.5})")),
              head + "a metallicFactor is 1.5, expected 0 to 1 [SG2003]\n");
    EXPECT_EQ(messages(gltf(R"("normalTexture":{"index":7})")), head + "there is no texture 7 [SG2003]\n");
    EXPECT_EQ(messages(gltf(R"("normalTexture":{"index":0,"texCoord":8})")),
              head + "TEXCOORD_8 is named, expected 0 to 7 [SG2003]\n");
    EXPECT_EQ(messages(R"({"asset":{"version":"2.0"}})"), head + "it holds no materials [SG2003]\n");
}

// Real files become materials; damaged ones are refused without a crash.
TEST(Import, EveryFileAtHand) {
    const fs::path data = fs::path(SG_SOURCE_DIR) / ".." / "shared" / "data";
    if (!fs::exists(data)) GTEST_SKIP() << "skipped: " << data.string() << " is not on this machine";
    std::size_t taken = 0, refused = 0;
    for (const char* folder : {"gltf", "gltf-malformed", "materialx"}) {
        for (const auto& entry : fs::recursive_directory_iterator(data / folder)) {
            const fs::path extension = entry.path().extension();
            if (extension != ".gltf" && extension != ".glb") continue;
            RealFiles files;
            Diags diags;
            auto imported = import::import_gltf(files, entry.path(), diags);
            EXPECT_EQ(imported.has_value(), !diags.has_errors()) << entry.path();
            ++(imported ? taken : refused);
            if (imported) expect_materials(*imported, entry.path());
        }
    }
    std::cout << taken << " files taken, " << refused << " refused\n";
    EXPECT_GT(taken, 50u);
    EXPECT_GT(refused, 100u);
}

}  // namespace
}  // namespace sg
