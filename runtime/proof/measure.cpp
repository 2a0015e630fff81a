#include "runtime/proof/measure.hpp"

#include <fmt/core.h>

#include "runtime/mips.hpp"
#include "runtime/output.hpp"
#include "runtime/parameters.hpp"

namespace sg::proof {
namespace {

using runtime::Arguments;
using runtime::exit_code;
using runtime::Job;
using runtime::Picture;

// ---- heights of slopes ----

struct HeightSetting {
    std::string texture, file;
    double length = 1;
};

std::optional<HeightSetting> parse_height(const std::string& text, Diags& diags) {
    const std::size_t equals = text.find('='), colon = text.rfind(':');
    HeightSetting out;
    bool good = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
    if (good && colon != std::string::npos && colon > equals) {
        const auto number = runtime::parse_numbers(std::string_view(text).substr(colon + 1));
        good = number && number->size() == 1;
        if (good) out.length = (*number)[0];
    }
    if (!good) {
        diags.error(Code::bad_argument,
                    fmt::format("--height-of: expected TEXTURE=FILE or TEXTURE=FILE:LENGTH, "
                                "not '{}'",
                                printable(text)));
        return std::nullopt;
    }
    out.texture = text.substr(0, equals);
    const std::size_t end = colon != std::string::npos && colon > equals ? colon : text.size();
    out.file = text.substr(equals + 1, end - equals - 1);
    return out;
}

std::optional<std::size_t> texture_index(const ir::Module& module, std::string_view name, Diags& diags) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < module.textures.size(); ++i) {
        if (module.textures[i].name == name) return i;
        names.push_back(module.textures[i].name);
    }
    diags.error(Code::unknown_texture, fmt::format("--height-of: the material has no texture '{}'{}",
                                                   printable(name), did_you_mean(name, names)));
    return std::nullopt;
}

std::optional<std::map<std::string, Partner>> read_partners(std::span<const std::string> settings,
                                                            const std::filesystem::path& root, Judge& judge,
                                                            Files& files, Diags& diags) {
    std::map<std::string, Partner> out;
    for (const std::string& setting : settings) {
        const auto height = parse_height(setting, diags);
        if (!height) continue;
        const auto index = texture_index(judge.material->module, height->texture, diags);
        const auto bytes = read_or_report(files, (root.empty() ? "." : root) / height->file, diags);
        if (!index || !bytes) continue;
        const auto image = asset::read_image(*bytes, height->file, Place{}, diags);
        if (!image) continue;
        judge.texels.push_back(texels_of(runtime::mip_chain(*image, {})));
        ir::Sampled sampled = judge.material->bindings.textures[*index];
        sampled.texels = &judge.texels.back();
        out[height->texture] = {sampled, height->length};
    }
    if (diags.has_errors()) return std::nullopt;
    return out;
}

void report_missing(const ir::Module& module, const NoHeight& missing, Diags& diags) {
    const ir::Value& value = module.at(missing.value);
    std::string layer = "a layer";
    if (value.layer.valid()) {
        const ir::Layer& l = module.layers[value.layer.index];
        layer = fmt::format("layer '{}' ({})", printable(l.id), printable(l.kind));
    }
    std::string texture;
    if (ir::info(value.op).attribute == ir::Attribute::Texture)
        texture = fmt::format(", texture '{}'", printable(module.textures[value.index].name));
    diags.error(Code::no_height, fmt::format("{}{} has no height: {}", layer, texture, missing.why));
}

// ---- what is printed and written ----

double number(const Numbers& numbers, runtime::AngleLimit::Which which) {
    const double all[] = {numbers.median, numbers.p95, numbers.p99, numbers.max};
    return all[static_cast<int>(which)];
}

int report(const Angles& angles, const Arguments& arguments, Files& files, Diags& diags) {
    const Numbers numbers = numbers_of(angles.degrees);
    fmt::print("{}\n", text_of(numbers));
    std::fflush(stdout);
    if (!arguments.output.empty()) {
        const double scale = arguments.error_scale.value_or(round_scale(numbers.p99));
        const auto format = *runtime::picture_format(arguments.output);
        const runtime::DebugView view{"error", 0, 1, runtime::ViewKind::vector};
        const std::string bytes = format == runtime::PictureFormat::png
                                      ? asset::png_bytes(angle_map(angles, scale))
                                      : runtime::picture_bytes(angle_values(angles), view, format, {});
        if (!write_or_report(files, {{arguments.output, bytes}}, diags)) return exit_code(diags);
    }
    if (arguments.max_angle) {
        static constexpr const char* kWords[] = {"median", "95th percentile", "99th percentile",
                                                 "largest angle"};
        const double found = number(numbers, arguments.max_angle->which);
        if (!(found <= arguments.max_angle->degrees))
            diags.error(Code::angle_exceeded,
                        fmt::format("the {} is {:.4g} degrees, more than the {:g} that --max-angle allows",
                                    kWords[static_cast<int>(arguments.max_angle->which)], found,
                                    arguments.max_angle->degrees));
    }
    return exit_code(diags);
}

