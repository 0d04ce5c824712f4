// The surface of a pixel of frame 1 in frame 0, read between the pixels of frame 0: what the
// perspective motion model takes of it.
#pragma once

#include <algorithm>

#include "runtime/generation/generation_job.h"

namespace warplut::generation {

// Taps belong to one surface if their depths differ by at most this, relative to the lesser one.
inline constexpr float kSurfaceTolerance = 0.1f;

// No depth that is divided by is less. What depths give depends on their ratios alone, above this.
inline constexpr float kLeastSurfaceDepth = 1e-12f;

// Paths whose depth over that of frame 1 is less pass the camera.
inline constexpr float kLeastDepthRatio = 1.0f / 16;

// A depth that can be divided by.
inline float NotZero(float depth) { return std::max(depth, kLeastSurfaceDepth); }

struct SurfaceBefore {
  Vector motion;    // m0
  float ratio = 1;  // z0 / z1
  float gate = 0;   // how far m0 counts; with 0 there is no such surface and ratio is 1
};

// At p0 = p1 - m1, given that m1 is finite. Of the four pixels of frame 0 around p0 (those of the
// border beyond it) count those whose motion is finite and whose depth is within kSurfaceTolerance
// of the anchor's. The anchor is, of those with a weight, the one whose depth is nearest to z1, the
// first of equals. m0 is bilinear among them, z0 in 1 / z, which is linear on the screen for a
// plane; where all depths are equal z0 is that depth to the bit. The gate is that of
// |DepthDifference| of z0 and z1. It is 0 where p0 is outside of the image.
SurfaceBefore FindSurfaceBefore(const GenerationJob& job, int x, int y, Vector m1);

}  // namespace warplut::generation
