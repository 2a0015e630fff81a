// Draws an artefact from its manifest alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/diag.hpp"
#include "runtime/artefact.hpp"
#include "runtime/picture.hpp"
#include "runtime/scene.hpp"
#include "runtime/textures.hpp"
#include "runtime/views.hpp"

namespace sg::runtime {

namespace gpu {
class Device;
}

struct RenderOptions {
    std::uint32_t width = 512;  // pixels, at least 1
    std::uint32_t height = 512;
    std::uint32_t supersample = 1;      // draws so many times larger and shrinks
    double time = 0;                    // seconds
    std::vector<std::byte> parameters;  // from pack_parameters
    // Draws with a viewport of negative height, as engines do whose y grows upward; the same matrices, so
    // that the picture is upside down.
    bool negative_viewport = false;
};

// One entry point with everything that it binds, on the device; draws any number of its views. Everything
// that is handed in must outlive it. Not thread-safe.
class Renderer {
public:
    // Fails with mesh_attribute, or vulkan_failed. The artefact must have the entry point.
    static std::optional<Renderer> create(gpu::Device& device, const Artefact& artefact,
                                          const TextureSet& textures, const Scene& scene,
                                          const RenderOptions& options, std::string_view entry, Diags& diags);
    Renderer(Renderer&&) noexcept;
    ~Renderer();

    std::optional<Picture> draw(const DebugView& view, Diags& diags);

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// One view in one call.
std::optional<Picture> render(gpu::Device& device, const Artefact& artefact, const TextureSet& textures,
                              const Scene& scene, const View& view, const RenderOptions& options,
                              Diags& diags);

}  // namespace sg::runtime
