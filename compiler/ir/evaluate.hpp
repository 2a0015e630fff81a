// The interpreter: runs any module in double precision on the mathematics of ir/reference/, which shares no
// code with the GLSL library. It is the oracle for whole materials and for the optimiser. Cost: linear in the
// module.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "ir/ir.hpp"
#include "ir/reference/combine.hpp"
#include "ir/reference/decal.hpp"
#include "ir/reference/frame.hpp"
#include "ir/reference/noise.hpp"
#include "ir/reference/parallax.hpp"
#include "ir/reference/tbn.hpp"
#include "ir/reference/texture.hpp"
#include "ir/reference/triplanar.hpp"
#include "ir/reference/uv.hpp"

namespace sg::ir {

// A place in the space of a lookup with its screen derivatives.
struct Volume {
    ref::dvec3 p, dx, dy;
};

struct NormalDerivatives {
    ref::dvec3 dndx, dndy;
};

// What a value evaluates to, by width. ir::Type keeps the meaning; the names are those of types.def's GLSL
// column.
using Datum = std::variant<double, ref::dvec2, ref::dvec3, ref::dvec4, ref::Frame, ref::Uv, ref::Basis,
                           Volume, ref::TriplanarUv, ref::Noise, glm::dmat4, ref::Decal, ref::DerivPair,
                           ref::March, NormalDerivatives>;
inline constexpr std::array<std::string_view, std::variant_size_v<Datum>> kDatumGlsl = {
    "float", "vec2",    "vec3",        "vec4",          "SgFrame",
    "SgUv",  "SgBasis", "SgVolume",    "SgTriplanarUv", "SgNoise",
    "mat4",  "SgDecal", "SgDerivPair", "SgParallax",    "SgNormalDerivatives"};

// The components of a datum in the order of its fields.
std::vector<double> components(const Datum& datum);

// What parallax and the frames that it makes need to know of the camera.
struct PixelCamera {
    bool perspective = true;
    ref::dvec3 position{0.0};              // absolute world space
    ref::dvec3 direction{0.0, 0.0, -1.0};  // unit, where it looks
    glm::dmat4 relative_from_screen{1.0};  // (x px, y px, depth, 1) to homogeneous relative world space
};

// What the vertex stage and the frame hand to one pixel. Conventions: compiler/artefacts.md.
struct PixelInputs {
    ref::dvec3 position{0.0};                 // relative world space
    ref::dvec3 vertex_normal{0.0, 0.0, 1.0};  // as interpolated
    ref::dvec4 vertex_tangent{1.0, 0.0, 0.0, 1.0};
    std::array<ref::Uv, 8> uvs{};
    ref::dvec3 dpdx{1.0, 0.0, 0.0};  // of the position, per pixel
    ref::dvec3 dpdy{0.0, -1.0, 0.0};
    ref::dvec3 dndx{0.0};  // of the unit base normal, per pixel
    ref::dvec3 dndy{0.0};
    double facing = 1.0;  // +1 front, -1 back
    ref::dvec4 vertex_color{1.0};
    Volume object{};  // the pixel in object space
    Volume world{};   // and in absolute world space
    double time = 0.0;
    glm::dmat3 world_from_object{1.0};   // upper 3x3
    glm::dmat3 normal_from_object{1.0};  // its inverse transpose up to a positive factor
    ref::dvec3 object_origin{0.0};       // relative world space
    PixelCamera camera;
};

// A texture's texels and how its sampler reads them. Isotropic; the level of detail is
// 0.5 log2(max(|dim dx|^2, |dim dy|^2)) + lod_bias, below 0 under magnification.
struct Sampled {
    enum class Wrap { repeat, mirror, clamp };
    enum class Mips { none, nearest, linear };
    const ref::TextureSource* texels = nullptr;  // must outlive the evaluator
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    bool linear = true;  // within a level
    Mips mips = Mips::linear;
    double lod_bias = 0.0;

    [[nodiscard]] ref::dvec4 at(const ref::Uv& uv) const;
    // At a level of detail that the shader computed itself.
    [[nodiscard]] ref::dvec4 at_level(ref::dvec2 st, double level) const;
};

// What the material hands to every pixel, by TextureId and ParameterId.
struct Bindings {
    std::vector<Sampled> textures;
    std::vector<Datum> parameters;  // each as wide as its type
};

// A constant or a parameter's value: the first components of `number`, as many as the type has; a matrix by
// its columns.
Datum datum_of(Type type, std::span<const double> number);

// The module with the host's numbers as the manifest has them: 32-bit floats, as those of the shader are, so
// that 0.7 is no larger than a parameter of 0.7.
Module with_stored_numbers(Module module);
// What the host computes from the parameters, by Value::index of Op::derived.
std::vector<Datum> derived_values(const Module& module, const Bindings& bindings);

class Evaluator {
public:
    // `module` must verify and outlive the evaluator; the bindings must be complete.
    Evaluator(const Module& module, Bindings bindings);
    // Evaluates all values for one pixel: entry i is value %i. Valid until the next run. `known`: the first
    // of them, where they are known already; not of this evaluator's own last run.
    const std::vector<Datum>& run(const PixelInputs& pixel, std::span<const Datum> known = {});
    // Of the last run. The module must have the output.
    [[nodiscard]] const Datum& output(Output output, std::uint32_t set = 0) const;
    // Parameters may be set between runs.
    Bindings& bindings() { return bindings_; }

private:
    const Module& module_;
    Bindings bindings_;
    std::vector<Datum> values_;
};

}  // namespace sg::ir
