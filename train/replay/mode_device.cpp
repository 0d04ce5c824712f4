#include "train/replay/mode_device.h"

namespace warplut {
namespace {

class ProcessorSuperResolution final : public SuperResolutionPasses {
 public:
  ProcessorSuperResolution(const SuperResolutionOptions& options, Executor& executor)
      : passes_(options, executor) {}

  void Process(const RenderedFrame& frame, const MutableImageView& out) override {
    passes_.Process(frame, out);
  }
  OutputGeometry Geometry() override { return passes_.Geometry(); }
  void SetRenderSize(int width, int height) override { passes_.SetRenderSize(width, height); }
  FrameTiles Tiles() const override { return passes_.Tiles(); }

 private:
  SuperResolution passes_;
};

class ProcessorFrameGeneration final : public FrameGenerationPasses {
 public:
  ProcessorFrameGeneration(const FrameGenerationOptions& options, Executor& executor)
      : passes_(options, executor) {}

  void Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out) override {
    passes_.Interpolate(frame0, frame1, alpha, out);
  }
  void Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out) override {
    passes_.Extrapolate(frame0, frame1, alpha, out);
  }
  FrameTiles Tiles() const override { return passes_.Tiles(); }

 private:
  FrameGeneration passes_;
};

}  // namespace

const std::string& ProcessorDevice::name() const {
  static const std::string name = "cpu";
  return name;
}

std::unique_ptr<SuperResolutionPasses> ProcessorDevice::MakeSuperResolution(
    const SuperResolutionOptions& options, bool) {
  return std::make_unique<ProcessorSuperResolution>(options, executor_);
}

std::unique_ptr<FrameGenerationPasses> ProcessorDevice::MakeFrameGeneration(
    const FrameGenerationOptions& options, PixelFormat) {
  return std::make_unique<ProcessorFrameGeneration>(options, executor_);
}

}  // namespace warplut
