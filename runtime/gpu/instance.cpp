#include "runtime/gpu/instance.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "runtime/gpu/check.hpp"
#include "runtime/gpu/handle.hpp"

namespace sg::runtime::gpu {
namespace {

constexpr const char* kLayer = "VK_LAYER_KHRONOS_validation";

#ifdef __SANITIZE_ADDRESS__
// A driver that is unloaded leaves blocks which the leak checker can no longer trace to it: keep it loaded.
void pin_drivers() {
    for (const char* library : {"libvulkan_lvp.so", "libVkLayer_khronos_validation.so"}) {
        dlopen(library, RTLD_NOW | RTLD_NODELETE);
    }
}
#else
void pin_drivers() {}
#endif

bool layer_is_installed() {
    std::uint32_t count = 0;
    if (vkEnumerateInstanceLayerProperties(&count, nullptr) != VK_SUCCESS) return false;
    std::vector<VkLayerProperties> layers(count);
    if (vkEnumerateInstanceLayerProperties(&count, layers.data()) < 0) return false;
    return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, kLayer) == 0;
    });
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    static_cast<ValidationLog*>(user)->add(data->pMessage);
    return VK_FALSE;
}

// Only what the layers say about our calls; the loader's own remarks on foreign drivers are "general".
VkDebugUtilsMessengerCreateInfoEXT messenger_info(ValidationLog* log) {
    auto info = make_info<VkDebugUtilsMessengerCreateInfoEXT>(
        VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = log;
    return info;
}

VkResult create_instance(ValidationLog* log, VkInstance* out) {
    auto application = make_info<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "surfgrad-render";
    application.apiVersion = VK_API_VERSION_1_1;
    auto info = make_info<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    if (log == nullptr) return vkCreateInstance(&info, nullptr, out);

    constexpr std::array kFeatures = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    constexpr std::array kExtensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME,
                                        VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(log);
    auto features = make_info<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
    features.pNext = &messenger;
    features.enabledValidationFeatureCount = kFeatures.size();
    features.pEnabledValidationFeatures = kFeatures.data();
    info.pNext = &features;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kLayer;
    info.enabledExtensionCount = kExtensions.size();
    info.ppEnabledExtensionNames = kExtensions.data();
    return vkCreateInstance(&info, nullptr, out);
}

}  // namespace
}  // namespace sg::runtime::gpu

#ifdef __SANITIZE_ADDRESS__
// The validation layer itself leaks a little per device, and says so to nobody else.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation.so\n";
}
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}
#endif

namespace sg::runtime::gpu {

void ValidationLog::add(std::string message) {
    std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

std::vector<std::string> ValidationLog::messages() const {
    std::lock_guard lock(mutex_);
    return messages_;
}

bool ValidationLog::report(Diags& diags) const {
    std::vector<std::string> said = messages();
    for (const std::string& message : said) {
        diags.error(Code::validation_failed, fmt::format("the Vulkan validation layers say: {}", message));
    }
    return said.empty();
}

Instance::Instance(Instance&& other) noexcept
    : instance_(std::exchange(other.instance_, VkInstance{VK_NULL_HANDLE})),
      messenger_(std::exchange(other.messenger_, VkDebugUtilsMessengerEXT{VK_NULL_HANDLE})),
      log_(std::move(other.log_)) {}

Instance::~Instance() {
    if (messenger_ != VK_NULL_HANDLE) {
        auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        if (destroy != nullptr) destroy(instance_, messenger_, nullptr);
    }
    if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

bool Instance::create_messenger(Diags& diags) {
    auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
    if (create == nullptr)
        return check(VK_ERROR_EXTENSION_NOT_PRESENT, "vkCreateDebugUtilsMessengerEXT", diags);
    VkDebugUtilsMessengerCreateInfoEXT info = messenger_info(log_.get());
    return check(create(instance_, &info, nullptr, &messenger_), "vkCreateDebugUtilsMessengerEXT", diags);
}

std::optional<Instance> Instance::create(bool validate, Diags& diags) {
    pin_drivers();
    if (validate && !layer_is_installed()) {
        diags.error(Code::layer_missing, fmt::format("the validation layer '{}' is not installed", kLayer));
        return std::nullopt;
    }
    Instance made;
    if (validate) made.log_ = std::make_shared<ValidationLog>();
    VkResult result = create_instance(made.log_.get(), &made.instance_);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER || result == VK_ERROR_INITIALIZATION_FAILED) {
        diags.error(Code::vulkan_missing, fmt::format("no Vulkan driver answers ({})", result_name(result)));
        return std::nullopt;
    }
    if (!check(result, "vkCreateInstance", diags)) return std::nullopt;
    if (validate && !made.create_messenger(diags)) return std::nullopt;
    return made;
}

}  // namespace sg::runtime::gpu
