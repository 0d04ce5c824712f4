// Temporal upscaling after FSR 2 (docs/METHODS.md): its numbers, its kernel, its locks.
//
// State of an output pixel, SrJob::next_state: lifetime of the lock, shading of the lock, lumas of
// the last frame and the one before.
#pragma once

#include <algorithm>
#include <cmath>

#include "luts/luma_weights.h"
#include "runtime/peers/sr/lanczos_samples.h"

namespace warplut::peers {

inline constexpr float kLumaStep = 1.0f / 255;     // lumas are rounded to it
inline constexpr float kLockBreak = 0.1f;          // relative change of shading that ends a lock
inline constexpr float kTrustedLock = 4.0f;        // how fast a lock that was confirmed counts
inline constexpr float kUnstableDeviation = 0.1f;  // of luma, where instability counts in full
inline constexpr float kPhasesOfPixel = 8.0f;      // of the jitter, for each render pixel at x1
inline constexpr int kShadingTile = 8;             // samples in each axis

// Lanczos' kernel of two lobes, (25/16 (2/5 t - 1)^2 - 9/16) (t/4 - 1)^2 for t = (d bias)^2 up to
// 4.
inline float Fsr2Kernel(float t) {
  const float s = std::min(t, 4.0f);
  const float a = 0.4f * s - 1, b = 0.25f * s - 1;
  return (25.0f / 16 * a * a - 9.0f / 16) * (b * b);
}

// As kernels sum it, without fused operations.
inline float LumaOf(float r, float g, float b) {
  return static_cast<float>(kLumaWeights[0]) * r + static_cast<float>(kLumaWeights[1]) * g +
         static_cast<float>(kLumaWeights[2]) * b;
}

// The lesser part of the greater; 1 for two zeros.
inline float LumaRatio(float a, float b) {
  const float greater = std::max(a, b);
  return greater > 0 ? std::min(a, b) / greater : 1.0f;
}

// Whether sample (i, j) lies on a thin feature: it is brighter or darker than all of its 8
// neighbours that are not alike, and no 2 x 2 samples that hold it are alike. Alike: lumas in a
// ratio below `ratio`.
bool IsThinFeature(const SrJob& job, int i, int j, float ratio);

// Mean lumas of the tiles of kShadingTile x kShadingTile samples that hold the samples of row j, as
// one value for each sample of the row. They tell changes of light from features that the jitter
// hits or misses. `sums` has room for a row.
void FillShadingRow(const SrJob& job, int j, float* sums, float* shading);

// What is taken off the lifetime of a lock with each frame: it lasts for one cycle of the jitter.
inline float LockDecay(const SrJob& job) {
  return 1.0f / (kPhasesOfPixel * job.x.scale() * job.y.scale());
}

// Limits the predicted pixel (x, y), whose history is all valid, to the 2 x 2 texels of the history
// around its source.
void LimitToTexels(const SrJob& job, const MotionView& motion, int x, int y);

}  // namespace warplut::peers
