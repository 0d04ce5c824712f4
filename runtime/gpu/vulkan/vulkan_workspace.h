// The workspace of an object on Vulkan: resources, passes, commands.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "runtime/gpu/vulkan/vulkan_commands.h"
#include "runtime/gpu/vulkan/vulkan_pass.h"

namespace warplut {

class VulkanWorkspace final : public GpuWorkspace {
 public:
  VulkanWorkspace(const VulkanDevice& device, PixelFormat format);
  ~VulkanWorkspace() override;

  void Allocate() override;
  std::byte* BytesOf(int buffer) override { return resources_->buffer(buffer).bytes; }
  int AddPass(const PassPlan& plan) override;
  void Run(const std::function<void()>& record) override;
  void RecordGrid(int pass, const void* numbers, std::size_t set, int width, int height) override;
  void CopyToCorner(int buffer, int image, int width, int height) override;
  void CopyToBuffer(int image, int buffer) override;
  void FillBuffer(int buffer, std::uint32_t value) override;
  std::vector<PassTime> Times() const override;

 private:
  const PassPlan& PlanOf(int pass) const override {
    return passes_[static_cast<std::size_t>(pass)]->plan();
  }

  const VulkanDevice& device_;
  PixelFormat format_;
  VulkanSamplers samplers_;
  VulkanCommands commands_;
  std::optional<VulkanResources> resources_;
  std::vector<std::unique_ptr<VulkanPass>> passes_;
  std::vector<const char*> run_;               // names of the passes of the last Run
  VkCommandBuffer recorded_ = VK_NULL_HANDLE;  // in Run
};

}  // namespace warplut
