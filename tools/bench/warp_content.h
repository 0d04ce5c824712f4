// Images, motion and tables that the warp is timed on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "luts/contract.h"
#include "runtime/image_view.h"

namespace warplut {

struct WarpImage {
  WarpImage(int width, int height, PixelFormat format)
      : bytes(static_cast<std::size_t>(width) * height * BytesPerPixel(format)),
        view{bytes.data(), width, height, std::ptrdiff_t{width} * BytesPerPixel(format), format} {}
  WarpImage(const WarpImage&) = delete;
  WarpImage& operator=(const WarpImage&) = delete;

  ImageView Const() const { return {view.data, view.width, view.height, view.stride, view.format}; }

  std::vector<std::byte> bytes;
  MutableImageView view;
};

struct WarpMotion {
  WarpMotion(int width, int height) : xy(static_cast<std::size_t>(width) * height * 2) {
    view = {xy.data(), width, height,
            std::ptrdiff_t{width} * 2 * static_cast<std::ptrdiff_t>(sizeof(float))};
  }
  WarpMotion(const WarpMotion&) = delete;
  WarpMotion& operator=(const WarpMotion&) = delete;

  std::vector<float> xy;
  MotionView view;
};

// Smooth waves with some noise, so that neither all texels nor all weights are alike.
void FillWarpImage(const WarpImage& image);

// Kinds of motion: "smooth", "uniform", "whole", "static" (warp_benchmark.h).
void FillWarpMotion(const std::string& kind, WarpMotion& motion);

// A table in i16 with exact row sums, of Catmull-Rom weights or a wide kernel's: the time does not
// depend on the weights.
std::vector<std::int16_t> MakeWarpTable(Footprint footprint);

}  // namespace warplut
