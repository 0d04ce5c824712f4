// Commands of one object: recorded, submitted and waited for, with a timestamp after each pass.
#pragma once

#include <functional>
#include <vector>

#include "runtime/gpu/vulkan/vulkan_pass.h"

namespace warplut {

class VulkanCommands {
 public:
  VulkanCommands(const VulkanDevice& device, int most_timestamps);
  ~VulkanCommands();
  VulkanCommands(const VulkanCommands&) = delete;
  VulkanCommands& operator=(const VulkanCommands&) = delete;

  // Records what `record` does, submits it and waits for its end. A GpuError if the device fails.
  void Run(const std::function<void(VkCommandBuffer)>& record);

  // Writes the next timestamp of this Run.
  void Timestamp(VkCommandBuffer commands);
  // Milliseconds between the timestamps of the last Run; empty where the device has none.
  std::vector<double> Intervals() const;

 private:
  void Destroy();

  const VulkanDevice& device_;
  std::uint32_t most_timestamps_, timestamps_ = 0;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  VkQueryPool queries_ = VK_NULL_HANDLE;
};

// From layout UNDEFINED to GENERAL, in which images are between the calls below.
void PrepareImage(VkCommandBuffer commands, const VulkanImage& image);
// The first width x height texels, which shaders can read afterwards. In the buffer rows of `width`
// follow each other.
void CopyToImage(VkCommandBuffer commands, const VulkanBuffer& from, const VulkanImage& to,
                 int width, int height);
// Every word of the buffer becomes `value`, which shaders can read then.
void FillBuffer(VkCommandBuffer commands, const VulkanBuffer& buffer, std::uint32_t value);
// Results that shaders stored. The processor can read the buffer when the commands ended.
void CopyToBuffer(VkCommandBuffer commands, const VulkanImage& from, const VulkanBuffer& to);

}  // namespace warplut
