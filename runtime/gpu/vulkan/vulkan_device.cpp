#define VOLK_IMPLEMENTATION
#include "runtime/gpu/vulkan/vulkan_device.h"

#include <algorithm>
#include <cstring>

#include "runtime/gpu/vulkan/vulkan_workspace.h"

namespace warplut {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

std::string ReasonOf(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "there is not enough memory";
    case VK_ERROR_DEVICE_LOST:
      return "the device was lost";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "there is no Vulkan driver";
    default:
      return "Vulkan returned " + std::to_string(result);
  }
}

VKAPI_ATTR VkBool32 VKAPI_CALL Collect(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                       VkDebugUtilsMessageTypeFlagsEXT type,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data,
                                       void* messages) {
  // Those of the loader tell of drivers, not of this program.
  if ((type & (VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
               VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT)) != 0) {
    static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
  }
  return VK_FALSE;
}

bool HasLayer(const char* name) {
  std::uint32_t count = 0;
  CheckVulkan(vkEnumerateInstanceLayerProperties(&count, nullptr), "to list the layers");
  std::vector<VkLayerProperties> layers(count);
  CheckVulkan(vkEnumerateInstanceLayerProperties(&count, layers.data()), "to list the layers");
  return std::any_of(layers.begin(), layers.end(), [&](const VkLayerProperties& layer) {
    return std::strcmp(layer.layerName, name) == 0;
  });
}

// The index of a queue family that computes, or -1.
int ComputeFamily(VkPhysicalDevice device, std::uint32_t* timestamp_bits) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
    *timestamp_bits = families[i].timestampValidBits;
    return static_cast<int>(i);
  }
  return -1;
}

int RankOf(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return 2;
    default:
      return 3;
  }
}

}  // namespace

void CheckVulkan(VkResult result, const std::string& what) {
  if (result == VK_SUCCESS) return;
  throw GpuError("the GPU failed " + what + ": " + ReasonOf(result));
}

VkFormat VulkanFormat(TexelFormat format) {
  switch (format) {
    case TexelFormat::kR8:
      return VK_FORMAT_R8_UNORM;
    case TexelFormat::kR16F:
      return VK_FORMAT_R16_SFLOAT;
    case TexelFormat::kR32F:
      return VK_FORMAT_R32_SFLOAT;
    case TexelFormat::kRg16F:
      return VK_FORMAT_R16G16_SFLOAT;
    case TexelFormat::kRg32F:
      return VK_FORMAT_R32G32_SFLOAT;
    case TexelFormat::kRgba8:
      return VK_FORMAT_R8G8B8A8_UNORM;
    case TexelFormat::kRgba16F:
      return VK_FORMAT_R16G16B16A16_SFLOAT;
    case TexelFormat::kRgba32F:
      return VK_FORMAT_R32G32B32A32_SFLOAT;
    case TexelFormat::kR11G11B10F:
      return VK_FORMAT_B10G11R11_UFLOAT_PACK32;
  }
  return VK_FORMAT_UNDEFINED;
}

VulkanDevice::VulkanDevice(const DeviceOptions& options) try {
  CreateInstance(options);
  TakePhysicalDevice();
  CreateDevice();
} catch (...) {
  Destroy();
  throw;
}

VulkanDevice::~VulkanDevice() { Destroy(); }

