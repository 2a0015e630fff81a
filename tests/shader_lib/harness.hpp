// GLSL against double precision. A Case is one row: an expression over packed floats, where its inputs come
// from, what mathematics says, how far apart the two may be and why, and the mistakes that must be noticed.
//
//   static std::vector<Case> cases() { return {{.name = "reject", .include = "surfgrad/frame.glsl", ...}}; }
//   SG_PROVE(Frame, cases());
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "glsl.hpp"
#include "ir/reference/texture.hpp"
#include "random.hpp"

namespace sg::proof {

// Half a unit in the last place of 1: the largest relative error of one correctly rounded operation. Lavapipe
// rounds
// + - * / and sqrt correctly and never fuses them; a bound of k roundings is written 2 k kUlp, so that a GPU
// with Vulkan's looser division and square root fits too.
inline constexpr double kUlp = 1.0 / (1 << 24);
inline constexpr std::size_t kCount = 100000;       // inputs per case
inline constexpr double kNoticed = 1e-5;            // a relative error that no bound hides
inline constexpr std::size_t kMutantCount = 10000;  // inputs until a mutant must have been noticed

// One input: the very floats that the shader read, as doubles.
class In {
public:
    explicit In(std::span<const float> floats) : floats_(floats) {}
    double operator[](std::size_t k) const { return floats_[k]; }
    glm::dvec2 v2(std::size_t k) const { return {floats_[k], floats_[k + 1]}; }
    glm::dvec3 v3(std::size_t k) const { return {v2(k), floats_[k + 2]}; }
    glm::dvec4 v4(std::size_t k) const { return {v3(k), floats_[k + 3]}; }
    std::size_t size() const { return floats_.size(); }

private:
    std::span<const float> floats_;
};

// Writes numbers at positions, from doubles.
template <typename Float>
class Pack {
public:
    explicit Pack(std::span<Float> floats) : floats_(floats) {}
    void put(std::size_t k, double x) { floats_[k] = static_cast<Float>(x); }
    void put(std::size_t k, glm::dvec2 v) { put(k, v.x), put(k + 1, v.y); }
    void put(std::size_t k, glm::dvec3 v) { put(k, v.x), put(k + 1, v.y), put(k + 2, v.z); }
    void put(std::size_t k, glm::dvec4 v) { put(k, glm::dvec3(v)), put(k + 3, v.w); }
    std::size_t size() const { return floats_.size(); }
    std::span<Float> floats() const { return floats_; }  // what was written so far

private:
    std::span<Float> floats_;
};
using Draw = Pack<float>;
using Expect = Pack<double>;

// Allowed: |shader - mathematics| <= absolute + relative |mathematics|, for each output float.
struct Bound {
    double absolute = 0.0;
    double relative = 0.0;
};

// A texture of a case: 32-bit floats, filtered linearly within and between levels. Texels must be floats.
struct CaseTexture {
    ref::MemoryTexture image;
    ref::Sampler sampler;
};

struct Case {
    std::string name = {};
    // Why a formula that is off by kNoticed of its result may pass. Empty: it may not.
    std::string blunt = {};
    std::string include = {};  // library file; several: separated by a blank
    int inputs = 0;            // floats per input
    int outputs = 0;           // floats per output
    // Statements. f(k), v2(k), v3(k), v4(k) read input floats from position k, m3(k) and m4(k) a matrix by
    // columns; put(k, x) writes an output from position k.
    std::string glsl = {};
    std::function<void(Random&, Draw&)> draw = {};
    // Empty when only `property` speaks (inputs outside the domain, say).
    std::function<void(const In&, Expect&)> reference = {};
    Bound bound = {};
    // How much the problem itself magnifies rounding at this input; the bound is multiplied by it. Empty: 1.
    std::function<double(const In&)> condition = {};
    // What must hold for every result: "" or what is wrong.
    std::function<std::string(const In& in, const In& out)> property = {};
    std::vector<Mutant> mutants = {};
    // GLSL before the function that holds `glsl`: published formulas to compare with, say.
    std::string declarations = {};
    // In GLSL: texture i is `texture2D image_<i>` with `sampler sampler_<i>`.
    std::vector<std::shared_ptr<const CaseTexture>> textures = {};
    std::size_t count = kCount;  // inputs to draw
};

// The shader that evaluates a case, without its #version line.
std::string shader_text(const Case& item);

// What the case's GLSL gives for packed inputs. Fails the running test when it does not compile or run.
std::vector<float> evaluate(const Case& item, std::span<const float> inputs, const Mutant* mutant = nullptr);

struct Worst {
    double ratio = 0.0;     // error / allowed; above 1 fails; infinite for NaN
    double error = 0.0;     // the largest absolute error
    std::string violation;  // the first input that failed, in full
    // The smallest relative error of a result that its bound shows somewhere; infinite where all should be 0.
    double sensitivity = std::numeric_limits<double>::infinity();
};
Worst compare(const Case& item, std::span<const float> inputs, std::span<const float> outputs);
std::vector<float> draw_inputs(const Case& item, std::size_t count);

// A vector has the length 1 within `tolerance` (false for NaN).
bool is_unit(glm::dvec3 v, double tolerance = 1e-5);
bool is_finite(glm::dvec3 v);

// One list after another.
inline std::vector<Case> joined(std::vector<Case> first, const std::vector<Case>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

struct MutantOf {
    Case item;
    Mutant mutant;
};
std::vector<MutantOf> mutants_of(const std::vector<Case>& cases);
std::string case_name(const testing::TestParamInfo<Case>& info);
std::string mutant_name(const testing::TestParamInfo<MutantOf>& info);

// Every case that SG_PROVE registered can be found by its name; null if there is none.
bool add_cases(std::function<std::vector<Case>()> cases);
const std::vector<Case>& all_cases();
const Case* find_case(const std::string& name);

// What a failing test prints of its parameter.
inline void PrintTo(const Case& item, std::ostream* out) {
    *out << item.name;
}
inline void PrintTo(const MutantOf& of, std::ostream* out) {
    *out << of.item.name << ", mutant of " << of.mutant.file;
}

class AgainstDouble : public testing::TestWithParam<Case> {};
class Mutants : public testing::TestWithParam<MutantOf> {};

}  // namespace sg::proof

// Registers `Concept/AgainstDouble.Holds/<case>` and `Concept/Mutants.AreNoticed/<case>_<number>`.
#define SG_PROVE(Concept, cases)                                                                        \
    [[maybe_unused]] const bool kAdded##Concept = ::sg::proof::add_cases([] { return cases; });         \
    INSTANTIATE_TEST_SUITE_P(Concept, AgainstDouble, testing::ValuesIn(cases), ::sg::proof::case_name); \
    INSTANTIATE_TEST_SUITE_P(Concept, Mutants, testing::ValuesIn(::sg::proof::mutants_of(cases)),       \
                             ::sg::proof::mutant_name)
