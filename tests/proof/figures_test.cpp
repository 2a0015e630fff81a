// The gallery: its claims hold and can fail, its faults are found with their place, its page works in a
// browser.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/files.hpp"
#include "tests/cross/process.hpp"
#include "tests/support/golden.hpp"

namespace sg::proof {
namespace {

namespace fs = std::filesystem;

fs::path figures_folder() {
    return test::source_dir() / "materials" / "figures";
}

std::vector<fs::path> all_figures() {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(figures_folder())) {
        if (entry.path().string().ends_with(".figure.json")) out.push_back(entry.path());
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::string browser() {
    for (const char* name : {"chromium-headless-shell", "chromium"}) {
        if (cross::has_program(name)) return name;
    }
    return "";
}

cross::Outcome gallery(const std::string& arguments) {
    return cross::run("'" SG_BINARY_DIR "/surfgrad-gallery' " + arguments + " 2>&1");
}

class Figures : public testing::TestWithParam<fs::path> {};

TEST_P(Figures, ShowWhatTheyClaim) {
    const cross::Outcome run = gallery("'" + GetParam().string() + "'");
    fmt::print("{}", run.text);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.text.find("holds "), std::string::npos) << "a figure without a claim";
    EXPECT_EQ(run.text.find("FAILS"), std::string::npos);
}

std::string figure_name(const testing::TestParamInfo<fs::path>& info) {
    return info.param.stem().stem().string();
}
INSTANTIATE_TEST_SUITE_P(Gallery, Figures, testing::ValuesIn(all_figures()), figure_name);

// Every material of the figures belongs to one, and every figure describes itself.
TEST(Gallery, UsesEveryMaterial) {
    std::string all;
    for (const fs::path& figure : all_figures()) all += test::read_file(figure);
    for (const auto& entry : fs::directory_iterator(figures_folder())) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".json") || name.ends_with(".figure.json")) continue;
        EXPECT_NE(all.find("\"" + name + "\""), std::string::npos) << name;
    }
}

class GalleryFaults : public testing::Test {
protected:
    fs::path folder_ = fs::path(SG_BINARY_DIR) / "tests" / "gallery";
    // A figure of our materials with another text.
    std::string run_with(const std::string& name, const std::string& json) {
        RealFiles files;
        EXPECT_EQ(files.write_all({{folder_ / name, json}}), "");
        const cross::Outcome run = gallery("--shrink 4 '" + (folder_ / name).string() + "'");
        EXPECT_EQ(run.exit_code, 1) << run.text;
        std::string text = run.text;
        const std::string prefix = folder_.string() + "/";
        for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
        return text;
    }
    static std::string replaced(std::string text, const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return at == std::string::npos ? text : text.replace(at, from.size(), to);
    }
};

// The mutants: the older method passed off as ours, and a bump of the wrong sign.
TEST_F(GalleryFaults, AFigureThatLiesFails) {
    RealFiles files;
    for (const char* name : {"perlin.json", "perlin_legacy.json", "legacy.glsl"})
        ASSERT_EQ(files.write_all({{folder_ / name, files.read(figures_folder() / name).bytes}}), "");
    const std::string figure = test::read_file(figures_folder() / "figure_4.figure.json");
    const std::string here =
        replaced(figure, "\"..\"", "\"" + figures_folder().parent_path().string() + "\"");
    const std::string swapped = replaced(here, R"("id": "ours",
      "material": "perlin.json")",
                                         R"("id": "ours",
      "material": "perlin_legacy.json")");
    const std::string lie = run_with("figure_4.figure.json", swapped);
    EXPECT_NE(lie.find("FAILS figure_4: "), std::string::npos) << lie;
    EXPECT_NE(lie.find(": error: the claim does not hold: surface gradient: median "), std::string::npos)
        << lie;
    EXPECT_NE(lie.find("[SG2111]"), std::string::npos) << lie;
    std::string sunk = files.read(folder_ / "perlin.json").bytes;
    ASSERT_EQ(files.write_all({{folder_ / "sunk.json", replaced(sunk, "0.05", "-0.05")}}), "");
    const std::string wrong = run_with("sunk.figure.json", replaced(here, R"("id": "ours",
      "material": "perlin.json")",
                                                                    R"("id": "ours",
      "material": "sunk.json")"));
    EXPECT_NE(wrong.find("FAILS sunk: "), std::string::npos) << wrong;
}

