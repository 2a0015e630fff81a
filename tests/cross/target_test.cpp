// The targets themselves: which there are, what the command line makes of them, what one lacks.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "compile.hpp"
#include "tests/cross/gl.hpp"
#include "tests/cross/process.hpp"
#include "tests/cross/results.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names(const std::vector<const target::Target*>& targets) {
    std::vector<std::string> out;
    for (const target::Target* t : targets) out.emplace_back(t->name);
    return out;
}
std::vector<std::string> selected(const std::vector<std::string>& words) {
    return names(target::select_targets(words));
}

TEST(Targets, NamesAndGroups) {
    using List = std::vector<std::string>;
    EXPECT_EQ(selected({"spirv"}), List{"spirv"});
    EXPECT_EQ(selected({"essl", "hlsl60", "essl300"}), (List{"hlsl60", "essl300", "essl310"}));
    EXPECT_EQ(selected({"msl", "hlsl", "glsl"}), (List{"hlsl50", "hlsl60", "msl21", "msl23", "glsl450"}));
    EXPECT_EQ(target::target_words(), (List{"spirv", "hlsl50", "hlsl", "hlsl60", "msl21", "msl", "msl23",
                                            "glsl450", "glsl", "essl300", "essl", "essl310"}));
}

TEST(Targets, EveryRowIsInTheDocs) {
    std::string text = test::read_file(test::source_dir() / "compiler/targets.md");
    for (const target::Target& t : target::all_targets()) {
        bool spirv = t.language == target::Language::spirv;
        std::string row = fmt::format("| `{}` | `{}` | `<stem>.<entry>.<vert\\|frag>.{}{}` | {} |", t.name,
                                      t.group, spirv ? "" : std::string(t.name) + ".", t.extension, t.doc);
        EXPECT_NE(text.find(row), text.npos) << "missing line:\n" << row;
    }
}

std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> out;
    if (!fs::exists(folder)) return out;
    for (const auto& entry : fs::directory_iterator(folder)) out.push_back(entry.path().filename().string());
    std::sort(out.begin(), out.end());
    return out;
}

TEST(Targets, TheCommandLineWritesWhatWasAskedFor) {
    const std::string sample = (test::source_dir() / "materials/normal_map.json").string();
    const fs::path out = scratch() / "asked";
    auto compile = [&](const std::string& list) {
        return run(fmt::format("'{}' compile '{}' -o '{}' --entry normal --target {} 2>&1", SG_SURFGRADC,
                               sample, out.string(), list));
    };
    Outcome unknown = compile("hlsl70");
    EXPECT_EQ(unknown.exit_code, 2) << unknown.text;
    EXPECT_EQ(files_below(out), std::vector<std::string>{});
    Outcome fine = compile("essl,hlsl60");
    EXPECT_EQ(fine.exit_code, 0) << fine.text;
    EXPECT_EQ(
        files_below(out),
        (std::vector<std::string>{
            "normal_map.json", "normal_map.normal.frag.essl300.glsl", "normal_map.normal.frag.essl310.glsl",
            "normal_map.normal.frag.hlsl60.hlsl", "normal_map.normal.vert.essl300.glsl",
            "normal_map.normal.vert.essl310.glsl", "normal_map.normal.vert.hlsl60.hlsl"}));
    auto stage =
        nlohmann::json::parse(test::read_file(out / "normal_map.json"))["entry_points"][0]["stages"][0];
    EXPECT_FALSE(stage.contains("file"));
    EXPECT_EQ(stage["targets"].size(), 3u);
}

TEST(Targets, SameBytesTwice) {
    for (const std::string& name : sample_names()) {
        Sample again = make_sample(name, name, drawn_library());
        EXPECT_EQ(again.texts, sample(name).texts) << name;
        EXPECT_EQ(again.manifest, sample(name).manifest) << name;
    }
}

// In one target no two resources of a kind share a place, and each has the same place wherever it is used.
TEST(Targets, PlacesNeverOverlap) {
    for (const std::string& name : sample_names()) {
        std::map<std::string, std::string> by_place, by_resource;
        const nlohmann::json manifest = nlohmann::json::parse(sample(name).manifest);
        for (const auto& entry : manifest["entry_points"]) {
            for (const auto& stage : entry["stages"]) {
                for (const auto& text : stage["targets"]) {
                    for (const auto& row : text["bindings"]) {
                        std::string target =
                            text["target"].get<std::string>() + " " + row["kind"].get<std::string>() + " ";
                        std::string resource =
                            fmt::format("{}{} {}", target, row["set"].dump(), row["binding"].dump());
                        std::string place = target;
                        for (const char* key : {"register", "space", "index", "unit"})
                            place += row.contains(key) ? row[key].dump() + " " : "";
                        EXPECT_EQ(by_place.try_emplace(place, resource).first->second, resource)
                            << name << ": " << place;
                        EXPECT_EQ(by_resource.try_emplace(resource, place).first->second, place)
                            << name << ": " << resource;
                    }
                }
            }
        }
        EXPECT_GT(by_place.size(), 10u);
    }
}

