#include "tests/oracle/material_oracle.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "ir/text.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/mesh/shapes.hpp"
#include "tests/render/workshop.hpp"

namespace sg::oracle {
namespace {

using ir::PixelInputs;
using ref::dvec2;
using ref::dvec3;

constexpr std::uint32_t kPixels = 96;  // per side of a picture

[[noreturn]] void fail(const std::string& what, const Diags& diags) {
    throw std::runtime_error(what + ":\n" + render(diags));
}

// lavapipe filters 8-bit textures in fixed point and takes one level of detail for each 2x2 pixels unless
// told otherwise; its own variable, read when the driver starts.
runtime::gpu::Device& device() {
    static runtime::gpu::Device instance = [] {
        ::setenv("GALLIVM_PERF", "no_aos_sampling,no_quad_lod", 1);
        Diags diags;
        auto made = runtime::gpu::Device::create({"", true}, diags);
        if (!made) fail("no device", diags);
        return std::move(*made);
    }();
    return instance;
}

// Without the holes of an alpha test: every pixel's normal is compared, and what is seen from outside is
// front faces alone.
truth::Recipe recipe_of(const std::string& sample, std::vector<std::string> entries) {
    static const std::map<std::string, std::string> kFiles = truth::sample_files();
    auto material = nlohmann::ordered_json::parse(kFiles.at(sample));
    if (material.contains("surface")) material["surface"].erase("alpha_test");
    return {material.dump(2), kFiles, std::move(entries), true};
}

// Isotropic: how a driver places the samples of an anisotropic filter is its own affair.
truth::Made made_of(const std::string& sample, const std::string& entry, Levels levels,
                    const target::ShaderLibrary& library,
                    const std::map<std::string, std::string>& other_files = {}) {
    truth::Recipe recipe = recipe_of(sample, {entry});
    for (const auto& [path, bytes] : other_files) recipe.files[path] = bytes;
    truth::Made made = truth::make(recipe, library);
    for (auto& chain : made.textures.chains) {
        if (levels == Levels::first) chain.resize(1);
    }
    for (runtime::SamplerSlot& slot : made.artefact.samplers) slot.state.anisotropy = 1;
    return made;
}

// Closed surfaces, so that all pixels face the camera or none does.
runtime::Scene make_scene(Seen seen) {
    runtime::Scene out;
    out.content.meshes.push_back(*runtime::make_shape(seen == Seen::outside ? "torus" : "sphere"));
    out.content.instances.push_back({"", 0, glm::mat4(1)});
    out.camera.position =
        seen == Seen::outside ? glm::normalize(dvec3(0.5, 0.9, 1)) * 5.6 : dvec3(0.1, -0.2, 0.15);
    out.camera.target = seen == Seen::outside ? dvec3(0) : dvec3(0.4, 0.1, 1);
    out.camera.fov_degrees = seen == Seen::outside ? 30 : 70;
    return out;
}

const runtime::Scene& scene(Seen seen) {
    static const runtime::Scene kOutside = make_scene(Seen::outside), kInside = make_scene(Seen::inside);
    return seen == Seen::outside ? kOutside : kInside;
}

ir::PixelCamera camera_of(const runtime::Scene& scene) {
    const runtime::CameraMatrices matrices =
        runtime::camera_matrices(scene.camera, runtime::bounds_of(scene.content), kPixels, kPixels);
    return {scene.camera.ortho_height <= 0, scene.camera.position, matrices.direction,
            matrices.relative_from_screen};
}

std::map<std::string, runtime::Picture> draw(const truth::Made& made, Seen seen,
                                             const std::vector<runtime::View>& views) {
    Diags diags;
    const runtime::RenderOptions options{kPixels, kPixels, 1, 0, made.parameters};
    auto renderer = runtime::Renderer::create(device(), made.artefact, made.textures, scene(seen), options,
                                              views.at(0).entry, diags);
    if (!renderer) fail("no renderer", diags);
    std::map<std::string, runtime::Picture> out;
    for (const runtime::View& view : views) {
        auto picture = renderer->draw(view.view, diags);
        if (!picture) fail(view.view.name, diags);
        out.emplace(view.view.name, std::move(*picture));
    }
    return out;
}

ir::Sampled::Wrap wrap_of(runtime::gpu::Wrap wrap) {
    using From = runtime::gpu::Wrap;
    return wrap == From::repeat  ? ir::Sampled::Wrap::repeat
           : wrap == From::clamp ? ir::Sampled::Wrap::clamp
                                 : ir::Sampled::Wrap::mirror;
}

ir::Sampled sampled_of(const runtime::gpu::SamplerState& state) {
    ir::Sampled out{.wrap_s = wrap_of(state.wrap_s), .wrap_t = wrap_of(state.wrap_t), .linear = state.linear};
    using From = runtime::gpu::MipFilter;
    out.mips = state.mip_filter == From::linear    ? ir::Sampled::Mips::linear
               : state.mip_filter == From::nearest ? ir::Sampled::Mips::nearest
                                                   : ir::Sampled::Mips::none;
    return out;
}

ref::MemoryTexture texels_of(const std::vector<asset::Image>& chain) {
    ref::MemoryTexture out;
    for (const asset::Image& image : chain) {
        ref::MemoryTexture::Level level{{image.width, image.height}, {}};
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x)
                level.texels.emplace_back(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2),
                                          image.at(x, y, 3));
        }
        out.chain.push_back(std::move(level));
    }
    return out;
}

