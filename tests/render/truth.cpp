#include "tests/render/truth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "tests/render/meshes.hpp"

namespace sg::truth {
namespace {

constexpr std::uint32_t kTexels = 256;  // per side of a texture
constexpr double kDegrees = 180 / 3.141592653589793;
constexpr double kWide = 1.5, kHigh = 0.8;  // of the squashed placement
constexpr double kUlp = 1.1920929e-7;       // of fp32, relative

glm::dvec2 texel_center(std::uint32_t x, std::uint32_t y) {
    return {(x + 0.5) / kTexels, (y + 0.5) / kTexels};
}

// The tangent-space normal that a texel stands for, green down.
glm::dvec3 tangent_normal(glm::dvec2 slope) {
    return glm::normalize(glm::dvec3(-slope, 1));
}

double reach(double zero) {
    return zero == 127.5 ? 127.5 : 127;
}

std::string texture_bytes(const Case& c, const Layer& layer) {
    const auto format = layer.float_texels ? asset::TexelFormat::float32 : asset::TexelFormat::unorm16;
    asset::Image image = asset::make_image(kTexels, kTexels, format);
    const Bump bump = bump_of(c, layer);
    for (std::uint32_t y = 0; y < kTexels; ++y) {
        for (std::uint32_t x = 0; x < kTexels; ++x) {
            glm::dvec3 m = tangent_normal(texture_slope({c.shape}, bump, texel_center(x, y)));
            if (layer.green_up) m.y = -m.y;
            for (int i = 0; i < 3; ++i) image.set(x, y, i, (m[i] * reach(layer.zero) + layer.zero) / 255);
            if (layer.two_channels) image.set(x, y, 2, 0);
            image.set(x, y, 3, 1);
        }
    }
    return layer.float_texels ? asset::exr_bytes({{"", 4, image}}) : asset::png16_bytes(image);
}

// What the bounds need to know about a texture, from the exact normals at texel centres.
struct TextureFacts {
    double second = 0;    // largest |second difference| along x plus the same along y
    double first = 0;     // largest |difference| between neighbours
    double steepest = 0;  // largest slope
};
TextureFacts facts_of(const Case& c, const Layer& layer) {
    const Bump bump = bump_of(c, layer);
    auto normal = [&](int x, int y) {
        const glm::dvec2 at = texel_center(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        return tangent_normal(texture_slope({c.shape}, bump, at));
    };
    TextureFacts out;
    double second_x = 0, second_y = 0;
    // The outermost rows are left out: on the sphere they are the poles, on the others the same as inside.
    for (int y = 1; y + 1 < static_cast<int>(kTexels); y += 3) {
        for (int x = 1; x + 1 < static_cast<int>(kTexels); x += 3) {
            const glm::dvec3 m = normal(x, y), r = normal(x + 1, y), d = normal(x, y + 1);
            second_x = std::max(second_x, glm::length(normal(x - 1, y) - 2.0 * m + r));
            second_y = std::max(second_y, glm::length(normal(x, y - 1) - 2.0 * m + d));
            out.first = std::max({out.first, glm::length(r - m), glm::length(d - m)});
            out.steepest = std::max(out.steepest, std::hypot(m.x, m.y) / m.z);
        }
    }
    out.second = second_x + second_y;
    return out;
}

// How the picture is taken, in object space.
struct Shot {
    glm::dvec3 from{0}, to{0};
    double fov = 30, ortho_height = 2.6;
};
Shot shot_of(const Case& c) {
    const glm::dvec3 side = c.shape == Shape::torus ? glm::dvec3(0.5, 0.9, 1) : glm::dvec3(0.5, 0.4, 1);
    const double distance = c.shape == Shape::torus ? 5.6 : 4.3;
    Shot shot{glm::normalize(side) * distance};
    if (c.shape == Shape::torus) shot.ortho_height = 3.2;
    switch (c.eye) {
        case Eye::front:
            return shot;
        case Eye::behind:
            shot.from.z = -shot.from.z;
            return shot;
        case Eye::inside:
            return {{0.1, -0.2, 0.15}, {0.4, 0.1, 1}, 70};
        case Eye::far:
            shot.from *= 4;
            shot.fov = 2 * kDegrees * std::atan(std::tan(15 / kDegrees) / 4);
            return shot;
        case Eye::facing:
            return {{0, 0, 4}, {0, 0, 0}, 30, 2.2};
    }
    return shot;
}

glm::mat4 placement_matrix(Placement placement) {
    if (placement == Placement::none) return glm::mat4(1);
    glm::dvec3 scale(2);
    if (placement == Placement::mirrored) scale = {-1.5, 1.5, 1.5};
    if (placement == Placement::squashed) scale = {kWide, kHigh, kWide};
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), {7, -3, 5});
    const glm::dmat4 turned = glm::rotate(moved, 1.1, glm::normalize(glm::dvec3(1, 2, 3)));
    return glm::mat4(glm::scale(turned, scale));
}

double scale_of(const glm::dmat4& matrix) {
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix))));
}

