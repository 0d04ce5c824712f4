// Images and buffers of one object, in a block of memory for each kind: images, buffers that only
// shaders see, buffers that the processor sees.
#pragma once

#include <cstddef>
#include <vector>

#include "runtime/gpu/gpu_workspace.h"
#include "runtime/gpu/vulkan/vulkan_device.h"

namespace warplut {

struct VulkanImage {
  ImagePlan plan;
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
};

struct VulkanBuffer {
  BufferPlan plan;
  VkBuffer buffer = VK_NULL_HANDLE;
  std::byte* bytes = nullptr;  // null if only shaders see it
};

class VulkanResources {
 public:
  // A GpuError where memory cannot be had. The device outlives the object.
  VulkanResources(const VulkanDevice& device, const std::vector<ImagePlan>& images,
                  const std::vector<BufferPlan>& buffers);
  ~VulkanResources();
  VulkanResources(const VulkanResources&) = delete;
  VulkanResources& operator=(const VulkanResources&) = delete;

  const VulkanImage& image(int i) const { return images_[static_cast<std::size_t>(i)]; }
  const VulkanBuffer& buffer(int i) const { return buffers_[static_cast<std::size_t>(i)]; }
  const std::vector<VulkanImage>& images() const { return images_; }

 private:
  void CreateImage(VulkanImage& image);
  void CreateBuffer(VulkanBuffer& buffer);
  void Destroy();
  void AllocateImages();
  void AllocateBuffers(bool on_device);

  const VulkanDevice& device_;
  std::vector<VulkanImage> images_;
  std::vector<VulkanBuffer> buffers_;
  VkDeviceMemory image_memory_ = VK_NULL_HANDLE, buffer_memory_ = VK_NULL_HANDLE,
                 shared_memory_ = VK_NULL_HANDLE;
};

}  // namespace warplut
