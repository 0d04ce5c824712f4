// The maker of a run's passes: the processor, or another device that has the same passes.
#pragma once

#include <memory>
#include <string>

#include "runtime/executor.h"
#include "runtime/frame_generation.h"
#include "runtime/super_resolution.h"

namespace warplut {

// SuperResolution on some device.
class SuperResolutionPasses {
 public:
  virtual ~SuperResolutionPasses() = default;
  virtual void Process(const RenderedFrame& frame, const MutableImageView& out) = 0;
  virtual OutputGeometry Geometry() = 0;
  // SuperResolution::SetRenderSize.
  virtual void SetRenderSize(int width, int height) = 0;
  // All 0 where the device does not count.
  virtual FrameTiles Tiles() const { return {}; }
};

// FrameGeneration on some device.
class FrameGenerationPasses {
 public:
  virtual ~FrameGenerationPasses() = default;
  virtual void Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                           const MutableImageView& out) = 0;
  virtual void Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                           const MutableImageView& out) = 0;
  virtual FrameTiles Tiles() const { return {}; }
};

class ModeDevice {
 public:
  virtual ~ModeDevice() = default;
  // As --device takes it.
  virtual const std::string& name() const = 0;
  // Whether the device has passes for valid options; otherwise *why is a sentence.
  virtual bool IsRunnable(const SuperResolutionOptions& options, std::string* why) const = 0;
  virtual bool IsRunnable(const FrameGenerationOptions& options, std::string* why) const = 0;
  // For runnable options. `makes_geometry`: Geometry will be called.
  virtual std::unique_ptr<SuperResolutionPasses> MakeSuperResolution(
      const SuperResolutionOptions& options, bool makes_geometry) = 0;
  // `color` is the format of the frames' colours.
  virtual std::unique_ptr<FrameGenerationPasses> MakeFrameGeneration(
      const FrameGenerationOptions& options, PixelFormat color) = 0;
};

// The runtime's own passes.
class ProcessorDevice final : public ModeDevice {
 public:
  // The executor outlives what is made.
  explicit ProcessorDevice(Executor& executor) : executor_(executor) {}

  const std::string& name() const override;
  bool IsRunnable(const SuperResolutionOptions&, std::string*) const override { return true; }
  bool IsRunnable(const FrameGenerationOptions&, std::string*) const override { return true; }
  std::unique_ptr<SuperResolutionPasses> MakeSuperResolution(const SuperResolutionOptions& options,
                                                             bool makes_geometry) override;
  std::unique_ptr<FrameGenerationPasses> MakeFrameGeneration(const FrameGenerationOptions& options,
                                                             PixelFormat color) override;

 private:
  Executor& executor_;
};

}  // namespace warplut
