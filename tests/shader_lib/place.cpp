#include "place.hpp"

#include <algorithm>

namespace sg::proof {
namespace {

void draw_projector(Random& random, Draw& in) {
    // s, t and ahead perpendicular, s and t as long; the place 0.5 to 1.5 ahead and off every cube's edge.
    const double size = random.magnitude(0.5, 2.0);
    const glm::dvec3 ahead = random.direction(), s = tangent_of(random, ahead);
    in.put(kProjectorAt, size * s), in.put(kProjectorAt + 3, size * glm::cross(ahead, s));
    in.put(kProjectorAt + 6, size * ahead);
    in.put(kProjectorAt + 9,
           glm::dvec3(random.uniform(-0.45, 0.45), random.uniform(-0.45, 0.45), random.uniform(0.5, 1.5)));
}

}  // namespace

std::vector<std::shared_ptr<const CaseTexture>> ramp_of_places() {
    static const auto made = [] {
        const double c = std::cos(1.0), s = std::sin(1.0);
        std::vector<std::shared_ptr<const CaseTexture>> out;
        for (glm::dvec2 slope : {kRamp, kRamp * glm::dvec2(-1, 1), kRamp * glm::dvec2(1, -1),
                                 glm::dvec2(c * kRamp.x - s * kRamp.y, s * kRamp.x + c * kRamp.y)}) {
            out.push_back(height_texture({kTexels, kTexels}, true, [slope](double u, double v) {
                return 0.5 + slope.x * (u - 31.5) + slope.y * (v - 31.5);
            }));
        }
        return out;
    }();
    return made;
}

void draw_place(Random& random, Draw& in, bool conformal) {
    draw_frame_and_uv(random, in);
    const double footprint = random.magnitude(0.25, 4.0) / kTexels;
    const glm::dvec2 along = random.direction2();
    const double angle = conformal ? 1.5707963267948966 : random.uniform(0.3, 2.8);
    const glm::dvec2 other = glm::dvec2(-along.y, along.x) * std::sin(angle) + along * std::cos(angle);
    in.put(kUvAt, 0.5 + glm::dvec2(random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15)));
    in.put(kUvAt + 2, footprint * along), in.put(kUvAt + 4, random.sign() * footprint * other);
    const glm::dvec3 n = In(in.floats()).v3(0), tangent = tangent_of(random, n);
    if (conformal) {
        const double size = random.magnitude(1e-3, 1.0);
        in.put(3, size * tangent), in.put(6, size * glm::cross(n, tangent));
    }
    const double step = std::min(glm::length(In(in.floats()).v3(3)), glm::length(In(in.floats()).v3(6)));
    in.put(kDerivAt, random.direction2() * random.magnitude(1e-2, 30.0));
    in.put(kScreenAt, random.direction2() * step * random.magnitude(1e-3, 30.0));
    in.put(kVectorAt, random.direction() * random.magnitude(1e-2, 30.0));
    in.put(kTangentAt, tangent * random.uniform(0.5, 1.0)), in.put(kTangentAt + 3, random.sign());
    in.put(kFactorAt, random.uniform(-4.0, 4.0));
    draw_projector(random, in);
}

void draw_anywhere(Random& random, Draw& in) {
    draw_place(random, in, false);
    const glm::dvec3 n = In(in.floats()).v3(0);
    if (random.coin()) {
        for (std::size_t k = 3; k < kSize; ++k) {
            if (k != kFactorAt && random.coin()) in.put(k, random.wild());
        }
    } else {
        const double size = random.magnitude(1e-12, 1e6), lean = random.magnitude(1e-9, 1.0);
        const glm::dvec3 along = size * (n + lean * tangent_of(random, n));
        in.put(3, along);
        in.put(6,
               random.uniform(-2.0, 2.0) * along + size * random.magnitude(1e-9, 1.0) * random.direction());
        in.put(13, random.uniform(-2.0, 2.0) * In(in.floats()).v2(11) +
                       random.magnitude(1e-9, 1e-2) * random.direction2());
        in.put(kScreenAt, random.direction2() * random.magnitude(1e-9, 1e9));
        in.put(kVectorAt, random.sign() * n * random.magnitude(1e-3, 1e9) +
                              random.direction() * random.magnitude(1e-6, 10.0));
    }
    in.put(kUvAt, glm::dvec2(0.5));
    for (std::size_t k = 0; k < 2; ++k) {
        if (const float d = in.floats()[kDerivAt + k]; std::isfinite(d))
            in.put(kDerivAt + k, std::clamp(d, -128.0f, 128.0f));
    }
}

}  // namespace sg::proof
