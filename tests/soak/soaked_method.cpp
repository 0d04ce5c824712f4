#include "tests/soak/soaked_method.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/golden/golden_scene.h"
#include "train/replay/image_views.h"
#include "train/replay/mode_run.h"

namespace warplut {
namespace {

// `reference` may be empty.
void Judge(const ImageView& image, const ImageView& reference, ShownValues* shown) {
  double error = 0;
  for (int y = 0; y < image.height; ++y) {
    const float* row = image.Row<float>(y);
    const float* wanted = reference.width > 0 ? reference.Row<float>(y) : nullptr;
    for (int i = 0; i < 4 * image.width; ++i) {
      if (i % 4 == 3) continue;
      shown->finite = shown->finite && std::isfinite(row[i]);
      shown->least = std::min(shown->least, row[i]);
      shown->largest = std::max(shown->largest, row[i]);
      if (wanted != nullptr) error += std::abs(static_cast<double>(row[i]) - wanted[i]);
    }
  }
  if (reference.width == 0) return;
  shown->error += error / (3.0 * image.width * image.height);
  ++shown->judged;
}

}  // namespace

SoakedMethod::SoakedMethod(const MethodInfo& method, const Table& table, Executor& executor)
    : method_(method), frame_(GoldenFrame()) {
  const Clip clip = GoldenClip(2);
  constexpr PixelFormat kColor = PixelFormat::kRgba32F;
  const GridSize grid = clip.output;
  for (Display& display : displays_) {
    display.color = ImageBuffer(grid.width, grid.height, kColor);
    display.depth = ImageBuffer(grid.width, grid.height, PixelFormat::kR32F);
    display.motion = MotionBuffer(grid.width, grid.height);
  }
  generated_ = ImageBuffer(grid.width, grid.height, kColor);
  ModeRunOptions options;
  options.method = &method;
  options.shown_format = kColor;
  options.super_resolution.warp = options.generation.warp = {
      .filter = Filter::kLut, .table = &table, .lookup = Lookup::kBilinear};
  if (method.super_resolution) {
    super_resolution_.emplace(EffectiveSuperResolution(clip, options), executor);
  }
  if (method.configure_generation != nullptr) {
    generation_.emplace(EffectiveGeneration(clip, options), executor);
  }
}

void SoakedMethod::MakeDisplay(ShownValues* shown) {
  Display& now = displays_[1];
  if (!super_resolution_) {
    CopyPixels(frame_.reference.view(), now.color.view());
    CopyPixels(frame_.reference_depth.view(), now.depth.view());
    CopyMotion(frame_.reference_motion.view(), now.motion.view());
  } else {
    super_resolution_->Process(frame_.Rendered(), now.color.view());
    Judge(now.color.view(), frame_.reference.view(), shown);
    if (generation_) {
      const OutputGeometry geometry = super_resolution_->Geometry();
      CopyPixels(geometry.depth, now.depth.view());
      CopyMotion(geometry.motion, now.motion.view());
    }
  }
  now.frame = {.color = now.color.view(),
               .depth = now.depth.view(),
               .motion = now.motion.view(),
               .cut = frame_.cut,
               .id = static_cast<std::uint64_t>(number_) + 1};
}

void SoakedMethod::Advance(ShownValues* shown) {
  std::swap(displays_[0], displays_[1]);
  RenderGoldenFrame(number_, frame_);
  MakeDisplay(shown);
  if (generation_ && number_ > 0) {
    const DisplayedFrame& frame0 = displays_[0].frame;
    const DisplayedFrame& frame1 = displays_[1].frame;
    if (method_.generation == Generation::kInterpolation) {
      generation_->Interpolate(frame0, frame1, 0.5F, generated_.view());
    } else {
      generation_->Extrapolate(frame0, frame1, 0.5F, generated_.view());
    }
    Judge(generated_.view(), {}, shown);
  }
  ++number_;
}

}  // namespace warplut