Compiled compiled_of(const std::string& sample) {
    MemoryFiles files;
    for (const auto& [path, bytes] : recipe_of(sample, {}).files) files.contents["in/" + path] = bytes;
    CompileRequest request;
    request.source = std::make_shared<Source>(Source{sample, recipe_of(sample, {}).json});
    request.stem = "sample";
    request.roots = {"in"};
    request.entries = {"normal"};
    Diags diags;
    auto compiled = compile_material(request, files, target::embedded_library(), diags);
    if (!compiled) fail(sample, diags);
    return std::move(*compiled);
}

}  // namespace

std::vector<std::string> all_samples() {
    std::vector<std::string> out;
    for (const auto& [path, bytes] : truth::sample_files()) {
        if (path.ends_with(".json") && path.find('/') == std::string::npos) out.push_back(path);
    }
    return out;
}

std::vector<std::string> validation_messages() {
    return device().log()->messages();
}

Material::Material(const std::string& sample, Levels levels) {
    const Compiled compiled = compiled_of(sample);
    std::string fault;
    module = ir::parse(compiled.reference_ir, fault).value();
    const truth::Made made = made_of(sample, "normal", levels, target::embedded_library());
    const auto manifest = nlohmann::json::parse(compiled.files.back().second);
    textures.resize(module.textures.size());
    bindings.textures.resize(module.textures.size());
    for (std::size_t i = 0; i < module.textures.size(); ++i) {
        const auto& slots = made.artefact.textures;
        const auto slot = std::find_if(slots.begin(), slots.end(),
                                       [&](const auto& s) { return s.name == module.textures[i].name; });
        if (slot == slots.end()) continue;  // optimised away
        const auto at = static_cast<std::size_t>(slot - slots.begin());
        textures[i] = texels_of(made.textures.chains[at]);
        const auto binding = manifest.at("textures").at(at).at("sampler_binding").get<std::uint32_t>();
        for (const runtime::SamplerSlot& sampler : made.artefact.samplers) {
            if (sampler.binding == binding) bindings.textures[i] = sampled_of(sampler.state);
        }
        bindings.textures[i].texels = &textures[i];
    }
    give_each_read_its_own_texture();
    for (const ir::Parameter& parameter : module.parameters) {
        std::array<double, 16> number{};
        for (const runtime::Parameter& p : made.artefact.parameters->parameters) {
            if (p.name == parameter.name) std::copy(p.initial.begin(), p.initial.end(), number.begin());
        }
        bindings.parameters.push_back(ir::datum_of(parameter.type, number));
    }
}

// Rounding errs in each read by itself, so that the reads of one texture must be movable one by one.
void Material::give_each_read_its_own_texture() {
    std::vector<bool> read(module.textures.size(), false);
    for (ir::Value& value : module.values) {
        if (ir::info(value.op).attribute != ir::Attribute::Texture) continue;
        const std::uint32_t texture = value.index;
        if (!read[texture]) {
            read[texture] = true;
            continue;
        }
        value.index = static_cast<std::uint32_t>(module.textures.size());
        module.textures.push_back(ir::Texture(module.textures[texture]));
        textures.push_back(ref::MemoryTexture(textures[texture]));
        bindings.textures.push_back(ir::Sampled(bindings.textures[texture]));
    }
    for (std::size_t i = 0; i < textures.size(); ++i) {
        if (!textures[i].chain.empty()) bindings.textures[i].texels = &textures[i];
    }
}

