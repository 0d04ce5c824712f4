#include "luts/prefilter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "luts/bake/bake.h"
#include "luts/bake/released_layout.h"
#include "luts/bake/table_io.h"
#include "luts/certificate/gain.h"
#include "luts/filters.h"
#include "luts/fit/head.h"
#include "luts/quantize/quantize.h"
#include "test_fits.h"

namespace warplut {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// Taps that invert side .1 to .2 %: the terms of 1 / A that are left out are added to the
// outermost.
Prefilter Fir() {
  Prefilter p{PrefilterKind::kFir, 0.1f, 4, {}};
  const double z = PoleOfSide(0.1);
  double sum = 0;
  for (int j = 1; j <= p.reach; ++j) {
    p.taps[j] = static_cast<float>((1 - z) / (1 + z) * std::pow(z, j));
    sum += 2 * static_cast<double>(p.taps[j]);
  }
  p.taps[0] = static_cast<float>(1 - sum);
  return p;
}

TEST(Prefilter, PoleAndSideAreInverse) {
  for (const double side : {0.01, 0.1, 1.0 / 6, 0.2, 0.23}) {
    const double z = PoleOfSide(side);
    EXPECT_GT(z, -1);
    EXPECT_LT(z, 0);
    EXPECT_NEAR(SideOfPole(z), side, 1e-14);
    EXPECT_NEAR(side + (1 - 2 * side) * z + side * z * z, 0, 1e-14);
  }
  EXPECT_NEAR(PoleOfSide(1.0 / 6), std::sqrt(3.0) - 2, 1e-15);  // the cubic B-spline's
}

TEST(Prefilter, ResponseIsTheInverseOfTheWholeOffset) {
  const Prefilter recursive{PrefilterKind::kRecursive, 0.17f, 0, {}};
  for (const double f : {0.0, 0.3, 1.0, 2.5, kPi}) {
    EXPECT_NEAR(PrefilterResponse(recursive, f) * WholeOffsetResponse(recursive, f), 1, 1e-15);
    EXPECT_NEAR(PrefilterResponse(Fir(), f) * WholeOffsetResponse(Fir(), f), 1, 2e-3);
    EXPECT_EQ(PrefilterResponse(Prefilter{}, f), 1);
  }
}

TEST(Prefilter, SaysWhatIsWrong) {
  const auto reason = [](const Prefilter& p) {
    const char* why = "";
    EXPECT_FALSE(IsValid(p, &why));
    return std::string(why);
  };
  EXPECT_TRUE(IsValid(Prefilter{}));
  EXPECT_TRUE(IsValid(Fir()));
  EXPECT_TRUE(IsValid(Prefilter{PrefilterKind::kRecursive, kLargestSide, 0, {}}));
  EXPECT_THAT(reason({PrefilterKind::kNone, 0.1f, 0, {}}), HasSubstr("expected none"));
  for (const float side : {0.25f, 0.3f, -0.1f, 0.0f, std::nanf("")}) {
    EXPECT_THAT(reason({PrefilterKind::kRecursive, side, 0, {}}), HasSubstr("inside the unit"));
  }
  EXPECT_THAT(reason({PrefilterKind::kRecursive, 0.1f, 1, {1}}), HasSubstr("has taps"));
  Prefilter fir = Fir();
  fir.taps[0] += 0.1f;
  EXPECT_THAT(reason(fir), HasSubstr("do not sum to 1"));
  fir = Fir();
  fir.taps[5] = 0.1f;
  EXPECT_THAT(reason(fir), HasSubstr("beyond its reach"));
  fir = Fir();
  fir.side = 0.2f;
  EXPECT_THAT(reason(fir), HasSubstr("does not invert its side"));
  fir.reach = 8;
  EXPECT_THAT(reason(fir), HasSubstr("other than 3, 5"));
}

TEST(SplineFamily, HasTheSamplesOfItsSideAndIsContinuous) {
  for (const double k : {0.0, 1.0 / 84, kOMomsK}) {
    const double side = SplineSide(k);
    const auto first = SplineTaps(k, 0.0), last = SplineTaps(k, 1.0);
    EXPECT_NEAR(first[0], side, 1e-16);
    EXPECT_NEAR(first[1], 1 - 2 * side, 1e-15);
    EXPECT_NEAR(first[2], side, 1e-15);
    EXPECT_NEAR(first[3], 0, 1e-15);
    for (int t = 0; t + 1 < kTaps; ++t) EXPECT_NEAR(first[t], last[t + 1], 1e-15);
    for (const double d : {0.1, 0.5, 0.77}) {
      const auto taps = SplineTaps(k, d), flipped = SplineTaps(k, 1 - d);
      double moment = 0;
      for (int t = 0; t < kTaps; ++t) {
        EXPECT_NEAR(taps[t], flipped[kTaps - 1 - t], 1e-15);
        moment += taps[t] * (t + kFirstTap - d);
      }
      EXPECT_NEAR(std::accumulate(taps.begin(), taps.end(), 0.0), 1, 1e-15);
      EXPECT_NEAR(moment, 0, 1e-15);  // of the prefilter it is 0 too: a ramp is moved by d
    }
  }
}

// The largest gains of the family over the nodes, by a dense grid of frequencies; that of the
// B-spline is 1.
TEST(SplineFamily, LargestGainsOverTheTable) {
  const auto largest = [](double k) {
    const Prefilter p{PrefilterKind::kRecursive, static_cast<float>(SplineSide(k)), 0, {}};
    double gain = 0;
    for (int i = 0; i < kNodes; ++i) {
      for (int j = 0; j <= i; ++j) {
        gain = std::max(gain, MaxGain(SplineWeights(k, NodeOffset(i), NodeOffset(j)), p).gain);
      }
    }
    return gain;
  };
  EXPECT_NEAR(largest(0), 1, 1e-6);
  EXPECT_NEAR(largest(1.0 / 84), 1.0075, 1e-4);
  EXPECT_NEAR(largest(kOMomsK), 1.0375, 1e-4);
}

TEST(PrefilteredHead, ZeroParametersAreTheSpline) {
  const Fit fit = MakeFit(0);
  const Weights<double> w = HeadWeights(fit.parameters.data(), 0.3, 0.8, 0.18);
  const Weights<double> spline = SplineWeights(SplineK(0.18), 0.3, 0.8);
  for (int k = 0; k < kWeights; ++k) EXPECT_EQ(w[k], spline[k]);
}

class PrefilteredHeadTest : public testing::TestWithParam<double> {
 protected:
  static constexpr double kSide = 0.18;
  const Fit fit_ = MakeFit(GetParam(), 7);
  Weights<double> At(double dx, double dy) const {
    return HeadWeights(fit_.parameters.data(), dx, dy, kSide);
  }
};
INSTANTIATE_TEST_SUITE_P(Sizes, PrefilteredHeadTest, testing::Values(0.0, 0.05, 1.0));

TEST_P(PrefilteredHeadTest, KeepsTheContractByConstruction) {
  const auto taps = SplineTaps(SplineK(kSide), 0.0);
  const Weights<double> whole = At(0, 0);
  const Weights<double> product = Separable(taps, taps);
  for (int k = 0; k < kWeights; ++k) EXPECT_NEAR(whole[k], product[k], 1e-12);
  for (const double d : {0.0, 0.2, 0.5, 0.9}) {
    const Weights<double> left = At(0, d), right = At(1, d);
    for (int y = -1; y <= 2; ++y) {
      EXPECT_NEAR(left[TapWeight(2, y)], 0, 1e-15);
      EXPECT_NEAR(left[TapWeight(-1, y)], left[TapWeight(1, y)], 1e-12);
      for (int x = -1; x < 2; ++x) {
        EXPECT_NEAR(left[TapWeight(x, y)], right[TapWeight(x + 1, y)], 1e-12);
      }
    }
    const Weights<double> w = At(d, 0.3);
    double sum = 0, moment = 0;
    for (int k = 0; k < kWeights; ++k) {
      sum += w[k];
      moment += w[k] * (TapX(k) - d);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(moment, 0, 1e-12);
    for (int g = 0; g < kSymmetries; ++g) {
      const auto [gx, gy] = MapOffset(g, d, 0.3);
      const Weights<double> image = At(gx, gy);
      for (int k = 0; k < kWeights; ++k) EXPECT_NEAR(image[MapWeight(g, k)], w[k], 1e-12);
    }
  }
}

TEST_P(PrefilteredHeadTest, GradientIsTheTranspose) {
  const HeadAt<double> head(0.3, 0.0625, kSide);
  const Fit a = MakeFit(1, 3), b = MakeFit(1, 4);
  Weights<double> x{}, y{};
  for (const int k : TapsOf(Footprint::k16)) {
    x[k] = a.parameters[k];
    y[k] = b.parameters[k];
  }
  const Weights<double> zero = head.Forward({}), forward = head.Forward(x);
  const Weights<double> backward = head.Backward(y);
  double left = 0, right = 0;
  for (int k = 0; k < kWeights; ++k) {
    left += (forward[k] - zero[k]) * y[k];
    right += x[k] * backward[k];
  }
  EXPECT_NEAR(left, right, 1e-13);
  constexpr double kStep = 1e-6;
  const Weights<double> up = HeadAt<double>(0.3, 0.0625, kSide + kStep).Forward(x);
  const Weights<double> down = HeadAt<double>(0.3, 0.0625, kSide - kStep).Forward(x);
  for (int k = 0; k < kWeights; ++k) {
    EXPECT_NEAR(head.base_slope()[k], (up[k] - down[k]) / (2 * kStep), 1e-8);
  }
}

class PrefilteredTableTest : public testing::TestWithParam<TableFormat> {};
INSTANTIATE_TEST_SUITE_P(Formats, PrefilteredTableTest,
                         testing::Values(TableFormat::kI16, TableFormat::kF16, TableFormat::kI8,
                                         TableFormat::kF32),
                         [](const auto& test) { return std::string(Name(test.param)); });

TEST_P(PrefilteredTableTest, KeepsTheContract) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Fit fit = WithPrefilter(MakeFit(seed == 0 ? 0 : 0.2, seed));
    const BakedTable table = Quantize(SampleFit(fit, kNodes), GetParam());
    EXPECT_EQ(table.view().prefilter, fit.prefilter);
    EXPECT_EQ(SentenceOf([&] { CheckTable(table.view(), "table"); }), "");
  }
}

