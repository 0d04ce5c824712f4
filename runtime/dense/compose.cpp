#include "runtime/dense/dense_job.h"

namespace warplut::dense {
namespace {

void TakeLonger(const Motion& m, Motion& longest) {
  if (m.SquaredLength() > longest.SquaredLength()) longest = m;
}

// The longest motion of each pixel of row y and its neighbours in the row.
void LongestInRow(const DenseJob& job, int y, Motion* longest) {
  const int width = job.options.width, radius = job.options.motion_radius;
  for (int x = 0; x < width; ++x) {
    longest[x] = {0, 0};
    for (int u = std::max(x - radius, 0); u <= std::min(x + radius, width - 1); ++u) {
      TakeLonger(job.MotionAt(u, y), longest[x]);
    }
  }
}

struct Pixel {
  int x, y;
};

// The new pixel of a block.
Pixel NewPixel(const DenseJob& job, int block_x, int block_y) {
  const int i = PlaceInOrder(job.OrderAt(block_x, block_y), job.place);
  return {2 * block_x + i % 2, 2 * block_y + i / 2};
}

// The 8 pixels around (x, y) lie in 2 x 2 blocks, each of which has one new pixel.
void AddNewSamples(const DenseJob& job, int x, int y, BoxSums& sums) {
  const int columns = job.options.width / 2, rows = job.options.height / 2;
  const auto add = [&](const Pixel& p) {
    if (std::abs(p.x - x) <= 1 && std::abs(p.y - y) <= 1) sums.Add(job.NewSample(p.x, p.y));
  };
  const int left = (x + 1) / 2 - 1, top = (y + 1) / 2 - 1;
  for (int block_y = std::max(top, 0); block_y <= std::min(top + 1, rows - 1); ++block_y) {
    if (left < 0 || left + 1 >= columns) {
      add(NewPixel(job, std::max(left, 0), block_y));
      continue;
    }
    const Pixel a = NewPixel(job, left, block_y), b = NewPixel(job, left + 1, block_y);
    const bool in_order = a.y <= b.y;  // of the reference
    add(in_order ? a : b);
    add(in_order ? b : a);
  }
}

}  // namespace

Motion LongestMotion(const DenseJob& job, int x0, int y0, int x1, int y1, int radius) {
  Motion longest{0, 0};
  for (int y = std::max(y0 - radius, 0); y <= std::min(y1 + radius, job.options.height - 1); ++y) {
    for (int x = std::max(x0 - radius, 0); x <= std::min(x1 + radius, job.options.width - 1); ++x) {
      TakeLonger(job.MotionAt(x, y), longest);
    }
  }
  return longest;
}

void ComposeRows(const DenseJob& job, int begin, int end, Motion* row_longest) {
  const int width = job.options.width, radius = job.options.motion_radius;
  const int first = std::max(begin - radius, 0),
            last = std::min(end - 1 + radius, job.options.height - 1);
  const auto row = [&](int y) { return row_longest + std::ptrdiff_t{y - first} * width; };
  for (int y = first; y <= last; ++y) LongestInRow(job, y, row(y));
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < width; ++x) {
      Motion m{0, 0};
      for (int v = std::max(y - radius, first); v <= std::min(y + radius, last); ++v) {
        TakeLonger(row(v)[x], m);
      }
      ComposePixel(job, x, y, m, [&](BoxSums& sums) { AddNewSamples(job, x, y, sums); });
    }
  }
}

}  // namespace warplut::dense
