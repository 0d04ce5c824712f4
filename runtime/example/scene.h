// Stands for a renderer in the examples: a wall that moves, a disc in front of it, exact motion.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"

namespace example {

// Colours of the wall and of the disc in [0, 1]. (x, y) are output pixels on their own surface.
inline std::array<float, 3> WallColor(double x, double y) {
  const double rings = std::sin(0.003 * (x * x + y * y)), bars = std::sin(1.3 * x + 0.5 * y);
  return {static_cast<float>(0.5 + 0.3 * rings + 0.1 * bars),
          static_cast<float>(0.5 + 0.35 * rings), static_cast<float>(0.5 + 0.3 * bars)};
}
inline std::array<float, 3> DiscColor(double x, double y) {
  const double weave = std::sin(0.8 * x) * std::sin(0.9 * y);
  return {static_cast<float>(0.7 + 0.3 * weave), static_cast<float>(0.6 + 0.2 * weave), 0.2f};
}

// Writes a channel in [0, 1] to RGBA8 or RGBA32F.
inline void Store(const warplut::MutableImageView& image, int x, int y, int channel, float value) {
  if (image.format == warplut::PixelFormat::kRgba8) {
    image.Row<std::uint8_t>(y)[4 * x + channel] =
        static_cast<std::uint8_t>(std::lround(255 * value));
  } else {
    image.Row<float>(y)[4 * x + channel] = value;
  }
}
inline float Load(const warplut::ImageView& image, int x, int y, int channel) {
  return image.format == warplut::PixelFormat::kRgba8
             ? static_cast<float>(image.Row<std::uint8_t>(y)[4 * x + channel]) / 255
             : image.Row<float>(y)[4 * x + channel];
}

// PSNR over RGB in dB, without 16 pixels at each edge. Both are RGBA8 or RGBA32F.
inline double Psnr(const warplut::ImageView& a, const warplut::ImageView& b) {
  constexpr int kMargin = 16;
  double sum = 0, count = 0;
  for (int y = kMargin; y < a.height - kMargin; ++y) {
    for (int x = kMargin; x < a.width - kMargin; ++x) {
      for (int c = 0; c < 3; ++c, ++count) sum += std::pow(Load(a, x, y, c) - Load(b, x, y, c), 2);
    }
  }
  return -10 * std::log10(sum / count);
}

// The wall alone, moved by so many pixels in x and y.
inline void DrawWall(double moved, const warplut::MutableImageView& image) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto color =
          WallColor(x + 0.5 - image.width / 2 - moved, y + 0.5 - image.height / 2 - moved);
      for (int c = 0; c < 3; ++c) Store(image, x, y, c, color[c]);
      Store(image, x, y, 3, 1);
    }
  }
}

// The same motion in every pixel.
inline void FillMotion(float x, float y, const warplut::MutableMotionView& motion) {
  for (int row = 0; row < motion.height; ++row) {
    for (int i = 0; i < motion.width; ++i) {
      motion.Row(row)[2 * i] = x;
      motion.Row(row)[2 * i + 1] = y;
    }
  }
}

class Scene {
 public:
  Scene(int render_width, int render_height, int output_width, int output_height)
      : scale_(static_cast<double>(output_width) / render_width),
        color_(render_width, render_height, warplut::PixelFormat::kRgba32F),
        depth_(render_width, render_height, warplut::PixelFormat::kR32F),
        motion_(render_width, render_height),
        reference_(output_width, output_height, warplut::PixelFormat::kRgba8) {}

  // Frame `index`: one sample in each pixel, at its centre plus the jitter. Its views end at the
  // next call.
  warplut::RenderedFrame Render(int index) {
    const warplut::MutableImageView color = color_.view(), depth = depth_.view();
    const warplut::MutableMotionView motion = motion_.view();
    const int phase = index % 32 + 1;
    const double jitter_x = Halton(phase, 2) - 0.5, jitter_y = Halton(phase, 3) - 0.5;
    for (int y = 0; y < color.height; ++y) {
      for (int x = 0; x < color.width; ++x) {
        const Sample sample =
            At((x + 0.5 + jitter_x) * scale_, (y + 0.5 + jitter_y) * scale_, index);
        for (int c = 0; c < 3; ++c) Store(color, x, y, c, sample.color[c]);
        depth.Row<float>(y)[x] = sample.depth;
        motion.Row(y)[2 * x] = static_cast<float>(sample.speed[0] / scale_);
        motion.Row(y)[2 * x + 1] = static_cast<float>(sample.speed[1] / scale_);
      }
    }
    return {.color = color,
            .depth = depth,
            .motion = motion,
            .jitter_x = static_cast<float>(jitter_x),
            .jitter_y = static_cast<float>(jitter_y),
            .cut = index == 0};
  }

  // The image that should be displayed at `time` (in frames): the mean of 4 x 4 samples in each
  // output pixel. Its view ends at the next call.
  warplut::ImageView Reference(double time) {
    const warplut::MutableImageView image = reference_.view();
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        std::array<float, 3> mean = {};
        for (int i = 0; i < 16; ++i) {
          const Sample sample = At(x + (i % 4 + 0.5) / 4, y + (i / 4 + 0.5) / 4, time);
          for (int c = 0; c < 3; ++c) mean[c] += sample.color[c] / 16;
        }
        for (int c = 0; c < 3; ++c) Store(image, x, y, c, mean[c]);
        Store(image, x, y, 3, 1);
      }
    }
    return image;
  }

 private:
  struct Sample {
    std::array<float, 3> color;
    float depth;                  // in units of the far plane
    std::array<double, 2> speed;  // output pixels per frame, y down
  };

  // The radical inverse of n in base b, in (0, 1).
  static double Halton(int n, int b) {
    double value = 0;
    for (double digit = 1.0 / b; n > 0; n /= b, digit /= b) value += digit * (n % b);
    return value;
  }

  Sample At(double x, double y, double time) const {
    constexpr std::array<double, 2> kWall = {1.37, 0.41}, kDisc = {-2.15, 0.8};
    const warplut::ImageView image = reference_.view();
    const double dx = x - image.width * 0.7 - kDisc[0] * time;
    const double dy = y - image.height * 0.4 - kDisc[1] * time;
    if (std::hypot(dx, dy) < image.height * 0.2) return {DiscColor(dx, dy), 0.1f, kDisc};
    const double wall_x = x - image.width * 0.5 - kWall[0] * time;
    const double wall_y = y - image.height * 0.5 - kWall[1] * time;
    return {WallColor(wall_x, wall_y), 0.5f, kWall};
  }

  double scale_;
  warplut::ImageBuffer color_, depth_;
  warplut::MotionBuffer motion_;
  warplut::ImageBuffer reference_;
};

}  // namespace example
