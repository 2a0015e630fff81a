#include "tests/cross/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "compile.hpp"
#include "runtime/blocks.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/mesh/shapes.hpp"
#include "runtime/parameters.hpp"
#include "runtime/vertices.hpp"
#include "tests/cross/function_caller.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/own_levels.hpp"

namespace sg::cross {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const Diags& diags) {
    throw std::runtime_error(what + ":\n" + render(diags));
}

constexpr const char* kSwiftShader = "/usr/lib/chromium/vk_swiftshader_icd.json";

// llvmpipe draws both for Vulkan and for GL. Its short cuts (8-bit filtering, one level of detail per four
// pixels, approximate logarithms) are switched off, so that what differs is the text alone. WebGPU runs on
// SwiftShader, which is a Vulkan driver too. Drivers and their loader read these when they start.
bool prepare_drivers() {
    const char* listed = std::getenv("VK_ICD_FILENAMES");
    ::setenv(listed ? "VK_ICD_FILENAMES" : "VK_ADD_DRIVER_FILES",
             ((listed ? listed + std::string(":") : "") + kSwiftShader).c_str(), 1);
    return ::setenv("GALLIVM_PERF", "no_aos_sampling,no_quad_lod,no_rho_approx,no_brilinear", 1) == 0;
}
const bool kReady = prepare_drivers();

runtime::gpu::Device make_device(const char* name, bool validate) {
    Diags diags;
    auto made = runtime::gpu::Device::create({name, validate}, diags);
    if (!made || !kReady) fail("no device", diags);
    return std::move(*made);
}
runtime::gpu::Device& llvmpipe() {
    static runtime::gpu::Device instance = make_device("llvmpipe", true);
    return instance;
}

// A torus, turned and stretched so that no matrix is its own transpose, with every attribute there is.
runtime::Scene make_scene() {
    runtime::Scene scene;
    asset::Mesh mesh = *runtime::make_shape("torus");
    mesh.colors.clear();
    for (const glm::vec3& p : mesh.positions) mesh.colors.emplace_back(0.5f * p + 0.5f, 1.0f);
    for (std::size_t set = 2; set < mesh.uvs.size(); ++set) {
        mesh.uvs[set].clear();
        for (const glm::vec2& uv : mesh.uvs[0]) mesh.uvs[set].push_back(uv * static_cast<float>(set));
    }
    scene.content.meshes.push_back(std::move(mesh));
    glm::mat4 world = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    scene.content.instances.push_back({"torus", 0, glm::scale(world, glm::vec3(1, 1.3f, 0.8f))});
    scene.camera = runtime::default_camera(runtime::bounds_of(scene.content), 1);
    return scene;
}
const runtime::Scene& scene() {
    static const runtime::Scene kScene = make_scene();
    return kScene;
}

Slot read_slot(const nlohmann::json& row) {
    Slot out{row.at("kind"), row.at("set"), row.at("binding"), row.at("name")};
    if (row.contains("register")) {
        out.index = static_cast<std::uint32_t>(std::stoul(row["register"].get<std::string>().substr(1)));
        out.space = row.at("space");
    } else {
        out.index = row.contains("unit") ? row["unit"].get<std::uint32_t>() : row.value("index", out.binding);
    }
    out.sampler_binding = row.value("sampler_binding", 0u);
    return out;
}

Stage read_stage(const Sample& sample, const nlohmann::json& stage, const target::Target& target) {
    for (const auto& row : stage.at("targets")) {
        if (row.at("target") != target.name) continue;
        Stage out{sample.texts.at(row.at("file")), {}};
        for (const auto& slot : row.at("bindings")) out.slots.push_back(read_slot(slot));
        return out;
    }
    throw std::runtime_error(sample.name + ": the manifest has no " + std::string(target.name));
}

template <typename Block>
std::vector<std::byte> bytes_of(const Block& block) {
    auto span = std::as_bytes(std::span(&block, 1));
    return {span.begin(), span.end()};
}

