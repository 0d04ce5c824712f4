#include "tools/vulkan_modes.h"

#include "datasets/error.h"
#include "runtime/gpu/gpu_frame_generation.h"
#include "runtime/gpu/gpu_super_resolution.h"

namespace warplut {
namespace {

class VulkanSuperResolution final : public SuperResolutionPasses {
 public:
  VulkanSuperResolution(const VulkanDevice& device, const SuperResolutionOptions& options,
                        bool makes_geometry)
      : passes_(device, options, {}, makes_geometry) {}

  void Process(const RenderedFrame& frame, const MutableImageView& out) override {
    passes_.Process(frame, out);
  }
  OutputGeometry Geometry() override { return passes_.Geometry(); }
  void SetRenderSize(int, int) override {
    throw Error("the render size varies; the GPU has super resolution of one size");
  }

 private:
  GpuSuperResolution passes_;
};

class VulkanFrameGeneration final : public FrameGenerationPasses {
 public:
  VulkanFrameGeneration(const VulkanDevice& device, const FrameGenerationOptions& options,
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

std::unique_ptr<SuperResolutionPasses> VulkanModes::MakeSuperResolution(
    const SuperResolutionOptions& options, bool makes_geometry) {
  std::string why;
  if (!GpuSuperResolution::IsRunnable(device_, options, &why)) throw Error(why);
  return std::make_unique<VulkanSuperResolution>(device_, options, makes_geometry);
}

std::unique_ptr<FrameGenerationPasses> VulkanModes::MakeFrameGeneration(
    const FrameGenerationOptions& options, PixelFormat color) {
  std::string why;
  if (!GpuFrameGeneration::IsRunnable(device_, options, &why)) throw Error(why);
  return std::make_unique<VulkanFrameGeneration>(device_, options, color);
}

}  // namespace warplut
