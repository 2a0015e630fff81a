#include "tests/proof/variants.hpp"

#include <fmt/core.h>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/mesh/shapes.hpp"
#include "runtime/proof/angles.hpp"

namespace sg::proof {
namespace {

using glm::dvec3;
using runtime::SmoothShape;

constexpr dvec3 kStretch(1.2, 0.8, 1.2);  // along the torus' axis: its parameter lines stay perpendicular

constexpr std::uint32_t kTruthsPerSide = 14;

bool inside(Change change) {
    return change == Change::inside_mirror || change == Change::inside_flip;
}

glm::dmat4 placement(Change change) {
    const glm::dmat4 one(1);
    if (change == Change::negative) return glm::scale(one, dvec3(-1, 1, 1));
    if (change != Change::stretched) return one;
    return glm::scale(glm::rotate(one, 0.4, glm::normalize(dvec3(1, 2, 3))), kStretch);
}

// Both uv sets with s turned round, and the tangents, which belong to the first.
void mirror_uvs(asset::Mesh& mesh) {
    for (auto& set : mesh.uvs) {
        for (glm::vec2& st : set) st.x = 1 - st.x;
    }
    for (glm::vec4& tangent : mesh.tangents) tangent = -tangent;
}

asset::Mesh mesh_of(SmoothShape shape) {
    if (shape == SmoothShape::torus) return runtime::make_torus(512, 256, 1.0f, 0.4f, false);
    return shape == SmoothShape::sphere ? runtime::make_sphere(512, 256, false)
                                        : runtime::make_rock(512, 256);
}

// Near enough that no footprint dampens anything: a pixel covers 0.003 units of the torus, 0.006 of others.
runtime::Camera camera_of(SmoothShape shape, Change change) {
    const bool torus = shape == SmoothShape::torus;
    runtime::Camera out;
    out.position = glm::normalize(dvec3(0.5, 0.9, 1)) * 5.6;
    out.target = torus ? dvec3(0.573, 0.283, 1.147) : dvec3(0.25, 0.45, 0.5);
    out.fov_degrees = torus ? 5 : 9;
    if (change == Change::ortho) out.ortho_height = torus ? 0.4 : 0.75;
    if (change == Change::negative) out.position.x = -out.position.x, out.target.x = -out.target.x;
    if (change == Change::stretched) {
        out.position = dvec3(placement(change) * glm::dvec4(out.position, 1));
        out.target = dvec3(placement(change) * glm::dvec4(out.target, 1));
    }
    if (inside(change)) {  // of a torus: within the tube
        out.position = torus ? dvec3(0.02, 0.05, 1) : dvec3(0.1, -0.1, 0.05);
        out.target = torus ? dvec3(0.6, -0.05, 0.95) : dvec3(0.4, 0.6, 0.7);
        out.fov_degrees = 50;
    }
    return out;
}

// Where each pixel is, and its normal, without a bump.
struct Bare {
    runtime::Picture positions, normals;
};
const Bare& bare_of(SmoothShape shape, Change change) {
    static std::map<bool, truth::Made> made;  // by: it flips
    static std::map<std::pair<SmoothShape, Change>, Bare> pictures;
    const auto [at, fresh] = pictures.try_emplace({shape, change});
    if (!fresh) return at->second;
    const bool flip = change == Change::inside_flip;
    const std::string json =
        fmt::format(R"({{"version": 1, "surface": {{"two_sided": "{}"}}}})", flip ? "flip" : "mirror");
    if (!made.contains(flip)) made.emplace(flip, truth::make({json, {}, {"normal", "debug"}}));
    const std::uint32_t side = variant_side(change);
    const runtime::Scene& scene = variant_scene(shape, change);
    at->second = {truth::draw(made.at(flip), scene, "position", side, side),
                  truth::draw(made.at(flip), scene, "normal", side, side)};
    return at->second;
}

bool on_uvs(const KindCase& c, const std::string& texture) {
    return c.shape == SmoothShape::torus && texture == "map";
}
// A map of slopes along s and t: x turns with s.
bool turns_with_s(const KindCase& c, const std::string& texture) {
    return on_uvs(c, texture) && c.partners.contains(texture) && c.name != "object_normal_map";
}

}  // namespace

std::span<const Variant> all_variants() {
    static constexpr Variant kVariants[] = {{Change::plain, "plain"},
                                            {Change::ortho, "orthographic"},
                                            {Change::twice, "twice the resolution"},
                                            {Change::mirrored_uv, "mirrored uvs"},
                                            {Change::negative, "negative scale"},
                                            {Change::stretched, "non-uniform scale"},
                                            {Change::inside_mirror, "from inside, mirror"},
                                            {Change::inside_flip, "from inside, flip"},
                                            {Change::turned, "negative viewport"}};
    return kVariants;
}

const runtime::Scene& variant_scene(SmoothShape shape, Change change) {
    static std::map<std::pair<SmoothShape, Change>, runtime::Scene> scenes;
    const auto [at, fresh] = scenes.try_emplace({shape, change});
    runtime::Scene& out = at->second;
    if (!fresh) return out;
    out.content.meshes.push_back(mesh_of(shape));
    if (change == Change::mirrored_uv) mirror_uvs(out.content.meshes[0]);
    out.content.instances.push_back({"", 0, glm::mat4(placement(change))});
    out.camera = camera_of(shape, change);
    return out;
}

std::uint32_t variant_side(Change change) {
    return change == Change::twice ? 2 * kVariantPixels : kVariantPixels;
}

std::string variant_json(const KindCase& c, bool flip, bool drawn) {
    // A map as displacement counts in texels, of which a FunctionTexture has more.
    const double texels = c.name == "normal_map_as_displacement" ? kFunctionSide / kVariantTexels : 1;
    return (drawn && !c.drawn.empty() ? c.drawn : c.material) +
           fmt::format(
               R"(, "parameters": {{"h": {{"type": "float", "default": {}, "range": [-1, 1]}}}}, "surface": {{"two_sided": "{}"}}}})",
               kVariantStrength * c.unit * texels, flip ? "flip" : "mirror");
}

asset::Image variant_texture(const KindCase& c, const std::string& name, Change change) {
    const Texel texel = textures_of(c, change == Change::stretched ? kStretch : dvec3(1)).at(name);
    const bool mirrored = change == Change::mirrored_uv && on_uvs(c, name);
    asset::Image out = asset::make_image(kVariantTexels, kVariantTexels, asset::TexelFormat::float32);
    for (std::uint32_t y = 0; y < out.height; ++y) {
        for (std::uint32_t x = 0; x < out.width; ++x) {
            const std::uint32_t from = mirrored ? out.width - 1 - x : x;
            ref::dvec4 value = texel((glm::dvec2(from, y) + 0.5) / double(kVariantTexels));
            if (mirrored && turns_with_s(c, name)) value.x = 1 - value.x;
            for (int i = 0; i < 4; ++i) out.set(x, y, i, value[i]);
        }
    }
    return out;
}

const runtime::TextureSet& DrawnKind::textures(const runtime::Artefact& artefact, Change change) {
    const bool own = change == Change::mirrored_uv || change == Change::stretched;
    const auto [at, fresh] = textures_.try_emplace(own ? change : Change::plain);
    if (fresh) {
        for (const runtime::TextureSlot& slot : artefact.textures)
            at->second.chains.push_back({variant_texture(case_, slot.name, change)});
    }
    return at->second;
}

runtime::Picture DrawnKind::normals(Change change, const std::string& json) {
    const bool flip = change == Change::inside_flip;
    auto found = made_.find(flip);
    if (found == made_.end()) {
        truth::Recipe recipe{json.empty() ? variant_json(case_, flip) : json, {}};
        recipe.optimise = json.empty();
        RealFiles files;
        recipe.files["shaders/custom.glsl"] =
            files.read(SG_SOURCE_DIR "/materials/shaders/custom.glsl").bytes;
        recipe.files["any.png"] = asset::png_bytes(asset::make_image(4, 4, asset::TexelFormat::unorm8));
        found = made_.emplace(flip, truth::make(recipe, library_)).first;
    }
    found->second.textures = textures(found->second.artefact, change);
    const std::uint32_t side = variant_side(change);
    const runtime::Scene& scene = variant_scene(case_.shape, change);
    if (change != Change::turned) return truth::draw(found->second, scene, "normal", side, side);
    return truth::upside_down(truth::draw(found->second, scene, "normal", side, side, true));
}

DrawnKind::Errors DrawnKind::against_truth(const runtime::Picture& normals, Change change) {
    const bool flip = change == Change::inside_flip;
    auto found = subjects_.find(flip);
    if (found == subjects_.end()) {
        found = subjects_.emplace(flip, made_subject(case_, variant_json(case_, flip, false))).first;
        found->second.bindings().parameters.at(0) = kVariantStrength * case_.unit;
    }
    const runtime::Scene& scene = variant_scene(case_.shape, change);
    const std::uint32_t side = variant_side(change), step = side / kTruthsPerSide;
    const auto camera = camera_matrices(scene.camera, runtime::bounds_of(scene.content), side, side);
    Truth judge =
        found->second.truth(Sight{case_.shape, glm::dmat4(scene.content.instances[0].world_from_object),
                                  scene.camera.position, camera.relative_from_screen, 0});
    const Bare& bare = bare_of(case_.shape, change);
    Errors out;
    dvec3 last_point(0.0), last_normal(0.0);  // of the row
    for (std::uint32_t y = step / 2; y < side; y += step) {
        bool follows = false;
        for (std::uint32_t x = step / 2; x < side; x += step) {
            if (!truth::covered(normals, x, y)) continue;
            const dvec3 point = truth::rgb(bare.positions, x, y);
            const dvec3 sight = change == Change::ortho ? camera.direction : point;
            const TrueNormal exact = judge.at(point, {x + 0.5, y + 0.5}, sight, true);
            out.error.push_back(angle_degrees(truth::rgb(normals, x, y), exact.held));
            out.tilt.push_back(angle_degrees(exact.base, exact.held));
            out.bare.push_back(angle_degrees(truth::rgb(bare.normals, x, y), exact.base));
            out.moved = std::max(out.moved, exact.moved);
            if (follows)
                out.curvature = std::max(
                    out.curvature, glm::distance(exact.base, last_normal) / glm::distance(point, last_point));
            last_point = point;
            last_normal = exact.base;
            follows = true;
        }
    }
    return out;
}

}  // namespace sg::proof
