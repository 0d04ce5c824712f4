// Frames of a scene in motion: a textured square that passes before a textured wall, under a camera
// that pans.
#pragma once

#include <cmath>
#include <cstdint>

#include "runtime/frame_generation.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"

namespace warplut {

class MovingScene {
 public:
  MovingScene(int width, int height)
      : width_(width),
        height_(height),
        color_(width, height, PixelFormat::kRgba8),
        depth_(width, height, PixelFormat::kR32F),
        motion_(width, height) {}

  void Render(int frame) {
    jitter_ = frame % 2 == 0 ? 0.25f : -0.25f;
    const double pan = 1.25 * frame, left = width_ / 4.0 + 2.5 * frame;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const bool square =
            x >= left && x < left + width_ / 4.0 && y > height_ / 4 && y < height_ / 2;
        const double u = x + jitter_ - (square ? left : pan);
        const double v = y - jitter_;
        auto* pixel = static_cast<std::uint8_t*>(color_.view().At(x, y));
        for (int c = 0; c < 3; ++c) {
          pixel[c] = static_cast<std::uint8_t>(127.5 + 100 * std::sin(0.9 * u + 0.4 * c) *
                                                           std::cos(0.7 * v));
        }
        pixel[3] = 255;
        depth_.view().Row<float>(y)[x] = square ? 0.2f : 0.6f;
        motion_.view().Row(y)[2 * x] = square ? 2.5f : 1.25f;
      }
    }
  }

  RenderedFrame Rendered() const {
    return {color_.view(), depth_.view(), motion_.view(), jitter_, -jitter_, false};
  }
  DisplayedFrame Displayed() const { return {color_.view(), depth_.view(), motion_.view(), false}; }

 private:
  int width_, height_;
  float jitter_ = 0;
  ImageBuffer color_, depth_;
  MotionBuffer motion_;
};

}  // namespace warplut
