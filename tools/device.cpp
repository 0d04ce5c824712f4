#include "tools/device.h"

#include <fmt/format.h>

#include "datasets/error.h"

#ifdef WARPLUT_HAS_GPU
#include "tools/vulkan_modes.h"
#endif

namespace warplut {
namespace {

constexpr const char* kCpu = "cpu";
constexpr const char* kVulkan = "vulkan";

#ifdef WARPLUT_HAS_GPU
// Owns the device that its passes run on.
class OpenedVulkan final : public ModeDevice {
 public:
  std::unique_ptr<SuperResolutionPasses> MakeSuperResolution(const SuperResolutionOptions& options,
                                                             bool makes_geometry) override {
    return modes_.MakeSuperResolution(options, makes_geometry);
  }
  std::unique_ptr<FrameGenerationPasses> MakeFrameGeneration(const FrameGenerationOptions& options,
                                                             PixelFormat color) override {
    return modes_.MakeFrameGeneration(options, color);
  }

 private:
  VulkanDevice device_;
  VulkanModes modes_{device_};
};
#endif

}  // namespace

std::vector<std::string> DeviceNames() { return {kCpu, kVulkan}; }

void CheckDevice([[maybe_unused]] const std::string& device) {
#ifndef WARPLUT_HAS_GPU
  if (device == kCpu) return;
  throw Error(fmt::format("this build has no passes for the device {}; expected {}", device, kCpu));
#endif
}

std::unique_ptr<ModeDevice> OpenDevice([[maybe_unused]] const std::string& device) {
#ifdef WARPLUT_HAS_GPU
  if (device == kVulkan) return std::make_unique<OpenedVulkan>();
#endif
  return nullptr;
}

}  // namespace warplut
