#include "ir/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "base/ice.hpp"
#include "ir/evaluate_ops.hpp"

namespace sg::ir {
namespace {

using ref::dvec2;
using ref::dvec3;
using ref::dvec4;

struct Lister {
    std::vector<double> out;

    void operator()(double x) { out.push_back(x); }
    template <int N>
    void operator()(const glm::vec<N, double>& v) {
        for (int i = 0; i < N; ++i) out.push_back(v[i]);
    }
    void operator()(const ref::Frame& f) {
        list(f.position, f.normal, f.dpdx, f.dpdy, f.sigma_x, f.sigma_y, f.flip_sign);
    }
    void operator()(const ref::Uv& uv) { list(uv.st, uv.dx, uv.dy); }
    void operator()(const ref::Basis& basis) { list(basis.tangent, basis.bitangent); }
    void operator()(const Volume& v) { list(v.p, v.dx, v.dy); }
    void operator()(const ref::TriplanarUv& uv) { list(uv.x, uv.y, uv.z); }
    void operator()(const ref::Noise& n) { list(n.value, n.gradient); }
    void operator()(const glm::dmat4& m) { list(m[0], m[1], m[2], m[3]); }
    void operator()(const ref::Decal& d) { list(d.local, d.uv, d.grad_s, d.grad_t); }
    void operator()(const ref::DerivPair& pair) { list(pair.first, pair.second); }
    void operator()(const ref::March& march) { list(march.hit.offset, march.hit.height); }
    void operator()(const NormalDerivatives& n) { list(n.dndx, n.dndy); }

    template <class... Parts>
    void list(const Parts&... parts) {
        (operator()(parts), ...);
    }
};

// A mirrored coordinate is the same as a clamped one after folding: the texel beyond the edge is the edge's
// own.
double folded(double x) {
    const double phase = x - 2.0 * std::floor(x / 2.0);
    return phase < 1.0 ? phase : 2.0 - phase;
}

ref::Wrap after_folding(Sampled::Wrap wrap) {
    return wrap == Sampled::Wrap::repeat ? ref::Wrap::repeat : ref::Wrap::clamp;
}

}  // namespace

std::vector<double> components(const Datum& datum) {
    Lister lister;
    std::visit(lister, datum);
    return lister.out;
}

dvec4 Sampled::at(const ref::Uv& uv) const {
    return at_level(uv.st, ref::uv_level(uv, dvec2(texels->size(0))) + lod_bias);
}

dvec4 Sampled::at_level(dvec2 place, double wanted) const {
    const ref::Sampler sampler{after_folding(wrap_s), after_folding(wrap_t)};
    const dvec2 st(wrap_s == Wrap::mirror ? folded(place.x) : place.x,
                   wrap_t == Wrap::mirror ? folded(place.y) : place.y);
    const double last = texels->levels() - 1;
    double level = std::clamp(wanted, 0.0, last);
    if (mips == Mips::none) level = 0.0;
    if (mips == Mips::nearest)
        level = std::ceil(level + 0.5) - 1.0;  // halves go to the finer level, as Vulkan asks
    if (linear) return ref::sample_lod(*texels, sampler, st, level);
    auto nearest = [&](int at) {
        const glm::ivec2 texel(glm::floor(st * dvec2(texels->size(at))));
        return ref::texel_at(*texels, sampler, texel, at);
    };
    const int fine = static_cast<int>(level);
    const double t = level - fine;
    return t > 0.0 ? (1.0 - t) * nearest(fine) + t * nearest(fine + 1) : nearest(fine);
}

Datum datum_of(Type type, std::span<const double> number) {
    if (type == Type::Projector) return glm::make_mat4(number.data());
    switch (component_count(type)) {
        case 1:
            return number[0];
        case 2:
            return dvec2(number[0], number[1]);
        case 3:
            return dvec3(number[0], number[1], number[2]);
        case 4:
            return dvec4(number[0], number[1], number[2], number[3]);
        default:
            SG_UNREACHABLE("a constant of a type that no constant has");
    }
}

Module with_stored_numbers(Module module) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    for (Value& value : module.host) {
        for (double& number : value.number)
            number = static_cast<float>(std::clamp(number, -kLargest, kLargest));
    }
    return module;
}

std::vector<Datum> derived_values(const Module& module, const Bindings& bindings) {
    const PixelInputs nowhere;
    std::vector<Datum> host, out;
    host.reserve(module.host.size());
    for (const Value& value : module.host)
        host.push_back(evaluate_row(value.op)->run(Call{value, nowhere, bindings, host}));
    for (const Derived& derived : module.derived) out.push_back(host[derived.host.index]);
    return out;
}

Evaluator::Evaluator(const Module& module, Bindings bindings)
    : module_(module), bindings_(std::move(bindings)) {
    SG_ASSERT(bindings_.textures.size() == module.textures.size());
    SG_ASSERT(bindings_.parameters.size() == module.parameters.size());
    for (std::size_t i = 0; i < module.parameters.size(); ++i) {
        SG_ASSERT(kDatumGlsl[bindings_.parameters[i].index()] == info(module.parameters[i].type).glsl);
    }
    for (const Value& value : module.values) SG_ASSERT(evaluate_row(value.op) != nullptr);
    values_.reserve(module.values.size());
}

const std::vector<Datum>& Evaluator::run(const PixelInputs& pixel, std::span<const Datum> known) {
    values_.assign(known.begin(), known.end());
    const std::vector<Datum> derived = derived_values(module_, bindings_);
    for (const Value& value : std::span(module_.values).subspan(known.size())) {
        values_.push_back(evaluate_row(value.op)->run(Call{value, pixel, bindings_, values_, derived}));
    }
    return values_;
}

const Datum& Evaluator::output(Output output, std::uint32_t set) const {
    for (const OutputBinding& binding : module_.outputs) {
        if (binding.output == output && binding.set == set) return values_[binding.value.index];
    }
    SG_UNREACHABLE("the module does not have this output");
}

}  // namespace sg::ir
