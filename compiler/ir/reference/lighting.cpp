#include "ir/reference/lighting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/reference/legacy.hpp"

namespace sg::ref {
namespace {

double share(double x) {
    return std::clamp(x, 0.0, 1.0);
}

// The mirrored share straight on; of insulators 4 %.
dvec3 straight_on(const GgxSurface& surface) {
    return glm::mix(dvec3(0.04), surface.base_color, surface.metallic);
}

}  // namespace

double sin2_between(dvec3 a, dvec3 b) {
    const dvec3 area = glm::cross(a, b);
    return glm::dot(a, b) > 0.0 ? share(glm::dot(area, area)) : 1.0;
}

// Walter's Eq 33 is written in the angle: alpha^2 / (pi cos^4 (alpha^2 + tan^2)^2) = alpha^2 / (pi (alpha^2
// cos^2 + sin^2)^2).
double ggx_distribution(double sin2_h, double alpha) {
    const double a2 = alpha * alpha;
    return a2 / (std::numbers::pi * std::pow(a2 * (1.0 - sin2_h) + sin2_h, 2));
}

// 4 cos_l cos_v / G = 2 (cos_v |l| + cos_l |v|), where |x| is the length of a vector that is x high and alpha
// sin x wide.
double ggx_visibility(double cos_l, double cos_v, double alpha) {
    auto length = [&](double c) { return std::sqrt(c * c + alpha * alpha * (1.0 - c * c)); };
    return 1.0 / (2.0 * std::max(cos_v * length(cos_l) + cos_l * length(cos_v), 1e-6));
}

dvec3 fresnel(dvec3 f0, double cos_d) {
    return glm::mix(f0, dvec3(1.0), std::pow(share(1.0 - cos_d), 5));
}

dvec3 ggx(const GgxSurface& surface, dvec3 n, dvec3 view, dvec3 light, dvec3 radiance) {
    const dvec3 sum = view + light, h = sum / std::max(glm::length(sum), 1e-6);
    const double cos_l = share(glm::dot(n, light)), cos_v = std::abs(glm::dot(n, view)) + 1e-4;
    const double alpha = std::max(surface.roughness * surface.roughness, 2e-3);
    const dvec3 mirrored = fresnel(straight_on(surface), share(glm::dot(light, h)));
    const double lobe = ggx_distribution(sin2_between(n, h), alpha) * ggx_visibility(cos_l, cos_v, alpha);
    const dvec3 base = (dvec3(1.0) - mirrored) * (1.0 - surface.metallic) * surface.base_color;
    return cos_l * radiance * (base + std::numbers::pi * lobe * mirrored);
}

dvec3 ggx_radiance(const GgxSurface& surface, dvec3 n, const Lights& lights) {
    return surface.emission + surface.occlusion * lights.ambient * surface.base_color +
           ggx(surface, n, lights.view, lights.light, lights.radiance);
}

// The workshop's last line, (ambient + diffuse + specular) * color, with a colour of its own for the
// highlight.
dvec3 phong_radiance(const PhongSurface& surface, dvec3 n, const Lights& lights) {
    const Phong share = legacy_phong(n, lights.light, lights.view, surface.shininess);
    return surface.emission +
           (surface.occlusion * lights.ambient + share.diffuse * lights.radiance) * surface.base_color +
           share.specular * lights.radiance * surface.specular;
}

}  // namespace sg::ref