// ---- --compare ----

bool is_picture(const std::filesystem::path& path) {
    return runtime::picture_format(path).has_value();
}

// A float picture of normals; a pixel without a vector shows nothing.
std::optional<Picture> read_picture(const std::filesystem::path& path, Files& files, Diags& diags) {
    const auto bytes = read_or_report(files, path, diags);
    if (!bytes) return std::nullopt;
    auto image = asset::read_image(*bytes, path.string(), Place{}, diags);
    if (!image) return std::nullopt;
    if (image->format != asset::TexelFormat::float32) {
        diags.error(Code::not_comparable,
                    fmt::format("'{}' does not hold floats, expected normals as .exr or .pfm, as "
                                "surfgrad-render --view normal writes them",
                                printable(path.string())));
        return std::nullopt;
    }
    Picture out{std::move(*image), {}};
    for (std::uint32_t y = 0; y < out.values.height; ++y) {
        for (std::uint32_t x = 0; x < out.values.width; ++x) {
            double sum = 0;
            for (int c = 0; c < 3; ++c) sum += std::abs(out.values.at(x, y, c));
            out.coverage.push_back(sum != 0 ? 1.0f : 0.0f);
        }
    }
    return out;
}

std::optional<Picture> draw_normals(const Arguments& arguments, const std::filesystem::path& input,
                                    Files& files, int& code, Diags& diags) {
    const auto located = runtime::locate(input, arguments, "", files, code, diags);
    if (!located) return std::nullopt;
    const std::filesystem::path root = arguments.texture_root.value_or(input.parent_path());
    const auto job = runtime::prepare(arguments, located->manifest, root, "normal", files, diags);
    std::optional<Picture> out;
    if (job) {
        runtime::on_device(arguments, diags, [&](runtime::gpu::Device& device) {
            out = runtime::render(device, job->artefact, job->textures, job->scene, *job->view, job->options,
                                  diags);
            return out.has_value();
        });
    }
    code = exit_code(diags);
    return code == 0 ? out : std::nullopt;
}

std::optional<Picture> normals_of(const Arguments& arguments, const std::filesystem::path& input,
                                  Files& files, int& code, Diags& diags) {
    if (!is_picture(input)) return draw_normals(arguments, input, files, code, diags);
    auto out = read_picture(input, files, diags);
    code = exit_code(diags);
    return out;
}

}  // namespace

std::optional<Picture> draw_positions(runtime::gpu::Device& device, const Job& job, Diags& diags) {
    const auto view = runtime::find_view(job.artefact, "position", diags);
    if (!view) return std::nullopt;
    return runtime::render(device, job.artefact, job.textures, job.scene, *view, job.options, diags);
}

std::optional<Judge> make_judge(const Job& job, std::string_view mesh, const std::filesystem::path& manifest,
                                const std::filesystem::path& root, std::span<const std::string> heights,
                                Files& files, Diags& diags) {
    const auto shape = runtime::smooth_shape(mesh);
    if (!shape) {
        diags.error(
            Code::no_smooth_surface,
            fmt::format("'{}' stands for no smooth surface that could be displaced", printable(mesh)));
        return std::nullopt;
    }
    std::filesystem::path module = manifest;
    module.replace_extension(".ir");
    if (!files.exists(module)) {
        diags.error(Code::module_missing,
                    fmt::format("'{}' is not beside the manifest", printable(module.filename().string())));
        return std::nullopt;
    }
    const auto text = read_or_report(files, module, diags);
    if (!text) return std::nullopt;
    Judge out;
    out.material = load_material(*text, module.filename().string(), job.artefact, job.textures,
                                 job.options.parameters, diags);
    if (!out.material) return std::nullopt;
    auto partners = read_partners(heights, root, out, files, diags);
    if (!partners) return std::nullopt;
    out.camera = runtime::camera_matrices(job.scene.camera, runtime::bounds_of(job.scene.content),
                                          job.options.width, job.options.height);
    const Sight sight{*shape, glm::dmat4(job.scene.content.instances.at(0).world_from_object),
                      job.scene.camera.position, out.camera.relative_from_screen, job.options.time};
    out.truth =
        std::make_unique<Truth>(out.material->module, out.material->bindings, std::move(*partners), sight);
    if (const auto missing = out.truth->missing()) {
        report_missing(out.material->module, *missing, diags);
        return std::nullopt;
    }
    return out;
}

