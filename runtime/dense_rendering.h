// Temporally dense rendering: one sample per 2 x 2 pixels and subframe, at four times the rate, and
// a displayed frame of every subframe. Andersson et al., Temporally Dense Ray Tracing, High
// Performance Graphics 2019; docs/METHODS.md tells what of it is here and what not.
//
// A block is 2 x 2 pixels. A subframe has one sample of each block; four subframes are a cycle and
// have each pixel once, in the block's order. A pixel whose sample is that of this subframe is new,
// others are old. Each pixel keeps its last samples and the motion of the last one.
//
// Process composes the displayed frame. m is the longest motion among the pixels around
// (motion_radius), the first in row order of equal ones; a pixel is static if |m| is at most
// `static_motion`, else dynamic.
//   static, sampled since it is  the mean of its samples since then, up to window of them
//   new and dynamic              its sample
//   all others                   the displayed frame before at p - m, bilinear, limited to mean +-
//                                gamma sigma of the new samples among the 8 pixels around; that
//                                mean where p - m lies outside the image, or there is no frame
//                                before
// Pixels that are averaged are sampled at one of four offsets, by the number of the cycle; others
// at their centres.
// After each cycle every block gets its order for the next one (runtime/dense_order.h), by the
// longest motion around its pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "luts/visibility.h"
#include "runtime/dense_order.h"
#include "runtime/executor.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

inline constexpr int kBlockSize = 2;          // pixels of a block in each axis
inline constexpr int kSubframesPerCycle = 4;  // so many pixels are in a block
inline constexpr int kLargestMotionRadius = 3;

struct DenseOptions {
  int width = 0, height = 0;  // of the displayed frame, even
  OrderRule order = OrderRule::kMixed;
  int motion_radius = 1;  // 0 to kLargestMotionRadius: 1 is 3 x 3 pixels
  int window = 4;         // samples that a static pixel averages, 1 to 4
  bool reproject = true;  // false: old dynamic pixels stay as they were displayed, not limited
  DenseParameters parameters;
  bool reference = false;  // run the plain version of the composition

  // Otherwise *why (if not null) names the option and its range.
  bool IsValid(std::string* why = nullptr) const;
};

// Where a block is sampled: the pixel, and the offset from its centre in pixels, in (-1/2, 1/2).
struct DenseSample {
  int x = 0, y = 0;
  float dx = 0, dy = 0;
};

// What was sampled; both views have a pixel for each block, width / 2 x height / 2.
//   color   RGBA8, RGBA16F or RGBA32F of display values; alpha is ignored; NaN and infinite
//           channels count as 0, others are limited to [0, 1].
//   motion  pixels of the displayed frame, from the subframe before to this one, of what the sample
//           shows (in a mirror, what is reflected). A vector with a NaN or infinite component has
//           no history.
struct Subframe {
  ImageView color;
  MotionView motion;
  bool cut = false;  // shares nothing with the subframe before
};

class DenseRendering {
 public:
  // Allocates every buffer. The options must be valid. The executor outlives the object; any
  // executor gives the same bits.
  DenseRendering(const DenseOptions& options, Executor& executor);
  ~DenseRendering();

  // The sample that the next subframe has of block (x, y), 0 <= x < width / 2, 0 <= y < height / 2.
  DenseSample Next(int x, int y) const;
  // The order of that block in the cycle of the next subframe.
  BlockOrder Order(int x, int y) const;

  // Composes the displayed frame; allocates nothing. One thread calls it at a time. `out` is RGBA8,
  // RGBA16F or RGBA32F, width x height; its alpha becomes 1. IsProcessable checks both.
  void Process(const Subframe& subframe, const MutableImageView& out);
  bool IsProcessable(const Subframe& subframe, const MutableImageView& out, std::string* why) const;

  // Forgets all subframes and begins a cycle.
  void Reset();

  // Bytes of all buffers.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
