// The command line of surfgrad-render.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "runtime/camera.hpp"

namespace sg::runtime {

// What an angle may be at most, degrees, and which of the numbers is held to it.
struct AngleLimit {
    enum class Which { median, p95, p99, max };
    double degrees = 0;
    Which which = Which::max;
};

struct Arguments {
    std::filesystem::path input;  // a manifest or a material
    std::filesystem::path output;
    std::filesystem::path dump_inputs;
    std::string mesh = "sphere";
    std::string mesh_material;  // "": all of the scene
    std::string view = "lit";
    std::uint32_t width = 512, height = 512;
    std::uint32_t supersample = 1;
    std::optional<Camera> camera;         // none: the default one
    std::optional<double> ortho_height;   // world units
    std::optional<glm::dvec3> light;      // towards the light
    std::vector<std::string> parameters;  // NAME=VALUE
    std::uint32_t detail = 1;             // of a built-in shape: times as fine
    std::filesystem::path compare;        // what to compare the normals with
    std::vector<std::string> height_of;   // TEXTURE=FILE[:LENGTH], of the error view
    std::optional<AngleLimit> max_angle;
    std::optional<double> error_scale;  // degrees
    double time = 0;                    // seconds
    double exposure = 0;                // stops
    std::string device;
    std::optional<std::filesystem::path> texture_root;
    std::string numbers;  // surfgradc's --numbers; "" where it was not given
    bool validate = false;
    bool list_devices = false;

    // Whether angles are what is wanted.
    [[nodiscard]] bool measures() const { return view == "error" || !compare.empty(); }
};

// Either arguments, or the exit code to leave with (after --help and --version 0, after a wrong command line
// 2); what there is to say has been printed then.
struct CommandLine {
    std::optional<Arguments> arguments;
    int exit_code = 0;
};
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace sg::runtime
