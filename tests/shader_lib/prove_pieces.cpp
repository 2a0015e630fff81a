// The library's small parts, each called by itself, against the row of ir/functions.hpp; and that table
// against the library: every function has a row of its own types, and a case that calls it.
#include <cctype>
#include <cmath>

#include "harness.hpp"
#include "ir/functions.hpp"
#include "ir/reference/decal.hpp"
#include "ir/reference/noise.hpp"
#include "library_index.hpp"
#include "textures.hpp"

namespace sg::proof {
namespace {

constexpr const char* kDecal = "surfgrad/decal.glsl";
constexpr const char* kNoise = "surfgrad/noise.glsl";

// The reference of a function, out of the table.
template <class Function>
Function* reference(const char* name) {
    return std::any_cast<Function*>(ir::library_function(name)->pointer);
}

void put_decal(Expect& out, const ref::Decal& decal) {
    out.put(0, decal.uv.st), out.put(2, decal.uv.dx), out.put(4, decal.uv.dy);
    out.put(6, decal.grad_s), out.put(9, decal.grad_t), out.put(12, decal.local);
}
constexpr const char* kPutDecal =
    "put(0, d.uv.st); put(2, d.uv.dx); put(4, d.uv.dy); put(6, d.grad_s); put(9, d.grad_t); put(12, "
    "d.local);";

std::vector<Case> decal_cases() {
    return {
        {.name = "decal_row",
         .include = kDecal,
         .inputs = 17,
         .outputs = 3,
         .glsl = "put(0, sg_decal_row(m4(0), int(f(16))));",
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 16; ++k) in.put(k, random.uniform(-4.0, 4.0));
                 in.put(16, random.below(3));
             },
         .reference =
             [](const In& in, Expect& out) {
                 const glm::dmat4 m(in.v4(0), in.v4(4), in.v4(8), in.v4(12));
                 out.put(0,
                         reference<glm::dvec3(glm::dmat4, int)>("sg_decal_row")(m, static_cast<int>(in[16])));
             },
         .bound = {},  // a copy
         .mutants = {{kDecal, "projector[2][row]);", "projector[3][row]);"}}},
        {.name = "decal_from_gradients",
         .include = kDecal,
         .inputs = 17,
         .outputs = 15,
         .glsl =
             std::string("SgDecal d = sg_decal_from_gradients(v3(0), v2(3), v3(5), v3(8), v3(11), v3(14));") +
             kPutDecal,
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 17; ++k) in.put(k, random.uniform(-1.0, 1.0));
             },
         .reference =
             [](const In& in, Expect& out) {
                 put_decal(out, reference<ref::Decal(glm::dvec3, glm::dvec2, glm::dvec3, glm::dvec3,
                                                     glm::dvec3, glm::dvec3)>("sg_decal_from_gradients")(
                                    in.v3(0), in.v2(3), in.v3(5), in.v3(8), in.v3(11), in.v3(14)));
             },
         // Three products below 1 and two sums below 3: 3 + 2 + 3 halves of u; doubled.
         .bound = {.absolute = 16 * kUlp},
         .mutants = {{kDecal, "vec2(dot(grad_s, dpdx), dot(grad_t, dpdx))",
                      "vec2(dot(grad_s, dpdx), dot(grad_s, dpdy))"}}},
    };
}

std::vector<Case> decal_quotient_cases() {
    return {
        {.name = "decal_central",
         .include = kDecal,
         .inputs = 21,
         .outputs = 15,
         .glsl = std::string(
                     "SgDecal d = sg_decal_central(v3(0), v3(3), v3(6), v3(9), v3(12), v3(15), v3(18));") +
                 kPutDecal,
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 21; ++k) in.put(k, random.uniform(-1.0, 1.0));
                 in.put(5, random.below(8) == 0 ? -random.uniform(0.0, 1.0) : random.uniform(0.1, 1.0));
             },
         .reference =
             [](const In& in, Expect& out) {
                 put_decal(out, reference<ref::Decal(glm::dvec3, glm::dvec3, glm::dvec3, glm::dvec3,
                                                     glm::dvec3, glm::dvec3, glm::dvec3)>("sg_decal_central")(
                                    in.v3(0), in.v3(3), in.v3(6), in.v3(9), in.v3(12), in.v3(15), in.v3(18)));
             },
         // A slope (1 rounding), its product and a difference (2), times one over ahead (2), and a dot
         // product of three (5) of vectors up to 1.8 long.
         .bound = {.absolute = 36 * kUlp},
         .condition =
             [](const In& in) {
                 const double ahead = in[5] > 0.0 ? in[5] : 1.0;
                 return (1.0 + 1.8 / ahead) / ahead;
             },
         .mutants = {{kDecal, "bool before = ray.z > 1e-6;", "bool before = true;"},
                     {kDecal, "0.5 / ray.z : 0.0", "1.0 / ray.z : 0.0"}}},
        {.name = "decal_fade",
         .include = kDecal,
         .inputs = 2,
         .outputs = 1,
         .glsl = "put(0, sg_decal_fade(f(0), f(1)));",
         .draw = [](Random& random,
                    Draw& in) { in.put(0, random.uniform(-0.1, 1.2)), in.put(1, random.uniform(0.05, 1.0)); },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, reference<double(double, double)>("sg_decal_fade")(in[0], in[1]));
             },
         // A difference and a quotient (2) times the cubic's slope of 1.5, and the cubic (5).
         .bound = {.absolute = 16 * kUlp},
         .condition = [](const In& in) { return 1.0 + 0.1 / in[1]; },
         .mutants = {{kDecal, "t * t * (3.0 - 2.0 * t)", "t"}}},
    };
}

