#include "runtime/gpu/pass_sequence.h"

namespace warplut {
namespace {

constexpr int kMostTimestamps = 24;

// Texels as they are; beyond the edges the outermost.
VkSampler MakeSampler(const VulkanDevice& device) {
  const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                    .pNext = nullptr,
                                    .flags = 0,
                                    .magFilter = VK_FILTER_NEAREST,
                                    .minFilter = VK_FILTER_NEAREST,
                                    .mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                    .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                    .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                    .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                    .mipLodBias = 0,
                                    .anisotropyEnable = VK_FALSE,
                                    .maxAnisotropy = 1,
                                    .compareEnable = VK_FALSE,
                                    .compareOp = VK_COMPARE_OP_NEVER,
                                    .minLod = 0,
                                    .maxLod = 0,
                                    .borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_BLACK,
                                    .unnormalizedCoordinates = VK_FALSE};
  VkSampler sampler = VK_NULL_HANDLE;
  CheckVulkan(vkCreateSampler(device.handle(), &info, nullptr, &sampler), "to make a sampler");
  return sampler;
}

}  // namespace

PassSequence::PassSequence(const VulkanDevice& device, const GpuResources& resources,
                           PixelFormat format)
    : device_(device),
      resources_(resources),
      format_(format),
      sampler_(MakeSampler(device)),
      commands_(device, kMostTimestamps) {}

PassSequence::~PassSequence() { vkDestroySampler(device_.handle(), sampler_, nullptr); }

int PassSequence::Add(const PassPlan& plan) {
  PassOptions options = {.name = plan.name,
                         .spirv = CodeOf(plan.shader, format_),
                         .constants = plan.constants,
                         .sets = {},
                         .numbers_bytes = plan.numbers_bytes,
                         .width = plan.width,
                         .height = plan.height,
                         .group_width = plan.group_width,
                         .group_height = plan.group_height};
  for (const std::vector<Binding>& bindings : plan.sets) {
    std::vector<PassResource>& set = options.sets.emplace_back();
    for (const Binding& binding : bindings) {
      if (binding.use == Binding::Use::kBuffer) {
        set.push_back({.buffer = resources_.buffer(binding.index).buffer});
      } else {
        set.push_back({.view = resources_.image(binding.index).view,
                       .stored = binding.use == Binding::Use::kStored});
      }
    }
  }
  passes_.push_back(std::make_unique<ComputePass>(device_, options, sampler_));
  return static_cast<int>(passes_.size()) - 1;
}

void PassSequence::Run(const std::function<void(VkCommandBuffer)>& record) {
  run_.clear();
  commands_.Run(record);
}

// Each time is from the end of the pass before, or of what came before the first.
void PassSequence::Record(VkCommandBuffer commands, int pass, const void* numbers,
                          std::size_t set) {
  if (pass < 0) return;
  if (run_.empty()) commands_.Timestamp(commands);
  const ComputePass& recorded = *passes_[static_cast<std::size_t>(pass)];
  recorded.Record(commands, numbers, set);
  commands_.Timestamp(commands);
  run_.push_back(recorded.name());
}

std::vector<PassTime> PassSequence::Times() const {
  const std::vector<double> intervals = commands_.Intervals();
  std::vector<PassTime> times;
  for (std::size_t i = 0; i < intervals.size(); ++i) times.push_back({run_[i], intervals[i]});
  return times;
}

}  // namespace warplut
