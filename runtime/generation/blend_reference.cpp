#include "runtime/generation/blend.h"

namespace warplut::generation {

float FrameShare(const GenerationJob& job, int x, int y, Vector from0, Vector from1,
                 float brightness0, float brightness1) {
  const PixelIndex p0 = NearestPixel(job, x, y, {-from0.x, -from0.y});
  const PixelIndex p1 = NearestPixel(job, x, y, {-from1.x, -from1.y});
  if (p0.x < 0 && p1.x < 0) return job.alpha >= 0.5f ? 1.0f : 0.0f;
  if (p0.x < 0) return 1.0f;
  if (p1.x < 0) return 0.0f;
  const float depth =
      DepthDifference(DepthOf(job.options), LeastDepthAround(job.depth0, p0.x, p0.y),
                      LeastDepthAround(job.depth1, p1.x, p1.y));
  const float brightness = GatesBrightness(job.options) ? brightness0 - brightness1 : kUnlike;
  return InterpolationShare(depth, brightness, job.alpha, job.depth_threshold(),
                            job.brightness_threshold(), job.options.gate_width);
}

void BlendRowReference(const GenerationJob& job, const WarpedFrames& warped, int y,
                       const MutableImageView& out) {
  for (int x = 0; x < job.width(); ++x) {
    Rgb color = LoadRgb(warped.color1.format, warped.color1.At(x, y));
    if (job.Interpolates()) {
      const Rgb color0 = LoadRgb(warped.color0.format, warped.color0.At(x, y));
      const float share =
          FrameShare(job, x, y, MotionAt(warped.from0, x, y), MotionAt(warped.from1, x, y),
                     Brightness(color0), Brightness(color));
      for (int i = 0; i < 3; ++i) {
        color.c[i] = color0.c[i] + share * (color.c[i] - color0.c[i]);
      }
    }
    StoreRgb(color, out.format, out.At(x, y));
  }
}

}  // namespace warplut::generation
