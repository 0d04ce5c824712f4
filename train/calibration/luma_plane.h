// Luma of the runtime's images, as losses see them.
#pragma once

#include <vector>

#include "runtime/color_encoding.h"
#include "runtime/executor.h"
#include "runtime/image_view.h"
#include "train/metrics/ssim.h"

namespace warplut {

struct LumaPlane {
  int width = 0, height = 0;
  std::vector<float> values;  // row by row

  PlaneView view() const { return {values.data(), width, height, width}; }
};

// kLumaWeights (train/metrics/luma.h) of an RGBA image as a display shows it
// (train/metrics/displayed_color.h), 8-bit codes divided by 255.
LumaPlane LumaOf(const ImageView& image, ColorEncoding encoding, Executor& executor);

}  // namespace warplut
