// Warps in plain C++: a history as floats with a border, and samplers that read around a position.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "runtime/core/pixel.h"
#include "runtime/image_view.h"

namespace warplut {

// Four channels; the loops over them become one vector operation.
struct alignas(16) PlainTexel {
  std::array<float, 4> c{};

  PlainTexel& Add(float weight, const PlainTexel& texel) {
    for (int i = 0; i < 4; ++i) c[i] += weight * texel.c[i];
    return *this;
  }
};

// How far from its cell a sampler may read: taps -(kPlainReach - 1) .. kPlainReach.
inline constexpr int kPlainReach = 3;

class PlainHistory {
 public:
  explicit PlainHistory(const ImageView& image)
      : width_(image.width),
        height_(image.height),
        row_(image.width + 2 * kBorder),
        texels_(static_cast<std::size_t>(row_) * (image.height + 2 * kBorder)) {
    for (int y = -kBorder; y < height_ + kBorder; ++y) {
      const int from_y = std::clamp(y, 0, height_ - 1);
      for (int x = -kBorder; x < width_ + kBorder; ++x) {
        const void* pixel = image.At(std::clamp(x, 0, width_ - 1), from_y);
        PlainTexel& texel = texels_[Index(x, y)];
        for (int c = 0; c < Channels(image.format); ++c) {
          texel.c[static_cast<std::size_t>(c)] = LoadChannel(image.format, pixel, c);
        }
      }
    }
  }

  const PlainTexel& At(int x, int y) const { return texels_[Index(x, y)]; }
  // The cell from which every tap reads what clamped coordinates read.
  int CellX(float floor_x) const { return Cell(floor_x, width_); }
  int CellY(float floor_y) const { return Cell(floor_y, height_); }

 private:
  static constexpr int kBorder = 2 * kPlainReach + 1;

  static int Cell(float floor, int size) {
    return static_cast<int>(std::clamp(floor, static_cast<float>(-kPlainReach - 1),
                                       static_cast<float>(size + kPlainReach - 1)));
  }
  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y + kBorder) * static_cast<std::size_t>(row_) +
           static_cast<std::size_t>(x + kBorder);
  }

  int width_, height_, row_;
  std::vector<PlainTexel> texels_;
};

// out(p) = sampler(history, x, y, dx, dy) with p - m = texel (x, y) + (dx, dy), d in [0, 1). Motion
// is finite.
template <class Sampler>
void PlainWarp(const ImageView& image, const MotionView& motion, Sampler sampler,
               const MutableImageView& out) {
  const PlainHistory history(image);
  for (int y = 0; y < out.height; ++y) {
    const float* m = motion.Row(y);
    for (int x = 0; x < out.width; ++x, m += 2) {
      // The fraction of -m alone: adding p first would round it.
      const float floor_x = std::floor(-m[0]), floor_y = std::floor(-m[1]);
      const PlainTexel texel =
          sampler(history, history.CellX(static_cast<float>(x) + floor_x),
                  history.CellY(static_cast<float>(y) + floor_y), -m[0] - floor_x, -m[1] - floor_y);
      void* to = out.At(x, y);
      for (int c = 0; c < Channels(out.format); ++c) {
        StoreChannel(out.format, texel.c[static_cast<std::size_t>(c)], to, c);
      }
    }
  }
}

}  // namespace warplut