// How a text declares the vertex input of a manifest's row.
std::string declaration_of(const nlohmann::json& row, target::Language language) {
    const std::string location = row.at("location").dump();
    if (language == target::Language::hlsl) return " : " + row.at("semantic").get<std::string>() + ";";
    const std::string variable = " " + row.at("variable").get<std::string>();
    if (language == target::Language::msl) return variable + " [[attribute(" + location + ")]];";
    return "layout\\(location = " + location + "\\) in \\w+" + variable + ";";
}

// What an engine binds by: the names and numbers that the manifest states stand in the texts.
TEST(Targets, TextsDeclareWhatTheManifestStates) {
    std::size_t rows = 0;
    for (const std::string& name : sample_names()) {
        const nlohmann::json manifest = nlohmann::json::parse(sample(name).manifest);
        for (const auto& entry : manifest["entry_points"]) {
            for (const auto& text : entry["stages"][0]["targets"]) {
                const std::string file = text["file"], &written = sample(name).texts.at(file);
                const target::Language language =
                    target::find_target(text["target"].get<std::string>())->language;
                ASSERT_EQ(text["vertex_inputs"].size(), entry["vertex_inputs"].size()) << file;
                for (std::size_t i = 0; i < text["vertex_inputs"].size(); ++i, ++rows) {
                    const auto& row = text["vertex_inputs"][i];
                    EXPECT_EQ(row["location"], entry["vertex_inputs"][i]["location"]) << file;
                    const std::string declared = declaration_of(row, language);
                    const bool gl = language == target::Language::glsl || language == target::Language::essl;
                    EXPECT_TRUE(gl ? std::regex_search(written, std::regex(declared))
                                   : written.find(declared) != written.npos)
                        << file << ": " << declared;
                }
                EXPECT_NE(written.find(" " + text["function"].get<std::string>() + "("), written.npos)
                    << file;
            }
        }
    }
    EXPECT_GT(rows, 1000u);
}

// The library with another body of sg_stage_sample.
target::ShaderLibrary library_with(const std::string& body) {
    target::ShaderLibrary library = target::embedded_library();
    std::string& text = library.files.at("stage/fragment.glsl");
    const std::string plain = "return texture(sampler2D(image, filtering), uv.st);";
    EXPECT_NE(text.find(plain), text.npos);
    text.replace(text.find(plain), plain.size(), body);
    return library;
}

// Bilinear filtering by hand: the same picture whether four texels are gathered or, as in ESSL 3.00, read one
// by one.
TEST(Targets, GatherIsFourReadsInEssl300) {
    Sample gathered =
        make_sample("normal_map", "normal_map_gather",
                    library_with("vec2 p = uv.st * vec2(textureSize(sampler2D(image, filtering), 0)) - 0.5; "
                                 "vec2 f = p - floor(p);\n"
                                 "    vec4 g = textureGather(sampler2D(image, filtering), (floor(p) + 1.0) / "
                                 "vec2(textureSize(sampler2D(image, filtering), 0)));\n"
                                 "    float red = mix(mix(g.w, g.z, f.x), mix(g.x, g.y, f.x), f.y); return "
                                 "vec4(red, 0.5 * red, 1.0, 1.0);"));
    for (const char* name : {"glsl450", "essl310", "essl300"}) {
        const target::Target& target = *target::find_target(name);
        EXPECT_EQ(gathered.texts.at(fmt::format("normal_map_gather.normal.frag.{}.glsl", name))
                          .find("textureGather") == std::string::npos,
                  std::string_view(name) == "essl300");
        if (!missing_tool(target).empty()) GTEST_SKIP() << name << ": " << missing_tool(target);
        Difference d = compare(reference(gathered), draw_all({drawing(gathered, target)}).at(0).pixels);
        fmt::print("gather, {}: largest {:.2e}, 99.9 % {:.2e}\n", name, d.largest, d.p999);
        EXPECT_GT(d.both, 5000u);
        EXPECT_LE(d.p999, limit_of(target).p999);
        EXPECT_LE(d.largest, limit_of(target).largest);
    }
}

std::string messages_of(const std::string& body, const std::vector<std::string>& targets) {
    const fs::path path = test::source_dir() / "materials/normal_map.json";
    RealFiles files;
    CompileRequest request;
    request.source = std::make_shared<Source>(Source{"wall.json", test::read_file(path)});
    request.stem = "wall";
    request.roots = {path.parent_path()};
    request.entries = {"normal"};
    request.targets = target::select_targets(targets);
    Diags diags;
    auto compiled = compile_material(request, files, library_with(body), diags);
    EXPECT_EQ(compiled.has_value(), !diags.has_errors());
    EXPECT_EQ(diags.exit_code(), diags.has_errors() ? 1 : 0);
    return render(diags);
}

