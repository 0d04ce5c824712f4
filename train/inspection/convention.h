// The convention that motion, jitter and depth of a sequence are stored in, as candidates of it
// are compared.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "datasets/sequence/sequence.h"

namespace warplut {

// Which unit a stored number is in. kOutputPixels: pixels of the output grid.
enum class StoredUnit { kPixels, kOutputPixels, kUv, kNdc };

// How motion is stored. The motion of the frame that it leads to or from is, in pixels of the
// render grid and y down,
//   m_c = sign_c pixels_c (scale_c stored_(swapped ? 1 - c : c) + bias_c).
struct MotionConvention {
  std::array<double, 2> scale{1, 1}, bias{0, 0};
  StoredUnit unit = StoredUnit::kPixels;
  bool swapped = false;  // the first channel is y
  bool forward = false;  // stored at the pixels of the earlier of two frames
  bool negated = false;  // from the later frame to the earlier one
  bool y_up = false;
  int frame_offset = 0;  // MotionStream::frame_offset

  std::string DirectionName() const;  // "previous-to-current", ...
  std::string UnitName() const;
  std::string AxesName() const;   // "x, y" or "y, x"
  std::string YName() const;      // "down" or "up"
  std::string FrameName() const;  // "its own", "one late", "one early"
  bool operator==(const MotionConvention&) const = default;
};

// How the jitter offsets of the manifest are to be understood. Offset i of the cycle belongs to
// frame i + shift.
struct JitterConvention {
  bool none = false;  // the frames are not jittered by them
  bool negated_x = false, negated_y = false, swapped = false;
  StoredUnit unit = StoredUnit::kPixels;
  int shift = 0;

  std::string SignName() const;
  std::string AxesName() const;
  std::string UnitName() const;
  std::string FrameName() const;
  bool operator==(const JitterConvention&) const = default;
};

// The answer of the manifest.
MotionConvention StatedMotion(const Sequence& sequence);

// Every candidate; the stated one is the first. `encoded`: the stored values may be 0.5 + v / 2.
std::vector<MotionConvention> MotionCandidates(const Sequence& sequence, bool encoded);
std::vector<JitterConvention> JitterCandidates(const Sequence& sequence);

// Pixels of the render grid of one unit, in x and y, without signs.
std::array<double, 2> PixelsPer(StoredUnit unit, GridSize render, GridSize output);

// The offsets of one cycle, as `convention` understands those of the sequence.
std::vector<Vec2> JitterOf(const Sequence& sequence, const JitterConvention& convention);

// How depth is stored.
struct DepthConvention {
  bool nearer_is_larger = false;
  bool hyperbolic = false;  // linear in 1 / view depth
  std::string OrderName() const;
  std::string CurveName() const;
};
DepthConvention StatedDepth(const DepthStream& depth);

}  // namespace warplut
