#include "train/fit/objective/prefilter_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "train/fit/rivals/spline_family.h"

namespace warplut {
namespace {

TEST(PrefilterMap, NumbersOfComesBack) {
  const RealPrefilter recursive = RecursivePrefilter(0.15);
  const PrefilterMap iir = PrefilterMap::Recursive(0.2);
  ASSERT_EQ(iir.size(), 1);
  EXPECT_NEAR(iir.At(iir.NumbersOf(recursive).data()).side, 0.15, 1e-14);

  const RealPrefilter fir = FirPrefilter(0.15, 4);
  const PrefilterMap map = PrefilterMap::Fir(4, 0.2);
  ASSERT_EQ(map.size(), 5);
  const RealPrefilter back = map.At(map.NumbersOf(fir).data());
  EXPECT_EQ(back.reach, 4);
  for (int j = 0; j <= 4; ++j) EXPECT_NEAR(back.taps[j], fir.taps[j], 1e-14);

  EXPECT_EQ(PrefilterMap().size(), 0);
  EXPECT_EQ(PrefilterMap().At(nullptr), RealPrefilter());
  EXPECT_EQ(PrefilterMap::Fixed(0.17).At(nullptr), RecursivePrefilter(0.17));
}

// Stable by construction.
TEST(PrefilterMap, TheSideStaysInsideWhateverTheNumberIs) {
  const PrefilterMap map = PrefilterMap::Recursive(0.2);
  for (const double u : {-1e300, -50.0, 0.0, 50.0, 1e300}) {
    const RealPrefilter prefilter = map.At(&u);
    EXPECT_GE(prefilter.side, static_cast<double>(kLeastSide));
    EXPECT_LE(prefilter.side, 0.2);
    EXPECT_TRUE(IsValid(Rounded(prefilter)));
  }
  const double u = map.NumbersOf(RecursivePrefilter(0.2)).front();
  EXPECT_TRUE(std::isfinite(u));
  EXPECT_NEAR(map.At(&u).side, 0.2, 1e-3);
}

TEST(PrefilterMap, BackwardEqualsDifferences) {
  const PrefilterMap map = PrefilterMap::Fir(3, 0.19);
  std::vector<double> numbers = map.NumbersOf(FirPrefilter(0.14, 3));
  RealPrefilter factors{.side = 0.7};
  factors.taps = {1.1, -0.4, 0.3, 2.0};
  const auto value = [&] {
    const RealPrefilter p = map.At(numbers.data());
    double sum = factors.side * p.side;
    for (int j = 0; j <= 3; ++j) sum += factors.taps[j] * p.taps[j];
    return sum;
  };
  std::vector<double> gradient(numbers.size());
  map.Backward(numbers.data(), factors, gradient.data());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double saved = numbers[i], h = 1e-6;
    numbers[i] = saved + h;
    const double above = value();
    numbers[i] = saved - h;
    EXPECT_NEAR(gradient[i], (above - value()) / (2 * h), 1e-8);
    numbers[i] = saved;
  }
}

}  // namespace
}  // namespace warplut
