#include "runtime/proof/gallery.hpp"

#include <fmt/core.h>

namespace sg::proof {
namespace {

std::string escaped(std::string_view text) {
    std::string out;
    for (char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

constexpr const char* kHead = R"page(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>surfgrad: pictures that prove it</title>
<style>
:root { color-scheme: light dark; --back: #fbfaf8; --ink: #1d1d1f; --soft: #6a6a70; --line: #ddd9d2; --card: #fff; --good: #1c7c3c; --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --back: #17181b; --ink: #e9e7e2; --soft: #a0a0a8; --line: #35363b; --card: #1f2024; --good: #6fcf8a; --bad: #ff8a80; } }
:root[data-theme=light] { color-scheme: light; --back: #fbfaf8; --ink: #1d1d1f; --soft: #6a6a70; --line: #ddd9d2; --card: #fff; --good: #1c7c3c; --bad: #b3261e; }
:root[data-theme=dark] { color-scheme: dark; --back: #17181b; --ink: #e9e7e2; --soft: #a0a0a8; --line: #35363b; --card: #1f2024; --good: #6fcf8a; --bad: #ff8a80; }
body { background: var(--back); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; max-width: 1180px; margin: 0 auto; padding: 1.5rem; }
header { display: flex; align-items: baseline; gap: 1rem; } header h1 { margin: 0; flex: 1; }
section { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1.2rem 1.4rem; margin: 1.6rem 0; }
h2 { margin: 0 0 .2rem; } .source { color: var(--soft); margin: 0 0 .8rem; }
.wipe { position: relative; max-width: 100%; margin: 0 auto .4rem; line-height: 0; background: #2a2a2e; }
.wipe img { width: 100%; height: auto; } .wipe img + img { position: absolute; inset: 0; }
.wipe .edge { position: absolute; top: 0; bottom: 0; width: 2px; background: #fff8; }
.controls { display: flex; flex-wrap: wrap; gap: .6rem; justify-content: center; align-items: center; margin-bottom: 1rem; }
.controls input { width: min(420px, 60vw); } .controls select { max-width: 17rem; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; } figure { margin: 0; flex: 1 1 220px; max-width: 360px; }
figure img { width: 100%; height: auto; background: #2a2a2e; } figcaption { font-weight: 600; }
table { border-collapse: collapse; margin: .8rem 0; } th, td { text-align: right; padding: .15rem .8rem; border-bottom: 1px solid var(--line); } th:first-child, td:first-child { text-align: left; }
li.holds::marker { content: "\2713  "; color: var(--good); } li.fails::marker { content: "\2717  "; color: var(--bad); }
pre { overflow: auto; max-height: 24rem; font-size: 13px; border: 1px solid var(--line); padding: .6rem; border-radius: 6px; } summary { cursor: pointer; }
button, select { font: inherit; }
</style></head><body>
<header><h1>Pictures that prove it</h1><button id="theme" type="button">light / dark</button></header>
<p>Each figure shows older methods beside surface gradients, and how far the normal of every pixel is from that of the surface which is
really displaced, computed in double precision. Numbers are degrees. Maps run from black (0) to white, one scale per figure. What bump
mapping leaves out at most is derived for each pixel from heights, curvatures and tilts; what is beyond it comes from filters and texels.</p>
)page";

constexpr const char* kTail = R"page(<script>
"use strict";
for (const section of document.querySelectorAll("section")) {
  const [under, over] = section.querySelectorAll(".wipe img");
  const edge = section.querySelector(".edge"), range = section.querySelector("input[type=range]");
  const [left, right] = section.querySelectorAll("select");
  const wipe = () => { over.style.clipPath = `inset(0 0 0 ${range.value}%)`; edge.style.left = `${range.value}%`; };
  const pick = () => { under.src = left.value; over.src = right.value; };
  range.addEventListener("input", wipe);
  left.addEventListener("change", pick);
  right.addEventListener("change", pick);
  wipe();
}
document.getElementById("theme").addEventListener("click", () => {
  const root = document.documentElement;
  const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
});
</script></body></html>
)page";

std::string file_name(const DrawnFigure& figure, const std::string& id, const std::string& what) {
    std::string out = figure.figure.name + "." + id + "." + what + ".png";
    for (char& c : out) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '.' || c == '-' || c == '_';
        if (!plain) c = '_';
    }
    return out;
}

// Every picture of the figure, lit and as map, as options of a list; one is chosen.
std::string options(const DrawnFigure& figure, std::size_t chosen) {
    std::string out;
    for (std::size_t i = 0; i < figure.pictures.size(); ++i) {
        const FigurePicture& p = figure.pictures[i].picture;
        out += fmt::format("<option value=\"{}\"{}>{}</option>", file_name(figure, p.id, "lit"),
                           i == chosen ? " selected" : "", escaped(p.label));
    }
    for (const DrawnPicture& drawn : figure.pictures) {
        if (drawn.error.empty()) continue;
        out += fmt::format("<option value=\"{}\">error of {}</option>",
                           file_name(figure, drawn.picture.id, "error"), escaped(drawn.picture.label));
    }
    return out;
}

void add_wipe(const DrawnFigure& figure, std::string& page) {
    const std::size_t last = figure.pictures.size() - 1;
    const std::string left = file_name(figure, figure.pictures[0].picture.id, "lit"),
                      right = file_name(figure, figure.pictures[last].picture.id, "lit");
    page += fmt::format(
        "<div class=\"wipe\" style=\"width:{}px\"><img src=\"{}\" alt=\"left\"><img src=\"{}\" "
        "alt=\"right\"><div "
        "class=\"edge\"></div></div>\n"
        "<div class=\"controls\"><select aria-label=\"left\">{}</select><input type=\"range\" min=\"0\" "
        "max=\"100\" "
        "value=\"50\" aria-label=\"wipe\"><select aria-label=\"right\">{}</select></div>\n",
        2 * figure.figure.width, left, right, options(figure, 0), options(figure, last));
}

void add_maps(const DrawnFigure& figure, std::string& page) {
    page += "<div class=\"row\">\n";
    auto add = [&](const std::string& file, const std::string& caption) {
        page += fmt::format(
            "<figure><img loading=\"lazy\" src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
            file, escaped(caption), escaped(caption));
    };
    for (const DrawnPicture& p : figure.pictures)
        add(file_name(figure, p.picture.id, "lit"), p.picture.label);
    if (!figure.truth.empty()) add(file_name(figure, "truth", "normals"), "The displaced surface");
    page += "</div>\n";
    if (figure.truth.empty()) return;
    page += "<div class=\"row\">\n";
    for (const DrawnPicture& p : figure.pictures)
        add(file_name(figure, p.picture.id, "error"), "Error of " + p.picture.label);
    page +=
        "</div>\n<table><tr><th>degrees from the truth</th><th>median</th><th>95 %</th><th>99 "
        "%</th><th>largest</th></tr>\n";
    auto row = [&](const std::string& label, const Numbers& n) {
        page +=
            fmt::format("<tr><td>{}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td></tr>\n",
                        escaped(label), n.median, n.p95, n.p99, n.max);
    };
    for (const DrawnPicture& p : figure.pictures) row(p.picture.label, p.numbers);
    if (figure.figure.held) {
        for (const DrawnPicture& p : figure.pictures) row(p.picture.label + ", weights held", p.held);
        row("H grad w, which all leave out", figure.neglected);
    }
    row("left out by bump mapping, at most", figure.most_left_out);
    page += "</table>\n";
}

void add_figure(const DrawnFigure& figure, std::string& page) {
    page += fmt::format("<section id=\"{}\"><h2>{}</h2><p class=\"source\">{}</p><p>{}</p>\n",
                        escaped(figure.figure.name), escaped(figure.figure.title),
                        escaped(figure.figure.source), escaped(figure.figure.text));
    add_wipe(figure, page);
    add_maps(figure, page);
    page += "<ul>\n";
    for (const auto& [text, holds] : figure.claims)
        page += fmt::format("<li class=\"{}\">{}</li>\n", holds ? "holds" : "fails", escaped(text));
    page += "</ul>\n";
    for (const DrawnPicture& p : figure.pictures)
        page += fmt::format(
            "<details><summary>{}: material and shader</summary><pre>{}</pre><pre>{}</pre></details>\n",
            escaped(p.picture.label), escaped(p.json), escaped(p.glsl));
    page += "</section>\n";
}

}  // namespace

std::vector<std::pair<std::filesystem::path, std::string>> gallery_files(
    const std::vector<DrawnFigure>& figures) {
    std::vector<std::pair<std::filesystem::path, std::string>> out;
    std::string page = kHead;
    for (const DrawnFigure& figure : figures) {
        add_figure(figure, page);
        for (const DrawnPicture& p : figure.pictures) {
            out.emplace_back(file_name(figure, p.picture.id, "lit"), p.lit);
            if (!p.error.empty()) out.emplace_back(file_name(figure, p.picture.id, "error"), p.error);
        }
        if (!figure.truth.empty()) out.emplace_back(file_name(figure, "truth", "normals"), figure.truth);
    }
    out.emplace_back("index.html", page + kTail);
    return out;
}

}  // namespace sg::proof
