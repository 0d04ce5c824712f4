#include "tools/report/page/label_placement.h"

#include <algorithm>
#include <array>

namespace warplut {
namespace {

// Where the label's centre lies from its point: dx and dy in units of
// (half its size + the point's radius), from beside to farther away.
struct Place {
  double dx, dy;
};
constexpr std::array<Place, 16> kPlaces = {{{1, 0},
                                            {-1, 0},
                                            {0, -1},
                                            {0, 1},
                                            {1, -1},
                                            {1, 1},
                                            {-1, -1},
                                            {-1, 1},
                                            {0.5, -1},
                                            {-0.5, -1},
                                            {0.5, 1},
                                            {-0.5, 1},
                                            {1, -2},
                                            {1, 2},
                                            {-1, -2},
                                            {-1, 2}}};

LabelBox BoxAt(const LabelledPoint& point, const Place& place) {
  const double x = point.x + place.dx * (point.width / 2 + kPointRadius);
  const double y = point.y + place.dy * (point.height / 2 + kPointRadius);
  return {x - point.width / 2, y - point.height / 2, x + point.width / 2, y + point.height / 2};
}

}  // namespace

std::vector<PlacedLabel> PlaceLabels(const std::vector<LabelledPoint>& points,
                                     const LabelBox& area) {
  std::vector<LabelBox> taken;
  for (const LabelledPoint& point : points) {
    taken.push_back({point.x - kPointRadius + 1, point.y - kPointRadius + 1,
                     point.x + kPointRadius - 1, point.y + kPointRadius - 1});
  }
  std::vector<PlacedLabel> placed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].width <= 0) continue;
    for (const Place& place : kPlaces) {
      const LabelBox box = BoxAt(points[i], place);
      const bool free = std::none_of(taken.begin(), taken.end(),
                                     [&](const LabelBox& other) { return box.Overlaps(other); });
      if (!free || !box.IsInside(area)) continue;
      placed[i] = {.shown = true, .box = box};
      taken.push_back(box);
      break;
    }
  }
  return placed;
}

}  // namespace warplut
