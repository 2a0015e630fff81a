// The contract of compiler/artefacts.md against what the shaders really hold: block layouts, locations,
// bindings.
#include <gtest/gtest.h>

#include <regex>
#include <spirv_cross/spirv_cross.hpp>

#include "compile.hpp"
#include "runtime/blocks.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

using Layout = std::map<std::string, std::uint32_t>;

// "| 128 | `camera_position` | vec4 |" below the block's heading.
Layout documented(const std::string& block) {
    std::string text = test::read_file(test::source_dir() / "compiler/artefacts.md");
    std::size_t begin = text.find("`" + block + "`, ");
    EXPECT_NE(begin, std::string::npos) << block;
    text = text.substr(begin, std::min(text.find("\n### ", begin), text.find("\n## ", begin)) - begin);
    std::regex row("\\| (\\d+) \\| `(\\w+)` \\|");
    Layout out;
    for (std::sregex_iterator it(text.begin(), text.end(), row), end; it != end; ++it)
        out[(*it)[2]] = static_cast<std::uint32_t>(std::stoul((*it)[1]));
    std::smatch size;
    EXPECT_TRUE(std::regex_search(text, size, std::regex(", (\\d+) bytes")));
    out["size"] = static_cast<std::uint32_t>(std::stoul(size[1]));
    return out;
}

target::Words words_of(const Compiled& compiled, const std::string& file) {
    for (const auto& [name, bytes] : compiled.files) {
        if (name != file) continue;
        target::Words words(bytes.size() / 4);
        std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
        return words;
    }
    ADD_FAILURE() << file;
    return {};
}

Layout reflected(const spirv_cross::Compiler& shader, const std::string& block) {
    Layout out;
    for (const auto& buffer : shader.get_shader_resources().uniform_buffers) {
        if (shader.get_name(buffer.base_type_id) != block) continue;
        const spirv_cross::SPIRType& type = shader.get_type(buffer.base_type_id);
        for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
            out[shader.get_member_name(buffer.base_type_id, i)] = shader.type_struct_member_offset(type, i);
        }
        out["size"] = static_cast<std::uint32_t>(shader.get_declared_struct_size(type));
    }
    return out;
}

Compiled compile_sample(const std::string& stem, layers::Numbers numbers = layers::Numbers::baked) {
    std::filesystem::path path = test::source_dir() / "materials" / (stem + ".json");
    RealFiles files;
    Diags diags;
    CompileRequest request{.source = std::make_shared<Source>(Source{path.string(), test::read_file(path)}),
                           .stem = stem,
                           .roots = {path.parent_path()}};
    request.numbers = numbers;
    auto out = compile_material(request, files, target::embedded_library(), diags);
    EXPECT_TRUE(out) << render(diags);
    return out ? std::move(*out) : Compiled{};
}

TEST(Contract, BlocksLieAsDocumented) {
    Compiled compiled = compile_sample("layered");
    spirv_cross::Compiler vertex(words_of(compiled, "layered.forward.vert.spv"));
    EXPECT_EQ(reflected(vertex, "SgFrameBlock"), documented("SgFrameBlock"));
    EXPECT_EQ(reflected(vertex, "SgObjectBlock"), documented("SgObjectBlock"));
}

