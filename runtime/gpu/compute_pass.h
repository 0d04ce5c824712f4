// One compute shader with its specialisation, its resources and its dispatch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/gpu/vulkan_resources.h"

namespace warplut {

// What is at a binding: an image, sampled or stored to, or a buffer that is read and written.
struct PassResource {
  VkImageView view = VK_NULL_HANDLE;
  bool stored = false;
  VkBuffer buffer = VK_NULL_HANDLE;  // in place of an image
};

struct PassOptions {
  const char* name = "";
  std::span<const std::uint32_t> spirv;
  // constant_id 0, 1, ...; booleans are 0 or 1. Those that the shader lacks do nothing.
  std::vector<std::int32_t> constants;
  // Bindings 0, 1, ...; images are in layout GENERAL. Each of the sets has the same kinds of
  // resources; Record says which set is bound.
  std::vector<std::vector<PassResource>> sets;
  std::size_t numbers_bytes = 0;  // of the push constants
  int width = 0, height = 0;      // of the grid that is dispatched
  int group_width = 8, group_height = 8;
};

class ComputePass {
 public:
  // `sampler` outlives the pass.
  ComputePass(const VulkanDevice& device, const PassOptions& options, VkSampler sampler);
  ~ComputePass();
  ComputePass(const ComputePass&) = delete;
  ComputePass& operator=(const ComputePass&) = delete;

  const char* name() const { return name_; }

  // Records the dispatch, and a barrier after which what it stored can be read.
  void Record(VkCommandBuffer commands, const void* numbers, std::size_t set = 0) const;

 private:
  void CreateLayouts(const PassOptions& options);
  void CreatePipeline(const PassOptions& options);
  void CreateSets(const PassOptions& options);
  void WriteSet(const std::vector<PassResource>& resources, VkDescriptorSet set, VkSampler sampler);
  void Destroy();

  const VulkanDevice& device_;
  const char* name_;
  std::size_t numbers_bytes_;
  std::uint32_t groups_x_, groups_y_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> sets_;
};

}  // namespace warplut
