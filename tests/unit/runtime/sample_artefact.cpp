#include "tests/unit/runtime/sample_artefact.hpp"

#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sg::runtime::test {
namespace {

std::string shader_bytes(const std::string& name) {
    std::ifstream file(SG_SHADER_DIR "/" + name + ".spv", std::ios::binary);
    if (!file) throw std::runtime_error("no shader " + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string stages(const std::string& entry, const std::string& fragment) {
    auto stage = [&](const char* kind, const std::string& shader) {
        return fmt::format(
            R"({{"stage": "{0}", "file": "sample.{1}.{0}.spv", "hash": "{2}", "instructions": 1}})", kind,
            entry, content_hash(shader_bytes(shader)));
    };
    return fmt::format("\"stages\": [{}, {}]", stage("vert", "sample.vert"), stage("frag", fragment));
}

constexpr const char* kInputs = R"("vertex_inputs": [
    {"name": "position", "location": 0, "format": "float3"}, {"name": "normal", "location": 1, "format": "float3"},
    {"name": "tangent", "location": 2, "format": "float4"}, {"name": "uv0", "location": 4, "format": "float2"}],
  "outputs": [{"name": "color", "location": 0, "format": "float4"}])";

constexpr const char* kCommonBindings =
    R"({"set": 0, "binding": 0, "kind": "uniform_buffer", "name": "SgFrameBlock", "stages": ["vert", "frag"]},
    {"set": 2, "binding": 0, "kind": "uniform_buffer", "name": "SgObjectBlock", "stages": ["vert"]})";

constexpr const char* kMaterialBindings =
    R"({"set": 1, "binding": 0, "kind": "uniform_buffer", "name": "SgMaterialBlock", "stages": ["frag"]},
    {"set": 1, "binding": 1, "kind": "texture", "name": "paint", "stages": ["frag"]},
    {"set": 1, "binding": 2, "kind": "sampler", "name": "sampler0", "stages": ["frag"]})";

constexpr const char* kViews = R"("views": [
    {"name": "position", "number": 0, "components": 3, "kind": "position"},
    {"name": "base-normal", "number": 1, "components": 3, "kind": "direction"},
    {"name": "uv0", "number": 2, "components": 2, "kind": "uv"},
    {"name": "uv0-derivatives", "number": 3, "components": 4, "kind": "vector"},
    {"name": "tangent", "number": 4, "components": 3, "kind": "direction"},
    {"name": "unprojected", "number": 5, "components": 3, "kind": "position"},
    {"name": "facing", "number": 6, "components": 3, "kind": "vector"}])";

constexpr const char* kParameters = R"("parameter_block": {"set": 1, "binding": 0, "size": 16, "parameters": [
    {"name": "tint", "type": "color", "offset": 0, "default": [1, 1, 1], "label": "", "unit": ""},
    {"name": "gain", "type": "float", "offset": 12, "default": [0.5], "range": [0, 4], "label": "", "unit": ""}]})";

constexpr const char* kSamplers =
    R"("samplers": [{"set": 1, "binding": 2, "wrap_s": "repeat", "wrap_t": "repeat",
    "filter": "linear", "mip_filter": "linear", "anisotropy": 1}])";

}  // namespace

asset::Image paint() {
    constexpr std::uint32_t kSide = 64;
    asset::Image image = asset::make_image(kSide, kSide, asset::TexelFormat::unorm8);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            bool edge = std::min(x, y) < 3 || std::max(x, y) >= kSide - 3;
            bool right = x >= kSide / 2, lower = y >= kSide / 2;
            double level = edge ? 0.1 : 1.0;
            image.set(x, y, 0, right == lower ? level : 0);
            image.set(x, y, 1, right ? level : 0);
            image.set(x, y, 2, lower ? level : 0);
            image.set(x, y, 3, 1);
        }
    }
    return image;
}

std::string sample_manifest(const std::string& two_sided) {
    std::string texture = fmt::format(
        R"("textures": [{{"name": "paint", "file": "pictures/paint.png", "hash": "{}", "set": 1, "binding": 1,
    "sampler_binding": 2, "encoding": "color", "color_space": "srgb"}}])",
        content_hash(asset::png_bytes(paint())));
    return fmt::format(
        R"({{"format": "surfgrad-artefact", "version": 1, "generator": "a test", "name": "sample", "stem": "sample",
"source": {{"file": "sample.json", "hash": ""}}, "two_sided": "{}",
"entry_points": [
 {{"name": "forward", {}, {}, "bindings": [{}, {}], "views": []}},
 {{"name": "debug", {}, {}, "bindings": [{}], {}}}],
{}, {}, {}}})",
        two_sided, stages("forward", "sample_forward.frag"), kInputs, kCommonBindings, kMaterialBindings,
        stages("debug", "sample_debug.frag"), kInputs, kCommonBindings, kViews, kParameters, texture,
        kSamplers);
}

std::vector<std::pair<std::filesystem::path, std::string>> sample_files(const std::filesystem::path& folder,
                                                                        const std::string& two_sided) {
    return {{folder / "sample.json", sample_manifest(two_sided)},
            {folder / "sample.forward.vert.spv", shader_bytes("sample.vert")},
            {folder / "sample.forward.frag.spv", shader_bytes("sample_forward.frag")},
            {folder / "sample.debug.vert.spv", shader_bytes("sample.vert")},
            {folder / "sample.debug.frag.spv", shader_bytes("sample_debug.frag")},
            {folder / "pictures/paint.png", asset::png_bytes(paint())}};
}

}  // namespace sg::runtime::test
