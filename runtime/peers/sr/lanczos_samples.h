// What sgsr2 and fsr2 share (docs/METHODS.md): how they weigh samples, how fast a pixel moves, and
// how its history is limited and blended.
//
// d is the distance of a sample in render pixels, |m| the motion in output pixels.
#pragma once

#include <algorithm>
#include <cmath>

#include "runtime/peers/sr/neighbourhood.h"

namespace warplut::peers {

inline constexpr float kMostKernelBias = 1.99f;  // kernels are no narrower than at factor 2
// The box weighs a sample by exp(curve d^2), curve from the first to the second as |m| rises to
// kCurveMotion.
inline constexpr float kStillCurve = -2.0f, kMovingCurve = -3.0f, kCurveMotion = 50.0f;
inline constexpr float kBoxMotion = 20.0f;   // |m| from which the box is one standard deviation
inline constexpr float kStillMotion = 0.1f;  // |m| from which the history weighs 10 samples most
inline constexpr float kMovingSamples = 10.0f;
inline constexpr float kLimitedWeight = 0.1f;  // of history that had to be limited, at most
// A history that leaves the range of the samples by less is inside.
inline constexpr float kRangeSlack = 0x1p-10f;
inline constexpr float kLeastWeight = 0.01f;  // of samples that count

inline float Saturate(float v) { return std::clamp(v, 0.0f, 1.0f); }

// Length of the motion at an output pixel, in output pixels; 0 where there is none, or no frame
// that it leads to.
inline float MotionLength(const SrJob& job, int x, int y) {
  if (!job.HasHistory()) return 0.0f;
  const int i = job.x.nearest()[x], j = job.y.nearest()[y];
  const float mx = job.planes.motion_x.Row(j)[i] * job.x.scale();
  const float my = job.planes.motion_y.Row(j)[i] * job.y.scale();
  const float length = std::sqrt(mx * mx + my * my);
  return IsFinite(length) ? length : 0.0f;
}

// The narrower the kernel the larger the scale.
inline float KernelBias(const SrJob& job) {
  return std::min(std::sqrt(job.x.scale() * job.y.scale()), kMostKernelBias);
}

inline float BoxCurve(float length) {
  return kStillCurve + (kMovingCurve - kStillCurve) * Saturate(length / kCurveMotion);
}

// The weight of the history before it is limited: it falls with motion towards that of 10 times the
// samples, then of the samples.
inline float HistoryWeight(float validity, float weight, float length) {
  const auto towards = [](float from, float to, float t) {
    return std::min(from, from + t * (to - from));
  };
  const float base = towards(validity, kMovingSamples * weight, Saturate(length / kStillMotion));
  return towards(base, weight, Saturate(length / kBoxMotion));
}

}  // namespace warplut::peers
