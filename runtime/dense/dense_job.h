// What the plain and the fast composition of temporally dense rendering share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "runtime/dense_rendering.h"

namespace warplut::dense {

// Motion of what has no history: from outside any image, and longer than any that leads into it.
inline constexpr float kNoHistory = 1e6f;

struct Color {
  float c[3];
};

struct Motion {
  float x, y;
  float SquaredLength() const { return x * x + y * y; }
};

// One composition. Colours are RGBA32F, the alpha of `samples` unused.
struct DenseJob {
  const DenseOptions& options;
  std::uint32_t cycle;                    // since the last reset
  int place;                              // of this subframe in the cycle
  bool has_before;                        // a displayed frame
  const BlockOrder* orders;               // width / 2 for each row of blocks
  ImageView samples[kSubframesPerCycle];  // of cycle i modulo 4
  MotionView motion;                      // of the last samples
  ImageView before;
  MutableImageView displayed;
  std::uint8_t* counts;  // of samples that are averaged, width for each row

  BlockOrder OrderAt(int block_x, int block_y) const {
    return orders[static_cast<std::ptrdiff_t>(block_y) * (options.width / 2) + block_x];
  }
  // The place of pixel (x, y) in the cycle.
  int PlaceOf(int x, int y) const {
    return PlaceInOrder(OrderAt(x / 2, y / 2), x % 2 + 2 * (y % 2));
  }
  std::uint8_t& CountAt(int x, int y) const {
    return counts[static_cast<std::ptrdiff_t>(y) * options.width + x];
  }
  Motion MotionAt(int x, int y) const {
    const float* m = motion.Row(y) + 2 * std::ptrdiff_t{x};
    return {m[0], m[1]};
  }
  // The newest sample of a pixel that has one in this cycle.
  const float* NewSample(int x, int y) const {
    return samples[cycle % kSubframesPerCycle].Row<float>(y) + 4 * std::ptrdiff_t{x};
  }
  bool IsDynamic(const Motion& m) const {
    const float limit = options.parameters.static_motion;
    return m.SquaredLength() > limit * limit;
  }
};

// The mean of the last `count` samples of pixel (x, y), the newest first.
inline Color MeanSample(const DenseJob& job, int x, int y, int count) {
  const std::uint32_t newest = job.PlaceOf(x, y) <= job.place ? job.cycle : job.cycle - 1;
  Color sum{};
  for (int i = 0; i < count; ++i) {
    const std::uint32_t slot = (newest - static_cast<std::uint32_t>(i)) % kSubframesPerCycle;
    const float* s = job.samples[slot].Row<float>(y) + 4 * std::ptrdiff_t{x};
    for (int c = 0; c < 3; ++c) sum.c[c] += s[c];
  }
  for (float& c : sum.c) c /= static_cast<float>(count);
  return sum;
}

// The displayed frame before at position p - m of pixel (x, y), bilinear with the edge's pixels
// repeated; false where that lies outside the image.
inline bool Reproject(const DenseJob& job, int x, int y, const Motion& m, Color* color) {
  const int width = job.options.width, height = job.options.height;
  const float u = static_cast<float>(x) - m.x, v = static_cast<float>(y) - m.y;
  const auto inside = [](float t, int size) {
    return t >= -0.5f && t <= static_cast<float>(size) - 0.5f;
  };
  if (!job.has_before || !inside(u, width) || !inside(v, height)) return false;
  const float left = std::floor(u), top = std::floor(v);
  const float fx = u - left, fy = v - top;
  const int x0 = std::max(static_cast<int>(left), 0);
  const int x1 = std::min(static_cast<int>(left) + 1, width - 1);
  const float* row0 = job.before.Row<float>(std::max(static_cast<int>(top), 0));
  const float* row1 = job.before.Row<float>(std::min(static_cast<int>(top) + 1, height - 1));
  for (int c = 0; c < 3; ++c) {
    const float upper = row0[4 * x0 + c] + fx * (row0[4 * x1 + c] - row0[4 * x0 + c]);
    const float lower = row1[4 * x0 + c] + fx * (row1[4 * x1 + c] - row1[4 * x0 + c]);
    color->c[c] = upper + fy * (lower - upper);
  }
  return true;
}

// The sums over the new samples around an old pixel.
struct BoxSums {
  Color sum{}, squares{};
  float count = 0;

  void Add(const float* sample) {
    for (int c = 0; c < 3; ++c) {
      sum.c[c] += sample[c];
      squares.c[c] += sample[c] * sample[c];
    }
    count += 1;
  }
  // `history` limited to the box, or its centre without a history.
  Color Limit(const Color* history, float gamma) const {
    Color result;
    for (int c = 0; c < 3; ++c) {
      const float mean = sum.c[c] / count;
      const float variance = std::max(squares.c[c] / count - mean * mean, 0.0f);
      const float half = gamma * std::sqrt(variance);
      result.c[c] = history == nullptr ? mean : std::clamp(history->c[c], mean - half, mean + half);
    }
    return result;
  }
};

inline void Display(const DenseJob& job, int x, int y, const Color& color) {
  float* out = job.displayed.Row<float>(y) + 4 * std::ptrdiff_t{x};
  std::copy_n(color.c, 3, out);
  out[3] = 1;
}

// The colour of pixel (x, y), whose longest motion is m, displayed; its count is updated.
// add_new_samples(sums) adds those among the 8 pixels around.
template <class AddNewSamples>
void ComposePixel(const DenseJob& job, int x, int y, const Motion& m,
                  const AddNewSamples& add_new_samples) {
  const bool is_new = job.PlaceOf(x, y) == job.place;
  std::uint8_t& count = job.CountAt(x, y);
  const bool dynamic = job.IsDynamic(m);
  if (dynamic) {
    count = 0;
  } else if (is_new) {
    count = static_cast<std::uint8_t>(std::min(count + 1, job.options.window));
  }
  if (count > 0) return Display(job, x, y, MeanSample(job, x, y, count));
  if (is_new) return Display(job, x, y, MeanSample(job, x, y, 1));
  Color history;
  const Motion from = job.options.reproject ? m : Motion{0, 0};
  const bool has_history = Reproject(job, x, y, from, &history);
  if (has_history && !job.options.reproject) return Display(job, x, y, history);
  BoxSums sums;
  add_new_samples(sums);
  Display(job, x, y, sums.Limit(has_history ? &history : nullptr, job.options.parameters.gamma));
}

// The longest motion within `radius` of the pixels [x0, x1] x [y0, y1], the first of equal ones.
Motion LongestMotion(const DenseJob& job, int x0, int y0, int x1, int y1, int radius);

// Rows [begin, end) of the displayed frame.
void ComposeRowsReference(const DenseJob& job, int begin, int end);
// The same bits; `row_longest` holds width motions for each of end - begin + 2 radius rows.
void ComposeRows(const DenseJob& job, int begin, int end, Motion* row_longest);

}  // namespace warplut::dense
