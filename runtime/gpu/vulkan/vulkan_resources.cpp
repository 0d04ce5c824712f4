#include "runtime/gpu/vulkan/vulkan_resources.h"

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

VulkanResources::VulkanResources(const VulkanDevice& device, const std::vector<ImagePlan>& images,
                                 const std::vector<BufferPlan>& buffers)
    : device_(device) {
  try {
    for (const ImagePlan& plan : images) CreateImage(images_.emplace_back(VulkanImage{plan}));
    for (const BufferPlan& plan : buffers) CreateBuffer(buffers_.emplace_back(VulkanBuffer{plan}));
    if (!images_.empty()) AllocateImages();
    for (const bool on_device : {true, false}) AllocateBuffers(on_device);
  } catch (...) {
    Destroy();
    throw;
  }
}

VulkanResources::~VulkanResources() { Destroy(); }

void VulkanResources::Destroy() {
  const VkDevice device = device_.handle();
  for (const VulkanImage& i : images_) {
    vkDestroyImageView(device, i.view, nullptr);
    vkDestroyImage(device, i.image, nullptr);
  }
  for (const VulkanBuffer& b : buffers_) vkDestroyBuffer(device, b.buffer, nullptr);
  vkFreeMemory(device, image_memory_, nullptr);
  vkFreeMemory(device, buffer_memory_, nullptr);
  vkFreeMemory(device, shared_memory_, nullptr);
}

void VulkanResources::CreateImage(VulkanImage& image) {
  const ImagePlan& plan = image.plan;
  VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                            VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (IsStored(plan.format) && plan.layers == 0) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
  const VkImageCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
      .pNext = nullptr,
      .flags = 0,
      .imageType = VK_IMAGE_TYPE_2D,
      .format = VulkanFormat(plan.format),
      .extent = {static_cast<std::uint32_t>(plan.width), static_cast<std::uint32_t>(plan.height),
                 1},
      .mipLevels = 1,
      .arrayLayers = static_cast<std::uint32_t>(std::max(plan.layers, 1)),
      .samples = VK_SAMPLE_COUNT_1_BIT,
      .tiling = VK_IMAGE_TILING_OPTIMAL,
      .usage = usage,
      .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
      .queueFamilyIndexCount = 0,
      .pQueueFamilyIndices = nullptr,
      .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED};
  CheckVulkan(vkCreateImage(device_.handle(), &info, nullptr, &image.image), "to make an image");
}

void VulkanResources::CreateBuffer(VulkanBuffer& buffer) {
  const VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                   .pNext = nullptr,
                                   .flags = 0,
                                   .size = buffer.plan.size,
                                   .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                                            VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                   .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
                                   .queueFamilyIndexCount = 0,
                                   .pQueueFamilyIndices = nullptr};
  CheckVulkan(vkCreateBuffer(device_.handle(), &info, nullptr, &buffer.buffer), "to make a buffer");
}

void VulkanResources::AllocateImages() {
  std::vector<VkMemoryRequirements> requirements(images_.size());
  for (std::size_t i = 0; i < images_.size(); ++i)
    vkGetImageMemoryRequirements(device_.handle(), images_[i].image, &requirements[i]);
  const std::vector<VkDeviceSize> places = Places(requirements);
  image_memory_ = AllocateBlock(
      device_, places.back(),
      device_.MemoryType(CommonTypes(requirements), VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT));
  for (std::size_t i = 0; i < images_.size(); ++i) {
    VulkanImage& image = images_[i];
    CheckVulkan(vkBindImageMemory(device_.handle(), image.image, image_memory_, places[i]),
                "to place an image");
    const VkImageViewCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .pNext = nullptr,
        .flags = 0,
        .image = image.image,
        .viewType = image.plan.layers > 0 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D,
        .format = VulkanFormat(image.plan.format),
        .components = {},
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, VK_REMAINING_ARRAY_LAYERS}};
    CheckVulkan(vkCreateImageView(device_.handle(), &info, nullptr, &image.view),
                "to make the view of an image");
  }
}

void VulkanResources::AllocateBuffers(bool on_device) {
  std::vector<VulkanBuffer*> buffers;
  std::vector<VkMemoryRequirements> requirements;
  for (VulkanBuffer& buffer : buffers_) {
    if (buffer.plan.on_device != on_device) continue;
    buffers.push_back(&buffer);
    requirements.emplace_back();
    vkGetBufferMemoryRequirements(device_.handle(), buffer.buffer, &requirements.back());
  }
  if (buffers.empty()) return;
  const std::vector<VkDeviceSize> places = Places(requirements);
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
