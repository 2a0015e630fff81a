#include "runtime/cli.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/output.hpp"
#include "runtime/parameters.hpp"

namespace sg::runtime {
namespace {

constexpr int kCommandLineWrong = 2;
constexpr std::uint32_t kMaxSide = 16384;
constexpr std::uint32_t kMaxSupersample = 8;
constexpr std::uint32_t kMaxDetail = 16;
constexpr double kMaxPixels = 1u << 26u;  // drawn, so with --supersample: about 4 GB in all

// The options that are texts with an inner form.
struct Texts {
    std::string size, camera, light, max_angle;
};

void bad(Diags& diags, std::string_view option, std::string_view expected, std::string_view text) {
    diags.error(Code::bad_argument,
                fmt::format("{}: expected {}, not '{}'", option, expected, printable(text)));
}

std::optional<glm::dvec3> parse_point(std::string_view text) {
    auto numbers = parse_numbers(text);
    if (!numbers || numbers->size() != 3) return std::nullopt;
    return glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

void parse_size(const std::string& text, Arguments& out, Diags& diags) {
    std::size_t cross = text.find('x');
    auto width = parse_numbers(std::string_view(text).substr(0, cross));
    auto height =
        cross == std::string::npos ? width : parse_numbers(std::string_view(text).substr(cross + 1));
    auto is_side = [](const auto& n) {
        return n && n->size() == 1 && (*n)[0] >= 1 && (*n)[0] <= kMaxSide && (*n)[0] == std::floor((*n)[0]);
    };
    if (!is_side(width) || !is_side(height)) {
        return bad(diags, "--size", fmt::format("WIDTHxHEIGHT, each from 1 to {}", kMaxSide), text);
    }
    out.width = static_cast<std::uint32_t>((*width)[0]);
    out.height = static_cast<std::uint32_t>((*height)[0]);
    if ((*width)[0] * (*height)[0] * out.supersample * out.supersample > kMaxPixels) {
        bad(diags, "--size and --supersample", "at most 67108864 pixels to draw",
            fmt::format("{} times {} squared", text, out.supersample));
    }
}

void parse_camera(const std::string& text, Arguments& out, Diags& diags) {
    std::size_t first = text.find(':');
    std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
    std::optional<glm::dvec3> position, target;
    if (first != std::string::npos) {
        position = parse_point(std::string_view(text).substr(0, first));
        target = parse_point(std::string_view(text).substr(first + 1, second - first - 1));
    }
    Camera camera;
    bool fov_ok = true;
    if (second != std::string::npos) {
        auto fov = parse_numbers(std::string_view(text).substr(second + 1));
        fov_ok = fov && fov->size() == 1 && (*fov)[0] >= 0.1 && (*fov)[0] <= 170;
        if (fov_ok) camera.fov_degrees = (*fov)[0];
    }
    if (!position || !target || *position == *target || !fov_ok) {
        return bad(diags, "--camera",
                   "X,Y,Z:X,Y,Z or X,Y,Z:X,Y,Z:FOV (two different points, 0.1 to 170 degrees)", text);
    }
    camera.position = *position;
    camera.target = *target;
    out.camera = camera;
}

void parse_light(const std::string& text, Arguments& out, Diags& diags) {
    out.light = parse_point(text);
    if (!out.light || glm::length(*out.light) == 0) bad(diags, "--light", "X,Y,Z, not all 0", text);
}

void parse_limit(const std::string& text, Arguments& out, Diags& diags) {
    static constexpr std::array<std::string_view, 4> kWords = {"median", "p95", "p99", "max"};
    const std::size_t colon = text.find(':');
    const auto number = parse_numbers(std::string_view(text).substr(0, colon));
    const std::string word = colon == std::string::npos ? "max" : text.substr(colon + 1);
    const auto which = std::find(kWords.begin(), kWords.end(), word);
    if (!number || number->size() != 1 || (*number)[0] < 0 || which == kWords.end())
        return bad(diags, "--max-angle", "DEGREES or DEGREES:median, :p95, :p99 or :max", text);
    out.max_angle = {(*number)[0], static_cast<AngleLimit::Which>(which - kWords.begin())};
}

// What goes with --view error and --compare alone.
void check_angles(const Texts& texts, Arguments& out, Diags& diags) {
    const bool measures = out.measures();
    if (!texts.max_angle.empty()) parse_limit(texts.max_angle, out, diags);
    if (out.error_scale && !(*out.error_scale > 0 && *out.error_scale <= 180))
        bad(diags, "--error-scale", "more than 0 and at most 180 degrees",
            fmt::format("{}", *out.error_scale));
    if (!measures && (out.max_angle || out.error_scale))
        diags.error(Code::bad_argument,
                    "--max-angle and --error-scale: expected --view error or --compare beside them");
    if (out.view != "error" && !out.height_of.empty())
        diags.error(Code::bad_argument, "--height-of: expected --view error beside it");
    if (measures && !out.dump_inputs.empty())
        diags.error(Code::bad_argument,
                    "--dump-inputs: expected neither --view error nor --compare beside it");
    if (out.view == "error" && !out.compare.empty())
        diags.error(Code::bad_argument, "--compare: expected another view than error beside it");
    if (measures && out.supersample > 1)
        diags.error(Code::bad_argument, "--supersample: expected 1 where angles are measured");
}

void check(const Texts& texts, Arguments& out, Diags& diags) {
    parse_size(texts.size, out, diags);
    if (!texts.camera.empty()) parse_camera(texts.camera, out, diags);
    if (!texts.light.empty()) parse_light(texts.light, out, diags);
    if (out.ortho_height && !(*out.ortho_height > 0 && std::isfinite(*out.ortho_height))) {
        bad(diags, "--ortho", "a height above 0", fmt::format("{}", *out.ortho_height));
    }
    if (!std::isfinite(out.time) || !std::isfinite(out.exposure)) {
        bad(diags, "--time and --exposure", "finite numbers", "nan or inf");
    }
    std::error_code fault;
    if (out.texture_root && !std::filesystem::is_directory(*out.texture_root, fault))
        bad(diags, "--texture-root", "a folder", out.texture_root->string());
    if (out.list_devices) return;
    check_angles(texts, out, diags);
    if (out.input.empty())
        diags.error(Code::bad_argument, "no artefact and no material is given; see --help");
    if (out.output.empty() && out.dump_inputs.empty() && !out.measures()) {
        diags.error(Code::bad_argument, "nothing to write: give -o FILE or --dump-inputs FILE");
    }
    if (!out.output.empty() && out.output.lexically_normal() == out.dump_inputs.lexically_normal()) {
        bad(diags, "--dump-inputs", "another file than -o", out.dump_inputs.string());
    }
    if (!out.output.empty() && !picture_format(out.output)) {
        bad(diags, "--output", "a file that ends in .png, .exr or .pfm", out.output.string());
    }
    if (!out.dump_inputs.empty() && picture_format(out.dump_inputs) != PictureFormat::exr) {
        bad(diags, "--dump-inputs", "a file that ends in .exr", out.dump_inputs.string());
    }
}

void add_options(CLI::App& app, Arguments& out, Texts& texts) {
    app.add_option("input", out.input, "an artefact's manifest, or a material, which is then compiled first");
    app.add_option("-o,--output", out.output,
                   "the picture: .png (for the eye), .exr or .pfm (raw 32-bit floats)");
    app.add_option(
           "--mesh", out.mesh,
           "a built-in shape (plane, sphere, torus, cube, rounded_cube, rock) or a .gltf or .glb file")
        ->capture_default_str();
    app.add_option("--mesh-material", out.mesh_material,
                   "draw only what has this material in the .gltf or .glb file");
    app.add_option("--detail", out.detail, "triangles of a built-in shape are so many times smaller per side")
        ->check(CLI::Range(1u, kMaxDetail))
        ->capture_default_str();
    app.add_option("--view", out.view,
                   "lit, normal, a debug view of the material, or error: the angle to the normal of the "
                   "surface that is really displaced")
        ->capture_default_str();
    app.add_option("--compare", out.compare,
                   "the angle to the normals of another material, artefact or picture (.exr, .pfm)");
    app.add_option("--max-angle", texts.max_angle,
                   "DEGREES[:median|p95|p99|max]: fail above it (with --view error or --compare)");
    app.add_option("--error-scale", out.error_scale, "degrees at the bright end of the map of angles");
    app.add_option("--height-of", out.height_of,
                   "TEXTURE=FILE[:LENGTH]: the height map that a map of slopes was baked from, and the world "
                   "length of its value 1 (repeatable; with --view error)")
        ->allow_extra_args(false);
    app.add_option("--size", texts.size, "WIDTHxHEIGHT in pixels, or one number for both")
        ->capture_default_str();
    app.add_option("--camera", texts.camera,
                   "X,Y,Z:X,Y,Z[:FOV]: position, target, vertical field of view in degrees");
    app.add_option("--ortho", out.ortho_height,
                   "an orthographic camera that sees so many world units vertically");
    app.add_option("--light", texts.light, "X,Y,Z: the direction towards the light, world axes");
    app.add_option(
           "--param", out.parameters,
           "NAME=VALUE, NAME=V,V,V or, of a texture, NAME=FILE: a parameter of the material (repeatable)")
        ->allow_extra_args(false);
    app.add_option("--time", out.time, "seconds")->capture_default_str();
    app.add_option("--exposure", out.exposure, "stops, of the lit view's PNG")->capture_default_str();
    app.add_option("--supersample", out.supersample, "draw N times larger per side and shrink")
        ->check(CLI::Range(1u, kMaxSupersample))
        ->capture_default_str();
    app.add_option("--texture-root", out.texture_root,
                   "the folder of the textures (default: the input's folder)");
    app.add_option(
           "--numbers", out.numbers,
           "of a material: compile its numbers into the shader (baked) or into the block (uniforms), as "
           "surfgradc does")
        ->check(CLI::IsMember({"baked", "uniforms"}));
    app.add_option("--dump-inputs", out.dump_inputs, "write every debug view as a layer of this .exr");
    app.add_option("--device", out.device, "part of the device's name (default: a GPU, else the CPU device)");
    app.add_flag("--validate", out.validate, "fail on any message of the Vulkan validation layers");
    app.add_flag("--list-devices", out.list_devices, "print the devices and leave");
    app.set_version_flag("--version", SG_VERSION_TEXT);
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
    Arguments arguments;
    Texts texts;
    texts.size = "512x512";
    CLI::App app("Draws a compiled material.", "surfgrad-render");
    add_options(app, arguments, texts);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        int code = app.exit(error);
        return {std::nullopt, code == 0 ? 0 : kCommandLineWrong};
    }
    Diags diags;
    check(texts, arguments, diags);
    if (!diags.has_errors()) return {arguments, 0};
    fmt::print(stderr, "{}", render(diags));
    return {std::nullopt, kCommandLineWrong};
}

}  // namespace sg::runtime
