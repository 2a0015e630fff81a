#include "runtime/program.hpp"

#include <fmt/core.h>

#include "runtime/job.hpp"
#include "runtime/output.hpp"
#include "runtime/proof/measure.hpp"

namespace sg::runtime {
namespace {

int print_devices(Diags& diags) {
    auto devices = gpu::list_devices(diags);
    if (!devices) return diags.exit_code();
    for (const gpu::DeviceDescription& device : *devices) {
        fmt::print("{} ({}){}\n", device.name, device.kind,
                   device.refused.empty() ? "" : fmt::format(": cannot be used, {}", device.refused));
    }
    return 0;
}

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

}  // namespace

int run_program(const Arguments& arguments, Diags& diags) {
    if (arguments.list_devices) return print_devices(diags);
    RealFiles files;
    if (!arguments.compare.empty()) return proof::run_compare(arguments, files, diags);
    if (arguments.view == "error") return proof::run_error_view(arguments, files, diags);
    int code = 0;
    const auto located = locate(arguments.input, arguments, "", files, code, diags);
    if (!located) return code;
    const std::filesystem::path root = arguments.texture_root.value_or(arguments.input.parent_path());
    const std::string_view view = arguments.output.empty() ? "" : std::string_view(arguments.view);
    const auto job = prepare(arguments, located->manifest, root, view, files, diags);
    OutputFiles out;
    auto draw = [&](gpu::Device& device) {
        return (!job->view || draw_picture(device, arguments, *job, out, diags)) &&
               (job->dumped.empty() || draw_dump(device, arguments, *job, out, diags));
    };
    if (job && on_device(arguments, diags, draw)) write_or_report(files, out, diags);
    return exit_code(diags);
}

}  // namespace sg::runtime
