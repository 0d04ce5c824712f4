// The passes of a run on a GPU.
#pragma once

#include "runtime/gpu/vulkan_device.h"
#include "train/replay/mode_device.h"

namespace warplut {

// Frames pass through the memory of the processor from one object to the other, as displayed frames
// do between SuperResolution and FrameGeneration.
class VulkanModes final : public ModeDevice {
 public:
  // The device outlives what is made.
  explicit VulkanModes(const VulkanDevice& device) : device_(device) {}

  std::unique_ptr<SuperResolutionPasses> MakeSuperResolution(const SuperResolutionOptions& options,
                                                             bool makes_geometry) override;
  std::unique_ptr<FrameGenerationPasses> MakeFrameGeneration(const FrameGenerationOptions& options,
                                                             PixelFormat color) override;

 private:
  const VulkanDevice& device_;
};

}  // namespace warplut