TEST_P(PrefilteredTableTest, TheRowOfTheWholeOffsetClosesForEverySide) {
  for (double side = 0.02; side < 0.23; side += 0.0093) {
    const Fit fit = WithPrefilter(MakeFit(0), side);
    const BakedTable table = Quantize(SampleFit(fit, kNodes), GetParam());
    EXPECT_EQ(SentenceOf([&] { CheckTable(table.view(), "table"); }), "") << side;
  }
}

TEST_P(PrefilteredTableTest, RefusesThePrefilterOfAnother) {
  const BakedTable table = Quantize(SampleFit(WithPrefilter(MakeFit(0)), kNodes), GetParam());
  TableView other = table.view();
  other.prefilter.side = 0.13f;
  EXPECT_THAT(SentenceOf([&] { CheckTable(other, "t"); }), HasSubstr("do not belong together"));
  other.prefilter = {};
  EXPECT_THAT(SentenceOf([&] { CheckTable(other, "t"); }), HasSubstr("expected 0"));
  other.prefilter = {PrefilterKind::kRecursive, 0.3f, 0, {}};
  EXPECT_THAT(SentenceOf([&] { CheckTable(other, "t"); }), HasSubstr("inside the unit circle"));
}

TEST(PrefilteredTable, RefusesUnequalWeightsAboutAWholeOffset) {
  const BakedTable table =
      Quantize(SampleFit(WithPrefilter(MakeFit(0.2)), kNodes), TableFormat::kI16);
  std::vector<IntegerRow> rows = TableIntegers(table.view(), "t");
  rows[RowIndex(0, 5)][TapWeight(-1, 0)] += 1;
  rows[RowIndex(0, 5)][TapWeight(0, 0)] -= 1;
  const BakedTable changed(TableFormat::kI16, rows, table.view().prefilter);
  EXPECT_THAT(SentenceOf([&] { CheckTable(changed.view(), "t"); }), HasSubstr("both sides"));
}

