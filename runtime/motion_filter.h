// Takes quantisation and noise out of motion vectors: a guided filter whose guide is inverse depth.
//
// Under a moving camera the motion of what stands still is, in a neighbourhood, linear in 1 / depth. In the window around each
// pixel m = A (1 / z) + B is fitted by least squares, A and B are averaged over the windows that hold the pixel, and the motion is
// A (1 / z) + B there. Source: He, Sun, Tang, "Guided image filtering", 2010, with the guide of warplut.
#pragma once

#include <string>

#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/image_view.h"

namespace warplut {

struct MotionFilterOptions {
  int radius = 16;  // window of (2 radius + 1)^2 pixels, cut at the borders; in [1, 64]

  bool IsValid(std::string* why = nullptr) const;
};

class MotionFilter {
 public:
  MotionFilter(int width, int height, const MotionFilterOptions& options);

  // depth: R32F as in RenderedFrame; motion, out: of one size with it; `out` may be `motion`. Pixels whose motion is not
  // finite have no part in any window and are copied.
  void Apply(const ImageView& depth, const MotionView& motion, Executor& executor,
             const MutableMotionView& out);

  // The same, slowly: direct sums in double.
  static void Reference(const ImageView& depth, const MotionView& motion,
                        const MotionFilterOptions& options, const MutableMotionView& out);

  std::size_t MemoryBytes() const;

 private:
  MotionFilterOptions options_;
  RowBuffer sums_, coefficients_;
};

}  // namespace warplut