TEST_F(GalleryFaults, AreAllReportedWithTheirPlace) {
    const std::string json = R"({ "title": 1, "mash": "sphere",
"detail": 99, "text": "x", "mesh": "plane",
"pictures": [ { "id": "a", "material": "a.json" } ],
"claims": [
{ "text": "t", "picture": "b", "below": 1, "above": 2 },
{ "text": "t", "picture": "a", "below": 1, "tilted": 91 } ] })";
    EXPECT_EQ(run_with("bad.figure.json", json),
              R"(bad.figure.json:1:12: error: expected a string, not a number [SG1103]
{ "title": 1, "mash": "sphere",
           ^
    write a value of the expected type
bad.figure.json:1:15: error: unknown key 'mash' in a figure, did you mean 'mesh'? [SG1101]
{ "title": 1, "mash": "sphere",
              ^^^^^^
    remove the key or use the name that is suggested
bad.figure.json:2:11: error: 'detail' must be from 1 to 16, not 99 [SG1104]
"detail": 99, "text": "x", "mesh": "plane",
          ^^
    choose a number inside the range
bad.figure.json:3:15: error: a picture needs the key 'label' [SG1102]
"pictures": [ { "id": "a", "material": "a.json" } ],
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    add the key
bad.figure.json:5:1: error: a claim needs exactly one of 'below', 'above', 'times' and 'apart' [SG1102]
{ "text": "t", "picture": "b", "below": 1, "above": 2 },
^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    add the key
bad.figure.json:5:27: error: unknown picture 'b', expected 'a' [SG1106]
{ "text": "t", "picture": "b", "below": 1, "above": 2 },
                          ^^^
    use one of the words that are listed
bad.figure.json:6:1: error: a claim about single pixels needs the key 'truth' [SG1102]
{ "text": "t", "picture": "a", "below": 1, "tilted": 91 } ] }
^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    add the key
bad.figure.json:6:54: error: 'tilted' must be from 0 to 90, not 91 [SG1104]
{ "text": "t", "picture": "a", "below": 1, "tilted": 91 } ] }
                                                     ^^
    choose a number inside the range
)");
}

TEST_F(GalleryFaults, HeldWeightsMustBeAskedFor) {
    const std::string figure = test::read_file(figures_folder() / "figure_7_a.figure.json");
    const std::string text = run_with("held.figure.json", replaced(figure, R"("held": true
  },)",
                                                                   R"("held": false
  },)"));
    EXPECT_NE(text.find("error: a claim about held weights needs \"held\": true in 'truth' [SG1102]"),
              std::string::npos)
        << text;
}

// Nothing can be said about pixels that are not there.
TEST_F(GalleryFaults, AClaimAboutNoPixelFails) {
    const std::string figure = test::read_file(figures_folder() / "figure_8.figure.json");
    std::string json = replaced(figure, R"("below": 0.58)", R"("below": 0.58, "tilted": 90)");
    json = replaced(json, "\"..\"", "\"" + figures_folder().parent_path().string() + "\"");
    RealFiles files;
    for (const char* name : {"screen", "forward", "hq", "map"}) {
        const std::string file = fmt::format("magnified_{}.json", name);
        ASSERT_EQ(files.write_all({{folder_ / file, files.read(figures_folder() / file).bytes}}), "");
    }
    const std::string text = run_with("level.figure.json", json);
    EXPECT_EQ(
        text.substr(std::min(text.find("level.figure.json:"), text.size())),
        "level.figure.json:54:5: error: the claim does not hold: 2 x 2 derivatives: median 0 degrees, below "
        "0.58; of 0 pixels tilted by 90 degrees or more [SG2111]\n    {\n    ^\n"
        "    look at the map of angles; mend the material or the claim\n");
}

