#include "runtime/gpu/vulkan/vulkan_pass.h"

namespace warplut {
namespace {

VkDescriptorType TypeOf(Binding::Use use) {
  switch (use) {
    case Binding::Use::kSampled:
    case Binding::Use::kFiltered:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case Binding::Use::kStored:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case Binding::Use::kBuffer:
      break;
  }
  return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

}  // namespace

VulkanPass::VulkanPass(const VulkanDevice& device, const VulkanResources& resources,
                       const PassPlan& plan, std::span<const std::uint32_t> spirv,
                       const VulkanSamplers& samplers)
    : device_(device), plan_(plan) {
  try {
    CreateLayouts();
    CreatePipeline(spirv);
    CreateSets();
    for (std::size_t i = 0; i < sets_.size(); ++i)
      WriteSet(resources, plan.sets[i], sets_[i], samplers);
  } catch (...) {
    Destroy();
    throw;
  }
}

VulkanPass::~VulkanPass() { Destroy(); }

void VulkanPass::Destroy() {
  const VkDevice device = device_.handle();
  vkDestroyDescriptorPool(device, pool_, nullptr);
  vkDestroyPipeline(device, pipeline_, nullptr);
  vkDestroyPipelineLayout(device, layout_, nullptr);
  vkDestroyDescriptorSetLayout(device, set_layout_, nullptr);
}

void VulkanPass::CreateLayouts() {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  const std::vector<Binding>& first = plan_.sets.front();
  for (std::size_t i = 0; i < first.size(); ++i) {
    bindings.push_back({static_cast<std::uint32_t>(i), TypeOf(first[i].use), 1,
                        VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  }
  const VkDescriptorSetLayoutCreateInfo set = {
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
      .pNext = nullptr,
      .flags = 0,
      .bindingCount = static_cast<std::uint32_t>(bindings.size()),
      .pBindings = bindings.data()};
  CheckVulkan(vkCreateDescriptorSetLayout(device_.handle(), &set, nullptr, &set_layout_),
              std::string("to lay out the pass ") + plan_.name);
  const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0,
                                     static_cast<std::uint32_t>(plan_.numbers_bytes)};
  const VkPipelineLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                             .pNext = nullptr,
                                             .flags = 0,
                                             .setLayoutCount = 1,
                                             .pSetLayouts = &set_layout_,
                                             .pushConstantRangeCount = 1,
                                             .pPushConstantRanges = &range};
  CheckVulkan(vkCreatePipelineLayout(device_.handle(), &layout, nullptr, &layout_),
              std::string("to lay out the pass ") + plan_.name);
}

void VulkanPass::CreatePipeline(std::span<const std::uint32_t> spirv) {
  const VkShaderModuleCreateInfo module_info = {
      .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
      .pNext = nullptr,
      .flags = 0,
      .codeSize = spirv.size_bytes(),
      .pCode = spirv.data()};
  VkShaderModule module = VK_NULL_HANDLE;
  CheckVulkan(vkCreateShaderModule(device_.handle(), &module_info, nullptr, &module),
              std::string("to take the shader of the pass ") + plan_.name);
  std::vector<VkSpecializationMapEntry> entries;
  for (std::uint32_t i = 0; i < plan_.constants.size(); ++i)
    entries.push_back({i, i * 4, sizeof(std::int32_t)});
  const VkSpecializationInfo specialization = {
      static_cast<std::uint32_t>(entries.size()), entries.data(),
      plan_.constants.size() * sizeof(std::int32_t), plan_.constants.data()};
  const VkPipelineShaderStageCreateInfo stage = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
      .pNext = nullptr,
      .flags = 0,
      .stage = VK_SHADER_STAGE_COMPUTE_BIT,
      .module = module,
      .pName = "main",
      .pSpecializationInfo = &specialization};
  const VkComputePipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                            .pNext = nullptr,
                                            .flags = 0,
                                            .stage = stage,
                                            .layout = layout_,
                                            .basePipelineHandle = VK_NULL_HANDLE,
                                            .basePipelineIndex = 0};
  const VkResult result =
      vkCreateComputePipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
  vkDestroyShaderModule(device_.handle(), module, nullptr);
  CheckVulkan(result, std::string("to compile the pass ") + plan_.name);
}

void VulkanPass::CreateSets() {
  const auto sets = static_cast<std::uint32_t>(plan_.sets.size());
  const auto count = sets * static_cast<std::uint32_t>(plan_.sets.front().size());
  const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, count},
                                        {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, count},
                                        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count}};
  const VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                           .pNext = nullptr,
                                           .flags = 0,
                                           .maxSets = sets,
                                           .poolSizeCount = 3,
                                           .pPoolSizes = sizes};
  CheckVulkan(vkCreateDescriptorPool(device_.handle(), &pool, nullptr, &pool_),
              "to make descriptors");
  const std::vector<VkDescriptorSetLayout> layouts(sets, set_layout_);
  const VkDescriptorSetAllocateInfo set = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                           .pNext = nullptr,
                                           .descriptorPool = pool_,
                                           .descriptorSetCount = sets,
                                           .pSetLayouts = layouts.data()};
  sets_.resize(sets);
  CheckVulkan(vkAllocateDescriptorSets(device_.handle(), &set, sets_.data()),
              "to make descriptors");
}

void VulkanPass::WriteSet(const VulkanResources& resources, const std::vector<Binding>& bindings,
                          VkDescriptorSet set, const VulkanSamplers& samplers) {
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    const Binding& binding = bindings[i];
    const bool is_buffer = binding.use == Binding::Use::kBuffer;
    VkDescriptorImageInfo image = {VK_NULL_HANDLE, VK_NULL_HANDLE, VK_IMAGE_LAYOUT_GENERAL};
    VkDescriptorBufferInfo buffer = {VK_NULL_HANDLE, 0, VK_WHOLE_SIZE};
    if (is_buffer) {
      buffer.buffer = resources.buffer(binding.index).buffer;
    } else {
      image.imageView = resources.image(binding.index).view;
      if (binding.use == Binding::Use::kSampled) image.sampler = samplers.nearest;
      if (binding.use == Binding::Use::kFiltered) image.sampler = samplers.linear;
    }
    const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                        .pNext = nullptr,
                                        .dstSet = set,
                                        .dstBinding = static_cast<std::uint32_t>(i),
                                        .dstArrayElement = 0,
                                        .descriptorCount = 1,
                                        .descriptorType = TypeOf(binding.use),
                                        .pImageInfo = is_buffer ? nullptr : &image,
                                        .pBufferInfo = is_buffer ? &buffer : nullptr,
                                        .pTexelBufferView = nullptr};
    vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
  }
}

void VulkanPass::Record(VkCommandBuffer commands, const void* numbers, std::size_t set, int width,
                        int height) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &sets_[set], 0,
                          nullptr);
  vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0,
                     static_cast<std::uint32_t>(plan_.numbers_bytes), numbers);
  vkCmdDispatch(commands, static_cast<std::uint32_t>(plan_.groups_x(width)),
                static_cast<std::uint32_t>(plan_.groups_y(height)), 1);
  // The next passes read results of this one, or overwrite its inputs.
  const VkMemoryBarrier barrier = {
      .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
      .pNext = nullptr,
      .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
      .dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1, &barrier, 0, nullptr, 0,
                       nullptr);
}

}  // namespace warplut