class PrefilteredFilesTest : public testing::Test {
 protected:
  const std::filesystem::path folder_ = TestFolder();
  const std::filesystem::path path_ = folder_ / "fit.json";

  template <class Change>
  std::string SentenceAfter(const Fit& fit, const Change& change) {
    WriteFit(path_, fit);
    ordered_json json = ordered_json::parse(ReadFile(path_));
    change(json);
    WriteFile(path_, json.dump());
    return SentenceOf([&] { ReadFit(path_); });
  }
};

TEST_F(PrefilteredFilesTest, SurviveARoundTrip) {
  Fit fir = MakeFit(0.2);
  fir.prefilter = Fir();
  for (const Fit& fit : {WithPrefilter(MakeFit(0.2)), fir}) {
    WriteFit(path_, fit);
    EXPECT_EQ(ReadFit(path_).prefilter, fit.prefilter);
    const BakedFiles files = Bake(fit);
    EXPECT_EQ(files.exr, "");
    WriteBaked(folder_, files);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "test_fit.exr"));
    const LoadedTable loaded = LoadTable(folder_ / "test_fit.json");
    EXPECT_EQ(loaded.table.view().prefilter, fit.prefilter);
    EXPECT_THAT(files.header, HasSubstr("// Prefilter: the table reads coefficients"));
    EXPECT_THAT(files.header, HasSubstr("PrefilterKind::"));
  }
}

