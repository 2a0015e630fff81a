// The Vulkan instance, with the validation layers where they are asked for.
#pragma once

#include <vulkan/vulkan.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"

namespace sg::runtime::gpu {

// What the validation layers said. Outlives the instance, so that messages about its destruction are kept
// too.
class ValidationLog {
public:
    void add(std::string message);  // thread-safe: the layers may call from any thread
    [[nodiscard]] std::vector<std::string> messages() const;
    // True if nothing was said; otherwise adds one validation_failed per message.
    bool report(Diags& diags) const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
};

class Instance {
public:
    // Vulkan 1.1. `validate` loads the Khronos validation layer with synchronisation validation; its warnings
    // and errors go to log(). Fails with vulkan_missing, layer_missing or vulkan_failed.
    static std::optional<Instance> create(bool validate, Diags& diags);

    Instance(Instance&& other) noexcept;
    Instance& operator=(Instance&&) = delete;
    ~Instance();

    [[nodiscard]] VkInstance get() const { return instance_; }
    // Null without validation.
    [[nodiscard]] const std::shared_ptr<ValidationLog>& log() const { return log_; }

private:
    Instance() = default;
    bool create_messenger(Diags& diags);

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::shared_ptr<ValidationLog> log_;
};

}  // namespace sg::runtime::gpu
