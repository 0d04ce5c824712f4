#include "runtime/gpu/vulkan/vulkan_commands.h"

#include <algorithm>

namespace warplut {
namespace {

// One side of a barrier of an image.
struct ImageUse {
  VkImageLayout layout;
  VkPipelineStageFlags stages;
  VkAccessFlags access;
};
constexpr VkPipelineStageFlags kCompute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags kCopies = VK_PIPELINE_STAGE_TRANSFER_BIT;
constexpr ImageUse kNew = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 0};
constexpr ImageUse kByShaders = {VK_IMAGE_LAYOUT_GENERAL, kCompute,
                                 VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT};
constexpr ImageUse kCopiedTo = {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kCopies,
                                VK_ACCESS_TRANSFER_WRITE_BIT};
constexpr ImageUse kCopiedFrom = {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kCopies,
                                  VK_ACCESS_TRANSFER_READ_BIT};

void ChangeUse(VkCommandBuffer commands, const VulkanImage& image, const ImageUse& before,
               const ImageUse& after) {
  const VkImageMemoryBarrier barrier = {
      .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
      .pNext = nullptr,
      .srcAccessMask = before.access,
      .dstAccessMask = after.access,
      .oldLayout = before.layout,
      .newLayout = after.layout,
      .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .image = image.image,
      .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, VK_REMAINING_ARRAY_LAYERS}};
  vkCmdPipelineBarrier(commands, before.stages, after.stages, 0, 0, nullptr, 0, nullptr, 1,
                       &barrier);
}

VkBufferImageCopy Corner(const VulkanImage& image, int width, int height) {
  return {
      .bufferOffset = 0,
      .bufferRowLength = 0,
      .bufferImageHeight = 0,
      .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0,
                           static_cast<std::uint32_t>(std::max(image.plan.layers, 1))},
      .imageOffset = {0, 0, 0},
      .imageExtent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 1}};
}

}  // namespace

VulkanCommands::VulkanCommands(const VulkanDevice& device, int most_timestamps)
    : device_(device), most_timestamps_(static_cast<std::uint32_t>(most_timestamps)) {
  try {
    const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .pNext = nullptr,
                                          .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                          .queueFamilyIndex = device.queue_family()};
    CheckVulkan(vkCreateCommandPool(device.handle(), &pool, nullptr, &pool_), "to make commands");
    const VkCommandBufferAllocateInfo buffer = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
        .pNext = nullptr,
        .commandPool = pool_,
        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
        .commandBufferCount = 1};
    CheckVulkan(vkAllocateCommandBuffers(device.handle(), &buffer, &commands_), "to make commands");
    const VkFenceCreateInfo fence = {
        .sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, .pNext = nullptr, .flags = 0};
    CheckVulkan(vkCreateFence(device.handle(), &fence, nullptr, &fence_), "to make a fence");
    if (device.tick() <= 0) return;
    const VkQueryPoolCreateInfo queries = {.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                           .pNext = nullptr,
                                           .flags = 0,
                                           .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                           .queryCount = most_timestamps_,
                                           .pipelineStatistics = 0};
    CheckVulkan(vkCreateQueryPool(device.handle(), &queries, nullptr, &queries_),
                "to make timestamps");
  } catch (...) {
    Destroy();
    throw;
  }
}

VulkanCommands::~VulkanCommands() { Destroy(); }

void VulkanCommands::Destroy() {
  vkDestroyQueryPool(device_.handle(), queries_, nullptr);
  vkDestroyFence(device_.handle(), fence_, nullptr);
  vkDestroyCommandPool(device_.handle(), pool_, nullptr);
}

