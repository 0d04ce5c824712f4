#include "tools/gpu_modes.h"

#include "runtime/gpu/gpu_frame_generation.h"
#include "runtime/gpu/gpu_super_resolution.h"

namespace warplut {
namespace {

class SuperResolutionOnGpu final : public SuperResolutionPasses {
 public:
  SuperResolutionOnGpu(const GpuDevice& device, const SuperResolutionOptions& options,
                       bool makes_geometry)
      : passes_(device, options, {}, makes_geometry) {}

  void Process(const RenderedFrame& frame, const MutableImageView& out) override {
    passes_.Process(frame, out);
  }
  OutputGeometry Geometry() override { return passes_.Geometry(); }
  void SetRenderSize(int width, int height) override { passes_.SetRenderSize(width, height); }

 private:
  GpuSuperResolution passes_;
};

class FrameGenerationOnGpu final : public FrameGenerationPasses {
 public:
  FrameGenerationOnGpu(const GpuDevice& device, const FrameGenerationOptions& options,
                       PixelFormat color)
      : passes_(device, options, GeneratedFormat(color)) {}

  void Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out) override {
    passes_.Interpolate(frame0, frame1, alpha, out);
  }
  void Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out) override {
    passes_.Extrapolate(frame0, frame1, alpha, out);
  }

 private:
  GpuFrameGeneration passes_;
};

}  // namespace

bool GpuModes::IsRunnable(const SuperResolutionOptions& options, std::string* why) const {
  return GpuSuperResolution::IsRunnable(device_, options, why);
}

bool GpuModes::IsRunnable(const FrameGenerationOptions& options, std::string* why) const {
  return GpuFrameGeneration::IsRunnable(device_, options, why);
}

std::unique_ptr<SuperResolutionPasses> GpuModes::MakeSuperResolution(
    const SuperResolutionOptions& options, bool makes_geometry) {
  return std::make_unique<SuperResolutionOnGpu>(device_, options, makes_geometry);
}

std::unique_ptr<FrameGenerationPasses> GpuModes::MakeFrameGeneration(
    const FrameGenerationOptions& options, PixelFormat color) {
  return std::make_unique<FrameGenerationOnGpu>(device_, options, color);
}

}  // namespace warplut