TEST(Targets, WhatATargetLacksIsRefusedByName) {
    const std::string levels = "return vec4(float(textureQueryLevels(sampler2D(image, filtering))));";
    const std::string level = "return vec4(textureQueryLod(sampler2D(image, filtering), uv.st).x);";
    const std::string green = "return textureGather(sampler2D(image, filtering), uv.st, 1);";
    EXPECT_EQ(messages_of(levels, {"spirv", "hlsl", "msl23", "glsl"}), "");
    EXPECT_EQ(messages_of(green, {"spirv", "hlsl", "msl", "glsl", "essl310"}), "");
    EXPECT_EQ(messages_of(levels, {"essl"}),
              "error: 'wall.normal' asks for the number of levels of a texture (textureQueryLevels), which "
              "essl300 cannot express [SG1401]\n"
              "error: 'wall.normal' asks for the number of levels of a texture (textureQueryLevels), which "
              "essl310 cannot express [SG1401]\n");
    EXPECT_EQ(messages_of(level, {"essl310"}),
              "error: 'wall.normal' asks for the level of detail of a texture (textureQueryLod), which "
              "essl310 cannot express [SG1401]\n");
    EXPECT_EQ(messages_of(green, {"essl"}),
              "error: 'wall.normal' gathers texels of another channel than red, with offsets or with a "
              "comparison (textureGather), which essl300 "
              "cannot express [SG1401]\n");
}

// Each is written wrong or refused in the cross-compiler's own words where nobody looks before.
TEST(Targets, WhatATextWouldSayWrongIsRefusedByName) {
    struct Case {
        const char* body;
        std::vector<std::string> fine, refused;
        const char* what;
    };
    const std::string plain = "return textureGrad(sampler2D(image, filtering), uv.st, uv.dx, uv.dy)";
    const Case cases[] = {
        {" * float(bitCount(uint(uv.st.x)));",
         {"hlsl", "msl", "glsl", "essl310"},
         {"essl300"},
         "works on single bits (bitfieldExtract and its kin)"},
        {" * unpackUnorm4x8(uint(uv.st.x));",
         {"hlsl", "msl", "glsl", "essl310"},
         {"essl300"},
         "packs four numbers into one (packUnorm4x8 and its kin)"},
        {" * ldexp(uv.st.x, 2);",
         {"hlsl", "msl", "glsl", "essl310"},
         {"essl300"},
         "takes numbers apart (frexp, ldexp)"},
        {" * asinh(uv.st.x);",
         {"msl", "glsl", "essl"},
         {"hlsl50", "hlsl60"},
         "asks for an area hyperbolic function (asinh, acosh, atanh)"},
        {" * float(double(uv.st.x) * double(uv.st.y));",
         {"hlsl", "glsl"},
         {"msl21", "msl23", "essl300", "essl310"},
         "computes in double precision"},
        {" * textureQueryLod(sampler2D(image, filtering), uv.st).x;",
         {"hlsl", "msl23", "glsl"},
         {"msl21", "essl300", "essl310"},
         "asks for the level of detail of a texture (textureQueryLod)"},
        {" * textureGatherOffsets(sampler2D(image, filtering), uv.st, ivec2[4](ivec2(0), ivec2(1), ivec2(2), "
         "ivec2(3)));",
         {"glsl"},
         {"hlsl50", "hlsl60", "msl21", "msl23", "essl310"},
         "gathers texels with four offsets (textureGatherOffsets)"},
    };
    for (const Case& row : cases) {
        EXPECT_EQ(messages_of(plain + row.body, row.fine), "") << row.body;
        std::string expected;
        for (const std::string& target : row.refused)
            expected +=
                fmt::format("error: 'wall.normal' {}, which {} cannot express [SG1401]\n", row.what, target);
        EXPECT_EQ(messages_of(plain + row.body, row.refused), expected);
    }
    std::string carry, expected;
    carry = "uint carry; uint sum = uaddCarry(uint(uv.st.x), 7u, carry); " + plain + " * float(sum + carry);";
    for (const char* target : {"hlsl50", "hlsl60", "essl300"})
        expected += fmt::format(
            "error: 'wall.normal' adds or subtracts with a carry (uaddCarry, usubBorrow), which {} "
            "cannot express [SG1401]\n",
            target);
    EXPECT_EQ(messages_of(carry, {"hlsl", "essl300"}), expected);
    EXPECT_EQ(messages_of(carry, {"msl", "glsl", "essl310"}), "");
}

}  // namespace
}  // namespace sg::cross
