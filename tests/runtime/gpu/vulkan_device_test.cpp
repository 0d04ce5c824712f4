#include "runtime/gpu/vulkan/vulkan_device.h"

#include <gtest/gtest.h>

namespace warplut {
namespace {

TEST(VulkanDevice, FailuresAreOneSentence) {
  const auto sentence = [](VkResult result) -> std::string {
    try {
      CheckVulkan(result, "to run a frame");
    } catch (const GpuError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(sentence(VK_SUCCESS), "");
  EXPECT_EQ(sentence(VK_ERROR_DEVICE_LOST), "the GPU failed to run a frame: the device was lost");
  EXPECT_EQ(sentence(VK_ERROR_OUT_OF_DEVICE_MEMORY),
            "the GPU failed to run a frame: there is not enough memory");
}

}  // namespace
}  // namespace warplut
