#include "tests/cross/metal.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>

#include "tests/cross/metal_source.hpp"
#include "tests/cross/process.hpp"
#include "tests/cross/raster.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

// Metal's literals without a suffix are floats.
Outcome run_clang(const std::string& source, const std::string& options) {
    auto file = scratch() / "texts.cpp";
    write_file(file, source);
    return run(
        fmt::format("clang++ -std=c++17 -w -Xclang -cl-single-precision-constant -ffp-contract=off "
                    "-ferror-limit=0 -I '{}' {} '{}' 2>&1",
                    (test::source_dir() / "tests/cross/metal").string(), options, file.string()));
}

// Texts by content, in the order of their first appearance: many targets and samples share them.
class Texts {
public:
    std::size_t add(const std::string& text) {
        auto [at, fresh] = numbers_.try_emplace(text, list.size());
        if (fresh) list.push_back(text);
        return at->second;
    }
    std::vector<std::string> list;

private:
    std::map<std::string, std::size_t> numbers_;
};

struct Plan {
    std::size_t vertex = 0, fragment = 0;
};

// What the manifest says is bound where, for one stage. `texels` keeps the textures' bytes alive.
SgBindings bind(const Drawing& drawing, const Stage& stage, std::vector<std::vector<float>>& texels) {
    SgBindings out{};
    for (const Slot& slot : stage.slots) {
        if (slot.kind == "uniform_buffer") out.buffers[slot.index] = drawing.blocks[slot.set].data();
        if (slot.kind == "texture") {
            const TextureView& view = drawing.textures.at(slot.binding);
            texels.push_back(linear_texels(view));
            out.textures[slot.index] = {texels.back().data(), static_cast<int>(view.chain->front().width),
                                        static_cast<int>(view.chain->front().height)};
        }
        if (slot.kind == "sampler") {
            const auto& state = drawing.samplers.at(slot.binding);
            out.samplers[slot.index] = {static_cast<int>(state.wrap_s), static_cast<int>(state.wrap_t),
                                        state.linear ? 1 : 0};
        }
    }
    return out;
}

std::vector<RasterVertex> run_vertices(const Drawing& drawing, const SgBindings& bindings,
                                       SgVertexFunction function) {
    std::vector<RasterVertex> out(drawing.attributes[0].values.size() / drawing.attributes[0].components);
    for (std::size_t i = 0; i < out.size(); ++i) {
        SgNumbers attributes{};
        for (const Attribute& a : drawing.attributes)
            std::memcpy(attributes[a.location], &a.values[i * a.components], a.components * sizeof(float));
        function(bindings, attributes, out[i].varyings, out[i].position);
    }
    return out;
}

std::string library_of(const std::string& source) {
    static int made = 0;
    const std::string file = (scratch() / fmt::format("texts{}.so", made++)).string();
    Outcome compiled = run_clang(source, fmt::format("-O1 -shared -fPIC -o '{}'", file));
    if (compiled.exit_code != 0) throw std::runtime_error("clang: " + compiled.text.substr(0, 2000));
    return file;
}

template <typename Function>
Function function_of(void* library, std::size_t text) {
    void* found = ::dlsym(library, fmt::format("sg_call_{}", text).c_str());
    if (!found) throw std::runtime_error(fmt::format("no function for text {}", text));
    return reinterpret_cast<Function>(found);
}

// All that decides what is drawn: the texts of two versions of Metal are often the same.
std::string key_of(const Drawing& drawing) {
    std::string out = fmt::format("{} {}\n", drawing.sample->name, drawing.shown->name);
    for (const Stage* stage : {&drawing.vertex, &drawing.fragment}) {
        for (const Slot& slot : stage->slots)
            out += fmt::format("{} {} {} {}\n", slot.kind, slot.set, slot.binding, slot.index);
        out += stage->text;
    }
    return out;
}

MetalPicture draw_one(const Drawing& drawing, SgVertexFunction vertex, SgFragmentFunction fragment) {
    std::vector<std::vector<float>> texels;
    const SgBindings vertex_bindings = bind(drawing, drawing.vertex, texels);
    const SgBindings fragment_bindings = bind(drawing, drawing.fragment, texels);
    return rasterise(run_vertices(drawing, vertex_bindings, vertex), drawing, fragment_bindings, fragment);
}

}  // namespace

std::string metal_missing() {
    return has_program("clang++") ? "" : "no clang++";
}

std::vector<MetalPicture> metal_draw(const std::vector<Drawing>& drawings) {
    static std::map<std::string, MetalPicture> pictures;
    Texts texts;
    std::vector<const Drawing*> fresh;
    std::vector<Plan> plans;
    for (const Drawing& drawing : drawings) {
        if (pictures.contains(key_of(drawing))) continue;
        fresh.push_back(&drawing);
        plans.push_back({texts.add(drawing.vertex.text), texts.add(drawing.fragment.text)});
    }
    if (!fresh.empty()) {
        void* library = ::dlopen(library_of(metal_source(texts.list, true)).c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!library) throw std::runtime_error(::dlerror());
        for (std::size_t i = 0; i < fresh.size(); ++i)
            pictures[key_of(*fresh[i])] =
                draw_one(*fresh[i], function_of<SgVertexFunction>(library, plans[i].vertex),
                         function_of<SgFragmentFunction>(library, plans[i].fragment));
        ::dlclose(library);
    }
    std::vector<MetalPicture> out;
    for (const Drawing& drawing : drawings) out.push_back(pictures.at(key_of(drawing)));
    return out;
}

std::vector<std::string> metal_refusals(const std::vector<std::string>& all) {
    Texts texts;
    std::vector<std::size_t> numbers;
    for (const std::string& text : all) numbers.push_back(texts.add(text));
    Outcome outcome = run_clang(metal_source(texts.list, false), "-fsyntax-only");
    std::vector<std::string> out;
    for (std::size_t number : numbers) {
        std::size_t at = outcome.text.find(fmt::format("text{}.metal:", number));
        out.push_back(at == outcome.text.npos ? ""
                                              : outcome.text.substr(at, outcome.text.find('\n', at) - at));
    }
    bool blamed = std::any_of(out.begin(), out.end(), [](const std::string& s) { return !s.empty(); });
    if (outcome.exit_code != 0 && !blamed) throw std::runtime_error("clang: " + outcome.text.substr(0, 2000));
    return out;
}

}  // namespace sg::cross
