// The gates and the blend of the pipeline: one formula each, for float, for double and for
// derivative types.
//
// A gate compares a difference with a threshold. Shipped gates are hard (width 0). Calibration uses
// the same gates with a finite width, as a hard gate is flat almost everywhere.
#pragma once

#include <algorithm>
#include <cstdint>

#include "luts/visibility.h"
#include "runtime/float_bits.h"

namespace WARPLUT_PUBLIC warplut {

// 1 where x <= threshold, 0 beyond; with width w > 0 a ramp from 1 at threshold (1 - w) to 0 at
// threshold (1 + w). A NaN x is beyond. threshold >= 0, w in [0, 1].
template <class T>
T Gate(T x, T threshold, T width) {
  if (IsNan(x)) return T(0);
  const T half = threshold * width;
  if (!(half > T(0))) return x <= threshold ? T(1) : T(0);
  const T share = (threshold + half - x) / (half + half);
  return share > T(0) ? (share < T(1) ? share : T(1)) : T(0);
}

// Depths are at least 0, and at most this where they were infinite or NaN: differences of depths
// are numbers.
inline constexpr float kFarthestDepth = 1e30f;

// The measure that T_D bounds. kAbsolute: the difference in units of the far plane (the paper's).
// kRelative: the difference divided by the lesser depth, which stays meaningful where far depth is
// coarse. kNone: nothing is rejected.
enum class DepthMeasure : std::uint8_t { kNone, kAbsolute, kRelative };

constexpr const char* Name(DepthMeasure measure) {
  switch (measure) {
    case DepthMeasure::kNone:
      return "none";
    case DepthMeasure::kAbsolute:
      return "absolute";
    case DepthMeasure::kRelative:
      return "relative";
  }
  return "";
}

// Signed difference a - b of two depths in [0, kFarthestDepth], in the units of the measure; 0 for
// kNone.
template <class T>
T DepthDifference(DepthMeasure measure, T a, T b) {
  switch (measure) {
    case DepthMeasure::kNone:
      return T(0);
    case DepthMeasure::kAbsolute:
      return a - b;
    case DepthMeasure::kRelative: {
      const T lesser = std::max(std::min(a, b), T(1e-12));
      return (a - b) / lesser;
    }
  }
  return T(0);
}

// Share of one sample at `distance` (render pixels) from the pixel centre: w_s = max(0, 1 - b d).
// Equation 2 of the paper, limited to 0 from below.
template <class T>
T SampleWeight(T b, T distance) {
  const T weight = T(1) - b * distance;
  return weight > T(0) ? weight : T(0);
}

// Share of the current frame: min(1, a * mean weight).
template <class T>
T BlendShare(T a, T mean_weight) {
  const T share = a * mean_weight;
  return share < T(1) ? share : T(1);
}

// Share of frame 1 in an interpolated pixel at time alpha in (0, 1): equation 1 of the paper.
// depth_difference is DepthDifference(D0, D1); the farther frame shows the revealed background.
//   depth_difference > T_D                 frame 0
//   depth_difference < -T_D                frame 1
//   |brightness_difference| <= T_B         the nearer frame in time (frame 1 from alpha = 1/2 on)
//   else                                   a linear blend
template <class T>
T InterpolationShare(T depth_difference, T brightness_difference, T alpha, T depth_threshold,
                     T brightness_threshold, T width) {
  const T frame0 = T(1) - Gate(depth_difference, depth_threshold, width);
  const T frame1 = T(1) - Gate(-depth_difference, depth_threshold, width);
  const T alike =
      Gate(brightness_difference < T(0) ? -brightness_difference : brightness_difference,
           brightness_threshold, width);
  const T nearer = alpha >= T(0.5) ? T(1) : T(0);
  const T blended = alike * nearer + (T(1) - alike) * alpha;
  return frame1 + (T(1) - frame0 - frame1) * blended;
}

}  // namespace warplut
