#include "tests/render/workshop.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "runtime/gpu/device.hpp"
#include "runtime/parameters.hpp"

namespace sg::truth {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const Diags& diags) {
    throw std::runtime_error(what + ":\n" + render(diags));
}

// lavapipe filters 8-bit textures in fixed point with 8-bit weights unless told otherwise; its own variable,
// read when the driver starts.
runtime::gpu::Device& device() {
    static runtime::gpu::Device instance = [] {
        ::setenv("GALLIVM_PERF", "no_aos_sampling", 1);
        Diags diags;
        auto made = runtime::gpu::Device::create({"", true}, diags);
        if (!made) fail("no device", diags);
        return std::move(*made);
    }();
    return instance;
}

}  // namespace

std::vector<std::string> validation_messages() {
    return device().log()->messages();
}

Made make(const Recipe& recipe, const target::ShaderLibrary& library) {
    MemoryFiles files;
    for (const auto& [path, bytes] : recipe.files) files.contents["in/" + path] = bytes;
    CompileRequest request;
    request.source = std::make_shared<Source>(Source{"case.json", recipe.json});
    request.stem = "case";
    request.roots = {"in"};
    request.entries = recipe.entries;
    request.optimise_ir = recipe.optimise;
    request.numbers = recipe.numbers;
    request.skipped_rule = recipe.skipped_rule;
    request.spirv.optimise = recipe.optimise ? target::Optimise::speed : target::Optimise::none;
    Diags diags;
    auto compiled = compile_material(request, files, library, diags);
    if (!compiled) fail(recipe.json, diags);
    std::vector<std::pair<fs::path, std::string>> out;
    for (auto& [name, bytes] : compiled->files) out.emplace_back(fs::path("out") / name, std::move(bytes));
    files.write_all(out);
    auto artefact = runtime::read_artefact(files, "out/case.json", diags);
    if (!artefact) fail(recipe.json, diags);
    auto textures = runtime::load_textures(files, *artefact, "in", diags);
    auto parameters = runtime::pack_parameters(*artefact, {}, diags);
    if (!textures || !parameters) fail(recipe.json, diags);
    return {std::move(*artefact), std::move(*textures), std::move(*parameters), std::move(compiled->ir)};
}

Made make(const Recipe& recipe) {
    static const target::ShaderLibrary kLibrary = target::embedded_library();
    return make(recipe, kLibrary);
}

runtime::Picture draw(const Made& made, const runtime::Scene& scene, const std::string& view,
                      std::uint32_t width, std::uint32_t height, bool negative_viewport) {
    Diags diags;
    auto found = runtime::find_view(made.artefact, view, diags);
    if (!found) fail(view, diags);
    runtime::RenderOptions options{width, height, 1, 0, made.parameters, negative_viewport};
    auto picture = runtime::render(device(), made.artefact, made.textures, scene, *found, options, diags);
    if (!picture) fail(view, diags);
    return std::move(*picture);
}

runtime::Picture upside_down(const runtime::Picture& picture) {
    runtime::Picture out = picture;
    const std::uint32_t width = picture.values.width, last = picture.values.height - 1;
    for (std::uint32_t y = 0; y <= last; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            for (int c = 0; c < 4; ++c) out.values.set(x, y, c, picture.values.at(x, last - y, c));
            out.coverage[std::size_t{y} * width + x] = picture.coverage[std::size_t{last - y} * width + x];
        }
    }
    return out;
}

std::map<std::string, std::string> sample_files() {
    std::map<std::string, std::string> out;
    const fs::path root = fs::path(SG_SOURCE_DIR) / "materials";
    RealFiles files;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const bool wanted = entry.path().extension() == ".json" || entry.path().extension() == ".png" ||
                            entry.path().extension() == ".glsl";
        if (entry.is_regular_file() && wanted)
            out[entry.path().lexically_relative(root).generic_string()] = files.read(entry.path()).bytes;
    }
    return out;
}

std::vector<std::string> figure_materials() {
    std::set<std::string> out;
    const std::map<std::string, std::string> files = sample_files();
    for (const auto& [path, bytes] : files) {
        const std::string name = fs::path(path).filename().string();
        if (!name.starts_with("figure_") || !name.ends_with(".figure.json")) continue;
        const auto figure = nlohmann::json::parse(bytes);
        for (const auto& picture : figure.at("pictures")) {
            const std::string material = "figures/" + picture.at("material").get<std::string>();
            if (files.at(material).find("\"custom\"") == std::string::npos) out.insert(material);
        }
    }
    return {out.begin(), out.end()};
}

Percentiles percentiles(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return {values[n / 2], values[n * 99 / 100], values[n - 1], n};
}

glm::dvec3 rgb(const runtime::Picture& picture, std::uint32_t x, std::uint32_t y) {
    const asset::Image& v = picture.values;
    return {v.at(x, y, 0), v.at(x, y, 1), v.at(x, y, 2)};
}

bool covered(const runtime::Picture& picture, std::uint32_t x, std::uint32_t y) {
    return picture.coverage[std::size_t{y} * picture.values.width + x] == 1;
}

void show(const runtime::Picture& picture, const std::string& name) {
    const char* folder = std::getenv("SG_RENDER_PICTURES");
    if (!folder) return;
    asset::Image out =
        asset::make_image(picture.values.width, picture.values.height, asset::TexelFormat::unorm8);
    for (std::uint32_t y = 0; y < out.height; ++y) {
        for (std::uint32_t x = 0; x < out.width; ++x) {
            for (int c = 0; c < 3; ++c)
                out.set(x, y, c, covered(picture, x, y) ? picture.values.at(x, y, c) * 0.5 + 0.5 : 0.2);
            out.set(x, y, 3, 1);
        }
    }
    std::ofstream(fs::path(folder) / (name + ".png"), std::ios::binary) << asset::png_bytes(out);
}

}  // namespace sg::truth
