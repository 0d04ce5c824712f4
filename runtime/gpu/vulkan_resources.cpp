#include "runtime/gpu/vulkan_resources.h"

#include <algorithm>

namespace warplut {
namespace {

VkDeviceSize Aligned(VkDeviceSize size, VkDeviceSize alignment) {
  return (size + alignment - 1) / alignment * alignment;
}

VkDeviceMemory AllocateBlock(const VulkanDevice& device, VkDeviceSize size, std::uint32_t type) {
  const VkMemoryAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                     .pNext = nullptr,
                                     .allocationSize = size,
                                     .memoryTypeIndex = type};
  VkDeviceMemory memory = VK_NULL_HANDLE;
  CheckVulkan(vkAllocateMemory(device.handle(), &info, nullptr, &memory),
              "to allocate " + std::to_string(size) + " bytes");
  return memory;
}

// Where each of `requirements` goes in a block; the block's size is last.
std::vector<VkDeviceSize> Places(const std::vector<VkMemoryRequirements>& requirements) {
  std::vector<VkDeviceSize> places = {0};
  for (const VkMemoryRequirements& r : requirements) {
    places.back() = Aligned(places.back(), r.alignment);
    places.push_back(places.back() + r.size);
  }
  return places;
}

std::uint32_t CommonTypes(const std::vector<VkMemoryRequirements>& requirements) {
  std::uint32_t bits = ~0u;
  for (const VkMemoryRequirements& r : requirements) bits &= r.memoryTypeBits;
  return bits;
}

}  // namespace

VkFormat VulkanFormat(PixelFormat format) {
  return format == PixelFormat::kRgba16F ? VK_FORMAT_R16G16B16A16_SFLOAT
                                         : VK_FORMAT_R32G32B32A32_SFLOAT;
}

bool IsStored(VkFormat format) {
  return format == VK_FORMAT_R32_SFLOAT || format == VK_FORMAT_R16G16B16A16_SFLOAT ||
         format == VK_FORMAT_R32G32B32A32_SFLOAT;
}

std::size_t TexelBytes(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R32_SFLOAT:
    case VK_FORMAT_R16G16_SFLOAT:
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
    case VK_FORMAT_R8G8B8A8_UNORM:
      return 4;
    case VK_FORMAT_R32G32_SFLOAT:
    case VK_FORMAT_R16G16B16A16_SFLOAT:
      return 8;
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return 16;
    default:
      throw GpuError("an image of an unknown format was asked for");
  }
}

GpuResources::~GpuResources() {
  const VkDevice device = device_.handle();
  for (const GpuImage& i : images_) {
    if (i.view != VK_NULL_HANDLE) vkDestroyImageView(device, i.view, nullptr);
    vkDestroyImage(device, i.image, nullptr);
  }
  for (const GpuBuffer& b : buffers_) vkDestroyBuffer(device, b.buffer, nullptr);
  vkFreeMemory(device, image_memory_, nullptr);
  vkFreeMemory(device, buffer_memory_, nullptr);
  vkFreeMemory(device, shared_memory_, nullptr);
}

int GpuResources::AddImage(VkFormat format, int width, int height, int layers) {
  const bool stores = IsStored(format) && layers == 0;
  VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                            VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (stores) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
  const VkImageCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
      .pNext = nullptr,
      .flags = 0,
      .imageType = VK_IMAGE_TYPE_2D,
      .format = format,
      .extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 1},
      .mipLevels = 1,
      .arrayLayers = static_cast<std::uint32_t>(std::max(layers, 1)),
      .samples = VK_SAMPLE_COUNT_1_BIT,
      .tiling = VK_IMAGE_TILING_OPTIMAL,
      .usage = usage,
      .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
      .queueFamilyIndexCount = 0,
      .pQueueFamilyIndices = nullptr,
      .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED};
  GpuImage image = {.format = format, .width = width, .height = height, .layers = layers};
  CheckVulkan(vkCreateImage(device_.handle(), &info, nullptr, &image.image), "to make an image");
  images_.push_back(image);
  return static_cast<int>(images_.size()) - 1;
}

int GpuResources::AddBuffer(std::size_t size, bool on_device) {
  const VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                   .pNext = nullptr,
                                   .flags = 0,
                                   .size = size,
                                   .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                                            VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                   .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
                                   .queueFamilyIndexCount = 0,
                                   .pQueueFamilyIndices = nullptr};
  GpuBuffer buffer = {.size = size, .on_device = on_device};
  CheckVulkan(vkCreateBuffer(device_.handle(), &info, nullptr, &buffer.buffer), "to make a buffer");
  buffers_.push_back(buffer);
  return static_cast<int>(buffers_.size()) - 1;
}

void GpuResources::Allocate() {
  if (!images_.empty()) AllocateImages();
  for (const bool on_device : {true, false}) AllocateBuffers(on_device);
}

void GpuResources::AllocateImages() {
  std::vector<VkMemoryRequirements> requirements(images_.size());
  for (std::size_t i = 0; i < images_.size(); ++i)
    vkGetImageMemoryRequirements(device_.handle(), images_[i].image, &requirements[i]);
  const std::vector<VkDeviceSize> places = Places(requirements);
  image_bytes_ = places.back();
  image_memory_ = AllocateBlock(
      device_, places.back(),
      device_.MemoryType(CommonTypes(requirements), VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT));
  for (std::size_t i = 0; i < images_.size(); ++i) {
    GpuImage& image = images_[i];
    CheckVulkan(vkBindImageMemory(device_.handle(), image.image, image_memory_, places[i]),
                "to place an image");
    const VkImageViewCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .pNext = nullptr,
        .flags = 0,
        .image = image.image,
        .viewType = image.layers > 0 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D,
        .format = image.format,
        .components = {},
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, VK_REMAINING_ARRAY_LAYERS}};
    CheckVulkan(vkCreateImageView(device_.handle(), &info, nullptr, &image.view),
                "to make the view of an image");
  }
}

void GpuResources::AllocateBuffers(bool on_device) {
  std::vector<GpuBuffer*> buffers;
  std::vector<VkMemoryRequirements> requirements;
  for (GpuBuffer& buffer : buffers_) {
    if (buffer.on_device != on_device) continue;
    buffers.push_back(&buffer);
    requirements.emplace_back();
    vkGetBufferMemoryRequirements(device_.handle(), buffer.buffer, &requirements.back());
  }
  if (buffers.empty()) return;
  const std::vector<VkDeviceSize> places = Places(requirements);
  buffer_bytes_ += places.back();
  const VkMemoryPropertyFlags kind =
      on_device ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                : VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  VkDeviceMemory& memory = on_device ? buffer_memory_ : shared_memory_;
  memory =
      AllocateBlock(device_, places.back(), device_.MemoryType(CommonTypes(requirements), kind));
  void* mapped = nullptr;
  if (!on_device) {
    CheckVulkan(vkMapMemory(device_.handle(), memory, 0, VK_WHOLE_SIZE, 0, &mapped),
                "to map memory");
  }
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    CheckVulkan(vkBindBufferMemory(device_.handle(), buffers[i]->buffer, memory, places[i]),
                "to place a buffer");
    if (!on_device) buffers[i]->bytes = static_cast<std::byte*>(mapped) + places[i];
  }
}

}  // namespace warplut
