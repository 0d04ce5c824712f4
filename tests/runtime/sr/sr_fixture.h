// Rendered frames for the tests of super resolution.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "runtime/core/pixel.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"

namespace warplut {

inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A frame that owns its images: grey, at half the far plane, without motion.
class TestFrame {
 public:
  TestFrame(int width, int height, PixelFormat format = PixelFormat::kRgba32F)
      : width_(width),
        height_(height),
        color_(width, height, format),
        depth_(width, height, PixelFormat::kR32F),
        motion_(width, height) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        SetColor(x, y, 0.5f, 0.5f, 0.5f);
        Depth(x, y) = 0.5f;
      }
    }
  }

  RenderedFrame View() const {
    return {color_.view(), depth_.view(), motion_.view(), jitter_x, jitter_y, cut};
  }

  void SetColor(int x, int y, float r, float g, float b) {
    const MutableImageView view = color_.view();
    const float white = ChannelScale(view.format);
    const float channels[4] = {r, g, b, 1.0f};
    for (int c = 0; c < 4; ++c) StoreChannel(view.format, channels[c] * white, view.At(x, y), c);
  }
  float& Depth(int x, int y) { return depth_.view().Row<float>(y)[x]; }
  void SetMotion(int x, int y, float mx, float my) {
    motion_.view().Row(y)[2 * x] = mx;
    motion_.view().Row(y)[2 * x + 1] = my;
  }
  void SetMotion(float mx, float my) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) SetMotion(x, y, mx, my);
    }
  }

  // Random colours and jitter; two surfaces with a slope each that move apart. Broken values: NaN,
  // infinities, negative depth.
  void Randomise(unsigned seed, bool with_broken_values = false) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    const float broken[4] = {kNaN, kInfinity, -kInfinity, -1.0f};
    jitter_x = 2 * value(random) - 1;
    jitter_y = 2 * value(random) - 1;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const bool near = (x / 5 + y / 7) % 2 == 0;
        SetColor(x, y, value(random), value(random), value(random));
        Depth(x, y) = near ? 0.2f + 0.001f * static_cast<float>(x) + 0.002f * value(random)
                           : 0.7f + 0.004f * static_cast<float>(y);
        SetMotion(x, y, near ? 1.3f + 0.1f * value(random) : -0.4f + 0.05f * value(random),
                  near ? -0.7f : 0.3f * value(random));
        if (!with_broken_values || random() % 16 != 0) continue;
        SetColor(x, y, broken[random() % 4], 1.5f, broken[random() % 4]);
        Depth(x, y) = broken[random() % 4];
        SetMotion(x, y, random() % 2 == 0 ? broken[random() % 3] : 0.5f, 0.25f);
      }
    }
  }

  float jitter_x = 0, jitter_y = 0;
  bool cut = false;

 private:
  int width_, height_;
  ImageBuffer color_, depth_;
  MotionBuffer motion_;
};

inline SuperResolutionOptions TestOptions(int render_width, int render_height, int output_width,
                                          int output_height) {
  SuperResolutionOptions options;
  options.render_width = render_width;
  options.render_height = render_height;
  options.output_width = output_width;
  options.output_height = output_height;
  return options;
}

inline ImageBuffer OutputOf(const SuperResolutionOptions& options,
                            PixelFormat format = PixelFormat::kRgba32F) {
  return {options.output_width, options.output_height, format};
}

// Channel c of pixel (x, y) of an RGBA32F image.
inline float At(const ImageBuffer& image, int x, int y, int c) {
  return image.view().Row<float>(y)[4 * x + c];
}

inline bool SameBits(const ImageBuffer& a, const ImageBuffer& b) {
  const ImageView va = a.view();
  const ImageView vb = b.view();
  for (int y = 0; y < va.height; ++y) {
    const auto bytes = static_cast<std::size_t>(va.width) * BytesPerPixel(va.format);
    if (std::memcmp(va.At(0, y), vb.At(0, y), bytes) != 0) return false;
  }
  return true;
}

}  // namespace warplut
