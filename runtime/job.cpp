#include "runtime/job.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "runtime/output.hpp"
#include "runtime/parameters.hpp"

namespace sg::runtime {
namespace {

constexpr int kCommandLineWrong = 2;

Camera chosen_camera(const Arguments& arguments, const Bounds& bounds) {
    Camera camera = arguments.camera
                        ? *arguments.camera
                        : default_camera(bounds, static_cast<double>(arguments.width) / arguments.height);
    if (arguments.ortho_height) camera.ortho_height = *arguments.ortho_height;
    return camera;
}

void choose_views(const Arguments& arguments, std::string_view view, Job& job, Diags& diags) {
    if (!view.empty()) job.view = find_view(job.artefact, view, diags);
    if (arguments.dump_inputs.empty()) return;
    job.dumped = debug_views(job.artefact);
    if (job.dumped.empty()) {
        diags.error(Code::unknown_view,
                    fmt::format("material '{}' has no debug views to dump", printable(job.artefact.name)));
    }
}

// Whether the input is a material; a file that cannot be read is reported.
std::optional<bool> is_material(Files& files, const std::filesystem::path& input, Diags& diags) {
    auto text = read_or_report(files, input, diags);
    if (!text) return std::nullopt;
    return !is_manifest(*text);
}

}  // namespace

int exit_code(const Diags& diags) {
    bool command_line = std::any_of(diags.all().begin(), diags.all().end(), [](const Diagnostic& d) {
        return d.severity == Severity::error && d.code == Code::bad_argument;
    });
    return command_line ? kCommandLineWrong : diags.exit_code();
}

std::optional<Located> locate(const std::filesystem::path& input, const Arguments& arguments,
                              const std::string& emit, Files& files, int& code, Diags& diags) {
    auto material = is_material(files, input, diags);
    const bool artefact = material && !*material;
    const bool asked = !arguments.numbers.empty() && input == arguments.input;
    if (artefact && !asked) return Located{input, std::nullopt};
    if (artefact) {
        diags.error(
            Code::bad_argument,
            fmt::format("--numbers: expected a material, '{}' is an artefact that was compiled before",
                        printable(input.string())));
        material.reset();
    }
    code = exit_code(diags);
    if (!material) return std::nullopt;
    auto folder = TemporaryFolder::create(diags);
    code = exit_code(diags);
    if (!folder) return std::nullopt;
    std::vector<std::string> options;
    if (!emit.empty()) options.insert(options.end(), {"--emit", emit});
    if (arguments.texture_root) options.insert(options.end(), {"-I", arguments.texture_root->string()});
    if (!arguments.numbers.empty()) options.insert(options.end(), {"--numbers", arguments.numbers});
    const auto ended = compile_material(compiler_beside_us(), input, folder->path(), diags, options);
    code = ended ? *ended : exit_code(diags);
    if (code != 0) return std::nullopt;
    std::filesystem::path manifest = folder->path() / input.stem();
    manifest += ".json";
    return Located{manifest, std::move(folder)};
}

std::optional<Job> prepare(const Arguments& arguments, const std::filesystem::path& manifest,
                           const std::filesystem::path& root, std::string_view view, Files& files,
                           Diags& diags) {
    auto artefact = read_artefact(files, manifest, diags);
    if (!artefact) return std::nullopt;
    Job job;
    job.artefact = std::move(*artefact);
    choose_views(arguments, view, job, diags);
    const std::vector<std::string> numbers = exchange_textures(job.artefact, arguments.parameters);
    auto parameters = pack_parameters(job.artefact, numbers, diags);
    auto textures = load_textures(files, job.artefact, root, diags);
    auto content = load_content(files, arguments.mesh, arguments.mesh_material, diags,
                                static_cast<int>(arguments.detail));
    if (diags.has_errors()) return std::nullopt;
    job.textures = std::move(*textures);
    job.scene.content = std::move(*content);
    job.scene.camera = chosen_camera(arguments, bounds_of(job.scene.content));
    if (arguments.light) job.scene.light.direction = *arguments.light;
    job.options = {arguments.width, arguments.height, arguments.supersample, arguments.time,
                   std::move(*parameters)};
    return job;
}

}  // namespace sg::runtime
