// Counts of a frame's tiles by kind: the work that the passes left out.
#pragma once

#include <cstdint>

#include "luts/visibility.h"
#include "runtime/warp.h"

namespace WARPLUT_PUBLIC warplut {

struct FrameTiles {
  std::int64_t total = 0;  // tiles of the frame (runtime/motion_tiles.h)
  // Tiles that were warped, by the kind of their motion: static and whole ones are copied, uniform
  // ones have one set of weights. Interpolation warps two frames and counts both.
  WarpStats warped;
  std::int64_t disoccluded =
      0;  // tiles with pixels whose source is not known; only these are searched or shown anew

  FrameTiles& operator+=(const FrameTiles& other) {
    total += other.total;
    warped += other.warped;
    disoccluded += other.disoccluded;
    return *this;
  }
};

}  // namespace warplut
