#include "luts/certificate/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "luts/filters.h"
#include "luts/quantize/quantize.h"
#include "tests/luts/quantization_error.h"
#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

BakedTable KeysTable(double a) {
  return Quantize(
      SampleWeights("keys", kNodes, [a](double dx, double dy) { return KeysWeights(a, dx, dy); }),
      TableFormat::kI16);
}

// A wave of amplitude 1, warped `warps` times by one row of weights; returns its amplitude,
// measured where no border has reached.
double AmplitudeAfter(const Weights<double>& w, double fx, double fy, int warps) {
  const int side = (kTaps - 1) * warps + 16;
  // Cosine and sine of the same wave: together they show the amplitude at every pixel.
  std::vector<double> wave[2];
  for (int part = 0; part < 2; ++part) {
    for (int i = 0; i < side * side; ++i) {
      const double phase = fx * (i % side) + fy * (i / side);
      wave[part].push_back(part == 0 ? std::cos(phase) : std::sin(phase));
    }
  }
  for (int n = 1; n <= warps; ++n) {
    for (std::vector<double>& x : wave) {
      std::vector<double> y(x.size());
      for (int row = n; row < side - 2 * n; ++row) {
        for (int col = n; col < side - 2 * n; ++col) {
          std::array<double, kWeights> texels{};
          for (const int k : TapsOf(Footprint::k16))
            texels[k] = x[(row + TapY(k)) * side + col + TapX(k)];
          y[row * side + col] = ApplyWeights(Footprint::k16, w, texels);
        }
      }
      x = y;
    }
  }
  const int centre = (warps + 4) * side + warps + 4;
  return std::hypot(wave[0][centre], wave[1][centre]);
}

TEST(Certificate, SafeWarpsIsTheLargestPowerBelowTheGrowth) {
  EXPECT_EQ(SafeWarps(1.0), std::nullopt);
  EXPECT_EQ(SafeWarps(1 + kUnitGainTolerance), std::nullopt);
  EXPECT_EQ(SafeWarps(kSafeGrowth), 1);
  EXPECT_EQ(SafeWarps(std::sqrt(kSafeGrowth) * (1 - 1e-15)), 2);
  EXPECT_EQ(SafeWarps(kSafeGrowth * 1.001), 0);
  for (const double gain : {1.00002, 1.008, 1.04, 1.7}) {
    const auto warps = static_cast<double>(SafeWarps(gain).value());
    EXPECT_LE(std::pow(gain, warps), kSafeGrowth);
    EXPECT_GT(std::pow(gain, warps + 1), kSafeGrowth);
  }
}

TEST(Certificate, CatmullRomIsNearlyUnbounded) {
  const BakedTable table = Quantize(SampleFit(MakeFit(0), kNodes), TableFormat::kF32);
  const Stability s = CertifyStability(table.view());
  EXPECT_NEAR(s.any.gain, 1, 1e-6);
  EXPECT_NEAR(s.half.gain, 1, 1e-12);
  EXPECT_FALSE(s.half.safe_warps.has_value());
  EXPECT_NEAR(s.half.closed_loop_gain, 1 - kDefaultBlend, 1e-12);
}

TEST(Certificate, PredictsTheGrowthOfTheWorstWave) {
  for (const double a : {-0.75, -0.70}) {
    const BakedTable table = KeysTable(a);
    const Stability s = CertifyStability(table.view());
    const Gain& worst = s.gains.nodes[s.gains.worst];
    const Weights<double> w =
        RealRow(TableIntegers(table.view(), "table")[s.gains.worst], table.format());
    const auto safe = static_cast<int>(s.any.safe_warps.value());
    const double amplitude = AmplitudeAfter(w, worst.fx, worst.fy, safe);
    EXPECT_NEAR(amplitude, std::pow(worst.gain, safe), 1e-9);
    EXPECT_LE(amplitude, kSafeGrowth);
    EXPECT_GT(AmplitudeAfter(w, worst.fx, worst.fy, safe + 1), kSafeGrowth);
  }
}

TEST(Certificate, SmallestBlendClosesTheLoop) {
  const BakedTable table = KeysTable(-0.7);
  const double blend = CertifyStability(table.view(), 0.25).any.smallest_blend;
  EXPECT_GT(blend, 0.03);
  EXPECT_LT(CertifyStability(table.view(), blend + 1e-9).any.closed_loop_gain, 1);
  EXPECT_GT(CertifyStability(table.view(), blend - 1e-9).any.closed_loop_gain, 1);
  EXPECT_EQ(CertifyStability(KeysTable(0).view()).half.smallest_blend, 0);
}

TEST(Certificate, HalfOffsetIsItsOwnNode) {
  const Stability s =
      CertifyStability(Quantize(SampleFit(MakeFit(0.3), kNodes), TableFormat::kI16).view());
  EXPECT_EQ(s.half.gain, s.gains.nodes[RowIndex(kNodes / 2, kNodes / 2)].gain);
  EXPECT_LE(s.half.gain, s.any.gain);
}

// Without storage errors these are about .074 and .003 for Catmull-Rom; what storage adds is at
// most its own error.
TEST(LookupError, OfCatmullRom) {
  const Fit fit = MakeFit(0);
  const RealTable real = SampleFit(fit, kNodes);
  for (const LookupError& e : MeasureLookupErrors(fit)) {
    SCOPED_TRACE(std::string(Name(e.format)) + " " + Name(e.lookup));
    const double lookup = e.lookup == Lookup::kNearest ? 0.074 : 0.0030;
    const double digits = e.lookup == Lookup::kNearest ? 1e-3 : 2e-4;
    const double storage = QuantizationError(real, Quantize(real, e.format).view());
    EXPECT_GT(e.worst, lookup - digits);
    EXPECT_LT(e.worst, lookup + digits + storage);
    EXPECT_LT(e.mean, e.worst);
    EXPECT_LT(e.brightness, 1e-6);
  }
}

TEST(LookupError, NearestLookupAtItsNodesSeesQuantisationOnly) {
  const Fit fit = MakeFit(0.2);
  const std::vector<LookupError> errors = MeasureLookupErrors(fit);
  ASSERT_EQ(errors.size(), 8u);
  const RealTable real = SampleFit(fit, kNodes);
  for (const LookupError& e : errors) {
    EXPECT_GE(e.worst, QuantizationError(real, Quantize(real, e.format).view()) - 1e-6);
  }
}

TEST(Certificate, JsonNamesEverything) {
  const nlohmann::ordered_json json = ToJson(Certify(MakeFit(0.3, 2), TableFormat::kI16, 0.25));
  EXPECT_EQ(json["safe_growth"], kSafeGrowth);
  EXPECT_EQ(json["blend"], 0.25);
  EXPECT_EQ(json["worst_node"].size(), 2u);
  EXPECT_EQ(json["lookup_errors"].size(), 8u);
  EXPECT_EQ(json["node_gains"].size(), static_cast<std::size_t>(kRows));
  EXPECT_GT(json["any_offset"]["gain"].get<double>(), 1);
  EXPECT_TRUE(json["any_offset"]["safe_warps"].is_number_integer());
  const nlohmann::ordered_json keys = ToJson({CertifyStability(KeysTable(-0.25).view()), {}});
  EXPECT_EQ(keys["half_offset"]["safe_warps"], "unbounded");
}

}  // namespace
}  // namespace warplut
