// How two images, or two fields of motion, differ: the one comparer of the tests of the runtime. A
// value that is not finite differs by infinity, so that no comparison loses it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "runtime/core/pixel.h"
#include "runtime/image_view.h"

namespace warplut {

// In values as they are stored: codes for RGBA8.
struct Difference {
  double largest = 0;         // of any channel
  double largest_within = 0;  // among the pixels of which no channel exceeds the tolerance
  double share = 0;           // of the pixels of which a channel exceeds the tolerance
  double rms = 0;             // over the channels
};

// Over `width` x `height` pixels; channel(x, y, c) gives a pair of values.
template <class Channel>
Difference DifferenceOf(int width, int height, int channels, double tolerance,
                        const Channel& channel) {
  Difference result;
  std::int64_t beyond = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double most = 0;
      for (int c = 0; c < channels; ++c) {
        const auto [a, b] = channel(x, y, c);
        const double difference = std::isfinite(a) && std::isfinite(b)
                                      ? std::abs(static_cast<double>(a) - static_cast<double>(b))
                                      : std::numeric_limits<double>::infinity();
        most = std::max(most, difference);
        result.rms += difference * difference;
      }
      result.largest = std::max(result.largest, most);
      if (most > tolerance) {
        ++beyond;
      } else {
        result.largest_within = std::max(result.largest_within, most);
      }
    }
  }
  const double pixels = static_cast<double>(width) * height;
  result.share = static_cast<double>(beyond) / pixels;
  result.rms = std::sqrt(result.rms / (pixels * channels));
  return result;
}

// Images of one size and format.
inline Difference Compare(const ImageView& a, const ImageView& b, double tolerance = 0) {
  return DifferenceOf(a.width, a.height, Channels(a.format), tolerance, [&](int x, int y, int c) {
    return std::pair{LoadChannel(a.format, a.At(x, y), c), LoadChannel(b.format, b.At(x, y), c)};
  });
}

// Motion of one size, in pixels.
inline Difference Compare(const MotionView& a, const MotionView& b, double tolerance = 0) {
  return DifferenceOf(a.width, a.height, 2, tolerance, [&](int x, int y, int c) {
    return std::pair{a.Row(y)[2 * x + c], b.Row(y)[2 * x + c]};
  });
}

}  // namespace warplut
