// One call of frame generation as its passes see it, and what they share.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "runtime/configuration/chosen.h"
#include "runtime/frame_generation.h"
#include "runtime/generation/splat_key.h"
#include "runtime/image_buffer.h"
#include "runtime/motion/point_carrier.h"

namespace warplut::generation {

struct Vector {
  float x = 0;
  float y = 0;
};

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator*(float s, Vector v) { return {s * v.x, s * v.y}; }

inline bool IsFinite(Vector v) { return warplut::IsFinite(v.x) && warplut::IsFinite(v.y); }

// Depth as the passes compare it: NaN, negative and infinite values are kFarthestDepth, -0 is 0.
inline float CleanDepth(float depth) {
  return depth >= 0.0f && depth <= kFarthestDepth ? depth + 0.0f : kFarthestDepth;
}

// Input is checked before (FrameGeneration::IsGenerable).
struct GenerationJob {
  const FrameGenerationOptions& options;
  bool interpolates;  // else extrapolates
  float alpha;
  bool motion0_counts;  // frame 0 is no cut and its motion is read
  ImageView depth0, depth1;
  MotionView motion0, motion1;
  // Of a reprojection: null without cameras, or where all stands still (StillSurface::column).
  const PointCarrier* carrier = nullptr;
  const std::int32_t* still_column = nullptr;

  // The two as the build contains them.
  bool Interpolates() const {
    return kPipeline.interpolation && (interpolates || !kPipeline.extrapolation);
  }
  bool CountsMotion0() const {
    return (warplut::Contains(kPipeline.generation.motion_model, MotionModel::kQuadratic) ||
            warplut::Contains(kPipeline.generation.motion_model, MotionModel::kPerspective)) &&
           motion0_counts;
  }
  // Whether the path is that of MotionModel::kPerspective; where frame 0 is a cut it is linear.
  bool FollowsPerspective() const {
    return CountsMotion0() && ModelOf(options) == MotionModel::kPerspective;
  }
  // From frame 0 on, in units of the time between frames 0 and 1.
  float time() const { return Interpolates() ? alpha : 1.0f + alpha; }

  int width() const { return options.width; }
  int height() const { return options.height; }
  float depth_threshold() const { return options.parameters.generation_depth_threshold; }
  float brightness_threshold() const {
    return CodeContrast(EncodingOf(options)) * options.parameters.brightness_threshold;
  }

  bool Contains(int x, int y) const { return x >= 0 && x < width() && y >= 0 && y < height(); }
};

inline float DepthAt(const ImageView& depth, int x, int y) {
  return CleanDepth(depth.Row<float>(y)[x]);
}

// Bits of a depth whose order as integers is that of CleanDepth: what that makes kFarthestDepth is
// above all numbers.
inline std::uint32_t DepthBits(float depth) { return std::bit_cast<std::uint32_t>(depth + 0.0f); }

// The least DepthAt of the 3 x 3 pixels around (x, y) that lie in the image.
inline float LeastDepthAround(const ImageView& depth, int x, int y) {
  std::uint32_t least = DepthBits(kFarthestDepth);
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, depth.height - 1); ++j) {
    const float* row = depth.Row<float>(j);
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, depth.width - 1); ++i) {
      least = std::min(least, DepthBits(row[i]));
    }
  }
  return std::bit_cast<float>(least);
}

inline Vector MotionAt(const MotionView& motion, int x, int y) {
  const float* row = motion.Row(y);
  return {row[2 * x], row[2 * x + 1]};
}

inline void SetMotion(const MutableMotionView& motion, int x, int y, Vector v) {
  float* row = motion.Row(y);
  row[2 * x] = v.x;
  row[2 * x + 1] = v.y;
}

// The pixel whose centre is nearest to pixel (x, y) moved by d, halves towards the lower right;
// {-1, -1} outside of the image or where d is not finite.
struct PixelIndex {
  int x, y;
};
inline PixelIndex NearestPixel(const GenerationJob& job, int x, int y, Vector d) {
  const float fx = std::floor(static_cast<float>(x) + d.x + 0.5f);
  const float fy = std::floor(static_cast<float>(y) + d.y + 0.5f);
  const bool inside = fx >= 0.0f && fx < static_cast<float>(job.width()) && fy >= 0.0f &&
                      fy < static_cast<float>(job.height());
  return inside ? PixelIndex{static_cast<int>(fx), static_cast<int>(fy)} : PixelIndex{-1, -1};
}

// Rows [first, last).
struct RowRange {
  int first;
  int last;
};

// Splat keys, one row after the other.
struct KeyView {
  SplatKey* keys;
  int width;

  SplatKey* Row(int y) const { return keys + static_cast<std::size_t>(y) * width; }
};

}  // namespace warplut::generation