#define SG_FIELD(block, field) \
    { #field, static_cast < std::uint32_t>(offsetof(runtime::block, field)) }
TEST(Contract, TheRendererFillsBlocksAsDocumented) {
    Layout frame = {SG_FIELD(FrameBlock, clip_from_relative), SG_FIELD(FrameBlock, relative_from_screen),
                    SG_FIELD(FrameBlock, camera_position),    SG_FIELD(FrameBlock, view_direction),
                    SG_FIELD(FrameBlock, light_direction),    SG_FIELD(FrameBlock, light_radiance),
                    SG_FIELD(FrameBlock, ambient_radiance),   SG_FIELD(FrameBlock, time_view),
                    {"size", sizeof(runtime::FrameBlock)}};
    EXPECT_EQ(frame, documented("SgFrameBlock"));
    Layout object = {SG_FIELD(ObjectBlock, relative_from_object),
                     SG_FIELD(ObjectBlock, normal_from_object),
                     {"size", sizeof(runtime::ObjectBlock)}};
    EXPECT_EQ(object, documented("SgObjectBlock"));
}
#undef SG_FIELD

// The manifest's parameter offsets are those of the compiled block.
TEST(Contract, ParametersLieWhereTheManifestSays) {
    Compiled compiled = compile_sample("layered");
    spirv_cross::Compiler fragment(words_of(compiled, "layered.forward.frag.spv"));
    Layout block = reflected(fragment, "SgMaterialBlock");
    ASSERT_EQ(block.size(), 4u);
    const std::string& manifest = compiled.files.back().second;
    for (const auto& [member, offset] : block) {
        if (member == "size") continue;
        std::regex row("\"name\": \"" + member.substr(2) +
                       "\",\\s*\"type\": \"\\w+\",\\s*\"offset\": " + std::to_string(offset) + ",");
        EXPECT_TRUE(std::regex_search(manifest, row)) << member << " at " << offset;
    }
}

// Two derived parameters may have one name for people, but not one member of the block.
TEST(Contract, DerivedParametersLieWhereTheManifestSays) {
    Compiled compiled = compile_sample("mossy_rock", layers::Numbers::uniforms);
    spirv_cross::Compiler fragment(words_of(compiled, "mossy_rock.forward.frag.spv"));
    Layout block = reflected(fragment, "SgMaterialBlock");
    const std::string& manifest = compiled.files.back().second;
    std::regex row("\"member\": \"(\\w+)\",\\s*\"type\": \"\\w+\",\\s*\"offset\": (\\d+)");
    Layout listed;
    int count = 0;
    for (std::sregex_iterator it(manifest.begin(), manifest.end(), row), end; it != end; ++it, ++count) {
        const std::string member = (*it)[1];
        EXPECT_TRUE(listed.emplace(member, std::stoul((*it)[2])).second) << "twice: " << member;
        EXPECT_EQ(block.count(member), 1u) << member;
        EXPECT_EQ(block[member], listed[member]) << member;
    }
    EXPECT_GE(count, 10);
}

// Every input and resource of every shader stands in the manifest, at its number.
TEST(Contract, ShadersUseWhatTheManifestLists) {
    for (const char* stem : {"normal_map", "two_unwraps", "layered"}) {
        Compiled compiled = compile_sample(stem);
        const std::string& manifest = compiled.files.back().second;
        for (const char* entry : {"forward", "normal", "debug"}) {
            for (const char* stage : {"vert", "frag"}) {
                spirv_cross::Compiler shader(
                    words_of(compiled, std::string(stem) + "." + entry + "." + stage + ".spv"));
                auto resources = shader.get_shader_resources(shader.get_active_interface_variables());
                std::smatch
                    head;  // a vertex input may have the same name, so what follows the name counts too
                ASSERT_TRUE(std::regex_search(
                    manifest, head,
                    std::regex(std::string("\"name\": \"") + entry + "\",\\s+\"stages\": \\[\\s+\\{")));
                auto begin = static_cast<std::size_t>(head.position());
                std::string section = manifest.substr(begin, manifest.find("\"views\"", begin) - begin);
                auto listed = [&](const spirv_cross::Resource& r, const std::string& kind) {
                    std::regex row("\"set\": " +
                                   std::to_string(shader.get_decoration(r.id, spv::DecorationDescriptorSet)) +
                                   ",\\s*\"binding\": " +
                                   std::to_string(shader.get_decoration(r.id, spv::DecorationBinding)) +
                                   ",\\s*\"kind\": \"" + kind + "\"");
                    EXPECT_TRUE(std::regex_search(section, row))
                        << stem << "." << entry << "." << stage << ": " << r.name;
                };
                for (const auto& r : resources.uniform_buffers) listed(r, "uniform_buffer");
                for (const auto& r : resources.separate_images) listed(r, "texture");
                for (const auto& r : resources.separate_samplers) listed(r, "sampler");
                EXPECT_TRUE(resources.push_constant_buffers.empty());
                EXPECT_TRUE(resources.sampled_images.empty());
                if (std::string(stage) != "vert") continue;
                for (const auto& r : resources.stage_inputs) {
                    std::string name = r.name.substr(std::string("sg_vertex_").size());
                    std::regex row("\"name\": \"" + name + "\",\\s*\"location\": " +
                                   std::to_string(shader.get_decoration(r.id, spv::DecorationLocation)) +
                                   ",");
                    EXPECT_TRUE(std::regex_search(section, row)) << r.name;
                }
            }
        }
    }
}

// An opacity without an alpha test shows in the lit picture alone: the other entries ask for nothing of it.
TEST(Contract, EntriesAskForWhatTheyUse) {
    MemoryFiles files;
    files.contents["/m/mask.png"] = "hashed, not decoded";
    Diags diags;
    const std::string text =
        R"({ "version": 1, "textures": { "m": { "file": "mask.png", "encoding": "mask" } },
        "surface": { "opacity": { "texture": "m", "channel": "r", "uv": 1 } } })";
    CompileRequest request{
        .source = std::make_shared<Source>(Source{"m.json", text}), .stem = "m", .roots = {"/m"}};
    auto out = compile_material(request, files, target::embedded_library(), diags);
    ASSERT_TRUE(out) << render(diags);
    const std::string& manifest = out->files.back().second;
    auto section = [&](const std::string& entry) {
        std::size_t begin = manifest.find("\"m." + entry + ".vert.spv\"");
        return manifest.substr(begin, manifest.find("\"views\"", begin) - begin);
    };
    EXPECT_NE(section("forward").find("\"uv1\""), std::string::npos);
    EXPECT_NE(section("forward").find("\"texture\""), std::string::npos);
    EXPECT_EQ(section("normal").find("\"uv1\""), std::string::npos) << section("normal");
    EXPECT_EQ(section("normal").find("\"texture\""), std::string::npos);
    spirv_cross::Compiler vertex(words_of(*out, "m.normal.vert.spv"));
    EXPECT_EQ(vertex.get_shader_resources().stage_outputs.size(), 1u);  // the normal alone
}

}  // namespace
}  // namespace sg
