// What the benchmarks of whole frames share: a synthetic frame, its sizes, how results are compared
// and told.
#pragma once

#include <string>

#include "runtime/frame_generation.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"

namespace warplut {

struct BenchSize {
  int width, height;
};
inline constexpr BenchSize kBenchSizes[] = {{1280, 720}, {1920, 1080}};

// The names of BenchSceneOptions::uniform.
inline constexpr const char* kBenchMotions[] = {"smooth", "uniform"};

struct BenchSceneOptions {
  int width = 0, height = 0;
  PixelFormat format = PixelFormat::kRgba8;
  bool uniform = false;     // one motion for all pixels, else another at every pixel
  float output_scale = 1;   // motion is that of an image so many times larger
  bool discs_part = false;  // the discs move the other way (not if uniform)
};

// Waves behind a grid of discs that are nearer.
class BenchScene {
 public:
  explicit BenchScene(const BenchSceneOptions& options);

  // With a jitter that depends on the index.
  RenderedFrame Rendered(int index) const;
  DisplayedFrame Displayed() const;

 private:
  void FillPixel(int x, int y);

  BenchSceneOptions options_;
  ImageBuffer color_, depth_;
  MotionBuffer motion_;
};

// The share of pixels of which a channel differs by more than `bound` code values of 8 bits. The
// images have one size and format.
double FlippedShare(const ImageView& a, const ImageView& b, float bound);

}  // namespace warplut
