// The last pass: frames 0 and 1, warped to the generated frame, become its colour.
#pragma once

#include <algorithm>

#include "luts/luma_weights.h"
#include "runtime/color_encoding.h"
#include "runtime/core/pixel.h"
#include "runtime/generation/generation_job.h"

namespace warplut::generation {

// Weights of R, G and B in the brightness that T_B is compared with.
inline constexpr float kBrightnessWeights[3] = {static_cast<float>(kLumaWeights[0]),
                                                static_cast<float>(kLumaWeights[1]),
                                                static_cast<float>(kLumaWeights[2])};

struct Rgb {
  float c[3];
};

inline float Brightness(const Rgb& v) {
  return kBrightnessWeights[0] * v.c[0] + kBrightnessWeights[1] * v.c[1] +
         kBrightnessWeights[2] * v.c[2];
}

// Share of frame 1 at pixel (x, y), whose motion and warped colours are given: InterpolationShare
// of the depths at the source positions and of the brightness. The depth is the least of the 3 x 3
// pixels around: pixels beside the foreground hold some of its colour, and where the other frame
// shows the background clear of it that frame is taken. A source position outside of the image
// gives way to the other one; if both are, the nearer frame in time counts.
float FrameShare(const GenerationJob& job, int x, int y, Vector from0, Vector from1,
                 float brightness0, float brightness1);

// A brightness difference beyond every T_B: what stands for it without a brightness gate.
inline constexpr float kUnlike = 4.0f;

// A pixel of a display-encoded image, or of codes, limited to [0, 1], NaN as 0; of a linear HDR
// image, limited as LimitHdr does; and back.
inline Rgb LoadRgb(PixelFormat format, const void* pixel) {
  Rgb color;
  for (int i = 0; i < 3; ++i) {
    const float value = LoadChannel(format, pixel, i) * (1.0f / ChannelScale(format));
    color.c[i] = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
  }
  return color;
}
inline Rgb LoadHdr(PixelFormat format, const void* pixel) {
  Rgb color;
  for (int i = 0; i < 3; ++i) {
    color.c[i] = LimitHdr(LoadChannel(format, pixel, i) * (1.0f / ChannelScale(format)));
  }
  return color;
}
inline void StoreRgb(const Rgb& color, PixelFormat format, void* pixel) {
  for (int i = 0; i < 3; ++i) StoreChannel(format, color.c[i] * ChannelScale(format), pixel, i);
  StoreChannel(format, ChannelScale(format), pixel, 3);
}

// The warped frames and the motion they were warped by; what of them lies in the row that is
// blended.
struct WarpedFrames {
  ImageView color0, color1;  // extrapolation: color1 alone
  MotionView from0, from1;
};
void BlendRowReference(const GenerationJob& job, const WarpedFrames& warped, int y,
                       const MutableImageView& out);

}  // namespace warplut::generation
