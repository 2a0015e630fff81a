// Every message that a material can cause, whole: cases/NAME.json in, cases/NAME.txt out. The file's name
// starts with the code that it is about.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compile.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;

const target::ShaderLibrary kLibrary = target::embedded_library();

std::string check(const std::string& name, std::string text, int* exit_code = nullptr) {
    MemoryFiles files;
    files.contents["/m/textures/a.png"] = "not read beyond its hash";
    files.contents["/secret.png"] = "must stay out of reach";
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "tests/errors/cases/shaders"))
        files.contents["/m/shaders/" + entry.path().filename().string()] = test::read_file(entry.path());
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "tests/errors/cases/bases"))
        files.contents["/m/bases/" + entry.path().filename().string()] = test::read_file(entry.path());
    files.contents["/m/" + name] = text;
    CompileRequest request{.source = std::make_shared<Source>(Source{name, std::move(text)})};
    request.stem = "case";
    request.roots = {"/m"};
    Diags diags;
    bool good = check_material(request, files, kLibrary, diags);
    EXPECT_EQ(good, !diags.has_errors());
    for (const std::string& read : files.reads) EXPECT_NE(read, "/secret.png");
    for (const Diagnostic& d : diags.all()) {
        EXPECT_TRUE(d.place.source) << "no place: " << d.message;
        EXPECT_EQ(std::count(d.message.begin(), d.message.end(), '\n'), 0) << d.message;
        EXPECT_NE(d.message.back(), '.') << d.message;
    }
    diags.sort();
    if (exit_code) *exit_code = diags.exit_code();
    return render(diags);
}

std::vector<fs::path> cases() {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "tests/errors/cases")) {
        if (entry.path().extension() == ".json") out.push_back(entry.path());
    }
    std::sort(out.begin(), out.end());
    return out;
}

TEST(Errors, WholeMessages) {
    for (const fs::path& path : cases()) {
        int exit_code = 0;
        std::string out = check("wall.json", test::read_file(path), &exit_code);
        EXPECT_EQ(exit_code, 1) << path;
        std::string stem = path.stem().string();
        std::string tag = stem.starts_with("SG") ? "[" + stem.substr(0, 6) + "]" : "";
        EXPECT_NE(out.find(tag), std::string::npos) << path << "\n" << out;
        test::expect_golden("errors/cases/" + stem + ".txt", out);
    }
}

// A number is a grey wherever a colour is wanted: the surface, and what colours are computed from.
TEST(Errors, ANumberIsAGrey) {
    auto module = [](const std::string& one, const std::string& two) {
        MemoryFiles files;
        const std::string text = R"({ "version": 1, "surface": { "base_color": )" + one +
                                 R"(, "emission": { "op": "add_color", "a": [0.1, 0.2, 0.3], "b": )" + two +
                                 " } } }";
        CompileRequest request{.source = std::make_shared<Source>(Source{"wall.json", text})};
        request.entries = {"forward"};
        Diags diags;
        auto compiled = compile_material(request, files, kLibrary, diags);
        EXPECT_TRUE(compiled) << render(diags);
        return compiled ? compiled->ir : "";
    };
    EXPECT_NE(module("0.4", "0.5"), "");
    EXPECT_EQ(module("0.4", "0.5"), module("[0.4, 0.4, 0.4]", "[0.5, 0.5, 0.5]"));
    EXPECT_NE(module("0.4", "0.5"), module("[0.4, 0.4, 0.4]", "[0.5, 0.5, 0.6]"));
}

TEST(Errors, TextThatIsNotUtf8) {
    EXPECT_EQ(check("wall.json", "{ \"version\": 1, \"name\": \"\xFF\" }"),
              "wall.json:1:26: error: syntax error while parsing value - invalid string: ill-formed UTF-8 "
              "byte [SG1004]\n"
              "{ \"version\": 1, \"name\": \"?\" }\n"
              "                         ^\n"
              "    save the file as UTF-8\n");
}

TEST(Errors, DepthIsRefused) {
    EXPECT_EQ(check("deep.json", std::string(200, '[')),
              "deep.json:1:129: error: nested deeper than 128 levels [SG1002]\n" + std::string(120, '[') +
                  "\n" + std::string(60, ' ') +
                  "^\n"
                  "    flatten or split the document\n");
}

