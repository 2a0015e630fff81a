// Texture coordinates (shader_lib/surfgrad/uv.glsl) against double precision.
#include "draws.hpp"
#include "ir/reference/uv.hpp"
#include "textures.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/uv.glsl";
constexpr const char* kPut = "put(0, uv.st); put(2, uv.dx); put(4, uv.dy);";
constexpr const char* kRead = "SgUv(v2(0), v2(2), v2(4))";

void put_uv(const ref::Uv& uv, Expect& out) {
    out.put(0, uv.st), out.put(2, uv.dx), out.put(4, uv.dy);
}
ref::Uv read_uv(const In& in) {
    return {in.v2(0), in.v2(2), in.v2(4)};
}

double signed_magnitude(Random& random) {
    return random.sign() * random.magnitude(0.05, 20.0);
}

void draw_transform(Random& random, Draw& in) {
    draw_uv(random, in, 0);
    in.put(6, glm::dvec2(signed_magnitude(random), signed_magnitude(random)));
    in.put(8, random.uniform(-6.3, 6.3));
    in.put(9, glm::dvec2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)));
}

// Output k is a sum of products no longer than the scaled vector: dx and dy are judged by their own, far
// smaller size.
double scaled_length(const In& in) {
    return std::max(std::abs(in[6]), std::abs(in[7])) * 3.0 + 2.0;
}

// Of a texture that is not square; the coordinate and the filter play no part.
Case texture_size(const char* name, glm::ivec2 size, bool levels) {
    return {.name = name,
            .include = kFile,
            .inputs = 1,
            .outputs = 2,
            .glsl = "put(0, f(0) * sg_texture_size(image_0, sampler_0));",
            .draw = [](Random& random, Draw& in) { in.put(0, random.sign()); },
            .reference = [size](const In& in, Expect& out) { out.put(0, in[0] * glm::dvec2(size)); },
            .bound = {},  // small integers
            .mutants = {{kFile, "textureSize(sampler2D(image, filtering), 0)",
                         "textureSize(sampler2D(image, filtering), 0) - 1"}},
            .textures = {random_texture(size, levels, ref::Wrap::repeat)}};
}

Case texture_size_with_levels() {
    Case item = texture_size("texture_size_with_levels", {48, 20}, true);
    item.mutants.push_back({kFile, "filtering), 0)", "filtering), 1)"});
    return item;
}

std::vector<Case> cases() {
    return {
        texture_size("texture_size", {7, 33}, false),
        texture_size_with_levels(),
        {.name = "uv_scale",
         .include = kFile,
         .inputs = 8,
         .outputs = 6,
         .glsl = std::string("SgUv uv = sg_uv_scale(") + kRead + ", v2(6));" + kPut,
         .draw =
             [](Random& random, Draw& in) {
                 draw_uv(random, in, 0);
                 in.put(6, glm::dvec2(signed_magnitude(random), signed_magnitude(random)));
             },
         .reference = [](const In& in, Expect& out) { put_uv(ref::uv_scale(read_uv(in), in.v2(6)), out); },
         .bound = {.absolute = 1e-30, .relative = 2 * kUlp},  // one product
         .mutants = {{kFile, "uv.dx * scale, uv.dy * scale", "uv.dx, uv.dy"},
                     {kFile, "uv.st * scale", "uv.st / scale"}}},
        {.name = "uv_transform",
         .include = kFile,
         .inputs = 11,
         .outputs = 6,
         .glsl = std::string("SgUv uv = sg_uv_transform(") + kRead + ", v2(6), f(8), v2(9));" + kPut,
         .draw = draw_transform,
         .reference =
             [](const In& in, Expect& out) {
                 put_uv(ref::uv_transform(read_uv(in), in.v2(6), in[8], in.v2(9)), out);
             },
         // Sine and cosine are good to 2^-11 by Vulkan's rules and to 3 ulp of 1 on lavapipe (toolchain.md
         // 6), then four roundings: 10 in all.
         .bound = {.absolute = 20 * kUlp},
         .condition = scaled_length,
         .mutants = {{kFile, "turn * tiled.st + offset", "turn * (tiled.st + offset)"},
                     {kFile, "turn * tiled.st + offset", "tiled.st + offset"}}},
        {.name = "uv_transform_derivatives",
         .include = kFile,
         .inputs = 11,
         .outputs = 4,
         .glsl = std::string("SgUv uv = sg_uv_transform(") + kRead +
                 ", v2(6), f(8), v2(9)); put(0, uv.dx); put(2, uv.dy);",
         .draw = draw_transform,
         .reference =
             [](const In& in, Expect& out) {
                 const ref::Uv uv = ref::uv_transform(read_uv(in), in.v2(6), in[8], in.v2(9));
                 out.put(0, uv.dx), out.put(2, uv.dy);
             },
         .bound = {.absolute = 20 * kUlp},  // as above, of the derivatives' own length
         .condition =
             [](const In& in) {
                 return std::max(glm::length(in.v2(2) * in.v2(6)), glm::length(in.v2(4) * in.v2(6)));
             },
         .mutants = {{kFile, "turn * tiled.dx, turn * tiled.dy", "tiled.dx, tiled.dy"},
                     {kFile, "turn * tiled.dx, turn * tiled.dy", "tiled.dx * turn, tiled.dy * turn"}}},
        {.name = "uv_level",
         .include = kFile,
         .inputs = 8,
         .outputs = 1,
         .glsl = std::string("put(0, sg_uv_level(") + kRead + ", v2(6)));",
         .draw =
             [](Random& random, Draw& in) {
                 draw_uv(random, in, 0);
                 in.put(6, glm::dvec2(1 << random.below(13), 1 << random.below(13)));
             },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::uv_level(read_uv(in), in.v2(6))); },
         // log2 is good to 5e-7 on lavapipe; its result of up to 30 is rounded once more.
         .bound = {.absolute = 1e-6, .relative = 4 * kUlp},
         .mutants = {{kFile, "0.5 * log2", "log2"},
                     {kFile, "max(dot(across, across), dot(down, down))", "dot(across, across)"},
                     {kFile, "vec2 down = dim * uv.dy", "vec2 down = uv.dy"},
                     {kFile, "max(dot(across, across), dot(down, down))",
                      "min(dot(across, across), dot(down, down))"}}},
    };
}

SG_PROVE(UvCoordinates, cases());

TEST(Uv, AConstantCoordinateHasAFiniteLevel) {
    const Case item = {.name = "constant",
                       .include = kFile,
                       .inputs = 1,
                       .outputs = 1,
                       .glsl = "put(0, sg_uv_level(SgUv(vec2(f(0)), vec2(0.0), vec2(0.0)), vec2(1024.0)));"};
    const std::vector<float> zero = {0.5f};
    EXPECT_NEAR(evaluate(item, zero)[0], -39.863, 0.01);
}

}  // namespace
}  // namespace sg::proof