// Textures lie in the first.
std::array<fs::path, 2> sample_folders() {
    return {test::source_dir() / "materials", test::source_dir() / "tests/cross/materials"};
}

fs::path sample_file(const std::string& name) {
    for (const fs::path& folder : sample_folders()) {
        if (fs::exists(folder / (name + ".json"))) return folder / (name + ".json");
    }
    throw std::runtime_error("no sample " + name);
}

}  // namespace

std::vector<std::string> sample_names() {
    std::vector<std::string> out;
    for (const fs::path& folder : sample_folders()) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() == ".json") out.push_back(entry.path().stem().string());
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

Sample make_sample(const std::string& name, const std::string& stem, const target::ShaderLibrary& library) {
    const fs::path path = sample_file(name), textures_at = sample_folders().front();
    RealFiles disk;
    CompileRequest request;
    request.source = std::make_shared<Source>(Source{path.filename().string(), test::read_file(path)});
    request.stem = stem;
    request.roots = {textures_at};
    request.targets.clear();
    for (const target::Target& target : target::all_targets()) request.targets.push_back(&target);
    Diags diags;
    auto compiled = compile_material(request, disk, library, diags);
    if (!compiled) fail(name, diags);
    MemoryFiles files;
    Sample out{.name = stem};
    for (const NamedText& text : compiled->glsl) out.glsl[text.name] = text.text;
    for (auto& [file, bytes] : compiled->files) {
        if (file.ends_with(".json")) out.manifest = bytes;
        bool text = !file.ends_with(".spv") && !file.ends_with(".json");
        if (text) out.texts[file] = bytes;
        files.contents["out/" + file] = std::move(bytes);
    }
    auto artefact = runtime::read_artefact(files, "out/" + out.name + ".json", diags);
    if (!artefact) fail(name, diags);
    auto textures = runtime::load_textures(disk, *artefact, textures_at, diags);
    auto parameters = runtime::pack_parameters(*artefact, {}, diags);
    if (!textures || !parameters) fail(name, diags);
    // What an anisotropic filter averages is the driver's affair, and no part of the text.
    for (runtime::SamplerSlot& slot : artefact->samplers) slot.state.anisotropy = 1;
    out.artefact = std::move(*artefact);
    out.textures = std::move(*textures);
    out.parameters = std::move(*parameters);
    return out;
}

const target::ShaderLibrary& drawn_library() {
    static const target::ShaderLibrary kLibrary = test::with_own_levels();
    return kLibrary;
}

const Sample& sample(const std::string& name) {
    static std::map<std::string, Sample> samples;
    auto it = samples.find(name);
    return it == samples.end() ? samples.emplace(name, make_sample(name, name, drawn_library())).first->second
                               : it->second;
}

const Sample& shipped(const std::string& name) {
    static const target::ShaderLibrary kLibrary = target::embedded_library();
    static std::map<std::string, Sample> samples;
    auto it = samples.find(name);
    return it == samples.end() ? samples.emplace(name, make_sample(name, name, kLibrary)).first->second
                               : it->second;
}

namespace {

asset::Image decoded(const TextureView& view) {
    const asset::Image& image = view.chain->front();
    asset::Image out = asset::make_image(image.width, image.height, asset::TexelFormat::float32);
    const std::vector<float> texels = linear_texels(view);
    std::memcpy(out.bytes.data(), texels.data(), out.bytes.size());
    return out;
}

}  // namespace

const Sample& base_sample(const Sample& sample) {
    static std::map<std::string, Sample> samples;
    auto [at, fresh] = samples.try_emplace(sample.name, sample);
    if (fresh) {
        at->second.name += " (level 0)";
        for (std::size_t i = 0; i < sample.textures.chains.size(); ++i) {
            bool& srgb = at->second.artefact.textures[i].srgb;
            at->second.textures.chains[i] = {decoded({&sample.textures.chains[i], srgb})};
            srgb = false;
        }
    }
    return at->second;
}

