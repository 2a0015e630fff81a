// glTF from memory: attributes, hierarchies, and what is said about damaged files.
#include <gtest/gtest.h>

#include <cstring>

#include "asset/mesh.hpp"
#include "base/files.hpp"

namespace sg::asset {
namespace {

// A buffer that grows attribute by attribute, with the JSON of its views and accessors.
struct Builder {
    std::string bytes, views, accessors;
    int count = 0;

    template <class T>
    int add(const std::vector<T>& numbers, int component_type, const char* type, int width,
            const char* extra = "") {
        while (bytes.size() % 4) bytes.push_back('\0');
        const std::size_t begin = bytes.size(), length = numbers.size() * sizeof(T);
        bytes.append(reinterpret_cast<const char*>(numbers.data()), length);
        const std::string comma = count ? "," : "";
        views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(begin) + R"(,"byteLength":)" +
                 std::to_string(length) + "}";
        accessors += comma + R"({"bufferView":)" + std::to_string(count) + R"(,"componentType":)" +
                     std::to_string(component_type) + R"(,"type":")" + type + R"(","count":)" +
                     std::to_string(numbers.size() / static_cast<std::size_t>(width)) + extra + "}";
        return count++;
    }

    [[nodiscard]] std::string json(const std::string& rest) const {
        return R"({"asset":{"version":"2.0"},"buffers":[{"uri":"a%20b.bin","byteLength":)" +
               std::to_string(bytes.size()) + R"(}],"bufferViews":[)" + views + R"(],"accessors":[)" +
               accessors + "]," + rest + "}";
    }
};

// A unit square in XY as a strip: positions, normals, tangents, normalised uvs, colours without alpha, u8
// indices.
Builder square() {
    Builder b;
    b.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 5126, "VEC3", 3);
    b.add<float>({0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 2}, 5126, "VEC3", 3);
    b.add<float>({3, 0, 0, 1, 3, 0, 0, 1, 3, 0, 0, -1, 0, 0, 0, 1}, 5126, "VEC4", 4);
    b.add<std::uint16_t>({0, 65535, 65535, 65535, 0, 0, 65535, 0}, 5123, "VEC2", 2, R"(,"normalized":true)");
    b.add<std::uint8_t>({255, 0, 51, 255, 0, 51, 255, 0, 51, 255, 0, 51}, 5121, "VEC3", 3,
                        R"(,"normalized":true)");
    b.add<std::uint8_t>({0, 1, 2, 3}, 5121, "SCALAR", 1);
    return b;
}

const std::string kStrip = R"("meshes":[{"name":"square","primitives":[{"mode":5,"indices":5,"attributes":)"
                           R"({"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_2":3,"COLOR_0":4}}]}])";

std::optional<Scene> read(const Builder& b, const std::string& rest, Diags& diags) {
    MemoryFiles files;
    files.contents["folder/a b.bin"] = b.bytes;
    files.contents["folder/a.gltf"] = b.json(rest);
    return read_gltf(files, "folder/a.gltf", diags);
}

std::string message_of(const Builder& b, const std::string& rest) {
    Diags diags;
    EXPECT_FALSE(read(b, rest, diags));
    return diags.all().empty() ? "" : diags.all()[0].message;
}

TEST(Gltf, ReadsEachAttributeInOurConventions) {
    Diags diags;
    const auto scene = read(square(), kStrip, diags);
    ASSERT_TRUE(scene) << render(diags);
    ASSERT_EQ(scene->instances.size(), 1u);
    const Mesh& mesh = scene->meshes.at(0);
    EXPECT_EQ(mesh.name, "square");
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(mesh.normals[3], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1, 0, 0, -1));
    EXPECT_EQ(mesh.tangents[2], glm::vec4(1, 0, 0, 1));
    EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[3]), mesh.normals[3]), 0.0f, 1e-6f);
    EXPECT_TRUE(mesh.uvs[0].empty());
    EXPECT_EQ(mesh.uvs[2][1], glm::vec2(1, 1));
    EXPECT_EQ(mesh.colors[0], glm::vec4(1, 0, 0.2f, 1));
}

TEST(Gltf, MissingNormalsBecomeFlatOnesAndDropTangents) {
    Diags diags;
    const auto scene = read(
        square(), R"("meshes":[{"primitives":[{"mode":6,"attributes":{"POSITION":0,"TANGENT":2}}]}])", diags);
    ASSERT_TRUE(scene) << render(diags);
    const Mesh& mesh = scene->meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 6u);
    EXPECT_TRUE(mesh.tangents.empty());
    EXPECT_EQ(mesh.positions[0], glm::vec3(1, 0, 0)) << "a fan starts with its second vertex";
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
}

