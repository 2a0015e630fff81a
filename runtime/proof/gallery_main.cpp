// surfgrad-gallery FIGURE.json ... [-o DIR] [--shrink N]: draws figures, measures them, writes the page.
#include <fmt/core.h>

#include <cstring>

#include "runtime/job.hpp"
#include "runtime/parameters.hpp"
#include "runtime/proof/gallery.hpp"

namespace {

constexpr const char* kHelp =
    "surfgrad-gallery FIGURE.json ... [-o DIR] [--shrink N] [--device NAME]\n"
    "Draws each figure, measures it, and fails where a claim does not hold.\n"
    "  -o DIR         write index.html and its pictures there\n"
    "  --shrink N     pictures N times smaller per side, for quick checks (1 to 8)\n"
    "  --device NAME  part of the device's name\n";

struct Line {
    std::vector<std::filesystem::path> figures;
    std::filesystem::path folder;
    std::uint32_t shrink = 1;
    std::string device;
};

std::optional<Line> parse(int argc, char** argv, sg::Diags& diags) {
    Line out;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (!word.starts_with('-')) {
            out.figures.emplace_back(word);
            continue;
        }
        const std::string value = i + 1 < argc ? argv[++i] : "";
        const auto number = sg::runtime::parse_numbers(value);
        if (word == "-o" && !value.empty()) {
            out.folder = value;
        } else if (word == "--device" && !value.empty()) {
            out.device = value;
        } else if (word == "--shrink" && number && number->size() == 1 && (*number)[0] >= 1 &&
                   (*number)[0] <= 8) {
            out.shrink = static_cast<std::uint32_t>((*number)[0]);
        } else {
            diags.error(sg::Code::bad_argument, fmt::format("'{} {}' is not understood; see --help",
                                                            sg::printable(word), sg::printable(value)));
        }
    }
    if (out.figures.empty()) diags.error(sg::Code::bad_argument, "no figure is given; see --help");
    if (diags.has_errors()) return std::nullopt;
    return out;
}

int run(const Line& line, sg::Diags& diags) {
    sg::RealFiles files;
    std::vector<sg::proof::Figure> figures;
    for (const auto& file : line.figures) {
        if (auto figure = sg::proof::read_figure(file, files, diags)) figures.push_back(std::move(*figure));
    }
    if (diags.has_errors()) return diags.exit_code();
    auto device = sg::runtime::gpu::Device::create({line.device, false}, diags);
    if (!device) return diags.exit_code();
    std::vector<sg::proof::DrawnFigure> drawn;
    for (const sg::proof::Figure& figure : figures) {
        auto one = sg::proof::draw_figure(figure, line.shrink, *device, files, diags);
        if (!one) return sg::runtime::exit_code(diags);
        for (const auto& [text, holds] : one->claims)
            fmt::print("{} {}: {}\n", holds ? "holds" : "FAILS", figure.name, text);
        for (const auto& p : one->pictures) {
            if (!figure.truth.empty())
                fmt::print("  {}: {}\n", p.picture.label, sg::proof::text_of(p.numbers));
            if (figure.held)
                fmt::print("  {}, weights held: {}\n", p.picture.label, sg::proof::text_of(p.held));
        }
        if (figure.held)
            fmt::print("  H grad w, which all leave out: {}\n", sg::proof::text_of(one->neglected));
        if (!figure.truth.empty())
            fmt::print("  left out by bump mapping, at most: {}\n", sg::proof::text_of(one->most_left_out));
        drawn.push_back(std::move(*one));
    }
    if (!line.folder.empty()) {
        auto page = sg::proof::gallery_files(drawn);
        for (auto& [name, bytes] : page) name = line.folder / name;
        sg::write_or_report(files, page, diags);
    }
    return sg::runtime::exit_code(diags);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--help") == 0) {
        fmt::print("{}", kHelp);
        return 0;
    }
    sg::Diags diags;
    const auto line = parse(argc, argv, diags);
    const int code = line ? run(*line, diags) : 2;
    std::fflush(stdout);
    diags.sort();
    fmt::print(stderr, "{}", sg::render(diags));
    return code;
}
