// A Vulkan 1.1 device for compute: the instance, the device and one queue.
#pragma once

#include <volk.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace warplut {

// One sentence: there is no device, it lacks something, or it failed.
class GpuError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws GpuError unless `result` is VK_SUCCESS; `what` was tried ("to submit a frame").
void CheckVulkan(VkResult result, const std::string& what);

struct DeviceOptions {
  // Collects the messages of VK_LAYER_KHRONOS_validation; a GpuError where it is not installed.
  bool validate = false;
};

class VulkanDevice {
 public:
  // Takes the first device that computes, a discrete GPU before others. A GpuError where there is
  // none. At most one object exists at a time: the functions of Vulkan are loaded for one device.
  explicit VulkanDevice(const DeviceOptions& options = {});
  ~VulkanDevice();
  VulkanDevice(const VulkanDevice&) = delete;
  VulkanDevice& operator=(const VulkanDevice&) = delete;

  const std::string& name() const { return name_; }
  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return family_; }
  int largest_image() const { return static_cast<int>(limits_.maxImageDimension2D); }
  // Nanoseconds of a tick of a timestamp; 0 where the queue has none.
  double tick() const { return tick_; }
  // Messages of the validation layers so far, without those of severity info.
  const std::vector<std::string>& messages() const { return messages_; }

  // Whether images of this format can be stored to by shaders, sampled and copied.
  bool CanStore(VkFormat format) const;
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
