// One channel of a render-grid image as floats, with a border, so that filters need no clamped
// coordinates.
#pragma once

#include <algorithm>
#include <cstddef>

#include "runtime/image_buffer.h"

namespace warplut {

// Row y, column x for x in [-kPlanePad, width + kPlanePad) and y in [-kPlaneRows,
// height + kPlaneRows). A row may be read and written in whole vectors of 16 floats from column 0
// on.
inline constexpr int kPlanePad = 16;
inline constexpr int kPlaneRows = 2;

class Plane {
 public:
  Plane() = default;
  Plane(int width, int height)
      : width_(width),
        height_(height),
        rows_((static_cast<std::size_t>(width) + 3 * kPlanePad) * sizeof(float),
              height + 2 * kPlaneRows) {}

  // As if made for this size, which is at most that of the constructor; the values are arbitrary.
  void SetSize(int width, int height) {
    width_ = width;
    height_ = height;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t bytes() const { return rows_.size(); }
  // Floats from one row to the next.
  int stride() const { return static_cast<int>(rows_.stride() / static_cast<int>(sizeof(float))); }

  float* Row(int y) { return Address(y); }
  const float* Row(int y) const { return Address(y); }

  // Repeats the outermost pixels of row y into its left and right border, and those of the first
  // and last row beyond them.
  void ExtendRow(int y) {
    float* row = Row(y);
    std::fill(row - kPlanePad, row, row[0]);
    std::fill(row + width_, row + width_ + kPlanePad, row[width_ - 1]);
    if (y == 0) {
      for (int above = 1; above <= kPlaneRows; ++above) CopyRow(0, -above);
    }
    if (y == height_ - 1) {
      for (int below = 1; below <= kPlaneRows; ++below) CopyRow(y, y + below);
    }
  }

 private:
  float* Address(int y) const {
    return reinterpret_cast<float*>(rows_.data() + (y + kPlaneRows) * rows_.stride()) + kPlanePad;
  }
  void CopyRow(int from, int to) {
    std::copy_n(Row(from) - kPlanePad, width_ + 2 * kPlanePad, Row(to) - kPlanePad);
  }

  int width_ = 0;
  int height_ = 0;
  RowBuffer rows_;
};

}  // namespace warplut