TEST(Errors, FileThatCannotBeRead) {
    class Locked final : public Files {
    public:
        ReadResult read(const fs::path&) override { return {Status::unreadable, "", "Permission denied"}; }
        bool exists(const fs::path&) override { return true; }
        std::vector<std::string> names(const fs::path&) override { return {}; }
        fs::path canonical(const fs::path& path) override { return path.lexically_normal(); }
        std::string write_all(const std::vector<std::pair<fs::path, std::string>>&) override {
            return "never";
        }
    } files;
    CompileRequest request{
        .source = std::make_shared<Source>(Source{
            "wall.json", R"({"version":1,"textures":{"a":{"file":"a.png","encoding":"tangent_normal"}}})"})};
    request.roots = {"/m"};
    Diags diags;
    EXPECT_FALSE(check_material(request, files, kLibrary, diags));
    EXPECT_EQ(render(diags),
              "wall.json:1:38: error: cannot read 'a.png': Permission denied [SG1303]\n"
              "{\"version\":1,\"textures\":{\"a\":{\"file\":\"a.png\",\"encoding\":\"tangent_normal\"}}}\n"
              "                                     ^^^^^^^\n"
              "    at /textures/a/file: check its permissions\n");
    EXPECT_EQ(diags.exit_code(), 4);
    EXPECT_FALSE(write_or_report(files, {}, diags));
    EXPECT_EQ(render(diags.all().back()), "error: never [SG1304]\n");
}

// Chunks of a PNG in front of its texels; its size, and what tells the colours.
std::string chunk(const std::string& type, const std::string& data) {
    return std::string(3, '\0') + static_cast<char>(data.size()) + type + data + "crc.";
}
std::string png(const std::string& chunks, const std::string& behind = "") {
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", std::string("\0\0\0\1\0\0\0\1\x8\2\0\0\0", 13)) + chunks +
           chunk("IDAT", "texels") + behind + chunk("IEND", "");
}
std::string gamma_chunk(std::uint32_t number) {
    std::string data;
    for (int shift : {24, 16, 8, 0}) data += static_cast<char>(number >> shift & 255u);
    return chunk("gAMA", data);
}
const std::string kSrgbChunk = chunk("sRGB", std::string(1, '\0'));

