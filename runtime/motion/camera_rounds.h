// What the fit of a camera (runtime/camera_motion.h) and its shader
// (runtime/gpu/shaders/camera.comp) share: its samples and its rounds.
#pragma once

#include <cstdint>

#include "runtime/camera_motion.h"

namespace warplut {

inline constexpr int kCameraUnknowns = 11;
// Rounds after which the samples nearer than the median remain.
inline constexpr int kHalvingRounds = 7;
// The least cut, in pixels: below, motion is exact.
inline constexpr double kLeastCut = 1e-4;
// Inverse depth, in medians, at which a sample counts half.
inline constexpr double kNearMedians = 8;

// The distance of samples, in pixels, on a grid of at most kCameraSamples. The first is at half of
// it in each axis.
constexpr int CameraSampleStep(int width, int height) {
  const auto fits = [&](int step) {
    return std::int64_t{(width + step - 1) / step} * ((height + step - 1) / step) <= kCameraSamples;
  };
  int step = 1;
  while (!fits(step)) ++step;
  return step;
}

}  // namespace warplut
