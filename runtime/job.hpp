// Everything about a run that needs no device, so that its errors come first and cost nothing.
#pragma once

#include "runtime/cli.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/material_process.hpp"
#include "runtime/render.hpp"

namespace sg::runtime {

// Where an input's manifest is: itself, or in a folder of ours that its material was compiled into.
struct Located {
    std::filesystem::path manifest;
    std::optional<TemporaryFolder> folder;
};
// Empty: `code` is what to leave with. emit: what else surfgradc is to write of a material (--emit), or "".
// Of the arguments surfgradc gets the texture root, a further folder to look for files in, and --numbers.
std::optional<Located> locate(const std::filesystem::path& input, const Arguments& arguments,
                              const std::string& emit, Files& files, int& code, Diags& diags);

struct Job {
    Artefact artefact;
    TextureSet textures;
    Scene scene;
    RenderOptions options;
    std::optional<View> view;  // where a picture is wanted
    std::vector<View> dumped;
};
// root: the folder of the textures. view: the name of what -o shows; "" for none.
std::optional<Job> prepare(const Arguments& arguments, const std::filesystem::path& manifest,
                           const std::filesystem::path& root, std::string_view view, Files& files,
                           Diags& diags);

// Calls `draw(device)` with the device that was asked for; afterwards the validation layers may add errors.
// The device lives inside, so that they also see it end.
template <class Draw>
bool on_device(const Arguments& arguments, Diags& diags, Draw draw) {
    std::shared_ptr<const gpu::ValidationLog> log;
    bool ok = false;
    {
        auto device = gpu::Device::create({arguments.device, arguments.validate}, diags);
        if (!device) return false;
        log = device->log();
        ok = draw(*device);
    }
    const bool silent = !log || log->report(diags);
    return ok && silent;
}

using OutputFiles = std::vector<std::pair<std::filesystem::path, std::string>>;

// 0, or what the worst of the errors means.
int exit_code(const Diags& diags);

}  // namespace sg::runtime
