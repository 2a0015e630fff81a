#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/diag.hpp"
#include "base/files.hpp"
#include "base/ice.hpp"

namespace sg {
namespace {

SourcePtr source(std::string text) {
    return std::make_shared<Source>(Source{"a.json", std::move(text)});
}

TEST(Source, ColumnsCountCodePoints) {
    std::string text = "ab\n\xC3\xA9\xE2\x82\xACx\n";
    EXPECT_EQ(line_column(text, 0).column, 1u);
    EXPECT_EQ(line_column(text, 3).line, 2u);
    EXPECT_EQ(line_column(text, 8).column, 3u);   // behind a two-byte and a three-byte character
    EXPECT_EQ(line_column(text, 1000).line, 3u);  // past the end: the end
}

TEST(Diag, PointsWithACaretUnderEachCharacter) {
    Diags diags;
    diags.error(Code::unknown_kind, {source("{\n  \"k\u00e9\": \"bad\" }"), {11, 16}, "/k"}, "no such kind");
    EXPECT_EQ(render(diags),
              "a.json:2:9: error: no such kind [SG1105]\n"
              "  \"k\u00e9\": \"bad\" }\n"
              "        ^^^^^\n"
              "    at /k: use a kind from `surfgradc kinds`\n");
}

TEST(Diag, CutsLongLinesAroundThePlace) {
    std::string text = std::string(500, 'a') + "X" + std::string(500, 'b');
    Diags diags;
    diags.error(Code::json_syntax, {source(text), {500, 501}, ""}, "here");
    std::string out = render(diags);
    EXPECT_EQ(out, "a.json:1:501: error: here [SG1001]\n" + std::string(60, 'a') + "X" +
                       std::string(59, 'b') + "\n" + std::string(60, ' ') +
                       "^\n"
                       "    fix the text at the place that the caret marks\n");
}

TEST(Diag, TabsAndControlCharactersDoNotMoveTheCaret) {
    Diags diags;
    diags.error(Code::json_syntax, {source("\t\x01x"), {2, 3}, ""}, "here");
    EXPECT_EQ(render(diags),
              "a.json:1:3: error: here [SG1001]\n  x\n  ^\n"
              "    fix the text at the place that the caret marks\n");
}

TEST(Diag, JsonFormIsOneObjectALine) {
    Diags diags;
    diags.error(Code::out_of_range, {source("{\"a\": 5}"), {6, 7}, "/a"}, "'a' is \"5\"");
    EXPECT_EQ(
        render(diags, DiagFormat::json),
        "{\"severity\":\"error\",\"code\":\"SG1104\",\"message\":\"'a' is "
        "\\\"5\\\"\",\"file\":\"a.json\",\"line\":1,"
        "\"column\":7,\"end_line\":1,\"end_column\":8,\"byte_begin\":6,\"byte_end\":7,\"pointer\":\"/a\","
        "\"mend\":\"choose a number inside the range\"}\n");
}

TEST(Diag, ExitCodeNamesWhoMustAct) {
    Diags diags;
    EXPECT_EQ(diags.exit_code(), 0);
    diags.warning(Code::json_syntax, {}, "only a warning");
    EXPECT_EQ(diags.exit_code(), 0);
    diags.error(Code::file_unwritable, "disk full");
    EXPECT_EQ(diags.exit_code(), 4);
    diags.error(Code::json_syntax, "bad text");
    EXPECT_EQ(diags.exit_code(), 1);
}

TEST(Diag, SortsByPlace) {
    Diags diags;
    SourcePtr s = source("abcdef");
    diags.error(Code::json_syntax, {s, {4, 5}, ""}, "second");
    diags.error(Code::json_syntax, {s, {1, 2}, ""}, "first");
    diags.sort();
    EXPECT_EQ(diags.all()[0].message, "first");
}

TEST(Diag, NearNames) {
    const std::string_view names[] = {"normal_map", "noise", "decal"};
    EXPECT_EQ(did_you_mean("normal_mpa", names), ", did you mean 'normal_map'?");
    EXPECT_EQ(did_you_mean("zebra", names), "");
    const std::string_view shorts[] = {"id", "a", "uv", "mask", "kind"};
    EXPECT_EQ(did_you_mean("knid", shorts), ", did you mean 'kind'?");
    EXPECT_EQ(did_you_mean("masks", shorts), ", did you mean 'mask'?");
    for (const std::string_view word : {"y", "ab", "king_of", "und", "set"})
        EXPECT_EQ(did_you_mean(word, shorts), "") << word;
    EXPECT_EQ(did_you_mean("kind", std::span(shorts).first(4)), "");
    EXPECT_EQ(one_of(names), "'normal_map', 'noise' or 'decal'");
    EXPECT_EQ(printable("a\nb"), "a\\x0ab");
}

TEST(Diag, CodesAreUniqueAndSayWhatToDo) {
    for (const CodeInfo& info : all_codes()) {
        EXPECT_FALSE(info.cause.empty());
        EXPECT_FALSE(info.mend.empty());
        EXPECT_EQ(&code_info(info.code), &info) << "two rows with the number " << static_cast<int>(info.code);
    }
}

TEST(Files, WriteAllWritesAllOrNothing) {
    namespace fs = std::filesystem;
    fs::path dir = fs::temp_directory_path() / ("surfgrad-files-" + std::to_string(::getpid()));
    fs::create_directories(dir / "taken");  // a folder stands where the second file should go
    RealFiles files;
    std::string reason = files.write_all({{dir / "a.txt", "a"}, {dir / "taken", "b"}});
    EXPECT_EQ(reason, "cannot write '" + (dir / "taken").string() + "': it is a folder");
    EXPECT_FALSE(fs::exists(dir / "a.txt"));
    EXPECT_EQ(std::distance(fs::directory_iterator(dir), fs::directory_iterator()), 1);  // no temporary left
    EXPECT_EQ(files.write_all({{dir / "sub" / "a.txt", "a"}}), "");
    EXPECT_EQ(files.read(dir / "sub" / "a.txt").bytes, "a");
    EXPECT_EQ(files.read(dir).status, Files::Status::folder);
    EXPECT_EQ(files.read(dir / "none").status, Files::Status::missing);
    fs::remove_all(dir);
}

TEST(Files, HashIsTheKnownOne) {
    // XXH3-128 of the empty input, from the algorithm's published test vectors.
    EXPECT_EQ(content_hash(""), "xxh3:99aa06d3014798d86001c324468d497f");
    EXPECT_NE(content_hash("a"), content_hash("b"));
}

TEST(IceDeathTest, OurOwnBugsExitWith3) {
    EXPECT_EXIT(SG_ASSERT(1 == 2), testing::ExitedWithCode(3), "internal error: assertion failed: 1 == 2");
}

}  // namespace
}  // namespace sg
