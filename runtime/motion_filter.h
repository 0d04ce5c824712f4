// Takes quantisation and noise out of the motion of what stands still.
//
// The motion of a still point depends on the camera, its pixel and its depth alone (runtime/camera_motion.h). The camera is
// fitted to the frame's motion; where it explains a motion vector within `limit` the vector is replaced by the camera's, elsewhere
// (moving objects) it is left as it is, to the bit. Per axis,
//   limit = min(options.limit, kNoiseToLimit * median |input motion - camera's motion|),
// so that the pass measures the noise itself: exact motion is as good as unchanged, and motion that no
// camera explains is changed by options.limit at most. Subnormals count as zero
// (runtime/float_environment.h).
#pragma once

#include <string>

#include "luts/visibility.h"
#include "runtime/camera_motion.h"
#include "runtime/executor.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// Safeguards above the bound by the noise, which decides wherever it is less: for super resolution, and for frames that others are
// generated between, which move farther (2 did better than 1 there: docs/GENERATION.md).
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

  // depth: R32F, treated as in RenderedFrame; motion, out: of one size with it; `out` may be `motion`. A vector that is not
  // finite is copied. Input is assumed to be checked. The same bits for any executor.
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
