// A sample material rendered on the device, and the same material run by the interpreter on the inputs that
// the render shows: pixel by pixel, how far the two are apart, beside how far rounding alone may bring them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compile.hpp"
#include "ir/evaluate.hpp"
#include "runtime/picture.hpp"

namespace sg::oracle {

// With the first level alone nothing depends on the level of detail, the one number that lavapipe
// approximates.
enum class Levels { first, all };
// A torus from outside, or a sphere from inside, where two-sided materials show back faces and others
// nothing.
enum class Seen { outside, inside };

// One material as the interpreter sees it. Not movable: the bindings point at the textures.
struct Material {
    Material(const std::string& sample, Levels levels);  // "layered.json" of materials/
    Material(const Material&) = delete;

    // As lowered, before any optimisation; custom layers replaced by their equivalents. Empty where one has
    // none.
    ir::Module module;
    std::vector<ref::MemoryTexture> textures;
    ir::Bindings bindings;

private:
    void give_each_read_its_own_texture();
};
std::vector<std::string> all_samples();

// Of every covered pixel: the inputs that the debug views show, with the library as it was built, and the
// resolved normal.
std::vector<ir::PixelInputs> draw_inputs(const std::string& sample, Seen seen);
std::vector<ref::dvec3> draw_normals(const std::string& sample, Seen seen, Levels levels,
                                     const target::ShaderLibrary& library,
                                     const std::map<std::string, std::string>& other_files = {});

// What the validation layers said about these renders so far.
std::vector<std::string> validation_messages();

// Degrees, of one pixel.
struct Deviation {
    double error = 0.0;
    double bound = 0.0;   // see deviation.cpp
    bool decided = true;  // false: rounding decides at which step a march ends, and no bound holds
};
Deviation deviation(const Material& material, const ir::Module& module, const ir::PixelInputs& pixel,
                    ref::dvec3 normal);

// Degrees.
struct Comparison {
    std::size_t pixels = 0;
    double median = 0.0, median_bound = 0.0;
    double p999 = 0.0, p999_bound = 0.0;  // 99.9th percentiles
    double beyond = 0.0;                  // the share of pixels whose error is beyond their own bound
    double undecided = 0.0;               // the share of pixels that were left out
    [[nodiscard]] bool holds() const;
};
// `module` is material.module or a mutant of it. Every `stride`th pixel is looked at.
Comparison compare(const Material& material, const ir::Module& module,
                   const std::vector<ir::PixelInputs>& inputs, const std::vector<ref::dvec3>& normals,
                   std::size_t stride = 1);

}  // namespace sg::oracle
