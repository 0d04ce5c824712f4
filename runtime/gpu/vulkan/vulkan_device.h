// A Vulkan 1.1 device for compute: the instance, the device and one queue.
#pragma once

#include <volk.h>

#include <string>
#include <vector>

#include "runtime/gpu/gpu_device.h"

namespace warplut {

// Throws GpuError unless `result` is VK_SUCCESS; `what` was tried ("to submit a frame").
void CheckVulkan(VkResult result, const std::string& what);

VkFormat VulkanFormat(TexelFormat format);

class VulkanDevice final : public GpuDevice {
 public:
  // Takes the first device that computes, a discrete GPU before others. A GpuError where there is
  // none. At most one object exists at a time: the functions of Vulkan are loaded for one device.
  explicit VulkanDevice(const DeviceOptions& options = {});
  ~VulkanDevice() override;

  const std::string& name() const override { return name_; }
  int largest_image() const override { return static_cast<int>(limits_.maxImageDimension2D); }
  std::size_t largest_buffer() const override { return limits_.maxStorageBufferRange; }
  bool has_times() const override { return tick_ > 0; }
  // Without those of severity info.
  const std::vector<std::string>& messages() const override { return messages_; }
  bool CanStore(TexelFormat format) const override;
  std::unique_ptr<GpuWorkspace> MakeWorkspace(PixelFormat format) const override;

  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return family_; }
  // Nanoseconds of a tick of a timestamp; 0 where the queue has none.
  double tick() const { return tick_; }
  // The first memory type among `bits` with these properties.
  std::uint32_t MemoryType(std::uint32_t bits, VkMemoryPropertyFlags properties) const;

 private:
  void CreateInstance(const DeviceOptions& options);
  void TakePhysicalDevice();
  void CreateDevice();
  void Destroy();

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  VkPhysicalDeviceLimits limits_ = {};
  VkPhysicalDeviceMemoryProperties memory_ = {};
  double tick_ = 0;
  std::string name_;
  std::vector<std::string> messages_;
};

}  // namespace warplut
