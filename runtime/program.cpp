#include "runtime/program.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "runtime/gpu/device.hpp"
#include "runtime/material_process.hpp"
#include "runtime/output.hpp"
#include "runtime/parameters.hpp"
#include "runtime/render.hpp"
#include "runtime/scene.hpp"

namespace sg::runtime {
namespace {

constexpr int kCommandLineWrong = 2;

int exit_code(const Diags& diags) {
    bool command_line = std::any_of(diags.all().begin(), diags.all().end(), [](const Diagnostic& d) {
        return d.severity == Severity::error && d.code == Code::bad_argument;
    });
    return command_line ? kCommandLineWrong : diags.exit_code();
}

int print_devices(Diags& diags) {
    auto devices = gpu::list_devices(diags);
    if (!devices) return diags.exit_code();
    for (const gpu::DeviceDescription& device : *devices) {
        fmt::print("{} ({}){}\n", device.name, device.kind,
                   device.refused.empty() ? "" : fmt::format(": cannot be used, {}", device.refused));
    }
    return 0;
}

// Everything about the job that needs no device, so that its errors come first and cost nothing.
struct Job {
    Artefact artefact;
    TextureSet textures;
    Scene scene;
    RenderOptions options;
    std::optional<View> view;  // where a picture is wanted
    std::vector<View> dumped;
};

Camera chosen_camera(const Arguments& arguments, const Bounds& bounds) {
    Camera camera = arguments.camera
                        ? *arguments.camera
                        : default_camera(bounds, static_cast<double>(arguments.width) / arguments.height);
    if (arguments.ortho_height) camera.ortho_height = *arguments.ortho_height;
    return camera;
}

void choose_views(const Arguments& arguments, Job& job, Diags& diags) {
    if (!arguments.output.empty()) job.view = find_view(job.artefact, arguments.view, diags);
    if (arguments.dump_inputs.empty()) return;
    job.dumped = debug_views(job.artefact);
    if (job.dumped.empty()) {
        diags.error(Code::unknown_view,
                    fmt::format("material '{}' has no debug views to dump", printable(job.artefact.name)));
    }
}

std::optional<Job> prepare(const Arguments& arguments, const std::filesystem::path& manifest,
                           const std::filesystem::path& texture_root, Files& files, Diags& diags) {
    auto artefact = read_artefact(files, manifest, diags);
    if (!artefact) return std::nullopt;
    Job job;
    job.artefact = std::move(*artefact);
    choose_views(arguments, job, diags);
    auto parameters = pack_parameters(job.artefact, arguments.parameters, diags);
    auto textures = load_textures(files, job.artefact, texture_root, diags);
    auto content = load_content(files, arguments.mesh, arguments.mesh_material, diags);
    if (diags.has_errors()) return std::nullopt;
    job.textures = std::move(*textures);
    job.scene.content = std::move(*content);
    job.scene.camera = chosen_camera(arguments, bounds_of(job.scene.content));
    if (arguments.light) job.scene.light.direction = *arguments.light;
    job.options = {arguments.width, arguments.height, arguments.supersample, arguments.time,
                   std::move(*parameters)};
    return job;
}

using OutputFiles = std::vector<std::pair<std::filesystem::path, std::string>>;

bool draw_picture(gpu::Device& device, const Arguments& arguments, const Job& job, OutputFiles& out,
                  Diags& diags) {
    auto picture = render(device, job.artefact, job.textures, job.scene, *job.view, job.options, diags);
    if (!picture) return false;
    DisplayOptions display{arguments.exposure, {bounds_of(job.scene.content), job.scene.camera.position}};
    out.emplace_back(arguments.output,
                     picture_bytes(*picture, job.view->view, *picture_format(arguments.output), display));
    return true;
}

bool draw_dump(gpu::Device& device, const Arguments& arguments, const Job& job, OutputFiles& out,
               Diags& diags) {
    auto renderer =
        Renderer::create(device, job.artefact, job.textures, job.scene, job.options, "debug", diags);
    if (!renderer) return false;
    std::vector<Picture> pictures;
    for (const View& view : job.dumped) {
        auto picture = renderer->draw(view.view, diags);
        if (!picture) return false;
        pictures.push_back(std::move(*picture));
    }
    out.emplace_back(arguments.dump_inputs, layered_exr(job.dumped, std::move(pictures)));
    return true;
}

// The device lives inside, so that the validation layers also see it end.
bool draw(const Arguments& arguments, const Job& job, OutputFiles& out, Diags& diags) {
    std::shared_ptr<const gpu::ValidationLog> log;
    bool ok = false;
    {
        auto device = gpu::Device::create({arguments.device, arguments.validate}, diags);
        if (!device) return false;
        log = device->log();
        ok = !job.view || draw_picture(*device, arguments, job, out, diags);
        ok = ok && (job.dumped.empty() || draw_dump(*device, arguments, job, out, diags));
    }
    bool silent = !log || log->report(diags);
    return ok && silent;
}

// Whether the input is a material; a file that cannot be read is reported.
std::optional<bool> is_material(Files& files, const std::filesystem::path& input, Diags& diags) {
    auto text = read_or_report(files, input, diags);
    if (!text) return std::nullopt;
    return !is_manifest(*text);
}

int draw_and_write(const Arguments& arguments, const std::filesystem::path& manifest, Files& files,
                   Diags& diags) {
    std::filesystem::path root = arguments.texture_root.value_or(arguments.input.parent_path());
    auto job = prepare(arguments, manifest, root, files, diags);
    OutputFiles out;
    if (job && draw(arguments, *job, out, diags)) write_or_report(files, out, diags);
    return exit_code(diags);
}

}  // namespace

int run_program(const Arguments& arguments, Diags& diags) {
    if (arguments.list_devices) return print_devices(diags);
    RealFiles files;
    auto material = is_material(files, arguments.input, diags);
    if (!material) return exit_code(diags);
    if (!*material) return draw_and_write(arguments, arguments.input, files, diags);
    auto folder = TemporaryFolder::create(diags);
    if (!folder) return exit_code(diags);
    auto code = compile_material(compiler_beside_us(), arguments.input, folder->path(), diags);
    if (!code) return exit_code(diags);
    if (*code != 0) return *code;
    std::filesystem::path manifest = folder->path() / arguments.input.stem();
    manifest += ".json";
    return draw_and_write(arguments, manifest, files, diags);
}

}  // namespace sg::runtime