TEST_F(PrefilteredFilesTest, AFitWithoutPrefilterStaysOfVersionOne) {
  WriteFit(path_, MakeFit(0.2));
  EXPECT_EQ(ordered_json::parse(ReadFile(path_))["version"], 1);
  EXPECT_FALSE(HasPrefilter(ReadFit(path_).prefilter));
}

TEST_F(PrefilteredFilesTest, ReadingRefusesAWrongPrefilter) {
  const Fit fit = WithPrefilter(MakeFit(0));
  const auto changed = [&](const char* field, const ordered_json& value) {
    return SentenceAfter(fit, [&](auto& j) { j["prefilter"][field] = value; });
  };
  EXPECT_THAT(changed("pole", -1.2), HasSubstr("expected a number in (-1, 0)"));
  EXPECT_THAT(changed("pole", -0.4), HasSubstr("the pole of side"));
  EXPECT_THAT(changed("kind", "none"), HasSubstr("expected recursive or fir"));
  EXPECT_THAT(changed("side", 0.4), HasSubstr("prefilter"));
  EXPECT_THAT(changed("gain", 1), HasSubstr("unknown"));
  EXPECT_THAT(SentenceAfter(fit, [](auto& j) { j.erase("prefilter"); }),
              HasSubstr("'prefilter' is missing"));
  Fit fir = fit;
  fir.prefilter = Fir();
  EXPECT_THAT(SentenceAfter(fir, [](auto& j) { j["prefilter"]["taps"] = {1.0}; }),
              HasSubstr("expected 2 to 8"));
  EXPECT_THAT(SentenceAfter(fir, [](auto& j) { j["prefilter"]["taps"][0] = 2.0; }),
              HasSubstr("do not sum to 1"));
}

TEST_F(PrefilteredFilesTest, TheReleasedLayoutRefusesAPrefilter) {
  EXPECT_THAT(SentenceOf([] { ToReleasedLayout(WithPrefilter(MakeFit(0))); }),
              HasSubstr("has a prefilter; expected one without"));
}

}  // namespace
}  // namespace warplut
