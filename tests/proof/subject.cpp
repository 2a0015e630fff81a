#include "tests/proof/subject.hpp"

#include <random>

namespace sg::proof {
namespace {

constexpr double kPixels = 65536;

// Any picture will do: functions take its place.
std::string any_picture() {
    asset::Image image = asset::make_image(4, 4, asset::TexelFormat::unorm8);
    return asset::png_bytes(image);
}

}  // namespace

Subject::Subject(const std::string& json,
                 const std::map<std::string, std::function<ref::dvec4(ref::dvec2)>>& textures) {
    truth::Recipe recipe{json, truth::sample_files()};
    recipe.files["any.png"] = any_picture();
    truth::Made made = truth::make(recipe);
    Diags diags;
    material_ = load_material(made.ir, "case.ir", made.artefact, made.textures, made.parameters, diags);
    if (!material_) throw std::runtime_error(render(diags));
    for (std::size_t i = 0; i < material_->module.textures.size(); ++i) {
        const auto found = textures.find(material_->module.textures[i].name);
        if (found == textures.end()) continue;
        functions_.emplace_back(found->second);
        material_->bindings.textures[i].texels = &functions_.back();
    }
}

void Subject::give_partner(const std::string& texture, std::function<double(ref::dvec2)> height,
                           double length) {
    functions_.emplace_back([height](ref::dvec2 st) { return ref::dvec4(height(st)); });
    Partner partner;
    partner.heights.texels = &functions_.back();
    partner.length = length;
    partners_[texture] = partner;
}

Truth Subject::truth(runtime::SmoothShape shape, const glm::dmat4& world_from_object) {
    return truth(
        Sight{shape, world_from_object, glance_camera().position, glance_matrices().relative_from_screen, 0});
}

Truth Subject::truth(const Sight& sight) const {
    return Truth(material_->module, material_->bindings, partners_, sight);
}

glm::dvec3 Subject::shaded(const ir::PixelInputs& inputs) {
    ir::Evaluator evaluator(material_->module, material_->bindings);
    evaluator.run(inputs);
    return std::get<ref::dvec3>(evaluator.output(ir::Output::normal));
}

runtime::Camera glance_camera() {
    runtime::Camera out;
    out.position = glm::dvec3(1, 1.1, 2.4) * 2.0;
    return out;
}

runtime::CameraMatrices glance_matrices() {
    runtime::Bounds bounds{glm::dvec3(-1.5), glm::dvec3(1.5), glm::dvec3(0), 2.6};
    return camera_matrices(glance_camera(), bounds, kPixels, kPixels);
}

std::vector<Glance> glances(runtime::SmoothShape shape, std::size_t count, unsigned seed,
                            const std::function<bool(const runtime::Foot&)>& keep) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(-1.5, 1.5);
    const glm::dvec3 eye = glance_camera().position;
    const glm::dmat4 clip_from_relative = glance_matrices().clip_from_relative;
    std::vector<Glance> out;
    while (out.size() < count) {
        const glm::dvec3 near(side(random), side(random), side(random));
        if (glm::length(near) < 0.3) continue;
        const runtime::Foot foot = foot_of(shape, near);
        if (shape == runtime::SmoothShape::plane && glm::length(foot.position) > 1) continue;
        if (keep && !keep(foot)) continue;
        const glm::dvec3 relative = foot.position - eye;
        if (glm::dot(glm::normalize(-relative), foot.normal) < 0.34) continue;
        const glm::dvec4 clip = clip_from_relative * glm::dvec4(relative, 1);
        out.push_back({relative, (glm::dvec2(clip) / clip.w + 1.0) * 0.5 * kPixels});
    }
    return out;
}

}  // namespace sg::proof
