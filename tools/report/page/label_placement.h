// Where labels stand beside their points without covering each other.
#pragma once

#include <vector>

namespace warplut {

// Pixels, y down.
struct LabelBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  bool Overlaps(const LabelBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool IsInside(const LabelBox& other) const {
    return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
  }
};

// A point with its label's size; without a size it is only kept free.
struct LabelledPoint {
  double x = 0, y = 0;
  double width = 0, height = 0;
};

struct PlacedLabel {
  bool shown = false;  // false: there is no room
  LabelBox box;
};

inline constexpr double kPointRadius = 5;  // pixels around a point that labels leave free

// Places the labels one after the other, each at the first of 16 places around its point that lies
// inside `area` and covers neither a point nor a label that was placed before. As many results as
// points.
std::vector<PlacedLabel> PlaceLabels(const std::vector<LabelledPoint>& points,
                                     const LabelBox& area);

}  // namespace warplut