void VulkanDevice::Destroy() {
  if (device_ != VK_NULL_HANDLE) vkDestroyDevice(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE) vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

void VulkanDevice::CreateInstance(const DeviceOptions& options) {
  if (volkInitialize() != VK_SUCCESS) {
    throw GpuError("there is no Vulkan on this machine: its loader, libvulkan.so.1, is missing");
  }
  if (volkGetInstanceVersion() < VK_API_VERSION_1_1) {
    throw GpuError("the Vulkan loader has version 1.0; 1.1 was expected");
  }
  if (options.validate && !HasLayer(kValidationLayer)) {
    throw GpuError("the Vulkan validation layers are not installed");
  }
  const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                         .pNext = nullptr,
                                         .pApplicationName = "warplut",
                                         .applicationVersion = 1,
                                         .pEngineName = "warplut",
                                         .engineVersion = 1,
                                         .apiVersion = VK_API_VERSION_1_1};
  const char* const extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  const std::uint32_t validated = options.validate ? 1 : 0;
  const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                     .pNext = nullptr,
                                     .flags = 0,
                                     .pApplicationInfo = &application,
                                     .enabledLayerCount = validated,
                                     .ppEnabledLayerNames = &kValidationLayer,
                                     .enabledExtensionCount = validated,
                                     .ppEnabledExtensionNames = &extension};
  CheckVulkan(vkCreateInstance(&info, nullptr, &instance_), "to start Vulkan");
  volkLoadInstanceOnly(instance_);
  if (!options.validate) return;
  const VkDebugUtilsMessengerCreateInfoEXT messenger = {
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
      .pNext = nullptr,
      .flags = 0,
      .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                         VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
      .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT |
                     VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                     VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT,
      .pfnUserCallback = Collect,
      .pUserData = &messages_};
  CheckVulkan(vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_),
              "to listen to the validation layers");
}

void VulkanDevice::TakePhysicalDevice() {
  std::uint32_t count = 0;
  CheckVulkan(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "to list the devices");
  std::vector<VkPhysicalDevice> devices(count);
  CheckVulkan(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "to list the devices");
  int best = 4;
  for (const VkPhysicalDevice device : devices) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    std::uint32_t timestamp_bits = 0;
    const int family = ComputeFamily(device, &timestamp_bits);
    const int rank = RankOf(properties.deviceType);
    if (properties.apiVersion < VK_API_VERSION_1_1 || family < 0 || rank >= best) continue;
    best = rank;
    physical_ = device;
    family_ = static_cast<std::uint32_t>(family);
    limits_ = properties.limits;
    name_ = properties.deviceName;
    tick_ = timestamp_bits == 0 ? 0.0 : static_cast<double>(limits_.timestampPeriod);
  }
  if (physical_ == VK_NULL_HANDLE) {
    throw GpuError("there is no device with Vulkan 1.1 and a compute queue on this machine");
  }
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
}

void VulkanDevice::CreateDevice() {
  const float priority = 1;
  const VkDeviceQueueCreateInfo queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                         .pNext = nullptr,
                                         .flags = 0,
                                         .queueFamilyIndex = family_,
                                         .queueCount = 1,
                                         .pQueuePriorities = &priority};
  const VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                   .pNext = nullptr,
                                   .flags = 0,
                                   .queueCreateInfoCount = 1,
                                   .pQueueCreateInfos = &queue,
                                   .enabledLayerCount = 0,
                                   .ppEnabledLayerNames = nullptr,
                                   .enabledExtensionCount = 0,
                                   .ppEnabledExtensionNames = nullptr,
                                   .pEnabledFeatures = nullptr};
  CheckVulkan(vkCreateDevice(physical_, &info, nullptr, &device_), "to open the device " + name_);
  volkLoadDevice(device_);
  vkGetDeviceQueue(device_, family_, 0, &queue_);
}

std::unique_ptr<GpuWorkspace> VulkanDevice::MakeWorkspace(PixelFormat format) const {
  return std::make_unique<VulkanWorkspace>(*this, format);
}

bool VulkanDevice::CanStore(TexelFormat format) const {
  constexpr VkFormatFeatureFlags kNeeded =
      VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT |
      VK_FORMAT_FEATURE_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(physical_, VulkanFormat(format), &properties);
  return (properties.optimalTilingFeatures & kNeeded) == kNeeded;
}

std::uint32_t VulkanDevice::MemoryType(std::uint32_t bits, VkMemoryPropertyFlags properties) const {
  for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
    const bool has_all = (memory_.memoryTypes[i].propertyFlags & properties) == properties;
    if ((bits & (1u << i)) != 0 && has_all) return i;
  }
  throw GpuError("the device " + name_ + " has no memory of the kind that is needed");
}

}  // namespace warplut
