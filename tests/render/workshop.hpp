// From a material's text to numbers in one process: compile, load, render on one shared device. The device
// has the validation layers on; validation_test.cpp fails the run if they say anything.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compile.hpp"
#include "runtime/render.hpp"

namespace sg::truth {

// Text of a material and the pictures that it names, by path.
struct Recipe {
    std::string json;
    std::map<std::string, std::string> files;
    std::vector<std::string> entries = {"normal"};
    bool optimise = true;  // both the IR and SPIR-V
    layers::Numbers numbers = layers::Numbers::baked;
    std::string skipped_rule = {};  // of the optimiser
};

struct Made {
    runtime::Artefact artefact;
    runtime::TextureSet textures;
    std::vector<std::byte> parameters;
    std::string ir;  // as lowered
};

// Ends the test with the messages where the recipe does not compile.
Made make(const Recipe& recipe, const target::ShaderLibrary& library);
// The same with the library as it was built.
Made make(const Recipe& recipe);

// Draws a view by name.
runtime::Picture draw(const Made& made, const runtime::Scene& scene, const std::string& view,
                      std::uint32_t width, std::uint32_t height, bool negative_viewport = false);
// Its rows from the last to the first.
runtime::Picture upside_down(const runtime::Picture& picture);

// Every file of materials/, by path relative to that folder, into a recipe's files.
std::map<std::string, std::string> sample_files();

// The materials that the paper's figures draw, "figures/perlin.json" say, but for the older methods in GLSL
// of their own.
std::vector<std::string> figure_materials();

// What the validation layers said so far.
std::vector<std::string> validation_messages();

struct Percentiles {
    double median = 0, p99 = 0, max = 0;
    std::size_t count = 0;
};
Percentiles percentiles(std::vector<double> values);

glm::dvec3 rgb(const runtime::Picture& picture, std::uint32_t x, std::uint32_t y);
bool covered(const runtime::Picture& picture, std::uint32_t x, std::uint32_t y);

// Writes the float picture, mapped from -1..1, as PNG into the folder that SG_RENDER_PICTURES names; nothing
// without.
void show(const runtime::Picture& picture, const std::string& name);

}  // namespace sg::truth