TEST_F(GalleryFaults, OfTheCommandLine) {
    EXPECT_EQ(gallery("").text, "error: no figure is given; see --help [SG2105]\n");
    EXPECT_EQ(gallery("a.figure.json --shrink 9").text,
              "error: '--shrink 9' is not understood; see --help [SG2105]\n");
    EXPECT_EQ(gallery("a.figure.json --shrink 9").exit_code, 2);
}

// The page in a browser: the slider wipes, the lists choose pictures, all pictures load, nothing is reported.
TEST(GalleryPage, WorksInABrowser) {
    if (browser().empty()) GTEST_SKIP() << "no Chromium: the gallery's page was not opened";
    const fs::path folder = fs::path(SG_BINARY_DIR) / "tests" / "gallery_page";
    fs::remove_all(folder);
    const cross::Outcome run =
        gallery("--shrink 4 '" + (figures_folder() / "figure_4.figure.json").string() + "' '" +
                (figures_folder() / "figure_8.figure.json").string() + "' -o '" + folder.string() + "'");
    ASSERT_TRUE(fs::exists(folder / "index.html")) << run.text;
    RealFiles files;
    std::string page = files.read(folder / "index.html").bytes;
    EXPECT_EQ(page.find("http://"), std::string::npos);
    EXPECT_EQ(page.find("https://"), std::string::npos);
    EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
    // What a reader does, and what came of it, as the body's text. Errors first: the page's own script
    // follows.
    const std::string watch = R"(<script>const faults = [];
addEventListener("error", e => faults.push(e.message || "a file that did not load: " + e.target.src), true);
console.error = console.warn = (...words) => faults.push(words.join(" "));</script>)";
    const std::string act = R"(<script>addEventListener("load", () => {
  const out = [], section = document.querySelector("section"), [under, over] = section.querySelectorAll(".wipe img");
  const range = section.querySelector("input[type=range]"), list = section.querySelector("select");
  const clip = () => over.style.clipPath;
  out.push(clip()); range.value = 20; range.dispatchEvent(new Event("input")); out.push(clip());
  range.value = 90; range.dispatchEvent(new Event("input")); out.push(clip(), section.querySelector(".edge").style.left);
  list.value = list.options[2].value; list.dispatchEvent(new Event("change")); out.push(under.getAttribute("src"));
  const color = () => getComputedStyle(document.body).backgroundColor;
  const before = color(); document.getElementById("theme").click(); out.push(before !== color() ? "theme changes" : "theme stays");
  // The load event comes when every eager picture is there, so that nothing here waits.
  const images = [...document.images];
  for (const i of images) if (!i.complete || !i.naturalWidth) faults.push("broken: " + i.src);
  document.body.textContent = [...out, images.length, "faults: " + faults.join("; ")].join("\n");
});</script>)";
    ASSERT_NE(page.find("loading=\"lazy\""), std::string::npos);
    for (std::size_t at = 0; (at = page.find("loading=\"lazy\"", at)) != std::string::npos;)
        page.replace(at, 14, "loading=\"eager\"");
    page.insert(page.find("<meta"), watch);
    page.insert(page.find("</body>"), act);
    ASSERT_EQ(files.write_all({{folder / "watched.html", page}}), "");
    const cross::Outcome dom = cross::run("timeout 100 " + browser() +
                                          " --headless --no-sandbox --disable-dev-shm-usage --disable-gpu "
                                          "--user-data-dir='" +
                                          (folder / "profile").string() + "' --dump-dom 'file://" +
                                          (folder / "watched.html").string() + "' 2>/dev/null");
    const std::size_t begin = dom.text.find("<body>"), end = dom.text.find("</body>");
    ASSERT_NE(begin, std::string::npos) << dom.text;
    // 2 figures: 2 and 4 pictures lit and as map, 1 truth each, 2 wiped.
    EXPECT_EQ(dom.text.substr(begin + 6, end - begin - 6),
              "inset(0px 0px 0px 50%)\ninset(0px 0px 0px 20%)\ninset(0px 0px 0px "
              "90%)\n90%\nfigure_4.legacy.error.png\n"
              "theme changes\n18\nfaults: ");
}

}  // namespace
}  // namespace sg::proof
