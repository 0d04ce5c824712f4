// The motion filter (runtime/motion_filter.h) as two passes: the camera of a frame by one group of
// threads, then its motion.
#pragma once

#include <vector>

#include "runtime/gpu/frame_numbers.h"
#include "runtime/gpu/gpu_workspace.h"
#include "runtime/gpu/input_conventions.h"

namespace warplut {

// Filtered motion is in pixels of its grid, from the frame before to this one, y down. It has 32
// bits, in a format that every device stores.
inline constexpr TexelFormat kFilteredMotionFormat = TexelFormat::kRgba32F;

// Adds the buffer that hands the camera from the first pass to the second.
int AddCameraBuffer(GpuWorkspace& workspace);

class MotionFilterPasses {
 public:
  MotionFilterPasses() = default;
  // Images of one size: depth and motion as `conventions` say, and the filtered motion, of
  // kFilteredMotionFormat.
  struct Images {
    int depth, motion, filtered;
  };
  // `limit` is that of MotionFilterOptions. After Allocate.
  MotionFilterPasses(float limit, const InputConventions& conventions, int camera,
                     const std::vector<Images>& sets, GpuWorkspace& workspace);

  // The first width x height pixels of the images. Nothing where there are no passes.
  void Record(std::size_t set, int width, int height, GpuWorkspace& workspace) const;

 private:
  int camera_ = -1, filter_ = -1;
  MotionFilterNumbers numbers_ = {};
};

}  // namespace warplut
