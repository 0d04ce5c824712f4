#include "runtime/color_encoding.h"

#include <gtest/gtest.h>

#include <cmath>

namespace warplut {
namespace {

template <class T>
T RoundTrip(T value) {
  const T mapped = value * ToneMapFactor(value);
  return mapped * InverseToneMapFactor(mapped);
}

TEST(ToneMap, MapsToLessThanOneAndRises) {
  double before = -1;
  for (double m = 0; m <= kLargestHdr; m = 1.5 * m + 1e-3) {
    const double mapped = m * ToneMapFactor(m);
    EXPECT_GT(mapped, before);
    EXPECT_LT(mapped, 1);
    before = mapped;
  }
}

TEST(ToneMap, IsReversible) {
  for (double m = 0; m <= kLargestHdr; m = 1.5 * m + 1e-3) {
    EXPECT_NEAR(RoundTrip(m), m, 1e-9 * (1 + m) * (1 + m)) << m;
    // A float mapped value resolves m to 2^-24 (1 + m)^2.
    const auto f = static_cast<float>(m);
    EXPECT_NEAR(RoundTrip(f), f, 0x1p-22 * (1 + m) * (1 + m)) << m;
  }
}

TEST(ToneMap, KeepsTheRatioOfChannels) {
  const float rgb[] = {4.0f, 1.0f, 0.25f};
  const float factor = ToneMapFactor(rgb[0]);
  const float back = InverseToneMapFactor(rgb[0] * factor);
  for (const float channel : rgb) EXPECT_NEAR(channel * factor * back, channel, 1e-5f);
}

TEST(ToneMap, LimitsWhatResamplingOvershoots) {
  for (const float mapped : {1.0f, 1.25f, 100.0f}) {
    const float value = std::min(mapped, 1.0f) * InverseToneMapFactor(mapped);
    EXPECT_TRUE(std::isfinite(value));
    EXPECT_NEAR(value, kLargestHdr, 0.01f * kLargestHdr);
  }
}

}  // namespace
}  // namespace warplut
