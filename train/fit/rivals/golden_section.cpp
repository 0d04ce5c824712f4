#include "train/fit/rivals/golden_section.h"

#include <cmath>
#include <numbers>

namespace warplut {
namespace {

constexpr double kRatio = std::numbers::phi - 1;

}  // namespace

int GoldenSectionEvaluations(double low, double high, double width) {
  const double steps = std::log(width / (high - low)) / std::log(kRatio);
  return 2 + static_cast<int>(std::ceil(std::fmax(steps, 0)));
}

Maximum GoldenSection(const std::function<double(double)>& f, double low, double high,
                      double width) {
  const int steps = GoldenSectionEvaluations(low, high, width) - 2;
  Maximum left{.at = high - kRatio * (high - low)};
  Maximum right{.at = low + kRatio * (high - low)};
  left.value = f(left.at);
  right.value = f(right.at);
  Maximum best = left.value >= right.value ? left : right;
  for (int step = 0; step < steps; ++step) {
    const bool keep_left = left.value >= right.value;
    if (keep_left) {
      high = right.at;
      right = left;
      left.at = high - kRatio * (high - low);
    } else {
      low = left.at;
      left = right;
      right.at = low + kRatio * (high - low);
    }
    Maximum& fresh = keep_left ? left : right;
    fresh.value = f(fresh.at);
    if (fresh.value > best.value) best = fresh;
  }
  return best;
}

}  // namespace warplut