std::vector<Case> noise_cases() {
    return {
        {.name = "perlin_pair",
         .include = kNoise,
         .inputs = 2,
         .outputs = 1,
         .glsl = "put(0, float(sg_perlin_pair(uint(f(0)), uint(f(1)))));",
         // Three bytes: exact in a float.
         .draw = [](Random& random,
                    Draw& in) { in.put(0, random.below(1 << 24)), in.put(1, random.below(256)); },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, reference<unsigned(unsigned, unsigned)>("sg_perlin_pair")(
                                static_cast<unsigned>(in[0]), static_cast<unsigned>(in[1])));
             },
         .bound = {},  // whole numbers
         .mutants = {{kNoise, "word >> (8u * (i & 1u))", "word"}}},
        {.name = "perlin_corner",
         .include = kNoise,
         .inputs = 4,
         .outputs = 4,
         .glsl = "put(0, sg_perlin_corner(uint(f(3)), v3(0)));",
         .draw = [](Random& random,
                    Draw& in) { in.put(0, random.within(1.0)), in.put(3, random.below(1 << 16)); },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, reference<glm::dvec4(unsigned, glm::dvec3)>("sg_perlin_corner")(
                                static_cast<unsigned>(in[3]), in.v3(0)));
             },
         .bound = {.absolute = 8 * kUlp},  // twice the sum of two numbers below 1; the third product is 0
         .mutants = {{kNoise, "2u * hash & 31u", "2u * hash & 15u"}}},
        {.name = "octave_weight",
         .include = kNoise,
         .inputs = 1,
         .outputs = 1,
         .glsl = "put(0, sg_octave_weight(f(0)));",
         .draw = [](Random& random, Draw& in) { in.put(0, random.uniform(0.0, 2.0)); },
         .reference = [](const In& in,
                         Expect& out) { out.put(0, reference<double(double)>("sg_octave_weight")(in[0])); },
         // As sg_smoothstep (10 roundings) and a difference; doubled.
         .bound = {.absolute = 22 * kUlp},
         .mutants = {{kNoise, "smoothstep(0.5, 1.0, footprint)", "smoothstep(0.5, 1.01, footprint)"}}},
    };
}

SG_PROVE(DecalPieces, joined(decal_cases(), decal_quotient_cases()));
SG_PROVE(NoisePieces, noise_cases());

// "vec3 sg_reject(vec3 v, vec3 n) {...": "vec3(vec3, vec3)".
std::string signature_of(const std::string& whole, const std::string& function) {
    const std::size_t name = whole.find(" " + function + "("), open = whole.find('(', name),
                      close = whole.find(')', open);
    std::string out;
    std::string word;
    bool named = false;
    for (char c : whole.substr(open + 1, close - open - 1) + ",") {
        if (c == ',') {
            named = false;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            if (!word.empty() && !named) out += (out.empty() ? "" : ", ") + word, named = true;
            word.clear();
            continue;
        }
        word = c == ',' ? "" : word + c;
    }
    return whole.substr(0, name) + "(" + out + ")";
}

TEST(ReferenceTable, HasEveryFunctionWithItsTypes) {
    const auto functions = library_functions();
    for (const auto& [function, file] : functions) {
        const ir::LibraryFunction* row = ir::library_function(function);
        ASSERT_NE(row, nullptr) << function << " of " << file << " has no row in compiler/ir/functions.cpp";
        EXPECT_EQ(row->signature, signature_of(definition(file, function), function)) << function;
    }
    for (const ir::LibraryFunction& row : ir::library_functions()) {
        EXPECT_TRUE(functions.contains(std::string(row.glsl)))
            << row.glsl << " is no function of the library";
    }
}

TEST(ReferenceTable, EveryFunctionIsCalledByACase) {
    for (const auto& [function, file] : library_functions()) {
        bool called = false;
        for (const Case& item : all_cases()) called |= item.glsl.find(function + "(") != std::string::npos;
        EXPECT_TRUE(called) << "no case calls " << function << " of " << file;
    }
}

}  // namespace
}  // namespace sg::proof
