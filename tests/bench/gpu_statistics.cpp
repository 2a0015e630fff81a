#include "gpu_statistics.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "gpu_device.hpp"

namespace sg::bench {
namespace {

// Everything here lives until the process ends, which follows at once.
VkInstance make_instance() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    return vkCreateInstance(&info, nullptr, &instance) == VK_SUCCESS ? instance : VK_NULL_HANDLE;
}

VkPhysicalDevice physical_device() {
    static const VkInstance instance = make_instance();
    std::uint32_t count = 1;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    if (instance != VK_NULL_HANDLE) vkEnumeratePhysicalDevices(instance, &count, &physical);
    return physical;
}

VkDevice make_device() {
    const VkPhysicalDevice physical = physical_device();
    if (physical == VK_NULL_HANDLE) return VK_NULL_HANDLE;
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{};
    executables.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    executables.pipelineExecutableInfo = VK_TRUE;
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &executables;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    VkDevice device = VK_NULL_HANDLE;
    return vkCreateDevice(physical, &info, nullptr, &device) == VK_SUCCESS ? device : VK_NULL_HANDLE;
}

VkPipelineLayout make_layout(VkDevice device) {
    constexpr std::array kKinds = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                   VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
                                   VK_DESCRIPTOR_TYPE_SAMPLER};
    std::array<VkDescriptorSetLayoutBinding, kKinds.size()> bindings{};
    for (std::uint32_t i = 0; i < bindings.size(); ++i) {
        bindings[i] = {i, kKinds[i], 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    }
    VkDescriptorSetLayoutCreateInfo set{};
    set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set.pBindings = bindings.data();
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    vkCreateDescriptorSetLayout(device, &set, nullptr, &set_layout);
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_layout;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    vkCreatePipelineLayout(device, &info, nullptr, &layout);
    return layout;
}

VkPipeline make_pipeline(VkDevice device, std::span<const std::uint32_t> words) {
    VkShaderModuleCreateInfo code{};
    code.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    code.codeSize = words.size_bytes();
    code.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    vkCreateShaderModule(device, &code, nullptr, &module);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = make_layout(device);
    VkPipeline pipeline = VK_NULL_HANDLE;
    vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    return pipeline;
}

std::vector<VkPipelineExecutableStatisticKHR> statistics_of(VkDevice device, VkPipeline pipeline,
                                                            std::uint32_t executable) {
    auto get = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
        vkGetDeviceProcAddr(device, "vkGetPipelineExecutableStatisticsKHR"));
    VkPipelineExecutableInfoKHR which{};
    which.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
    which.pipeline = pipeline;
    which.executableIndex = executable;
    std::uint32_t count = 0;
    get(device, &which, &count, nullptr);
    VkPipelineExecutableStatisticKHR blank{};
    blank.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
    std::vector<VkPipelineExecutableStatisticKHR> out(count, blank);
    get(device, &which, &count, out.data());
    return out;
}

// Which of the pipeline's programs belongs to the stage.
std::optional<std::uint32_t> executable_of(VkDevice device, VkPipeline pipeline,
                                           VkShaderStageFlagBits stage) {
    auto get = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
        vkGetDeviceProcAddr(device, "vkGetPipelineExecutablePropertiesKHR"));
    VkPipelineInfoKHR which{};
    which.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR;
    which.pipeline = pipeline;
    std::uint32_t count = 0;
    get(device, &which, &count, nullptr);
    VkPipelineExecutablePropertiesKHR blank{};
    blank.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
    std::vector<VkPipelineExecutablePropertiesKHR> all(count, blank);
    get(device, &which, &count, all.data());
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((all[i].stages & stage) != 0) return i;
    }
    return std::nullopt;
}

}  // namespace

VkDevice gpu_device() {
    static const VkDevice device = make_device();
    return device;
}

std::string gpu_driver_version() {
    const VkPhysicalDevice physical = physical_device();
    if (physical == VK_NULL_HANDLE) return "";
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(physical, &properties);
    const std::uint32_t version = properties.driverVersion;
    return std::to_string(VK_VERSION_MAJOR(version)) + "." + std::to_string(VK_VERSION_MINOR(version)) + "." +
           std::to_string(VK_VERSION_PATCH(version));
}

std::optional<GpuStatistics> pipeline_statistics(VkDevice device, VkPipeline pipeline,
                                                 VkShaderStageFlagBits stage) {
    const auto executable = executable_of(device, pipeline, stage);
    if (!executable) return std::nullopt;
    GpuStatistics out;
    for (const auto& statistic : statistics_of(device, pipeline, *executable)) {
        const std::string_view name = statistic.name;
        if (name == "Instructions") out.instructions = statistic.value.u64;
        if (name == "Inverse Throughput") out.inverse_throughput = statistic.value.u64;
        if (name == "VGPRs") out.vector_registers = statistic.value.u64;
        if (name == "Subgroups per SIMD") out.waves = statistic.value.u64;
    }
    return out;
}

std::optional<GpuStatistics> gpu_statistics(std::span<const std::uint32_t> words) {
    const VkDevice device = gpu_device();
    if (device == VK_NULL_HANDLE) return std::nullopt;
    const VkPipeline pipeline = make_pipeline(device, words);
    if (pipeline == VK_NULL_HANDLE) return std::nullopt;
    return pipeline_statistics(device, pipeline, VK_SHADER_STAGE_COMPUTE_BIT);
}

}  // namespace sg::bench
