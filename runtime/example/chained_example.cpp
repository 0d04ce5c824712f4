// Super resolution, then interpolation: 12 frames of 160 x 90 become 23 of 320 x 180.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "luts/baked/warplut_iir_x2.h"
#include "runtime/executor.h"
#include "runtime/frame_generation.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"
#include "scene.h"

namespace {

using namespace warplut;
constexpr int kWidth = 320, kHeight = 180;

// A displayed frame with buffers of its own. Two of them are in use at a time.
struct Display {
  ImageBuffer color{kWidth, kHeight, PixelFormat::kRgba8};
  ImageBuffer depth{kWidth, kHeight, PixelFormat::kR32F};
  MotionBuffer motion{kWidth, kHeight};
  DisplayedFrame frame;
};

void CopyGeometry(const OutputGeometry& from, Display& to) {
  for (int y = 0; y < kHeight; ++y) {
    std::memcpy(to.depth.view().Row<float>(y), from.depth.Row<float>(y), kWidth * sizeof(float));
    std::memcpy(to.motion.view().Row(y), from.motion.Row(y), 2 * kWidth * sizeof(float));
  }
}

}  // namespace

int main() {
  constexpr int kFrames = 12;
  const Table table(baked::kWarplutIirX2);
  SuperResolutionOptions options;
  options.render_width = kWidth / 2;
  options.render_height = kHeight / 2;
  options.output_width = kWidth;
  options.output_height = kHeight;
  options.warp = {.filter = Filter::kLut, .table = &table};
  FrameGenerationOptions generation_options;
  generation_options.width = kWidth;
  generation_options.height = kHeight;
  generation_options.warp = options.warp;
  ThreadPool executor;
  SuperResolution super_resolution(options, executor);
  FrameGeneration generation(generation_options, executor);

  example::Scene scene(kWidth / 2, kHeight / 2, kWidth, kHeight);
  Display displays[2];
  ImageBuffer between(kWidth, kHeight, PixelFormat::kRgba8);
  for (int i = 0; i < kFrames; ++i) {
    Display& now = displays[i % 2];
    const Display& before = displays[(i + 1) % 2];
    const RenderedFrame rendered = scene.Render(i);
    super_resolution.Process(rendered, now.color);
    const OutputGeometry geometry = super_resolution.Geometry();
    CopyGeometry(geometry, now);  // its views end at the next Process
    now.frame = {.color = now.color.view(),
                 .depth = now.depth.view(),
                 .motion = now.motion.view(),
                 .cut = geometry.cut,
                 .id = static_cast<std::uint64_t>(i) + 1};
    if (i == 0) continue;
    generation.Interpolate(before.frame, now.frame, 0.5f, between);  // show `between`, then `now`
  }
  std::printf("interpolated, frame %.1f: PSNR %.2f dB\n", kFrames - 1.5,
              example::Psnr(between, scene.Reference(kFrames - 1.5)));
}
