// Images and buffers of one object, in a block of memory for each kind: images, buffers that only
// shaders see, buffers that the processor sees.
#pragma once

#include <cstddef>
#include <vector>

#include "runtime/gpu/vulkan_device.h"
#include "runtime/image_view.h"

namespace warplut {

struct GpuImage {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  int width = 0, height = 0, layers = 0;
};

struct GpuBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  std::byte* bytes = nullptr;  // from Allocate on; null if only shaders see it
  std::size_t size = 0;
  bool on_device = false;  // only shaders see it
};

// That of kRgba16F or kRgba32F.
VkFormat VulkanFormat(PixelFormat format);

// Whether shaders store to images of this format. Others are inputs.
bool IsStored(VkFormat format);

// Bytes of a texel of the formats that are used here.
std::size_t TexelBytes(VkFormat format);

class GpuResources {
 public:
  explicit GpuResources(const VulkanDevice& device) : device_(device) {}
  ~GpuResources();
  GpuResources(const GpuResources&) = delete;
  GpuResources& operator=(const GpuResources&) = delete;

  // Indices into image() and buffer(). `layers` > 0 makes an array.
  int AddImage(VkFormat format, int width, int height, int layers = 0);
  int AddBuffer(std::size_t size, bool on_device = false);
  // Memory for all that was added; images then have views, buffers are mapped. Once.
  void Allocate();

  const GpuImage& image(int i) const { return images_[static_cast<std::size_t>(i)]; }
  const GpuBuffer& buffer(int i) const { return buffers_[static_cast<std::size_t>(i)]; }
  const std::vector<GpuImage>& images() const { return images_; }
  std::size_t bytes() const { return image_bytes_ + buffer_bytes_; }

 private:
  void AllocateImages();
  void AllocateBuffers(bool on_device);

  const VulkanDevice& device_;
  std::vector<GpuImage> images_;
  std::vector<GpuBuffer> buffers_;
  VkDeviceMemory image_memory_ = VK_NULL_HANDLE, buffer_memory_ = VK_NULL_HANDLE,
                 shared_memory_ = VK_NULL_HANDLE;
  std::size_t image_bytes_ = 0, buffer_bytes_ = 0;
};

}  // namespace warplut