TruePictures true_normals(const Job& job, Judge& judge, const Picture& positions, bool held) {
    const asset::Image& v = positions.values;
    const Picture empty{asset::make_image(v.width, v.height, asset::TexelFormat::float32),
                        std::vector<float>(positions.coverage.size(), 0.0f)};
    TruePictures out{empty, empty, Angles(v.width, v.height), Angles(v.width, v.height)};
    auto put = [](Picture& picture, std::uint32_t x, std::uint32_t y, glm::dvec3 normal) {
        if (normal == glm::dvec3(0)) return;  // the ray misses the surface
        picture.coverage[std::size_t{y} * picture.values.width + x] = 1;
        for (int c = 0; c < 3; ++c) picture.values.set(x, y, c, normal[c]);
        picture.values.set(x, y, 3, 1);
    };
    for (std::uint32_t y = 0; y < v.height; ++y) {
        for (std::uint32_t x = 0; x < v.width; ++x) {
            if (positions.coverage[std::size_t{y} * v.width + x] == 0) continue;
            const glm::dvec3 point(v.at(x, y, 0), v.at(x, y, 1), v.at(x, y, 2));
            const glm::dvec3 sight = job.scene.camera.ortho_height > 0 ? judge.camera.direction : point;
            const TrueNormal truth = judge.truth->at(point, {x + 0.5, y + 0.5}, sight, held);
            put(out.normal, x, y, truth.normal);
            if (held) put(out.held, x, y, truth.held);
            if (truth.normal == glm::dvec3(0)) continue;
            out.tilt.at(x, y) = angle_degrees(truth.base, truth.normal);
            out.left_out.at(x, y) = truth.left_out;
        }
    }
    return out;
}

std::optional<Angles> error_angles(runtime::gpu::Device& device, const Job& job, Judge& judge, Diags& diags) {
    const auto normals =
        runtime::render(device, job.artefact, job.textures, job.scene, *job.view, job.options, diags);
    const auto positions = draw_positions(device, job, diags);
    if (!normals || !positions) return std::nullopt;
    return angles_between(*normals, true_normals(job, judge, *positions).normal);
}

int run_error_view(const Arguments& arguments, Files& files, Diags& diags) {
    int code = 0;
    const auto located = runtime::locate(arguments.input, arguments, "ir", files, code, diags);
    if (!located) return code;
    const std::filesystem::path root = arguments.texture_root.value_or(arguments.input.parent_path());
    const auto job = runtime::prepare(arguments, located->manifest, root, "normal", files, diags);
    if (!job) return exit_code(diags);
    auto judge = make_judge(*job, arguments.mesh, located->manifest, root, arguments.height_of, files, diags);
    std::optional<Angles> angles;
    auto draw = [&](runtime::gpu::Device& device) {
        angles = error_angles(device, *job, *judge, diags);
        return angles.has_value();
    };
    if (!judge || !runtime::on_device(arguments, diags, draw)) return exit_code(diags);
    return report(*angles, arguments, files, diags);
}

int run_compare(const Arguments& arguments, Files& files, Diags& diags) {
    int code = 0;
    const auto ours = normals_of(arguments, arguments.input, files, code, diags);
    if (!ours) return code;
    const auto theirs = normals_of(arguments, arguments.compare, files, code, diags);
    if (!theirs) return code;
    if (ours->values.width != theirs->values.width || ours->values.height != theirs->values.height) {
        diags.error(
            Code::not_comparable,
            fmt::format("'{}' has {}x{} pixels, but '{}' has {}x{}", printable(arguments.input.string()),
                        ours->values.width, ours->values.height, printable(arguments.compare.string()),
                        theirs->values.width, theirs->values.height));
        return exit_code(diags);
    }
    return report(angles_between(*ours, *theirs), arguments, files, diags);
}

}  // namespace sg::proof
