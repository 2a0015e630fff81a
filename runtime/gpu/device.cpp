#include "runtime/gpu/device.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "runtime/gpu/check.hpp"

namespace sg::runtime::gpu {
namespace {

struct Candidate {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties{};
    std::optional<std::uint32_t> family;  // a queue family that draws and computes
    std::string refused;
};

std::string_view kind_name(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        default:
            return "other";
    }
}

// Smaller is preferred.
int preference(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 3;
        default:
            return 4;
    }
}

std::optional<std::uint32_t> find_family(VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    constexpr VkQueueFlags kNeeded = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & kNeeded) == kNeeded) return i;
    }
    return std::nullopt;
}

Candidate examine(VkPhysicalDevice physical) {
    Candidate candidate{physical, {}, find_family(physical), ""};
    vkGetPhysicalDeviceProperties(physical, &candidate.properties);
    std::uint32_t version = candidate.properties.apiVersion;
    if (version < VK_API_VERSION_1_1) {
        candidate.refused = fmt::format("it has Vulkan {}.{}, 1.1 is needed", VK_API_VERSION_MAJOR(version),
                                        VK_API_VERSION_MINOR(version));
    } else if (!candidate.family) {
        candidate.refused = "it has no queue that draws and computes";
    }
    return candidate;
}

std::optional<std::vector<Candidate>> candidates(const Instance& instance, Diags& diags) {
    std::uint32_t count = 0;
    VkResult result = vkEnumeratePhysicalDevices(instance.get(), &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    if (result == VK_SUCCESS) result = vkEnumeratePhysicalDevices(instance.get(), &count, devices.data());
    if (result == VK_ERROR_INITIALIZATION_FAILED || (result == VK_SUCCESS && count == 0)) {
        diags.error(Code::vulkan_missing, "no Vulkan driver offers a device");
        return std::nullopt;
    }
    if (!check(result, "vkEnumeratePhysicalDevices", diags)) return std::nullopt;
    std::vector<Candidate> out;
    for (VkPhysicalDevice device : devices) out.push_back(examine(device));
    return out;
}

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

// Marks the candidates that the request excludes and gives the best of the rest, or none.
const Candidate* choose(std::vector<Candidate>& all, const DeviceRequest& request) {
    const Candidate* best = nullptr;
    for (Candidate& candidate : all) {
        if (candidate.refused.empty() &&
            lower(candidate.properties.deviceName).find(lower(request.name)) == std::string::npos) {
            candidate.refused = fmt::format("its name does not contain '{}'", printable(request.name));
        }
        if (!candidate.refused.empty()) continue;
        if (best == nullptr ||
            preference(candidate.properties.deviceType) < preference(best->properties.deviceType)) {
            best = &candidate;
        }
    }
    return best;
}

void report_none(const std::vector<Candidate>& all, const DeviceRequest& request, Diags& diags) {
    std::vector<Note> notes;
    for (const Candidate& candidate : all) {
        notes.push_back(
            {fmt::format("'{}' was refused: {}", candidate.properties.deviceName, candidate.refused), {}});
    }
    std::string message = request.name.empty()
                              ? "no device can be used"
                              : fmt::format("no usable device has '{}' in its name", printable(request.name));
    diags.error(Code::device_missing, Place{}, std::move(message), std::move(notes));
}

}  // namespace

std::optional<std::vector<DeviceDescription>> list_devices(Diags& diags) {
    auto instance = Instance::create(false, diags);
    if (!instance) return std::nullopt;
    auto all = candidates(*instance, diags);
    if (!all) return std::nullopt;
    std::vector<DeviceDescription> out;
    for (const Candidate& candidate : *all) {
        out.push_back({candidate.properties.deviceName,
                       std::string(kind_name(candidate.properties.deviceType)), candidate.refused});
    }
    return out;
}