TEST(Gltf, NodesNestAndMirroredOnesKeepTheirDeterminant) {
    Diags diags;
    const auto scene = read(square(), kStrip + R"(,"scene":0,"scenes":[{"nodes":[1]}],"nodes":[
        {"name":"child","mesh":0,"translation":[0,0,5],"rotation":[0,0,0.70710678,0.70710678]},
        {"name":"parent","scale":[-2,1,1],"children":[0,2]},
        {"name":"matrix","mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 7,8,9,1]}])",
                            diags);
    ASSERT_TRUE(scene) << render(diags);
    ASSERT_EQ(scene->instances.size(), 2u);
    EXPECT_EQ(scene->instances[0].node, "child");
    const glm::mat4& m = scene->instances[0].world_from_object;
    EXPECT_NEAR(glm::determinant(m), -2.0f, 1e-5f);
    const glm::vec4 p = m * glm::vec4(1, 0, 0, 1);  // turned to +Y, moved, mirrored
    EXPECT_NEAR(glm::length(p - glm::vec4(0, 1, 5, 1)), 0.0f, 1e-5f);
    EXPECT_EQ(scene->instances[1].world_from_object[3], glm::vec4(-14, 8, 9, 1));
}

TEST(Gltf, SparseNumbersReplaceZeros) {
    Builder b = square();
    b.add<std::uint16_t>({1, 2}, 5123, "SCALAR", 1);
    b.add<float>({1, 0, 0, 0, 1, 0}, 5126, "VEC3", 3);
    b.accessors += R"(,{"componentType":5126,"type":"VEC3","count":3,"sparse":{"count":2,
        "indices":{"bufferView":6,"componentType":5123},"values":{"bufferView":7}}})";
    Diags diags;
    const auto scene = read(b, R"("meshes":[{"primitives":[{"attributes":{"POSITION":8}}]}])", diags);
    ASSERT_TRUE(scene) << render(diags);
    EXPECT_EQ(scene->meshes[0].positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(Gltf, PicturesAreNotRead) {
    MemoryFiles files;
    const Builder b = square();
    files.contents["a b.bin"] = b.bytes;
    files.contents["a.gltf"] =
        b.json(kStrip + R"(,"images":[{"uri":"wall.PNG"},{"uri":"data:image/png;base64,iVBORw0KGgo="}])");
    files.contents["wall.PNG"] = "no picture";
    Diags diags;
    ASSERT_TRUE(read_gltf(files, "a.gltf", diags)) << render(diags);
    EXPECT_EQ(files.reads, (std::vector<std::string>{"a.gltf", "a b.bin"}));
}

TEST(Gltf, SaysWhatIsDamaged) {
    const std::string prefix = "cannot read 'folder/a.gltf' as glTF 2.0: ";
    Builder far = square();
    far.add<std::uint8_t>({0, 1, 9}, 5121, "SCALAR", 1);
    EXPECT_EQ(message_of(far, R"("meshes":[{"primitives":[{"indices":6,"attributes":{"POSITION":0}}]}])"),
              prefix + "mesh 0, primitive 0: index 9 is out of range, expected less than 4 vertices");
    EXPECT_EQ(message_of(square(), R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":2}}]}])"),
              prefix + "mesh 0, primitive 0: accessor 2 has 4 numbers per element, expected 3");
    EXPECT_EQ(message_of(square(), R"("meshes":[{"primitives":[{"attributes":{"POSITION":77}}]}])"),
              prefix + "mesh 0, primitive 0: there is no accessor 77");
    Builder endless = square();
    endless.add<float>({1, 0, std::numeric_limits<float>::infinity()}, 5126, "VEC3", 3);
    EXPECT_EQ(message_of(endless, R"("meshes":[{"primitives":[{"attributes":{"POSITION":6}}]}])"),
              prefix + "mesh 0, primitive 0: accessor 6 holds a number that is not finite");
    EXPECT_EQ(message_of(square(), kStrip + R"(,"nodes":[{"children":[1]},{"children":[1],"mesh":0}])"),
              prefix + "node 1 has two parents or is its own");
    EXPECT_EQ(message_of(square(), kStrip + R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"),
              prefix + "it requires extension 'KHR_draco_mesh_compression'");
    EXPECT_EQ(message_of(square(), R"("meshes":[{"primitives":[{"mode":0,"attributes":{"POSITION":0}}]}])"),
              "'folder/a.gltf' draws no triangles");
    EXPECT_EQ(message_of(square(), R"("extras":)" + std::string(500, '[') + std::string(500, ']')),
              prefix + "nested deeper than 64 levels");
}

std::string rendered(const std::string& rest) {
    Diags diags;
    EXPECT_FALSE(read(square(), rest, diags));
    EXPECT_EQ(diags.exit_code(), 1);
    return render(diags);
}

TEST(Gltf, WholeMessages) {
    EXPECT_EQ(rendered(R"("meshes":[{"primitives":[{"attributes":{"POSITION":77}}]}])"),
              "error: cannot read 'folder/a.gltf' as glTF 2.0: mesh 0, primitive 0: there is no accessor 77 "
              "[SG2003]\n");
    EXPECT_EQ(rendered(R"("meshes":[])"), "error: 'folder/a.gltf' draws no triangles [SG2005]\n");
}

TEST(Gltf, AMissingFileIsNamed) {
    MemoryFiles files;
    Diags diags;
    EXPECT_FALSE(read_gltf(files, "nowhere.glb", diags));
    EXPECT_NE(render(diags).find("nowhere.glb"), std::string::npos) << render(diags);
}

}  // namespace
}  // namespace sg::asset
