// A device to draw and compute on: its choice, its one queue, its memory, and commands that run to their end.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "runtime/gpu/handle.hpp"
#include "runtime/gpu/instance.hpp"

namespace sg::runtime::gpu {

struct DeviceRequest {
    std::string
        name;  // part of the device's name, any case; "" takes a GPU if there is one, else a CPU device
    bool validate = false;
};

struct DeviceDescription {
    std::string name;
    std::string kind;     // "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string refused;  // why it cannot be used, "" if it can
};
// In the driver's order. Fails with vulkan_missing.
std::optional<std::vector<DeviceDescription>> list_devices(Diags& diags);

class Device {
public:
    // Fails with vulkan_missing, device_missing (with a note per device that says why it was refused),
    // layer_missing or vulkan_failed.
    static std::optional<Device> create(const DeviceRequest& request, Diags& diags);

    Device(Device&& other) noexcept;
    Device& operator=(Device&&) = delete;
    ~Device();

    [[nodiscard]] VkDevice get() const { return device_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
    [[nodiscard]] std::string name() const { return properties_.deviceName; }
    [[nodiscard]] bool has_anisotropy() const { return has_anisotropy_; }
    // What the validation layers said so far; null without validation. Keep the pointer beyond the device's
    // life to see what they say about its destruction.
    [[nodiscard]] std::shared_ptr<const ValidationLog> log() const { return instance_.log(); }

    // Allocates memory of the wanted properties for a resource.
    std::optional<OwnedMemory> allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties,
                                        Diags& diags) const;
    // Records commands through `record`, submits them and waits until they are done. Not thread-safe.
    bool submit(const std::function<void(VkCommandBuffer)>& record, Diags& diags) const;

private:
    explicit Device(Instance instance) : instance_(std::move(instance)) {}
    bool open(std::uint32_t family, Diags& diags);

    Instance instance_;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    OwnedCommandPool pool_;
    bool has_anisotropy_ = false;
};

}  // namespace sg::runtime::gpu
