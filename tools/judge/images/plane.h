// Offline images as the views that the metrics take.
#pragma once

#include "datasets/image.h"
#include "train/metrics/ssim.h"

namespace warplut {

// A 1-channel image without `border` pixels at each edge; at least one pixel must remain.
inline PlaneView InnerPlane(const Image& image, int border) {
  return {.data = image.data.data() + image.Index(border, border),
          .width = image.width - 2 * border,
          .height = image.height - 2 * border,
          .stride = image.width};
}

}  // namespace warplut