std::span<const Shown> all_shown() {
    static const Shown kRows[] = {
        {"normal", "normal", {"normal"}, {"normal"}},
        {"forward", "forward", {"lit"}, {"radiance"}},
        {"debug", "debug", {"gradient"}, {"gradient"}},
        {"function", "forward", {"lit"}, {"normal"}},
        {"gbuffer",
         "gbuffer",
         {"gbuffer:base_color", "gbuffer:normal", "gbuffer:surface", "gbuffer:emission"},
         {"base colour", "normal", "surface", "emission"}},
        {"depth", "depth", {"depth"}, {"depth"}}};
    return kRows;
}

const Shown& shown(std::string_view name) {
    return *std::find_if(all_shown().begin(), all_shown().end(),
                         [&](const Shown& s) { return s.name == name; });
}

Drawing drawing(const Sample& sample, const target::Target& target, const Shown& shown) {
    const runtime::EntryPoint& entry = *sample.artefact.entry(shown.entry);
    Drawing out{.sample = &sample, .target = &target, .shown = &shown};
    const nlohmann::json manifest = nlohmann::json::parse(sample.manifest);
    for (const auto& row : manifest.at("entry_points")) {
        if (row.at("name") != shown.entry) continue;
        if (target.language == target::Language::spirv) {
            for (const auto& slot : row.at("bindings")) out.fragment.slots.push_back(read_slot(slot));
            out.fragment.text = sample.glsl.at(std::string(shown.entry) + ".frag");
            if (shown.name == "function") call_function(out.fragment.text, sample, target);
            continue;
        }
        out.vertex = read_stage(sample, row.at("stages").at(0), target);
        out.fragment = read_stage(sample, row.at("stages").at(1), target);
        if (shown.name == "function") call_function(out.fragment.text, sample, target);
    }
    Diags diags;
    const auto view = runtime::find_view(sample.artefact, shown.views[0], diags);
    if (!view) fail(sample.name, diags);
    const asset::Instance& instance = scene().content.instances[0];
    auto mesh = runtime::prepare_mesh(scene().content.meshes[0], entry, sample.name, diags);
    if (!mesh) fail(sample.name, diags);
    for (const runtime::VertexInput& input : entry.inputs) {
        auto bytes = runtime::attribute_bytes(*mesh, input.name);
        Attribute attribute{input.location, input.components,
                            std::vector<float>(bytes.size() / sizeof(float))};
        std::memcpy(attribute.values.data(), bytes.data(), bytes.size());
        out.attributes.push_back(std::move(attribute));
    }
    out.indices = mesh->indices;
    auto bounds = runtime::bounds_of(scene().content);
    out.blocks = {bytes_of(runtime::frame_block(scene(), bounds, kSide, kSide, 0, view->view.number)),
                  sample.parameters,
                  bytes_of(runtime::object_block(scene().camera, instance.world_from_object))};
    for (std::size_t i = 0; i < sample.artefact.textures.size(); ++i) {
        out.textures[sample.artefact.textures[i].binding] = {&sample.textures.chains[i],
                                                             sample.artefact.textures[i].srgb};
    }
    for (const runtime::SamplerSlot& slot : sample.artefact.samplers) out.samplers[slot.binding] = slot.state;
    out.cull_back = !sample.artefact.two_sided;
    out.attachments = entry.outputs.size();
    return out;
}

namespace {

// Each plane by a view of its own.
Pixels draw_planes(runtime::gpu::Device& device, const Sample& sample, const runtime::Artefact& artefact,
                   const Shown& shown) {
    Diags diags;
    runtime::RenderOptions options{kSide, kSide, 1, 0, sample.parameters};
    auto renderer =
        runtime::Renderer::create(device, artefact, sample.textures, scene(), options, shown.entry, diags);
    if (!renderer) fail(sample.name, diags);
    Pixels out;
    for (std::string_view name : shown.views) {
        auto view = runtime::find_view(artefact, name, diags);
        auto picture = view ? renderer->draw(view->view, diags) : std::nullopt;
        if (!picture) fail(sample.name, diags);
        const std::size_t at = out.size();
        out.resize(at + kPlane);
        std::memcpy(&out[at], picture->values.bytes.data(), kPlane * sizeof(float));
    }
    return out;
}

}  // namespace

