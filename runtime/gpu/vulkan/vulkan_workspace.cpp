#include "runtime/gpu/vulkan/vulkan_workspace.h"

namespace warplut {
namespace {

constexpr int kMostTimestamps = 24;

VkSampler MakeSampler(const VulkanDevice& device, VkFilter filter) {
  const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                    .pNext = nullptr,
                                    .flags = 0,
                                    .magFilter = filter,
                                    .minFilter = filter,
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

VulkanWorkspace::VulkanWorkspace(const VulkanDevice& device, PixelFormat format)
    : device_(device),
      format_(format),
      samplers_{MakeSampler(device, VK_FILTER_NEAREST), MakeSampler(device, VK_FILTER_LINEAR)},
      commands_(device, kMostTimestamps) {}

VulkanWorkspace::~VulkanWorkspace() {
  vkDestroySampler(device_.handle(), samplers_.nearest, nullptr);
  vkDestroySampler(device_.handle(), samplers_.linear, nullptr);
}

void VulkanWorkspace::Allocate() {
  resources_.emplace(device_, images(), buffers());
  Run([&] {
    for (const VulkanImage& image : resources_->images()) PrepareImage(recorded_, image);
  });
}

int VulkanWorkspace::AddPass(const PassPlan& plan) {
  passes_.push_back(std::make_unique<VulkanPass>(device_, *resources_, plan,
                                                 SpirvOf(plan.shader, format_), samplers_));
  return static_cast<int>(passes_.size()) - 1;
}

void VulkanWorkspace::Run(const std::function<void()>& record) {
  run_.clear();
  commands_.Run([&](VkCommandBuffer commands) {
    recorded_ = commands;
    record();
  });
}

// Each time is from the end of the pass before, or of what came before the first.
void VulkanWorkspace::RecordGrid(int pass, const void* numbers, std::size_t set, int width,
                                 int height) {
  if (pass < 0) return;
  if (run_.empty()) commands_.Timestamp(recorded_);
  const VulkanPass& recorded = *passes_[static_cast<std::size_t>(pass)];
  recorded.Record(recorded_, numbers, set, width, height);
  commands_.Timestamp(recorded_);
  run_.push_back(recorded.plan().name);
}

void VulkanWorkspace::CopyToCorner(int buffer, int image, int width, int height) {
  warplut::CopyToImage(recorded_, resources_->buffer(buffer), resources_->image(image), width,
                       height);
}

void VulkanWorkspace::CopyToBuffer(int image, int buffer) {
  warplut::CopyToBuffer(recorded_, resources_->image(image), resources_->buffer(buffer));
}

void VulkanWorkspace::FillBuffer(int buffer, std::uint32_t value) {
  warplut::FillBuffer(recorded_, resources_->buffer(buffer), value);
}

std::vector<PassTime> VulkanWorkspace::Times() const {
  const std::vector<double> intervals = commands_.Intervals();
  std::vector<PassTime> times;
  for (std::size_t i = 0; i < intervals.size(); ++i) times.push_back({run_[i], intervals[i]});
  return times;
}

}  // namespace warplut
