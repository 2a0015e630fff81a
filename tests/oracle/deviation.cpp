// How far rounding may bring a render from the interpreter.
//
// Backward error: what a few roundings make of a sum of products, a quotient or a root is what exact
// arithmetic makes of operands that are a few roundings off. So each input of the pixel is moved by as many
// roundings as the operations that read it have, in each component and by that share of the whole vector (the
// cross terms of a 2x2 inverse or of a rejection mix the components); the interpreter says what each move is
// worth in degrees, and the bound is the sum.
//   vectors (normal, tangent, position, dpdx, dpdy, uv derivatives): 8 roundings, of at most 8 operations in
//     a row in base_normal, frame and basis_*.
//   coordinates: 4 roundings of the length of (s, t), at least of 1: the scaling, the product with the
//     texture's size, the half texel, and the fold or wrap.
//   the camera's matrix: the columns of a pixel's steps like vectors.
//   texels: 8 roundings of 1 in each channel: three lerps with two roundings each, the conversion from 8 or
//     16 bits, and the product with 255 in the decoding.
//   level of detail: lavapipe takes log2(2^e (1 + m)) as e + m, at most 0.0861 too small (m = 1/ln 2 - 1), of
//     the squared footprint: half of that too small. Exact drivers lie within. Worth nothing with the first
//     level alone.
//   what remains (scales, sums, the resolve): 16 roundings of the largest derivative or gradient, as an
//     angle.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "tests/oracle/material_oracle.hpp"

namespace sg::oracle {
namespace {

using ir::PixelInputs;
using ref::dvec3;

constexpr double kDegrees = 180 / 3.141592653589793;
constexpr double kRounding = 0x1p-24;  // of fp32, relative

constexpr double kVectors = 8 * kRounding, kCoordinates = 4 * kRounding, kTexels = 8 * kRounding,
                 kRest = 16 * kRounding;
constexpr double kLod = 0.0431;

// A texture with one channel raised.
struct Raised : ref::TextureSource {
    const ref::TextureSource* base = nullptr;
    glm::dvec4 by{0.0};
    glm::dvec4 fetch(glm::ivec2 texel, int level) const override { return base->fetch(texel, level) + by; }
    glm::ivec2 size(int level) const override { return base->size(level); }
    int levels() const override { return base->levels(); }
};

class Sensitivity {
public:
    Sensitivity(const Material& material, const ir::Module& module, const PixelInputs& pixel)
        : material_(material),
          module_(module),
          pixel_(pixel),
          evaluator_(module, material.bindings),
          values_(evaluator_.run(pixel)),
          normal_(output()) {
        first_reads_.assign(material.textures.size() + 1, module.values.size());
        for (std::size_t i = module.values.size(); i-- > 0;) {
            if (ir::info(module.values[i].op).attribute != ir::Attribute::Texture) continue;
            first_reads_[module.values[i].index] = first_reads_.back() = i;
        }
        for (std::size_t i = 0; i < module.values.size(); ++i) {
            const ir::Type type = module.values[i].type;
            if (type != ir::Type::Deriv && type != ir::Type::SurfGrad && type != ir::Type::VolGrad) continue;
            for (double x : ir::components(values_[i])) largest_ = std::max(largest_, std::abs(x));
        }
    }

