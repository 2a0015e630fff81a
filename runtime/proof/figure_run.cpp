#include "runtime/proof/figure_run.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "runtime/output.hpp"
#include "runtime/proof/measure.hpp"
#include "runtime/tonemap.hpp"

namespace sg::proof {
namespace {

using runtime::Arguments;
using runtime::Job;
using runtime::Picture;

constexpr std::uint32_t kSupersample = 2;

Arguments arguments_of(const Figure& figure, const std::string& material,
                       const std::vector<std::string>& parameters, std::uint32_t shrink) {
    Arguments out;
    out.input = figure.folder / material;
    out.mesh = figure.mesh;
    out.detail = figure.detail;
    out.width = std::max(figure.width / shrink, 1u);
    out.height = std::max(figure.height / shrink, 1u);
    out.camera = figure.camera;
    out.light = figure.light;
    out.parameters = parameters;
    out.texture_root = figure.materials;
    return out;
}

// A material compiled for this figure; keeps the folder that it lies in.
struct Compiled {
    runtime::Located located;
    Job job;
};
std::optional<Compiled> compile(const Arguments& arguments, std::string_view view, Files& files,
                                Diags& diags) {
    int code = 0;
    auto located = runtime::locate(arguments.input, arguments, "ir,glsl", files, code, diags);
    if (!located) {
        if (!diags.has_errors())
            diags.error(Code::claim_failed,
                        fmt::format("'{}' does not compile", printable(arguments.input.string())));
        return std::nullopt;
    }
    auto job = runtime::prepare(arguments, located->manifest, *arguments.texture_root, view, files, diags);
    if (!job) return std::nullopt;
    return Compiled{std::move(*located), std::move(*job)};
}

std::optional<Picture> draw(runtime::gpu::Device& device, Job& job, std::string_view view,
                            std::uint32_t supersample, Diags& diags) {
    const auto found = runtime::find_view(job.artefact, view, diags);
    if (!found) return std::nullopt;
    job.options.supersample = supersample;
    auto out = runtime::render(device, job.artefact, job.textures, job.scene, *found, job.options, diags);
    job.options.supersample = 1;
    return out;
}

std::optional<DrawnPicture> draw_one(const Figure& figure, const FigurePicture& picture, std::uint32_t shrink,
                                     runtime::gpu::Device& device, Files& files, Diags& diags) {
    const Arguments arguments = arguments_of(figure, picture.material, picture.parameters, shrink);
    auto compiled = compile(arguments, "lit", files, diags);
    if (!compiled) return std::nullopt;
    const auto lit = draw(device, compiled->job, "lit", kSupersample, diags);
    auto normals = draw(device, compiled->job, "normal", 1, diags);
    if (!lit || !normals) return std::nullopt;
    DrawnPicture out{picture};
    out.lit = asset::png_bytes(runtime::lit_to_display(*lit, 0));
    out.normals = std::move(*normals);
    out.json = files.read(arguments.input).bytes;
    std::filesystem::path glsl = compiled->located.manifest.parent_path() / arguments.input.stem();
    glsl += ".forward.frag.glsl";
    out.glsl = files.read(glsl).bytes;
    return out;
}

std::optional<TruePictures> draw_truth(const Figure& figure, std::uint32_t shrink,
                                       runtime::gpu::Device& device, Files& files, Diags& diags) {
    auto compiled =
        compile(arguments_of(figure, figure.truth, figure.truth_parameters, shrink), "normal", files, diags);
    if (!compiled) return std::nullopt;
    auto judge = make_judge(compiled->job, figure.mesh, compiled->located.manifest, figure.materials,
                            figure.heights, files, diags);
    if (!judge) return std::nullopt;
    const auto positions = draw_positions(device, compiled->job, diags);
    if (!positions) return std::nullopt;
    return true_normals(compiled->job, *judge, *positions, figure.held);
}

// Grey by the cosine to the light: enough to see the shape.
std::string shaded(const Picture& normals, glm::dvec3 light) {
    asset::Image out =
        asset::make_image(normals.values.width, normals.values.height, asset::TexelFormat::unorm8);
    const glm::dvec3 towards = glm::normalize(light);
    for (std::uint32_t y = 0; y < out.height; ++y) {
        for (std::uint32_t x = 0; x < out.width; ++x) {
            if (normals.coverage[std::size_t{y} * out.width + x] == 0) continue;
            const asset::Image& v = normals.values;
            const double cosine = glm::dot(glm::dvec3(v.at(x, y, 0), v.at(x, y, 1), v.at(x, y, 2)), towards);
            for (int c = 0; c < 3; ++c)
                out.set(x, y, c, runtime::srgb_encode(0.06 + 0.6 * std::max(cosine, 0.0)));
            out.set(x, y, 3, 1);
        }
    }
    return asset::png_bytes(out);
}

const DrawnPicture& picture_named(const DrawnFigure& figure, const std::string& id) {
    return *std::find_if(figure.pictures.begin(), figure.pictures.end(),
                         [&](const DrawnPicture& p) { return p.picture.id == id; });
}

double number(const Numbers& numbers, const std::string& name) {
    if (name == "p95") return numbers.p95;
    if (name == "p99") return numbers.p99;
    return name == "max" ? numbers.max : numbers.median;
}

// The angles of the pixels that a claim is about.
Numbers claimed(const Claim& claim, const std::vector<double>& degrees, const DrawnFigure& figure) {
    std::vector<double> out;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        if (claim.tilted > 0 && !(figure.tilt[i] >= claim.tilted)) continue;
        out.push_back(claim.beyond ? std::max(degrees[i] - figure.left_out[i], 0.0) : degrees[i]);
    }
    return numbers_of(std::move(out));
}

void judge_claim(const Claim& claim, DrawnFigure& out, Diags& diags) {
    const DrawnPicture& picture = picture_named(out, claim.picture);
    std::size_t pixels = 0;
    auto angles = [&](const DrawnPicture& p) {
        const Numbers numbers = claimed(claim, claim.held ? p.held_degrees : p.degrees, out);
        pixels = numbers.count;
        return number(numbers, claim.number);
    };
    double found = angles(picture);
    bool holds = false;
    std::string measured;
    switch (claim.kind) {
        case Claim::Kind::below:
        case Claim::Kind::above:
            holds = claim.kind == Claim::Kind::below ? found < claim.value : found > claim.value;
            measured = fmt::format("{}: {} {:.3g} degrees, {} {:g}", picture.picture.label, claim.number,
                                   found, claim.kind == Claim::Kind::below ? "below" : "above", claim.value);
            break;
        case Claim::Kind::times: {
            const DrawnPicture& other = picture_named(out, claim.other);
            const double least = angles(other);
            holds = found >= claim.value * least;
            measured = fmt::format("{}: {} {:.3g} degrees, {:.3g} times {:.3g} of {}, at least {:g}",
                                   picture.picture.label, claim.number, found, found / std::max(least, 1e-9),
                                   least, other.picture.label, claim.value);
            break;
        }
        case Claim::Kind::apart: {
            const DrawnPicture& other = picture_named(out, claim.other);
            const Numbers numbers =
                claimed(claim, angles_between(picture.normals, other.normals).degrees, out);
            pixels = numbers.count;
            found = number(numbers, claim.number);
            holds = found < claim.value;
            measured = fmt::format("{} and {}: {} {:.3g} degrees apart, below {:g}", picture.picture.label,
                                   other.picture.label, claim.number, found, claim.value);
            break;
        }
    }
    if (claim.beyond) measured += " beyond what bump mapping leaves out";
    if (claim.tilted > 0)
        measured += fmt::format("; of {} pixels tilted by {:g} degrees or more", pixels, claim.tilted);
    holds = holds && pixels > 0;
    if (!holds)
        diags.error(Code::claim_failed, claim.place, fmt::format("the claim does not hold: {}", measured));
    out.claims.emplace_back(claim.text + " (" + measured + ")", holds);
}

}  // namespace

