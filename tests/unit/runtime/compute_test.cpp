#include "runtime/compute.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "runtime/gpu/device.hpp"
#include "runtime/gpu/image.hpp"

namespace sg::runtime {
namespace {

std::vector<std::uint32_t> words_of(const std::string& name) {
    std::ifstream file(std::string(SG_SHADER_DIR "/") + name + ".spv", std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), words.size() * 4);
    return words;
}

// Runs sums.comp over `count` pairs and compares bit for bit with the processor.
void expect_sums(gpu::Device& device, std::size_t count) {
    Diags diags;
    auto compute = Compute::create(device, words_of("sums.comp"), diags);
    ASSERT_TRUE(compute) << render(diags);
    std::vector<float> inputs(2 * count), outputs(3 * count, -1.0f);
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = static_cast<float>(i % 1013) * 0.37f - 100.0f;
    ASSERT_TRUE(compute->run(inputs, 2, outputs, 3, count, diags)) << render(diags);
    for (std::size_t i = 0; i < count; ++i) {
        float a = inputs[2 * i], b = inputs[2 * i + 1];
        ASSERT_EQ(outputs[3 * i], a + b) << i;
        ASSERT_EQ(outputs[3 * i + 1], a - b) << i;
        ASSERT_EQ(outputs[3 * i + 2], a * b) << i;
    }
}

TEST(Compute, EvaluatesEveryElementOnce) {
    Diags diags;
    auto device = gpu::Device::create({}, diags);
    ASSERT_TRUE(device) << render(diags);
    for (std::size_t count : {0u, 1u, 63u, 64u, 65u, 100000u}) expect_sums(*device, count);
}

TEST(Compute, SplitsWhatIsTooLargeForOneDispatch) {
    Diags diags;
    auto device = gpu::Device::create({}, diags);
    ASSERT_TRUE(device) << render(diags);
    expect_sums(*device, std::size_t{device->limits().maxComputeWorkGroupCount[0]} * 64 + 77);
}

TEST(Compute, IsCleanUnderTheValidationLayers) {
    Diags diags;
    auto device = gpu::Device::create({.name = "", .validate = true}, diags);
    ASSERT_TRUE(device) << render(diags);
    auto log = device->log();
    expect_sums(*device, 200);
    { gpu::Device gone = std::move(*device); }
    EXPECT_TRUE(log->report(diags)) << render(diags);
}

TEST(Device, TheValidationLayersAreHeard) {
    Diags diags;
    auto device = gpu::Device::create({.name = "", .validate = true}, diags);
    ASSERT_TRUE(device) << render(diags);
    auto info = gpu::make_info<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = 4;  // and no usage, which Vulkan forbids
    VkBuffer buffer = VK_NULL_HANDLE;
    vkCreateBuffer(device->get(), &info, nullptr, &buffer);
    gpu::OwnedBuffer owned(device->get(), buffer);
    EXPECT_FALSE(device->log()->report(diags));
    EXPECT_NE(render(diags).find("VUID-VkBufferCreateInfo-usage"), std::string::npos) << render(diags);
    std::string whole;
    for (const std::string& said : device->log()->messages()) {
        whole += "error: the Vulkan validation layers say: " + said + " [SG2204]\n";
    }
    EXPECT_EQ(render(diags), whole);
    EXPECT_EQ(diags.exit_code(), 4);
}

TEST(Device, WhatItCannotHoldIsRefused) {
    Diags diags;
    auto device = gpu::Device::create({}, diags);
    ASSERT_TRUE(device) << render(diags);
    const std::uint32_t limit = device->limits().maxImageDimension2D;
    const std::string most = std::to_string(limit), beyond = std::to_string(limit + 1);
    EXPECT_FALSE(gpu::Image::create_attachment(*device, VK_FORMAT_R8G8B8A8_UNORM, {limit + 1, 1},
                                               VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, VK_IMAGE_ASPECT_COLOR_BIT,
                                               diags));
    EXPECT_EQ(render(diags), "error: an image of " + beyond + "x1 is beyond the limit of device '" +
                                 device->name() + "', " + most + "x" + most + " [SG2203]\n");
    EXPECT_EQ(diags.exit_code(), 4);
}

TEST(Device, ACallThatFailsIsNamedWithItsResult) {
    Diags diags;
    auto device = gpu::Device::create({}, diags);
    ASSERT_TRUE(device) << render(diags);
    VkMemoryRequirements needs{};
    needs.size = VkDeviceSize{1} << 50;  // beyond any heap and any address space of 47 bits
    needs.alignment = 1;
    needs.memoryTypeBits = ~0u;
    EXPECT_FALSE(device->allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT, diags));
    EXPECT_EQ(render(diags),
              "error: vkAllocateMemory of 1125899906842624 bytes failed with VK_ERROR_OUT_OF_DEVICE_MEMORY "
              "[SG2203]\n");
    EXPECT_EQ(diags.exit_code(), 4);
}

TEST(Device, OneThatDoesNotExistIsRefusedWithTheReasons) {
    Diags diags;
    auto all = gpu::list_devices(diags);
    ASSERT_TRUE(all && !all->empty());
    EXPECT_FALSE(gpu::Device::create({.name = "no such\ndevice"}, diags));
    std::string whole = "error: no usable device has 'no such\\x0adevice' in its name [SG2202]\n";
    for (const gpu::DeviceDescription& device : *all) {
        const std::string why =
            device.refused.empty() ? "its name does not contain 'no such\\x0adevice'" : device.refused;
        whole += "note: '" + device.name + "' was refused: " + why + "\n";
    }
    EXPECT_EQ(render(diags), whole);
    EXPECT_EQ(diags.exit_code(), 4);
}

}  // namespace
}  // namespace sg::runtime