// Positions do not depend on the material: one picture for all cases that share a scene.
const runtime::Picture& positions_of(const Case& c, const runtime::Scene& scene) {
    static std::map<std::string, runtime::Picture> pictures;
    const bool both_sides = c.two_sided != Side::front;
    const std::string key = fmt::format("{} {} {} {} {}", static_cast<int>(c.shape), static_cast<int>(c.eye),
                                        c.orthographic, static_cast<int>(c.placement), both_sides);
    auto [at, fresh] = pictures.try_emplace(key);
    if (fresh) {
        static const Made kFront = make({R"({"version": 1})", {}, {"debug"}});
        static const Made kBoth =
            make({R"({"version": 1, "surface": {"two_sided": "mirror"}})", {}, {"debug"}});
        at->second = draw(both_sides ? kBoth : kFront, scene, "position", kPixels, kPixels);
    }
    return at->second;
}

}  // namespace

// filter: bilinear filtering between values of a function f with second derivatives is off by at most 1/8 of
// the second
//   difference along x plus the same along y. An error e of the encoded unit normal is one of e (1 + d^2) in
//   the slope d, and of e / z = e sqrt(1 + d^2) more where z follows from x and y. At mip level l the texel
//   is also an average over 4^l texels, which is off by 1/24 of the second difference over 2^l texels; both
//   together 4^l (1/8 + 1/24).
// quantisation: half a step of 16 bits over the range -1..1 is 1/65535, in up to three channels.
// tessellation: a pixel's uv is interpolated over a flat facet and not that of the nearest point of the
// surface. The
//   mixed second derivative of P over a quad of angles da x db shifts it by up to da db / 4 times cot(polar
//   angle), below 6 for all but the polar caps of 9.5 degrees (0.7 % of the hemisphere, and foreshortened);
//   the torus' ring bulges by da^2/8 (R + r) / r. On the coarse cylinder it is the angle of a chord's point
//   against its parameter, u (1 - u^2) (da/2)^3 / 3 at most 0.385 (da/2)^3 / 3. The shift moves the texture
//   by shift / pi of its side (pi radians or more span it). The torus' interpolated normal is that of a
//   shifted point too, by da db / 4 R / (R - r). Squashed, vertex normals are made unit again before they are
//   interpolated, which shifts their weights by up to the anisotropy squared over a quad: db^2 / 8 times
//   that. mikkTSpace's bitangent is cross(N, T) / |N| of the raw interpolated vectors: |T| = |N| in a quad's
//   middle, so it is short by 1 - |N| = 1 - cos(da / 2). That is the agreed meaning of vertex tangents, not
//   an error of the shader. Tangents made from the triangles are the mean of three to the left and three to
//   the right of a vertex, whose turns of da / 2 cancel but for the difference of their lengths, da db / 4
//   times cot(polar angle) again.
// basis: tangents from uv derivatives are those of the facet: the direction of the facet's horizontal side,
// in the middle
//   of da, or for the second uv set of its vertical side, at one end of da; parallel lines turn against each
//   other by up to da times the sine of the elevation. Facets of the cylinder turn about the vertical alone,
//   which leaves no rotation in the surface.
// arithmetic: positions are relative to the camera, with an absolute error of a few units in the last place
// of the distance;
//   differences over the smaller of a pixel and a facet's side turn T by the quotient. Everything else is a
//   dozen roundings.
Bound bound_of(const Case& c) {
    const Tessellation mesh = tessellation_of(c.shape);
    const bool round = c.shape == Shape::sphere || c.shape == Shape::torus;
    double shift = mesh.da * mesh.db / 4 * 6;
    if (c.shape == Shape::torus) shift = std::max(shift, mesh.da * mesh.da / 8 * 3.5);
    if (c.shape == Shape::cylinder) shift = 0.385 / 3 * std::pow(mesh.da / 2, 3);
    const Shot shot = shot_of(c);
    const double distance = glm::distance(shot.from, shot.to),
                 pixel = 2 * std::tan(shot.fov / kDegrees / 2) * distance / kPixels;

    Bound bound;
    for (const Layer& layer : c.layers) {
        const TextureFacts facts = facts_of(c, layer);
        const double square = 1 + facts.steepest * facts.steepest, size = std::abs(layer.strength);
        const double gain = size * square * (layer.two_channels ? std::sqrt(square) : 1) * kDegrees;
        const double cells = c.mip_level > 0 ? std::pow(4, c.mip_level) * (1.0 / 8 + 1.0 / 24) : 1.0 / 8;
        bound.filter += gain * facts.second * cells;
        if (!layer.float_texels) bound.quantisation += gain * std::sqrt(layer.two_channels ? 2 : 3) / 65535;
        bound.tessellation += size * square * kDegrees * shift / 3.141592653589793 * kTexels * facts.first;
        if (layer.from_vertex) {
            if (c.tangents_made) bound.tessellation += size * facts.steepest * shift * kDegrees;
            bound.tessellation += size * facts.steepest * (1 - std::cos(mesh.da / 2)) * kDegrees;
            continue;
        }
        if (round) bound.basis += size * facts.steepest * mesh.da * (layer.uv == 1 ? 1 : 0.5) * kDegrees;
        bound.arithmetic +=
            size * facts.steepest * 4 * kUlp * distance / std::min(pixel, mesh.edge) * kDegrees;
    }
    if (c.placement == Placement::squashed)
        bound.tessellation += mesh.db * mesh.db / 8 * kWide * kWide / (kHigh * kHigh) * kDegrees;
    if (c.shape == Shape::torus) bound.tessellation += mesh.da * mesh.db / 4 / 0.6 * kDegrees;
    bound.arithmetic += 16 * kUlp * kDegrees;
    return bound;
}