    [[nodiscard]] dvec3 normal() const { return normal_; }
    // Whether every march ends at the step that exact arithmetic ends it at: no step's distance between ray
    // and surface is within what rounding does to it, nor the number of steps to a whole number. (The
    // distance: a texel's roundings, and those of its coordinate, over which a texel may change by 1. The
    // number: the 8 roundings of the view's cosine, times up to 256 steps.)
    [[nodiscard]] bool decided() const {
        for (std::size_t i = 0; i < module_.values.size(); ++i) {
            const ir::Value& value = module_.values[i];
            if (value.op != ir::Op::parallax_occlusion) continue;
            const auto number = [&](std::size_t k) { return values_[value.operands[k].index]; };
            const auto size = material_.bindings.textures[value.index].texels->size(0);
            const double texels = std::max(size.x, size.y);
            const double scale = std::abs(std::get<glm::dvec2>(number(2)).x);
            if (std::get<ref::March>(values_[i]).closest < scale * (kTexels + kCoordinates * texels))
                return false;
            const double steps = std::get<double>(number(3));
            const bool exact = module_.at(value.operands[3]).op == ir::Op::constant;
            if (!exact && std::abs(steps - std::round(steps)) < 256 * kVectors) return false;
        }
        return true;
    }
    // Radians.
    double bound() {
        double sum = kRest * largest_;
        sum += moved<3>(
            [](PixelInputs & p) -> auto& { return p.position; }, kVectors);
        sum += moved<3>(
            [](PixelInputs & p) -> auto& { return p.vertex_normal; }, kVectors);
        sum += moved<3>(
            [](PixelInputs & p) -> auto& { return p.vertex_tangent; }, kVectors);
        sum += moved<3>(
            [](PixelInputs & p) -> auto& { return p.dpdx; }, kVectors);
        sum += moved<3>(
            [](PixelInputs & p) -> auto& { return p.dpdy; }, kVectors);
        std::array<bool, 8> seen{};
        for (const ir::Value& value : module_.values) {
            if (value.op != ir::Op::uv_set) continue;
            const std::size_t set = value.index;
            if (std::exchange(seen[set], true)) continue;
            sum += moved<2>(
                [set](PixelInputs & p) -> auto& { return p.uvs[set].st; }, kCoordinates, 1.0);
            sum += moved<2>(
                [set](PixelInputs & p) -> auto& { return p.uvs[set].dx; }, kVectors);
            sum += moved<2>(
                [set](PixelInputs & p) -> auto& { return p.uvs[set].dy; }, kVectors);
        }
        for (const ir::Value& value : module_.values) {
            if (value.op == ir::Op::volume_object)
                sum += volume([](PixelInputs & p) -> auto& { return p.object; });
            if (value.op == ir::Op::volume_world)
                sum += volume([](PixelInputs & p) -> auto& { return p.world; });
        }
        sum += behind_parallax();
        for (std::size_t i = 0; i < material_.textures.size(); ++i) {
            if (!material_.textures[i].chain.empty()) sum += texture(i);
        }
        return sum + levels();
    }

private:
    [[nodiscard]] dvec3 output() const { return std::get<dvec3>(evaluator_.output(ir::Output::normal)); }

    double turned(const PixelInputs& pixel) {
        evaluator_.run(pixel);
        return glm::distance(output(), normal_);
    }
    // By what was done to a texture, or, behind the last of them, to all: what is computed before the first
    // read stays.
    double turned_by(std::size_t texture) {
        evaluator_.run(pixel_, std::span(values_).first(first_reads_[texture]));
        return glm::distance(output(), normal_);
    }

    // The sum over the first N components of an input, each moved by `share` of the vector's length or of
    // `least`.
    template <int N, class Field>
    double moved(Field field, double share, double least = 0.0) {
        double sum = 0.0;
        for (int c = 0; c < N; ++c) {
            PixelInputs pixel = pixel_;
            auto& vector = field(pixel);
            vector[c] += share * std::max(glm::length(vector), least);
            sum += turned(pixel);
        }
        return sum;
    }

    // What parallax and rebuilt frames read besides. A place's distance to the camera or to the object's
    // origin is rounded like a coordinate.
    double behind_parallax() {
        auto uses = [&](ir::Op op) {
            return std::any_of(module_.values.begin(), module_.values.end(),
                               [op](const ir::Value& value) { return value.op == op; });
        };
        double sum = 0.0;
        if (uses(ir::Op::normal_derivatives)) {
            sum += moved<3>(
                [](PixelInputs & p) -> auto& { return p.dndx; }, kVectors);
            sum += moved<3>(
                [](PixelInputs & p) -> auto& { return p.dndy; }, kVectors);
        }
        if (uses(ir::Op::volume_world_at))
            sum += moved<3>(
                [](PixelInputs & p) -> auto& { return p.camera.position; }, kCoordinates, 1.0);
        if (uses(ir::Op::volume_object_at))
            sum += moved<3>(
                [](PixelInputs & p) -> auto& { return p.object_origin; }, kCoordinates, 1.0);
        for (int column = 0; column < 2 && uses(ir::Op::frame_rebuilt); ++column)
            sum += moved<4>(
                [column](PixelInputs & p) -> auto& { return p.camera.relative_from_screen[column]; },
                kVectors);
        return sum;
    }