// What a check says of a material whose texture "map" is `declared` so and whose file holds `bytes`.
std::string check_texture(const std::string& declared, const std::string& bytes,
                          const std::string& layer = R"("kind": "normal_map", "texture": "map")") {
    MemoryFiles files;
    files.contents["/m/a.png"] = bytes;
    const std::string text = R"({ "version": 1,
  "textures": { "map": { "file": "a.png", )" +
                             declared +
                             R"( } },
  "bump": [ { "layers": [ { )" +
                             layer + R"( } ] } ],
  "surface": { "emission": [0, 0, 0] } }
)";
    CompileRequest request{.source = std::make_shared<Source>(Source{"wall.json", text}), .roots = {"/m"}};
    Diags diags;
    EXPECT_TRUE(check_material(request, files, kLibrary, diags));
    EXPECT_EQ(diags.exit_code(), 0);
    return render(diags);
}

const std::string kNormals = R"("encoding": "tangent_normal")";

TEST(Errors, APngThatSaysOtherwiseThanItsTextureIsWarnedOf) {
    EXPECT_EQ(
        check_texture(kNormals, png(kSrgbChunk)),
        "wall.json:2:34: warning: 'a.png' says by its chunk 'sRGB' that it holds sRGB colours, but texture "
        "'map' of encoding 'tangent_normal' is read as linear numbers, expected a file without that chunk "
        "[SG1215]\n"
        "  \"textures\": { \"map\": { \"file\": \"a.png\", \"encoding\": \"tangent_normal\" } },\n"
        "                                 ^^^^^^^\n"
        "    at /textures/map/file: export it without that chunk, or as what the texture is declared to "
        "be\n");
    EXPECT_EQ(
        check_texture(R"("encoding": "height")", png(gamma_chunk(45455)),
                      R"("kind": "height_map", "texture": "map")"),
        "wall.json:2:34: warning: 'a.png' says by its chunk 'gAMA' that it holds numbers of gamma 2.2, but "
        "texture 'map' of encoding 'height' is read as linear numbers, expected a file without that chunk "
        "[SG1215]\n"
        "  \"textures\": { \"map\": { \"file\": \"a.png\", \"encoding\": \"height\" } },\n"
        "                                 ^^^^^^^\n"
        "    at /textures/map/file: export it without that chunk, or as what the texture is declared to "
        "be\n");
    const std::string node = R"("kind": "noise", "mask": { "texture": "map", "channel": "r" })";
    EXPECT_EQ(
        check_texture(R"("encoding": "color")", png(gamma_chunk(100000)), node),
        "wall.json:2:34: warning: 'a.png' says by its chunk 'gAMA' that it holds linear numbers, but "
        "texture 'map' of encoding 'color' is read as sRGB colours, expected \"color_space\": \"linear\" or "
        "a file without that chunk [SG1215]\n"
        "  \"textures\": { \"map\": { \"file\": \"a.png\", \"encoding\": \"color\" } },\n"
        "                                 ^^^^^^^\n"
        "    at /textures/map/file: export it without that chunk, or as what the texture is declared to "
        "be\n");
}

TEST(Errors, APngThatSaysWhatItsTextureIsOrNothingIsNotWarnedOf) {
    const std::string colors = R"("encoding": "color")";
    const std::string node = R"("kind": "noise", "mask": { "texture": "map", "channel": "r" })";
    EXPECT_EQ(check_texture(kNormals, png("")), "");
    EXPECT_EQ(check_texture(kNormals, png(gamma_chunk(100000))), "");
    EXPECT_EQ(check_texture(kNormals, png(gamma_chunk(0))), "");            // says nothing
    EXPECT_EQ(check_texture(kNormals, png("", kSrgbChunk)), "");            // behind the texels
    EXPECT_EQ(check_texture(kNormals, png(kSrgbChunk).substr(0, 40)), "");  // cut off
    EXPECT_EQ(check_texture(kNormals, "GIF89a" + kSrgbChunk), "");
    EXPECT_EQ(check_texture(kNormals, png(kSrgbChunk), R"("kind": "noise")"), "");  // nothing reads it
    EXPECT_EQ(check_texture(colors, png(kSrgbChunk), node), "");
    EXPECT_EQ(check_texture(colors, png(gamma_chunk(45455)), node), "");
    EXPECT_EQ(check_texture(colors, png(gamma_chunk(100000) + kSrgbChunk), node), "");
    EXPECT_EQ(check_texture(colors + R"(, "color_space": "linear")", png(kSrgbChunk), node), "");
}

// The texture of a parameter is the declared one, or the one that an instance puts in its place; each is told
// once.
TEST(Errors, APngOfAParameterIsWarnedOfOnce) {
    const std::string layers =
        R"({ "kind": "normal_map", "texture": "$t" }, { "kind": "normal_map", "texture": "map" })";
    const std::string base = R"({ "version": 1,
  "textures": { "map": { "file": "a.png", "encoding": "tangent_normal" } },
  "parameters": { "t": { "type": "texture", "default": "map" } },
  "bump": [ { "layers": [ )" +
                             layers + " ] } ] }\n";
    auto check_instance = [&](const std::string& text) {
        MemoryFiles files;
        files.contents["/m/a.png"] = files.contents["/m/b.png"] = png(kSrgbChunk);
        files.contents["/m/base.json"] = base;
        CompileRequest request{.source = std::make_shared<Source>(Source{"wall.json", text}),
                               .roots = {"/m"}};
        Diags diags;
        EXPECT_TRUE(check_material(request, files, kLibrary, diags));
        return render(diags);
    };
    const std::string said =
        " says by its chunk 'sRGB' that it holds sRGB colours, but texture 'map' of encoding "
        "'tangent_normal' is read "
        "as linear numbers, expected a file without that chunk [SG1215]\n"
        "  \"textures\": { \"map\": { \"file\": \"a.png\", \"encoding\": \"tangent_normal\" } },\n"
        "                                 ^^^^^^^\n"
        "    at /textures/map/file: export it without that chunk, or as what the texture is declared to be\n";
    EXPECT_EQ(check_instance(base), "wall.json:2:34: warning: 'a.png'" + said);
    EXPECT_EQ(
        check_instance(R"({ "version": 1, "extends": "base.json", "parameters": { "t": "b.png" } })"),
        "base.json:2:34: warning: 'a.png'" + said +
            "wall.json:1:62: warning: 'b.png' says by its chunk 'sRGB' that it holds sRGB colours, but "
            "texture "
            "'$t' of encoding 'tangent_normal' is read as linear numbers, expected a file without that chunk "
            "[SG1215]\n"
            "{ \"version\": 1, \"extends\": \"base.json\", \"parameters\": { \"t\": \"b.png\" } }\n"
            "                                                             ^^^^^^^\n"
            "    at /parameters/t: export it without that chunk, or as what the texture is declared to be\n");
}

// Damaged versions of a good material: an answer or an error, never a crash, and text never slips through.
TEST(Errors, RandomDamageNeverCrashes) {
    unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::string good = test::read_file(test::source_dir() / "materials/layered.json");
    ASSERT_FALSE(good.empty());
    auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    for (int round = 0; round < 3000; ++round) {
        std::string text = good;
        for (std::size_t k = pick(4) + 1; k > 0; --k) {
            std::size_t at = pick(text.size());
            switch (pick(4)) {
                case 0:
                    text[at] = static_cast<char>(pick(256));
                    break;
                case 1:
                    text.erase(at, pick(12) + 1);
                    break;
                case 2:
                    text.insert(at, text.substr(pick(text.size()), pick(12)));
                    break;
                default:
                    text.insert(at, std::string(1, "{}[]\",:-9e$"[pick(11)]));
            }
        }
        check("damaged.json", text);
    }
}

}  // namespace
}  // namespace sg
