#include "train/replay/motion_step.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace warplut {
namespace {

constexpr float kSameValue = 0x1p-12f;

double ComponentStep(const MotionView& motion, int component) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(motion.width) * static_cast<std::size_t>(motion.height));
  for (int y = 0; y < motion.height; ++y) {
    for (int x = 0; x < motion.width; ++x) {
      const float value = motion.Row(y)[2 * x + component];
      if (std::isfinite(value)) values.push_back(value);
    }
  }
  std::sort(values.begin(), values.end());
  std::vector<float> gaps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const float gap = values[i] - values[i - 1];
    if (gap >= kSameValue) gaps.push_back(gap);
  }
  if (gaps.size() + 1 < kFewestValues) return 0;
  const auto twentieth = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 20);
  std::nth_element(gaps.begin(), twentieth, gaps.end());
  return *twentieth;
}

}  // namespace

double MotionStep(const MotionView& motion) {
  return std::min(ComponentStep(motion, 0), ComponentStep(motion, 1));
}

}  // namespace warplut
