// Removes quantisation and noise from the motion of surfaces that stand still.
//
// The motion of a still point depends on the camera, its pixel and its depth alone
// (runtime/camera_motion.h). The camera is fitted to the frame's motion. A vector that it explains
// within `limit` is replaced by the camera's. Other vectors (moving objects) keep their bits. Per
// axis,
//   limit = min(options.limit, kNoiseToLimit * median |input motion - camera's motion|),
// so that the pass measures the noise itself. Exact motion is as good as unchanged, and motion that
// no camera explains changes by options.limit at most. Subnormals count as zero
// (runtime/float_environment.h).
#pragma once

#include <string>

#include "luts/visibility.h"
#include "runtime/camera_motion.h"
#include "runtime/executor.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// Largest limits, in pixels, for super resolution and for frame generation, whose frames move
// farther. The bound by the noise decides wherever it is less.
inline constexpr float kMotionFilterLimit = 4;
inline constexpr float kGenerationMotionFilterLimit = 2;

struct MotionFilterOptions {
  float limit = kMotionFilterLimit;  // the largest change of a component, pixels; in (0, 16]

  // Otherwise *why (if not null) names the option and its range.
  bool IsValid(std::string* why = nullptr) const;
};

class MotionFilter {
 public:
  // Allocates every buffer; the size and the options must be valid.
  MotionFilter(int width, int height, const MotionFilterOptions& options);

  // depth is R32F, treated as in RenderedFrame. motion and out have its size; `out` may be
  // `motion`. Vectors that are not finite are copied. Input is assumed to be checked. Any executor
  // gives the same bits.
  void Apply(const ImageView& depth, const MotionView& motion, Executor& executor,
             const MutableMotionView& out);

  // The same, one pixel after the other in double.
  static void Reference(const ImageView& depth, const MotionView& motion,
                        const MotionFilterOptions& options, const MutableMotionView& out);

  std::size_t MemoryBytes() const { return fit_.MemoryBytes(); }

 private:
  MotionFilterOptions options_;
  CameraFit fit_;
};

}  // namespace warplut
