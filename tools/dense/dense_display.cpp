#include "tools/dense/dense_display.h"

#include <utility>

#include "datasets/jitter.h"
#include "runtime/method.h"
#include "tools/terminal/interrupt.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

// A position in every pixel, at an offset from its centre.
std::vector<Vec2> PixelPositions(const DenseWorld& world, const Vec2& offset) {
  std::vector<Vec2> positions;
  positions.reserve(static_cast<std::size_t>(world.width) * world.height);
  for (int y = 0; y < world.height; ++y) {
    for (int x = 0; x < world.width; ++x) {
      positions.push_back({x + 0.5 + offset.x, y + 0.5 + offset.y});
    }
  }
  return positions;
}

// The streams of samples, row after row.
struct SampledFrame {
  Image color, depth, motion;

  SampledFrame(const std::vector<SceneSample>& samples, int width, int height)
      : color(width, height, 3), depth(width, height, 1), motion(width, height, 2) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) color.data[3 * i + c] = samples[i].color[c];
      depth.data[i] = samples[i].depth;
      for (std::size_t c = 0; c < 2; ++c) motion.data[2 * i + c] = samples[i].motion[c];
    }
  }
};

class FrameMaker {
 public:
  virtual ~FrameMaker() = default;
  virtual Image Make(const DenseWorld& world, int index) = 0;
};

class OneSampleMaker final : public FrameMaker {
 public:
  Image Make(const DenseWorld& world, int index) override {
    const auto samples = world.trace(index, PixelPositions(world, {}));
    return SampledFrame(samples, world.width, world.height).color;
  }
};

class TaaMaker final : public FrameMaker {
 public:
  TaaMaker(const DenseWorld& world, int held)
      : held_(held),
        taa_(Options(world), executor_),
        out_(world.width, world.height, PixelFormat::kRgba32F) {}

  Image Make(const DenseWorld& world, int index) override {
    const Vec2 jitter = jitter_[static_cast<std::size_t>(index / held_) % jitter_.size()];
    const auto positions = PixelPositions(world, jitter);
    const SampledFrame frame(
        held_ == 1 ? world.trace(index, positions) : world.trace_slow(index, positions),
        world.width, world.height);
    const ImageBuffer color = ToBuffer(frame.color, PixelFormat::kRgba32F);
    const ImageBuffer depth = ToBuffer(frame.depth, PixelFormat::kR32F);
    const MotionBuffer motion = ToMotionBuffer(frame.motion);
    taa_.Process({color, depth, motion.view(), static_cast<float>(jitter.x),
                  static_cast<float>(jitter.y), false},
                 out_.view());
    return ToImage(std::as_const(out_).view());
  }

 private:
  static SuperResolutionOptions Options(const DenseWorld& world) {
    SuperResolutionOptions options;
    FindMethod("taau")->configure_super_resolution(options);
    options.render_width = options.output_width = world.width;
    options.render_height = options.output_height = world.height;
    return options;
  }

  int held_;
  std::vector<Vec2> jitter_ = JitterCycle(1);
  ThreadPool executor_;
  SuperResolution taa_;
  ImageBuffer out_;
};

class DenseMaker final : public FrameMaker {
 public:
  DenseMaker(const DenseWorld& world, const DenseOptions& options)
      : dense_(options, executor_), out_(world.width, world.height, PixelFormat::kRgba32F) {}

  Image Make(const DenseWorld& world, int index) override {
    const int columns = world.width / kBlockSize, rows = world.height / kBlockSize;
    std::vector<Vec2> positions;
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const DenseSample at = dense_.Next(x, y);
        positions.push_back({at.x + 0.5 + at.dx, at.y + 0.5 + at.dy});
      }
    }
    const SampledFrame sampled(world.trace(index, positions), columns, rows);
    const ImageBuffer color = ToBuffer(sampled.color, PixelFormat::kRgba32F);
    const MotionBuffer motion = ToMotionBuffer(sampled.motion);
    dense_.Process({color, motion.view(), false}, out_.view());
    return ToImage(std::as_const(out_).view());
  }

 private:
  ThreadPool executor_;
  DenseRendering dense_;
  ImageBuffer out_;
};

std::unique_ptr<FrameMaker> MakerOf(const DenseWorld& world, const DenseDisplay& display) {
  switch (display.shading) {
    case DenseShading::kOneSample:
      return std::make_unique<OneSampleMaker>();
    case DenseShading::kTaa:
      return std::make_unique<TaaMaker>(world, display.held);
    case DenseShading::kDense:
      break;
  }
  DenseOptions options = display.dense;
  options.width = world.width;
  options.height = world.height;
  return std::make_unique<DenseMaker>(world, options);
}

}  // namespace

std::vector<DenseDisplay> ComparedDisplays(const DenseOptions& dense) {
  const auto with = [&](OrderRule rule, bool reproject) {
    DenseOptions options = dense;
    options.order = rule;
    options.reproject = reproject;
    return options;
  };
  return {
      {"60 Hz, one sample", DenseShading::kOneSample, kSlowStep, {}},
      {"60 Hz, TAA", DenseShading::kTaa, kSlowStep, {}},
      {"240 Hz, dense, hourglass", DenseShading::kDense, 1, with(OrderRule::kHourglass, true)},
      {"240 Hz, dense, bowtie", DenseShading::kDense, 1, with(OrderRule::kBowtie, true)},
      {"240 Hz, dense, adaptive", DenseShading::kDense, 1, with(OrderRule::kMixed, true)},
      {"240 Hz, dense, not reprojected", DenseShading::kDense, 1, with(OrderRule::kMixed, false)},
      {"240 Hz, one sample", DenseShading::kOneSample, 1, {}},
  };
}

std::vector<Image> ShownFrames(const DenseWorld& world, const DenseDisplay& display,
                               int subframes) {
  const auto maker = MakerOf(world, display);
  std::vector<Image> shown;
  for (int i = 0; i < subframes; ++i) {
    ThrowIfInterrupted("dense", "nothing was printed");
    shown.push_back(i % display.held == 0 ? maker->Make(world, i) : shown.back());
  }
  return shown;
}

}  // namespace warplut
