#include "train/metrics/temporal_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "datasets/frame.h"
#include "runtime/gates.h"
#include "train/metrics/same_surface.h"

namespace warplut {
namespace {

// Where the centre of pixel (x, y) was, in pixels from the upper left corner.
Vec2 PreviousPosition(const MotionView& motion, int x, int y) {
  const float* m = motion.Row(y) + 2 * x;
  return {x + 0.5 - static_cast<double>(m[0]), y + 0.5 - static_cast<double>(m[1])};
}

double DepthAt(const ImageView& depth, int x, int y) {
  const double d = depth.Row<float>(y)[x];
  return d <= kFarthestDepth ? d : kFarthestDepth;
}

// The sum over channels for one pixel.
double SquaredChange(const Image& error, int x, int y, const Image& previous,
                     const Vec2& position) {
  const double u = position.x - 0.5, v = position.y - 0.5;
  const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
  const double dx = u - left, dy = v - top;
  const int x0 = std::max(left, 0), x1 = std::min(left + 1, previous.width - 1);
  const int y0 = std::max(top, 0), y1 = std::min(top + 1, previous.height - 1);
  double sum = 0;
  for (int c = 0; c < error.channels; ++c) {
    const double upper = (1 - dx) * previous.at(x0, y0, c) + dx * previous.at(x1, y0, c);
    const double lower = (1 - dx) * previous.at(x0, y1, c) + dx * previous.at(x1, y1, c);
    const double change = error.at(x, y, c) - ((1 - dy) * upper + dy * lower);
    sum += change * change;
  }
  return sum;
}

}  // namespace

TemporalErrorSum& TemporalErrorSum::operator+=(const TemporalErrorSum& other) {
  squares += other.squares;
  values += other.values;
  return *this;
}

double TemporalErrorSum::Rms() const {
  if (values == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(squares / static_cast<double>(values));
}

bool WasVisible(const FrameGeometry& geometry, const FrameGeometry& previous_geometry, int x,
                int y) {
  const Vec2 position = PreviousPosition(geometry.motion, x, y);
  const int width = geometry.motion.width, height = geometry.motion.height;
  if (!(position.x >= 0 && position.y >= 0 && position.x <= width && position.y <= height)) {
    return false;
  }
  const int px = std::min(static_cast<int>(position.x), width - 1);
  const int py = std::min(static_cast<int>(position.y), height - 1);
  const double change = DepthDifference(DepthMeasure::kRelative, DepthAt(geometry.depth, x, y),
                                        DepthAt(previous_geometry.depth, px, py));
  return std::abs(change) <= kSameSurface;
}

TemporalErrorSum TemporalError(const Image& error, const FrameGeometry& geometry,
                               const Image& previous_error, const FrameGeometry& previous_geometry,
                               int border) {
  std::vector<TemporalErrorSum> rows(static_cast<std::size_t>(error.height));
  tbb::parallel_for(border, std::max(border, error.height - border), [&](int y) {
    TemporalErrorSum& row = rows[static_cast<std::size_t>(y)];
    for (int x = border; x < error.width - border; ++x) {
      if (!WasVisible(geometry, previous_geometry, x, y)) continue;
      row.squares +=
          SquaredChange(error, x, y, previous_error, PreviousPosition(geometry.motion, x, y));
      row.values += error.channels;
    }
  });
  TemporalErrorSum total;
  for (const TemporalErrorSum& row : rows) total += row;
  return total;
}

}  // namespace warplut
