#include "luts/certificate/gain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "luts/filters.h"
#include "luts/quantize/quantize.h"
#include "luts/table.h"
#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

constexpr double kPi = std::numbers::pi;

// The largest |H| on a dense grid: the slow, obvious version.
double DenseMaxGain(const Weights<double>& w, int steps) {
  double best = 0;
  for (int a = 0; a <= steps / 2; ++a) {
    for (int b = 0; b < steps; ++b) {
      best = std::max(best, GainAt(w, 2 * kPi * a / steps, 2 * kPi * b / steps));
    }
  }
  return best;
}

TEST(Gain, TransferFunctionOfKnownKernels) {
  const Weights<double> half = BilinearWeights(0.5, 0.5);
  EXPECT_NEAR(GainAt(half, 0, 0), 1, 1e-15);
  EXPECT_NEAR(GainAt(half, kPi, 0), 0, 1e-15);
  EXPECT_NEAR(GainAt(half, kPi / 2, 0), std::cos(kPi / 4), 1e-15);
  EXPECT_NEAR(MaxGain(BilinearWeights(0.0, 0.0)).gain, 1, 1e-12);
  EXPECT_NEAR(MaxGain(half).gain, 1, 1e-12);
  Weights<double> twice{};
  twice[kIdentityWeight] = 2;
  EXPECT_NEAR(MaxGain(twice).gain, 2, 1e-12);
}

TEST(Gain, LargestGainOfKeysKernelsOverTheTable) {
  // Source: the gains that this project measured for these kernels, to the digits given.
  for (const auto& [a, expected] : {std::pair(-0.5, 1.000),
                                    {-0.54, 1.002},
                                    {-0.58, 1.008},
                                    {-0.60, 1.011},
                                    {-0.65, 1.024},
                                    {-0.70, 1.040}}) {
    const RealTable real = SampleWeights(
        "keys", kNodes, [a = a](double dx, double dy) { return KeysWeights(a, dx, dy); });
    const GainMap map = MapGains(Quantize(real, TableFormat::kF32).view());
    EXPECT_NEAR(map.nodes[map.worst].gain, expected, 6e-4) << a;
  }
}

TEST(Gain, AgreesWithADenseGrid) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Fit fit = MakeFit(0.3, seed);
    const RealTable real = SampleFit(fit, 8);
    const Weights<double>& w = real.Row(static_cast<int>(seed % 9), static_cast<int>(seed * 5 % 9));
    const Gain gain = MaxGain(w);
    const double dense = DenseMaxGain(w, 512);
    EXPECT_GE(gain.gain, dense * (1 - 1e-9));
    EXPECT_LE(gain.gain, dense * (1 + 4e-4));  // what 512 steps may miss
    EXPECT_NEAR(GainAt(w, gain.fx, gain.fy), gain.gain, 1e-9);
    EXPECT_GE(gain.fx, 0);
    EXPECT_LE(gain.fx, kPi);
    EXPECT_LE(std::abs(gain.fy), kPi);
  }
}

TEST(Gain, SymmetricNodesHaveEqualGains) {
  const GainMap map = MapGains(Quantize(SampleFit(MakeFit(0.2), kNodes), TableFormat::kI16).view());
  ASSERT_EQ(map.nodes.size(), static_cast<std::size_t>(kRows));
  for (int jy = 1; jy < kNodes; ++jy) {
    for (int ix = 1; ix < kNodes; ++ix) {
      const double gain = map.nodes[RowIndex(ix, jy)].gain;
      EXPECT_NEAR(map.nodes[RowIndex(kNodes - ix, jy)].gain, gain, 1e-9);
      EXPECT_NEAR(map.nodes[RowIndex(jy, ix)].gain, gain, 1e-9);
      EXPECT_LE(gain, map.nodes[map.worst].gain * (1 + 1e-12));
    }
  }
}

TEST(Gain, BilinearLookupHasNoMoreThanItsNodes) {
  const BakedTable baked = Quantize(SampleFit(MakeFit(0.3), kNodes), TableFormat::kF32);
  const GainMap map = MapGains(baked.view());
  const Table table(baked.view());
  for (float dy = 0.011f; dy < 1; dy += 0.13f) {
    for (float dx = 0.017f; dx < 1; dx += 0.11f) {
      const Weights<float> looked_up = table.At(dx, dy, Lookup::kBilinear);
      Weights<double> w;
      std::copy(looked_up.begin(), looked_up.end(), w.begin());
      double corners = 0;
      for (int c = 0; c < 4; ++c) {
        const int ix = static_cast<int>(dx * kNodes) + c % 2;
        const int jy = static_cast<int>(dy * kNodes) + c / 2;
        corners = std::max(corners, map.nodes[RowIndex(ix % kNodes, jy % kNodes)].gain);
      }
      EXPECT_LE(MaxGain(w).gain, corners + 1e-6);
    }
  }
}

}  // namespace
}  // namespace warplut
