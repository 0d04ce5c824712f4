// The passes of a run on a GPU.
#pragma once

#include "runtime/gpu/gpu_device.h"
#include "train/replay/mode_device.h"

namespace warplut {

// Frames pass through the memory of the processor from one object to the other, as displayed frames
// do between SuperResolution and FrameGeneration.
class GpuModes final : public ModeDevice {
 public:
  // `name` is that of --device. The device outlives what is made.
  GpuModes(std::string name, const GpuDevice& device) : name_(std::move(name)), device_(device) {}

  const std::string& name() const override { return name_; }
  bool IsRunnable(const SuperResolutionOptions& options, std::string* why) const override;
  bool IsRunnable(const FrameGenerationOptions& options, std::string* why) const override;
  std::unique_ptr<SuperResolutionPasses> MakeSuperResolution(const SuperResolutionOptions& options,
                                                             bool makes_geometry) override;
  std::unique_ptr<FrameGenerationPasses> MakeFrameGeneration(const FrameGenerationOptions& options,
                                                             PixelFormat color) override;

 private:
  std::string name_;
  const GpuDevice& device_;
};

}  // namespace warplut