    // A place and its derivatives; the place is looked up in cells, like a coordinate.
    template <class Field>
    double volume(Field field) {
        double sum = moved<3>(
            [&](PixelInputs & p) -> auto& { return field(p).p; }, kCoordinates, 1.0);
        sum += moved<3>(
            [&](PixelInputs & p) -> auto& { return field(p).dx; }, kVectors);
        return sum + moved<3>(
                         [&](PixelInputs & p) -> auto& { return field(p).dy; }, kVectors);
    }

    double texture(std::size_t i) {
        ir::Sampled& sampled = evaluator_.bindings().textures[i];
        const ir::Sampled before = sampled;
        double sum = 0.0;
        for (int c = 0; c < 4; ++c) {
            Raised raised;
            raised.base = before.texels;
            raised.by[c] = kTexels;
            sampled.texels = &raised;
            sum += turned_by(i);
            sampled = before;
        }
        return sum;
    }

    // Levels of detail: each read by itself, and all at once, as coordinates of one set have it, where one
    // read moves what the next one reads.
    double levels() {
        std::vector<ir::Sampled>& all = evaluator_.bindings().textures;
        const std::vector<ir::Sampled> before = all;
        double alone = 0.0, together = 0.0;
        for (std::size_t i = 0; i <= all.size(); ++i) {
            if (i < all.size() && material_.textures[i].chain.empty()) continue;
            double level = 0.0;  // not monotonous where the bias crosses a level
            for (double part : {0.25, 0.5, 0.75, 1.0}) {
                for (std::size_t k = 0; k < all.size(); ++k) {
                    if (i == all.size() || i == k) all[k].lod_bias = -kLod * part;
                }
                level = std::max(level, turned_by(i));
            }
            all = before;
            (i < all.size() ? alone : together) += level;
        }
        return std::max(alone, together);
    }

    const Material& material_;
    const ir::Module& module_;
    const PixelInputs& pixel_;
    ir::Evaluator evaluator_;
    const std::vector<ir::Datum> values_;
    dvec3 normal_;
    std::vector<std::size_t> first_reads_;  // of each texture, and of all
    double largest_ = 1.0;
};

double angle(dvec3 a, dvec3 b) {
    const double dot = glm::dot(a, b);
    return std::isfinite(dot) ? std::atan2(glm::length(glm::cross(a, b)), dot) : 3.15;
}

double at_share(std::vector<double>& values, double share) {
    if (values.empty()) return 0.0;
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

}  // namespace

Deviation deviation(const Material& material, const ir::Module& module, const PixelInputs& pixel,
                    dvec3 normal) {
    Sensitivity sensitivity(material, module, pixel);
    const bool decided = sensitivity.decided();
    const double bound = sensitivity.bound();
    return {angle(sensitivity.normal(), normal) * kDegrees, bound * kDegrees, decided};
}

bool Comparison::holds() const {
    return pixels > 1000 && undecided <= 0.01 && median <= median_bound && p999 <= p999_bound &&
           beyond <= 0.001;
}

Comparison compare(const Material& material, const ir::Module& module, const std::vector<PixelInputs>& inputs,
                   const std::vector<dvec3>& normals, std::size_t stride) {
    if (inputs.size() != normals.size()) return {};
    std::vector<double> errors, bounds;
    std::size_t beyond = 0, undecided = 0;
    for (std::size_t i = 0; i < inputs.size(); i += stride) {
        const Deviation d = deviation(material, module, inputs[i], normals[i]);
        if (!d.decided) {
            ++undecided;
            continue;
        }
        errors.push_back(d.error);
        bounds.push_back(d.bound);
        if (!(d.error <= d.bound)) ++beyond;
    }
    Comparison out;
    out.pixels = errors.size();
    out.beyond = static_cast<double>(beyond) / static_cast<double>(out.pixels);
    out.undecided = static_cast<double>(undecided) / static_cast<double>(out.pixels + undecided);
    out.median = at_share(errors, 0.5);
    out.p999 = at_share(errors, 0.999);
    out.median_bound = at_share(bounds, 0.5);
    out.p999_bound = at_share(bounds, 0.999);
    return out;
}

}  // namespace sg::oracle
