#include "tests/cross/webgl.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace sg::cross {
namespace {

using Json = nlohmann::json;

// ANGLE on Mesa's llvmpipe, the driver that draws the reference.
constexpr const char* kFlags = "--use-gl=angle --use-angle=gl-egl --ignore-gpu-blocklist";

Json level_json(const asset::Image& image) {
    const bool is_float = image.format != asset::TexelFormat::unorm8;
    return {{"width", image.width},
            {"height", image.height},
            {"float", is_float},
            {"bytes", is_float ? base64(texels_of(image)) : base64(image.bytes)}};
}

Json sampler_json(const runtime::gpu::SamplerState& state) {
    constexpr const char* kWraps[] = {"REPEAT", "MIRRORED_REPEAT", "CLAMP_TO_EDGE"};
    std::string within = state.linear ? "LINEAR" : "NEAREST";
    using enum runtime::gpu::MipFilter;
    std::string between = state.mip_filter == none     ? ""
                          : state.mip_filter == linear ? "_MIPMAP_LINEAR"
                                                       : "_MIPMAP_NEAREST";
    return {{"TEXTURE_WRAP_S", kWraps[static_cast<std::size_t>(state.wrap_s)]},
            {"TEXTURE_WRAP_T", kWraps[static_cast<std::size_t>(state.wrap_t)]},
            {"TEXTURE_MAG_FILTER", within},
            {"TEXTURE_MIN_FILTER", within + between}};
}

// `textures` grows by what no drawing had before.
Json drawing_json(const Drawing& drawing, Json& textures) {
    Json out = {{"vertex", drawing.vertex.text},
                {"fragment", drawing.fragment.text},
                {"indices", base64(drawing.indices)},
                {"cull", drawing.cull_back},
                {"attachments", drawing.attachments}};
    for (const Attribute& a : drawing.attributes) {
        out["attributes"].push_back(
            {{"location", a.location}, {"components", a.components}, {"values", base64(a.values)}});
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

}  // namespace

std::string webgl_missing() {
    static const std::string kMissing = [] {
        if (browser().empty()) return std::string("no chromium-headless-shell and no chromium");
        std::string body = body_of(
            "document.body.textContent = !!document.createElement('canvas').getContext('webgl2')", kFlags);
        return body == "true" ? "" : browser() + " has no WebGL 2 here";
    }();
    return kMissing;
}

PageOutcome webgl_draw(const std::vector<Drawing>& drawings) {
    PageOutcome out;
    for (std::span<const Drawing> page : pages_of(drawings)) {
        Json input = {{"side", kSide}, {"textures", Json::object()}, {"drawings", Json::array()}};
        for (const Drawing& drawing : page)
            input["drawings"].push_back(drawing_json(drawing, input["textures"]));
        out.add(run_page(input.dump(), {"bytes.js", "webgl.js"}, kFlags, page.size(), 0));
    }
    return out;
}

}  // namespace sg::cross