Device::Device(Device&& other) noexcept
    : instance_(std::move(other.instance_)),
      physical_(other.physical_),
      properties_(other.properties_),
      memory_(other.memory_),
      device_(std::exchange(other.device_, VkDevice{VK_NULL_HANDLE})),
      queue_(other.queue_),
      pool_(std::move(other.pool_)),
      has_anisotropy_(other.has_anisotropy_) {}

Device::~Device() {
    pool_ = {};
    if (device_ != VK_NULL_HANDLE) vkDestroyDevice(device_, nullptr);
}

bool Device::open(std::uint32_t family, Diags& diags) {
    VkPhysicalDeviceFeatures available{};
    vkGetPhysicalDeviceFeatures(physical_, &available);
    vkGetPhysicalDeviceProperties(physical_, &properties_);
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
    has_anisotropy_ = available.samplerAnisotropy == VK_TRUE;
    VkPhysicalDeviceFeatures wanted{};
    wanted.samplerAnisotropy = available.samplerAnisotropy;
    const float priority = 1.0f;
    auto queue = make_info<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    auto info = make_info<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.pEnabledFeatures = &wanted;
    if (!check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice", diags)) return false;
    vkGetDeviceQueue(device_, family, 0, &queue_);

    auto pool = make_info<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = family;
    VkCommandPool handle = VK_NULL_HANDLE;
    if (!check(vkCreateCommandPool(device_, &pool, nullptr, &handle), "vkCreateCommandPool", diags))
        return false;
    pool_ = {device_, handle};
    return true;
}

std::optional<Device> Device::create(const DeviceRequest& request, Diags& diags) {
    auto instance = Instance::create(request.validate, diags);
    if (!instance) return std::nullopt;
    auto all = candidates(*instance, diags);
    if (!all) return std::nullopt;
    const Candidate* chosen = choose(*all, request);
    if (chosen == nullptr) {
        report_none(*all, request, diags);
        return std::nullopt;
    }
    Device device(std::move(*instance));
    device.physical_ = chosen->physical;
    if (!device.open(*chosen->family, diags)) return std::nullopt;
    return device;
}

std::optional<OwnedMemory> Device::allocate(const VkMemoryRequirements& needs,
                                            VkMemoryPropertyFlags properties, Diags& diags) const {
    for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
        bool fits = (needs.memoryTypeBits >> i & 1u) != 0;
        if (!fits || (memory_.memoryTypes[i].propertyFlags & properties) != properties) continue;
        auto info = make_info<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
        info.allocationSize = needs.size;
        info.memoryTypeIndex = i;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        std::string call = fmt::format("vkAllocateMemory of {} bytes", needs.size);
        if (!check(vkAllocateMemory(device_, &info, nullptr, &memory), call, diags)) return std::nullopt;
        return OwnedMemory(device_, memory);
    }
    check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "finding a memory type", diags);
    return std::nullopt;
}

bool Device::submit(const std::function<void(VkCommandBuffer)>& record, Diags& diags) const {
    auto allocation = make_info<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    allocation.commandPool = pool_.get();
    allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocation.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    if (!check(vkAllocateCommandBuffers(device_, &allocation, &commands), "vkAllocateCommandBuffers", diags))
        return false;
    auto begin = make_info<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    auto fence_info = make_info<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    VkFence fence_handle = VK_NULL_HANDLE;
    bool ok = check(vkCreateFence(device_, &fence_info, nullptr, &fence_handle), "vkCreateFence", diags);
    OwnedFence fence(device_, fence_handle);
    ok = ok && check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer", diags);
    if (ok) {
        record(commands);
        ok = check(vkEndCommandBuffer(commands), "vkEndCommandBuffer", diags);
    }
    auto info = make_info<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands;
    ok = ok && check(vkQueueSubmit(queue_, 1, &info, fence.get()), "vkQueueSubmit", diags);
    constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();
    ok = ok && check(vkWaitForFences(device_, 1, &fence_handle, VK_TRUE, kForever), "vkWaitForFences", diags);
    vkFreeCommandBuffers(device_, pool_.get(), 1, &commands);
    return ok;
}

}  // namespace sg::runtime::gpu
