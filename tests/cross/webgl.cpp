#include "tests/cross/webgl.hpp"

#include <fmt/core.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/cross/process.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    std::string out;
    for (std::size_t i = 0; i < size; i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8u | (i + k < size ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += i + k <= size ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}
template <typename T>
std::string base64(const std::vector<T>& values) {
    return base64(values.data(), values.size() * sizeof(T));
}

Pixels pixels_from(const std::string& text) {
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (char c : text) {
        std::size_t digit = kDigits.find(c);
        if (digit == kDigits.npos) continue;
        group = group << 6u | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(group >> bits & 0xFFu);
    }
    Pixels out(std::size_t{kSide} * kSide * 4);
    if (bytes.size() != out.size() * sizeof(float)) throw std::runtime_error("the browser gave another number of bytes");
    std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
}

Json level_json(const asset::Image& image) {
    Json out = {{"width", image.width}, {"height", image.height}, {"float", image.format != asset::TexelFormat::unorm8}};
    if (image.format == asset::TexelFormat::unorm8) {
        out["bytes"] = base64(image.bytes);
        return out;
    }
    std::vector<float> values;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            for (int c = 0; c < 4; ++c) values.push_back(static_cast<float>(image.at(x, y, c)));
        }
    }
    out["bytes"] = base64(values);
    return out;
}

Json sampler_json(const runtime::gpu::SamplerState& state) {
    constexpr const char* kWraps[] = {"REPEAT", "MIRRORED_REPEAT", "CLAMP_TO_EDGE"};
    std::string within = state.linear ? "LINEAR" : "NEAREST";
    using enum runtime::gpu::MipFilter;
    std::string between = state.mip_filter == none ? "" : state.mip_filter == linear ? "_MIPMAP_LINEAR" : "_MIPMAP_NEAREST";
    return {{"TEXTURE_WRAP_S", kWraps[static_cast<std::size_t>(state.wrap_s)]},
            {"TEXTURE_WRAP_T", kWraps[static_cast<std::size_t>(state.wrap_t)]},
            {"TEXTURE_MAG_FILTER", within},
            {"TEXTURE_MIN_FILTER", within + between}};
}

// `textures` grows by what no drawing had before.
Json drawing_json(const Drawing& drawing, Json& textures) {
    Json out = {{"vertex", drawing.vertex.text}, {"fragment", drawing.fragment.text}, {"indices", base64(drawing.indices)}, {"cull", drawing.cull_back}};
    for (const Attribute& a : drawing.attributes) {
        out["attributes"].push_back({{"location", a.location}, {"components", a.components}, {"values", base64(a.values)}});
    }
    for (const Stage* stage : {&drawing.vertex, &drawing.fragment}) {
        for (const Slot& slot : stage->slots) {
            Json row = {{"name", slot.name}, {"index", slot.index}};
            if (slot.kind == "uniform_buffer") {
                row["bytes"] = base64(drawing.blocks[slot.set]);
            } else {
                const TextureView& view = drawing.textures.at(slot.binding);
                std::string key = fmt::format("{}", static_cast<const void*>(view.chain));
                if (!textures.contains(key)) {
                    for (const asset::Image& level : *view.chain) textures[key].push_back(level_json(level));
                }
                row["texture"] = key;
                row["srgb"] = view.srgb;
                row["sampler"] = sampler_json(drawing.samplers.at(slot.sampler_binding));
            }
            out["slots"].push_back(row);
        }
    }
    return out;
}

std::string browser() {
    for (const char* name : {"chromium-headless-shell", "chromium"}) {
        if (has_program(name)) return name;
    }
    return "";
}

// ANGLE on Mesa's llvmpipe, the driver that draws the reference.
std::string dom_of(const std::string& page) {
    auto file = scratch() / "page.html";
    write_file(file, page);
    return run(fmt::format("timeout 100 {} --headless --no-sandbox --disable-dev-shm-usage --user-data-dir='{}' --use-gl=angle --use-angle=gl-egl "
                           "--ignore-gpu-blocklist --dump-dom 'file://{}' 2>/dev/null",
                           browser(), (scratch() / "profile").string(), file.string()))
        .text;
}

}  // namespace

std::string webgl_missing() {
    static const std::string kMissing = [] {
        if (browser().empty()) return std::string("no chromium-headless-shell and no chromium");
        std::string dom = dom_of("<body><script>document.body.textContent = '[' + !!document.createElement('canvas').getContext('webgl2') + ']'</script>");
        return std::string(dom.find("[true]") == dom.npos ? browser() + " has no WebGL 2 here" : "");
    }();
    return kMissing;
}

WebglOutcome webgl_draw(const std::vector<Drawing>& drawings, const std::vector<ShaderPair>& pairs) {
    Json input = {{"side", kSide}, {"textures", Json::object()}, {"drawings", Json::array()}, {"pairs", Json::array()}};
    for (const Drawing& drawing : drawings) input["drawings"].push_back(drawing_json(drawing, input["textures"]));
    for (const ShaderPair& pair : pairs) input["pairs"].push_back({{"vertex", pair.vertex}, {"fragment", pair.fragment}});
    std::string script = test::read_file(test::source_dir() / "tests/cross/webgl.js");
    std::istringstream lines(dom_of("<body><script>const input = " + input.dump() + ";\n" + script + "</script></body>"));
    WebglOutcome out;
    std::string line;
    std::getline(lines, line);  // up to the body
    while (out.refusals.size() < drawings.size() + pairs.size()) {
        if (!std::getline(lines, line)) throw std::runtime_error("the browser gave no answer: " + line);
        bool drawn = out.refusals.size() < drawings.size();
        bool refused = line.starts_with("refused") || line.starts_with("no ");
        out.refusals.push_back(refused ? line : "");
        if (drawn) out.pictures.push_back(refused ? Pixels{} : pixels_from(line));
    }
    return out;
}

}  // namespace sg::cross
