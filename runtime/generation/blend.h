// The last pass: frames 0 and 1, warped to the generated frame, become its colour.
#pragma once

#include "runtime/generation/generation_job.h"

namespace warplut::generation {

// Weights of R, G and B in the brightness that T_B is compared with. Source: ITU-R BT.709-6, section 3.
inline constexpr float kBrightnessWeights[3] = {0.2126f, 0.7152f, 0.0722f};

struct Rgb {
  float c[3];
};

inline float Brightness(const Rgb& v) {
  return kBrightnessWeights[0] * v.c[0] + kBrightnessWeights[1] * v.c[1] +
         kBrightnessWeights[2] * v.c[2];
}

// Share of frame 1 at pixel (x, y), whose motion and warped colours are given: InterpolationShare of the depths at the source
// positions (those of the nearest pixels) and of the brightness. A source position outside of the image gives way to the other
// one; if both are, the nearer frame in time counts.
float FrameShare(const GenerationJob& job, int x, int y, Vector from0, Vector from1,
                 float brightness0, float brightness1);

// A brightness difference beyond every T_B: what stands for it without a brightness gate.
inline constexpr float kUnlike = 4.0f;

// What the codes or values of a format are divided by to lie in [0, 1].
constexpr float ChannelScale(PixelFormat format) {
  return format == PixelFormat::kRgba8 ? 255.0f : 1.0f;
}

// A pixel of a display-encoded image, or of a tone-mapped one, limited to [0, 1], NaN as 0; and back.
Rgb LoadRgb(PixelFormat format, const void* pixel);
void StoreRgb(const Rgb& color, PixelFormat format, void* pixel);

// The warped frames and the motion they were warped by; what of them lies in the row that is blended.
struct WarpedFrames {
  ImageView color0, color1;  // extrapolation: color1 alone
  MotionView from0, from1;
};
void BlendRowReference(const GenerationJob& job, const WarpedFrames& warped, int y,
                       const MutableImageView& out);

}  // namespace warplut::generation