namespace {

// The interpolated vertex normal N and tangent are no views, but follow from those that are: the base normal
// is n = N / |N|; the shown tangent is T / |N| and the shown bitangent is w cross(N, T) / |N|, which is |N|
// times as long as cross(n, T / |N|).
void vertex_vectors(PixelInputs& pixel, dvec3 n, dvec3 tangent, dvec3 bitangent) {
    const dvec3 across = glm::cross(n, tangent);
    const double length = glm::length(bitangent) / glm::length(across);
    pixel.vertex_normal = n * length;
    pixel.vertex_tangent = glm::dvec4(tangent * length, glm::dot(across, bitangent) < 0 ? -1.0 : 1.0);
}

}  // namespace

std::vector<PixelInputs> draw_inputs(const std::string& sample, Seen seen) {
    const truth::Made made = made_of(sample, "debug", Levels::first, target::embedded_library());
    const auto pictures = draw(made, seen, runtime::debug_views(made.artefact));
    const ir::PixelCamera camera = camera_of(scene(seen));
    std::vector<PixelInputs> out;
    for (std::uint32_t y = 0; y < kPixels; ++y) {
        for (std::uint32_t x = 0; x < kPixels; ++x) {
            if (!truth::covered(pictures.at("position"), x, y)) continue;
            auto vec3 = [&](const std::string& view) { return truth::rgb(pictures.at(view), x, y); };
            PixelInputs pixel;
            pixel.position = vec3("position");
            // A mirrored base normal faces the camera; the vertex normal of a back face does not.
            dvec3 n = vec3("base-normal");
            if (seen == Seen::inside && glm::dot(n, vec3("position")) < 0) n = -n;
            pixel.facing = seen == Seen::inside ? -1 : 1;
            pixel.vertex_normal = n;
            pixel.dpdx = vec3("dpdx");
            pixel.dpdy = vec3("dpdy");
            if (pictures.contains("base-normal-dx")) {
                pixel.dndx = vec3("base-normal-dx");
                pixel.dndy = vec3("base-normal-dy");
            }
            pixel.camera = camera;
            pixel.object_origin = -camera.position;
            if (pictures.contains("vertex-color")) {
                const asset::Image& color = pictures.at("vertex-color").values;
                for (int c = 0; c < 4; ++c) pixel.vertex_color[c] = color.at(x, y, c);
            }
            if (pictures.contains("tangent")) vertex_vectors(pixel, n, vec3("tangent"), vec3("bitangent"));
            for (std::size_t set = 0; set < pixel.uvs.size(); ++set) {
                const std::string name = "uv" + std::to_string(set);
                if (!pictures.contains(name)) continue;
                const asset::Image& slopes = pictures.at(name + "-derivatives").values;
                auto at = [&](int c) { return slopes.at(x, y, c); };
                pixel.uvs[set] = {dvec2(vec3(name)), {at(0), at(1)}, {at(2), at(3)}};
            }
            auto volume = [&](const std::string& name, ir::Volume& into) {
                if (pictures.contains(name)) into = {vec3(name), vec3(name + "-dx"), vec3(name + "-dy")};
            };
            volume("object-position", pixel.object);
            volume("world-position", pixel.world);
            out.push_back(pixel);
        }
    }
    return out;
}

std::vector<dvec3> draw_normals(const std::string& sample, Seen seen, Levels levels,
                                const target::ShaderLibrary& library,
                                const std::map<std::string, std::string>& other_files) {
    const truth::Made made = made_of(sample, "normal", levels, library, other_files);
    Diags diags;
    const auto view = runtime::find_view(made.artefact, "normal", diags);
    const runtime::Picture picture = draw(made, seen, {view.value()}).at("normal");
    std::vector<dvec3> out;
    for (std::uint32_t y = 0; y < kPixels; ++y) {
        for (std::uint32_t x = 0; x < kPixels; ++x) {
            if (truth::covered(picture, x, y)) out.push_back(truth::rgb(picture, x, y));
        }
    }
    return out;
}

}  // namespace sg::oracle