const Pixels& render_words(const Sample& sample, const ShaderWords& words, const Shown& shown,
                           Driver driver) {
    static std::map<std::tuple<std::string, std::string_view, Driver, ShaderWords>, Pixels> pictures;
    auto [at, fresh] = pictures.try_emplace({sample.name, shown.name, driver, words});
    if (!fresh) return at->second;
    runtime::Artefact artefact = sample.artefact;
    for (runtime::EntryPoint& entry : artefact.entries) {
        if (entry.name != shown.entry) continue;
        entry.vertex.words = words[0];
        entry.fragment.words = words[1];
    }
    if (driver == Driver::llvmpipe) {
        at->second = draw_planes(llvmpipe(), sample, artefact, shown);
    } else {
        runtime::gpu::Device swiftshader =
            make_device("SwiftShader", false);  // ends here: it does not survive the end of the process
        at->second = draw_planes(swiftshader, sample, artefact, shown);
    }
    return at->second;
}

const Pixels& reference(const Sample& sample, const Shown& what, Driver driver) {
    const Shown& drawn = what.name == "function" ? shown("normal") : what;
    const runtime::EntryPoint& entry = *sample.artefact.entry(drawn.entry);
    return render_words(sample, {entry.vertex.words, entry.fragment.words}, drawn, driver);
}

std::vector<std::string> validation_messages() {
    return llvmpipe().log()->messages();
}

bool has_swiftshader() {
    return fs::exists(kSwiftShader);
}

std::vector<float> texels_of(const asset::Image& image) {
    std::vector<float> out;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            for (int c = 0; c < 4; ++c) out.push_back(static_cast<float>(image.at(x, y, c)));
        }
    }
    return out;
}

std::vector<float> linear_texels(const TextureView& view) {
    std::vector<float> out = texels_of(view.chain->front());
    for (std::size_t i = 0; view.srgb && i < out.size(); ++i) {
        const double v = double{out[i]};
        if (i % 4 != 3)
            out[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return out;
}

Difference compare(const Pixels& a, const Pixels& b, const Measure& measure) {
    if (a.size() != b.size() || a.size() <= measure.plane * kPlane)
        throw std::runtime_error("a picture with another number of planes");
    const std::size_t last = a.size() - kPlane;
    Difference out;
    std::vector<double> errors;
    for (std::size_t i = 0; i < kPlane / 4; ++i) {
        const float *p = &a[measure.plane * kPlane + 4 * i], *q = &b[measure.plane * kPlane + 4 * i];
        const bool in_a = a[last + 4 * i + 3] != 0, in_b = b[last + 4 * i + 3] != 0;
        if (in_a != in_b) ++out.one_alone;
        if (!in_a || !in_b) continue;
        double error = 0;
        for (int c = 0; c < 4; ++c) {
            double d = std::abs(double{p[c]} - double{q[c]});
            error = d <= error ? error : d;  // keeps what is not a number
        }
        if (!measure.unit.empty()) error /= measure.unit[i];
        const bool on_edge = !measure.on_edge.empty() && measure.on_edge[i];
        double& most = on_edge ? out.on_edge : out.largest;
        out.edges += on_edge;
        if (!(error <= most)) most = error;
        errors.push_back(error);
    }
    out.both = errors.size();
    if (errors.empty()) return out;
    std::sort(errors.begin(), errors.end(), [](double x, double y) { return x < y || (x == x && y != y); });
    out.p999 = errors[std::min(errors.size() - 1, errors.size() * 999 / 1000)];
    return out;
}

}  // namespace sg::cross
