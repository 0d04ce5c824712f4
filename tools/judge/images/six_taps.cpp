#include "tools/judge/images/six_taps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace warplut {
namespace {

constexpr std::size_t kTapOfTexel = -kFirstOfSix;

SixTaps Normalised(SixTaps taps) {
  float total = 0;
  for (const float tap : taps) total += tap;
  for (float& tap : taps) tap /= total;
  return taps;
}

SixTaps TexelItself() {
  SixTaps taps{};
  taps[kTapOfTexel] = 1;
  return taps;
}

}  // namespace

SixTaps LanczosTaps(float d) {
  if (d == 0) return TexelItself();
  constexpr float kPi = std::numbers::pi_v<float>;
  // sin(pi (d + n)) is sin(pi d) but for its sign, and sin(pi (d + n) / 3) has three values but for
  // theirs.
  const float sine = std::sin(kPi * d);
  const std::array<float, 3> thirds = {std::sin(kPi * d / 3), std::sin(kPi * (d + 1) / 3),
                                       std::sin(kPi * (d + 2) / 3)};
  SixTaps taps;
  for (int i = 0; i < kSixTaps; ++i) {
    const int n = -(kFirstOfSix + i);  // the distance is d + n, -3 < d + n < 3
    const int third = (n + 3) % 3;
    const float t = d + static_cast<float>(n);
    // Going from d + third to d + n turns by n - third, a multiple of 3.
    const float sign = ((n - third) / 3) % 2 == 0 ? 1.0f : -1.0f;
    taps[i] = (n % 2 == 0 ? sine : -sine) * sign * thirds[third] / (t * t);
  }
  return Normalised(taps);
}

SixTaps KaiserSixTaps(float b, float d) {
  const WindowTaps<double> exact = KaiserTaps(static_cast<double>(b), static_cast<double>(d));
  SixTaps taps{};
  std::copy(exact.begin(), exact.end(), taps.begin());
  return taps;
}

}  // namespace warplut
