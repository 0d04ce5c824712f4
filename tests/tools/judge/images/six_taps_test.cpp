#include "tools/judge/images/six_taps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace warplut {
namespace {

double Sum(const SixTaps& taps) {
  double sum = 0;
  for (const float tap : taps) sum += static_cast<double>(tap);
  return sum;
}

double Sinc(double t) {
  return t == 0 ? 1 : std::sin(std::numbers::pi * t) / (std::numbers::pi * t);
}

TEST(SixTaps, SumToOneAndMirror) {
  for (const float b : {0.0f, 4.5f, static_cast<float>(kLargestKaiser)}) {
    for (int i = 0; i <= 16; ++i) {
      const float d = static_cast<float>(i) / 16;
      const SixTaps taps = KaiserSixTaps(b, d), mirrored = KaiserSixTaps(b, 1 - d);
      EXPECT_NEAR(Sum(taps), 1, 1e-6) << b << " at " << d;
      for (int k = 0; k < kSixTaps; ++k) {
        EXPECT_NEAR(taps[k], mirrored[kSixTaps - 1 - k], 2e-6) << b << " at " << d;
      }
    }
  }
  for (int i = 0; i < 16; ++i) {
    EXPECT_NEAR(Sum(LanczosTaps(static_cast<float>(i) / 16)), 1, 1e-6);
  }
}

TEST(SixTaps, NoFractionIsTheTexelItself) {
  const SixTaps texel = {0, 0, 1, 0, 0, 0};
  EXPECT_EQ(LanczosTaps(0), texel);
  EXPECT_EQ(KaiserSixTaps(4.5f, 0), texel);
}

// The plain formulas, in double.
TEST(SixTaps, AreWindowedSincs) {
  constexpr double kB = 4.5;
  for (const double d : {0.125, 0.5, 0.8125}) {
    std::array<double, kSixTaps> lanczos, kaiser;
    double lanczos_sum = 0, kaiser_sum = 0;
    for (int k = 0; k < kSixTaps; ++k) {
      const double t = d - (k - 2);
      lanczos[k] = Sinc(t) * Sinc(t / 3);
      kaiser[k] = Sinc(t) * std::cyl_bessel_i(0.0, kB * std::sqrt(1 - t * t / 9));
      lanczos_sum += lanczos[k];
      kaiser_sum += kaiser[k];
    }
    for (int k = 0; k < kSixTaps; ++k) {
      EXPECT_NEAR(LanczosTaps(static_cast<float>(d))[k], lanczos[k] / lanczos_sum, 1e-6);
      EXPECT_NEAR(KaiserSixTaps(kB, static_cast<float>(d))[k], kaiser[k] / kaiser_sum, 1e-6);
    }
  }
}

}  // namespace
}  // namespace warplut
