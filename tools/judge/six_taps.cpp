#include "tools/judge/six_taps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace warplut {
namespace {

constexpr std::size_t kTapOfTexel = -kFirstOfSix;
constexpr float kHalfWidth = kSixTaps / 2;

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

float Sinc(float t) {
  const float angle = std::numbers::pi_v<float> * t;
  return t == 0 ? 1 : std::sin(angle) / angle;
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

SixTaps KaiserTaps(float b, float d) {
  if (d == 0) return TexelItself();
  SixTaps taps;
  for (int i = 0; i < kSixTaps; ++i) {
    const float t = d - static_cast<float>(kFirstOfSix + i);
    const float inside = std::max(0.0f, 1 - (t / kHalfWidth) * (t / kHalfWidth));
    const double window = std::cyl_bessel_i(0.0, static_cast<double>(b * std::sqrt(inside)));
    taps[i] = Sinc(t) * static_cast<float>(window);
  }
  return Normalised(taps);
}

}  // namespace warplut