std::optional<DrawnFigure> draw_figure(const Figure& figure, std::uint32_t shrink,
                                       runtime::gpu::Device& device, Files& files, Diags& diags) {
    DrawnFigure out{figure};
    for (const FigurePicture& picture : figure.pictures) {
        auto drawn = draw_one(figure, picture, shrink, device, files, diags);
        if (!drawn) return std::nullopt;
        out.pictures.push_back(std::move(*drawn));
    }
    if (!figure.truth.empty()) {
        const auto truth = draw_truth(figure, shrink, device, files, diags);
        if (!truth) return std::nullopt;
        out.truth = shaded(truth->normal, figure.light.value_or(runtime::Light{}.direction));
        out.tilt = truth->tilt.degrees;
        out.left_out = truth->left_out.degrees;
        std::vector<Angles> all;
        double worst = 0;
        for (DrawnPicture& picture : out.pictures) {
            all.push_back(angles_between(picture.normals, truth->normal));
            picture.degrees = all.back().degrees;
            picture.numbers = numbers_of(picture.degrees);
            if (figure.held) picture.held_degrees = angles_between(picture.normals, truth->held).degrees;
            picture.held = numbers_of(picture.held_degrees);
            worst = std::max(worst, picture.numbers.p95);
        }
        if (figure.held) {
            const std::vector<double> weights = angles_between(truth->normal, truth->held).degrees;
            for (std::size_t i = 0; i < weights.size(); ++i) out.left_out[i] += weights[i];
            out.neglected = numbers_of(weights);
        }
        out.most_left_out = numbers_of(out.left_out);
        // One scale for all pictures of the figure, so that they can be compared by eye.
        for (std::size_t i = 0; i < all.size(); ++i)
            out.pictures[i].error = asset::png_bytes(angle_map(all[i], round_scale(worst)));
    }
    for (const Claim& claim : figure.claims) judge_claim(claim, out, diags);
    return out;
}

}  // namespace sg::proof