void VulkanCommands::Run(const std::function<void(VkCommandBuffer)>& record) {
  const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                          .pNext = nullptr,
                                          .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT,
                                          .pInheritanceInfo = nullptr};
  CheckVulkan(vkBeginCommandBuffer(commands_, &begin), "to record a frame");
  timestamps_ = 0;
  if (queries_ != VK_NULL_HANDLE) vkCmdResetQueryPool(commands_, queries_, 0, most_timestamps_);
  record(commands_);
  CheckVulkan(vkEndCommandBuffer(commands_), "to record a frame");
  const VkSubmitInfo submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                               .pNext = nullptr,
                               .waitSemaphoreCount = 0,
                               .pWaitSemaphores = nullptr,
                               .pWaitDstStageMask = nullptr,
                               .commandBufferCount = 1,
                               .pCommandBuffers = &commands_,
                               .signalSemaphoreCount = 0,
                               .pSignalSemaphores = nullptr};
  CheckVulkan(vkQueueSubmit(device_.queue(), 1, &submit, fence_), "to submit a frame");
  CheckVulkan(vkWaitForFences(device_.handle(), 1, &fence_, VK_TRUE, UINT64_MAX), "to run a frame");
  CheckVulkan(vkResetFences(device_.handle(), 1, &fence_), "to run a frame");
}

void VulkanCommands::Timestamp(VkCommandBuffer commands) {
  if (queries_ == VK_NULL_HANDLE || timestamps_ == most_timestamps_) return;
  vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_, timestamps_++);
}

std::vector<double> VulkanCommands::Intervals() const {
  if (timestamps_ < 2) return {};
  std::vector<std::uint64_t> ticks(timestamps_);
  CheckVulkan(vkGetQueryPoolResults(device_.handle(), queries_, 0, timestamps_,
                                    ticks.size() * sizeof(std::uint64_t), ticks.data(),
                                    sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT),
              "to read timestamps");
  std::vector<double> intervals;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    intervals.push_back(static_cast<double>(ticks[i] - ticks[i - 1]) * device_.tick() * 1e-6);
  return intervals;
}

void PrepareImage(VkCommandBuffer commands, const VulkanImage& image) {
  ChangeUse(commands, image, kNew, kByShaders);
}

void CopyToImage(VkCommandBuffer commands, const VulkanBuffer& from, const VulkanImage& to,
                 int width, int height) {
  const VkBufferImageCopy copy = Corner(to, width, height);
  ChangeUse(commands, to, kByShaders, kCopiedTo);
  vkCmdCopyBufferToImage(commands, from.buffer, to.image, kCopiedTo.layout, 1, &copy);
  ChangeUse(commands, to, kCopiedTo, kByShaders);
}

void FillBuffer(VkCommandBuffer commands, const VulkanBuffer& buffer, std::uint32_t value) {
  constexpr VkAccessFlags kByShader = kByShaders.access, kByCopy = VK_ACCESS_TRANSFER_WRITE_BIT;
  const VkMemoryBarrier before = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                  .pNext = nullptr,
                                  .srcAccessMask = kByShader,
                                  .dstAccessMask = kByCopy};
  vkCmdPipelineBarrier(commands, kCompute, kCopies, 0, 1, &before, 0, nullptr, 0, nullptr);
  vkCmdFillBuffer(commands, buffer.buffer, 0, VK_WHOLE_SIZE, value);
  const VkMemoryBarrier after = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                 .pNext = nullptr,
                                 .srcAccessMask = kByCopy,
                                 .dstAccessMask = kByShader};
  vkCmdPipelineBarrier(commands, kCopies, kCompute, 0, 1, &after, 0, nullptr, 0, nullptr);
}

void CopyToBuffer(VkCommandBuffer commands, const VulkanImage& from, const VulkanBuffer& to) {
  const VkBufferImageCopy copy = Corner(from, from.plan.width, from.plan.height);
  ChangeUse(commands, from, kByShaders, kCopiedFrom);
  vkCmdCopyImageToBuffer(commands, from.image, kCopiedFrom.layout, to.buffer, 1, &copy);
  ChangeUse(commands, from, kCopiedFrom, kByShaders);
  const VkMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                   .pNext = nullptr,
                                   .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                   .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
  vkCmdPipelineBarrier(commands, kCopies, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0,
                       nullptr);
}

}  // namespace warplut
