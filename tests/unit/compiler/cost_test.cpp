// What explain, the manifest and budgets count: the SPIR-V that is shipped, held against its assembly text.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "compile.hpp"
#include "explain.hpp"

namespace sg {
namespace {

// A material of these layers over the textures `n`, a normal map, and `h`, a height.
std::string material(const std::string& layers) {
    return R"({ "version": 1, "textures": { "n": { "file": "n.png", "encoding": "tangent_normal" }, )"
           R"("h": { "file": "h.png", "encoding": "height" } }, "bump": [ { "layers": [ )" +
           layers + " ] } ] }\n";
}

// Of the user: it reads the map three times, once in a loop, and asks for its size.
constexpr std::string_view kOwn = R"(vec2 slopes(texture2D map, sampler map_sampler, SgUv uv) {
    vec2 size = vec2(textureSize(sampler2D(map, map_sampler), 0));
    vec4 corners = textureGather(sampler2D(map, map_sampler), uv.st);
    vec2 sum = texelFetch(sampler2D(map, map_sampler), ivec2(0), 0).xy * corners.xy / size;
    for (int i = 0; i < 5; ++i) sum += textureLod(sampler2D(map, map_sampler), uv.st * float(i), 0.0).xy;
    return sum;
}
)";

class Costs : public testing::Test {
protected:
    Costs() { files_.contents = {{"/m/n.png", ""}, {"/m/h.png", ""}, {"/m/own.glsl", std::string(kOwn)}}; }

    static CompileRequest request(const std::string& text) {
        return {
            .source = std::make_shared<Source>(Source{"wall.json", text}), .stem = "wall", .roots = {"/m"}};
    }

    Compiled compile(const CompileRequest& request) {
        Diags diags;
        auto out = compile_material(request, files_, target::embedded_library(), diags);
        EXPECT_EQ(render(diags), "");
        return out ? std::move(*out) : Compiled{};
    }

    std::string faults(CompileRequest request, material::Cost cost, std::uint32_t limit) {
        request.budget[static_cast<std::size_t>(cost)] = material::Located<std::uint32_t>{limit, {}};
        Diags diags;
        compile_material(request, files_, target::embedded_library(), diags);
        return render(diags);
    }

    // The table of explain without instructions: name, reads and interpolants of each row.
    std::string explained(const std::string& text) {
        Diags diags;
        std::string whole =
            explain_material(request(text), files_, target::embedded_library(), diags).value_or("");
        static const std::regex kRow(R"(\n(.{51}) +(?:\d+|-?\d+ \(\d+ - \d+\)) {2,}(\S.*))"), kGaps("  +");
        std::string out;
        for (std::sregex_iterator row(whole.begin(), whole.end(), kRow), end; row != end; ++row)
            out += std::regex_replace((*row)[1].str() + "  " + (*row)[2].str(), kGaps, "  ") + "\n";
        return out;
    }

    // All that counts, everywhere that it is counted.
    void expect(const std::string& text, std::uint32_t reads, std::uint32_t interpolants) {
        const Compiled compiled = compile(request(text));
        const auto fragment =
            std::find_if(compiled.spirv_assembly.begin(), compiled.spirv_assembly.end(),
                         [](const NamedText& shader) { return shader.name == "forward.frag"; });
        ASSERT_NE(fragment, compiled.spirv_assembly.end());
        static const std::regex kRead("= OpImage(Sparse)?(Sample|Gather|DrefGather|Fetch)");
        EXPECT_EQ(std::distance(std::sregex_iterator(fragment->text.begin(), fragment->text.end(), kRead),
                                std::sregex_iterator()),
                  reads);
        const std::string& manifest = compiled.files.back().second;
        static const std::regex kManifestReads("\"texture_reads\": (\\d+)");
        std::smatch found;  // the first is the entry point forward
        ASSERT_TRUE(std::regex_search(manifest, found, kManifestReads));
        EXPECT_EQ(found[1].str(), std::to_string(reads));
        EXPECT_TRUE(
            explained(text).starts_with(fmt::format("(the whole shader)  {}  {}\n", reads, interpolants)))
            << explained(text);
        EXPECT_EQ(faults(request(text), material::Cost::texture_reads, reads), "");
        EXPECT_EQ(faults(request(text), material::Cost::texture_reads, reads - 1),
                  fmt::format("error: --budget texture_reads={}: the forward shader of 'wall.json' takes {} "
                              "texture reads [SG1402]\n",
                              reads - 1, reads));
        EXPECT_EQ(faults(request(text), material::Cost::interpolants, interpolants), "");
        EXPECT_EQ(faults(request(text), material::Cost::interpolants, interpolants - 1),
                  fmt::format("error: --budget interpolants={}: the forward shader of 'wall.json' takes {} "
                              "numbers from the vertex stage [SG1402]\n",
                              interpolants - 1, interpolants));
    }

private:
    MemoryFiles files_;
};

TEST_F(Costs, EveryReadOfAHeightMap) {
    expect(material(R"({ "kind": "height_map", "texture": "h", "method": "hq" })"), 7, 8);
    expect(material(R"({ "kind": "height_map", "texture": "h", "method": "screen" })"), 3, 8);
}

TEST_F(Costs, AQueryIsNoRead) {
    expect(material(R"({ "kind": "normal_map", "texture": "n", "scale": "displacement" })"), 1, 8);
}

TEST_F(Costs, ReadsInAFunctionOfTheUser) {
    expect(material(R"({ "kind": "custom", "file": "own.glsl", "function": "slopes", "returns": "derivative",
                         "uv": 0, "arguments": [{ "texture": "n" }, { "uv": 0 }] })"),
           3, 8);
}

// The IR keeps what is multiplied by 0 and a number without bounds; spirv-opt drops the read and the inputs.
TEST_F(Costs, NothingThatOnlySpirvOptDrops) {
    const std::string text = material(
        R"({ "id": "dead", "kind": "normal_map", "texture": "n", "basis": "vertex",
             "mask": { "op": "multiply", "a": 0, "b": { "op": "vertex_color", "channel": "r" } } },
           { "id": "live", "kind": "normal_map", "texture": "n", "uv": 1 })");
    expect(text, 1, 8);
    EXPECT_NE(compile(request(text)).optimised_ir.find("vertex_color"), std::string::npos);
    EXPECT_NE(explained(text).find("\ndead  normal_map  0 (1 - 1)  0 (8 - 8)\n"), std::string::npos)
        << explained(text);
}

}  // namespace
}  // namespace sg