runtime::Scene scene_of(const Case& c) {
    runtime::Scene scene;
    const glm::mat4 world = placement_matrix(c.placement);
    const Shot shot = shot_of(c);
    scene.content.meshes.push_back(mesh_of(c.shape, c.unwrap));
    if (c.tangents_made) scene.content.meshes[0].tangents.clear();
    scene.content.instances.push_back({"", 0, world});
    scene.camera.position = glm::dvec3(glm::dmat4(world) * glm::dvec4(shot.from, 1));
    scene.camera.target = glm::dvec3(glm::dmat4(world) * glm::dvec4(shot.to, 1));
    scene.camera.fov_degrees = shot.fov;
    if (c.orthographic) scene.camera.ortho_height = shot.ortho_height * scale_of(world);
    return scene;
}

const Recipe& recipe_of(const Case& c) {
    static std::map<std::string, Recipe> recipes;  // mutants draw cases again
    auto [at, fresh] = recipes.try_emplace(c.name);
    Recipe& recipe = at->second;
    if (!fresh) return recipe;
    nlohmann::json material = {{"version", 1}, {"bump", {{{"layers", nlohmann::json::array()}}}}};
    constexpr const char* kSides[] = {"off", "mirror", "flip"};
    material["surface"]["two_sided"] = kSides[static_cast<int>(c.two_sided)];
    for (std::size_t i = 0; i < c.layers.size(); ++i) {
        const Layer& layer = c.layers[i];
        const std::string name = fmt::format("map{}", i),
                          file = name + (layer.float_texels ? ".exr" : ".png");
        material["textures"][name] = {
            {"file", file},
            {"encoding", layer.two_channels ? "tangent_normal_xy" : "tangent_normal"},
            {"green", layer.green_up ? "up" : "down"},
            {"zero", layer.zero}};
        material["bump"][0]["layers"].push_back({{"kind", "normal_map"},
                                                 {"texture", name},
                                                 {"uv", layer.uv},
                                                 {"basis", layer.from_vertex ? "vertex" : "uv"},
                                                 {"tiling", {layer.tiling.x, layer.tiling.y}},
                                                 {"strength", layer.strength}});
        recipe.files[file] = texture_bytes(c, layer);
    }
    recipe.json = material.dump();
    return recipe;
}

Made make_case(const Case& c, const target::ShaderLibrary& library) {
    Made made = make(recipe_of(c), library);
    if (c.mip_level > 0) return made;
    for (auto& chain : made.textures.chains) chain.resize(1);
    return made;
}

Outcome run_case(const Case& c, const target::ShaderLibrary& library) {
    const Made made = make_case(c, library);
    const runtime::Scene scene = scene_of(c);
    const runtime::Picture normals = draw(made, scene, "normal", kPixels, kPixels);
    const runtime::Picture& positions = positions_of(c, scene);
    show(normals, c.name);

    const glm::dmat4 world(scene.content.instances[0].world_from_object), object = glm::inverse(world);
    std::vector<Bump> bumps;
    for (const Layer& layer : c.layers) bumps.push_back(bump_of(c, layer));
    const Side side = c.eye == Eye::behind || c.eye == Eye::inside ? c.two_sided : Side::front;
    std::vector<double> errors;
    for (std::uint32_t y = 0; y < kPixels; ++y) {
        for (std::uint32_t x = 0; x < kPixels; ++x) {
            if (covered(normals, x, y) != covered(positions, x, y)) errors.push_back(180);
            if (!covered(normals, x, y)) continue;
            const glm::dvec3 point(object * glm::dvec4(rgb(positions, x, y) + scene.camera.position, 1));
            errors.push_back(angle_degrees(rgb(normals, x, y),
                                           bumped_normal({c.shape}, bumps, point, side, glm::dmat3(world))));
        }
    }
    return {percentiles(std::move(errors)), bound_of(c)};
}

}  // namespace sg::truth
