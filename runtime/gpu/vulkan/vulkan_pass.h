// One compute shader with its specialisation, its resources and its dispatch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/gpu/vulkan/vulkan_resources.h"

namespace warplut {

// `nearest` reads texels as they are, `linear` blends between them. Positions beyond the edges have
// the outermost texels.
struct VulkanSamplers {
  VkSampler nearest = VK_NULL_HANDLE, linear = VK_NULL_HANDLE;
};

class VulkanPass {
 public:
  // The plan's bindings are indices of `resources`, whose images are in layout GENERAL. The device,
  // the resources and the samplers outlive the pass. A GpuError if the device does not take the
  // shader.
  VulkanPass(const VulkanDevice& device, const VulkanResources& resources, const PassPlan& plan,
             std::span<const std::uint32_t> spirv, const VulkanSamplers& samplers);
  ~VulkanPass();
  VulkanPass(const VulkanPass&) = delete;
  VulkanPass& operator=(const VulkanPass&) = delete;

  const PassPlan& plan() const { return plan_; }

  // Records the dispatch over a grid, and a barrier after which what it stored can be read.
  void Record(VkCommandBuffer commands, const void* numbers, std::size_t set, int width,
              int height) const;

 private:
  void CreateLayouts();
  void CreatePipeline(std::span<const std::uint32_t> spirv);
  void CreateSets();
  void WriteSet(const VulkanResources& resources, const std::vector<Binding>& bindings,
                VkDescriptorSet set, const VulkanSamplers& samplers);
  void Destroy();

  const VulkanDevice& device_;
  const PassPlan plan_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> sets_;
};

}  // namespace warplut
