// Footprints of 24 and 36 taps: kernel, head, table and files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "baked/test_24.h"
#include "luts/bake/bake.h"
#include "luts/bake/released_layout.h"
#include "luts/bake/table_io.h"
#include "luts/certificate/gain.h"
#include "luts/fit/head.h"
#include "luts/footprint_names.h"
#include "luts/quantize/quantize.h"
#include "test_fits.h"

namespace warplut {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

constexpr double kB = 4.5;

TEST(Footprint, ListsItsTapsRowByRow) {
  for (const Footprint footprint : kFootprints) {
    int last = -1;
    for (const int k : TapsOf(footprint)) {
      EXPECT_GT(k, last);
      EXPECT_TRUE(HasTap(footprint, TapX(k), TapY(k)));
      last = k;
    }
    EXPECT_EQ(FootprintWith(TapCount(footprint)), footprint);
  }
  EXPECT_FALSE(FootprintWith(20).has_value());
  EXPECT_EQ(FootprintNames(), "16, 24 or 36");
  for (const auto& [x, y] :
       {std::pair(0, -2), {1, -2}, {0, 3}, {1, 3}, {-2, 0}, {-2, 1}, {3, 0}, {3, 1}}) {
    EXPECT_TRUE(HasTap(Footprint::k24, x, y));
    EXPECT_FALSE(HasTap(Footprint::k16, x, y));
  }
  EXPECT_FALSE(HasTap(Footprint::k24, -2, -1));
}

TEST(KaiserTaps, AreTheWindowedSinc) {
  for (const double b : {0.0, 4.5, 12.0, 32.0}) {
    for (const double d : {0.0, 1e-9, 0.1, 0.5, 0.8, 1.0}) {
      const WindowTaps<double> taps = KaiserTaps(b, d), mirrored = KaiserTaps(b, 1 - d);
      WindowTaps<double> direct{};
      for (int i = 0; i < kWindowTaps; ++i) {
        const double t = d - (i + kFirstWindowTap);
        const double inside = std::max(0.0, 1 - t * t / 9);
        const double angle = std::numbers::pi * t;
        direct[i] =
            (t == 0 ? 1 : std::sin(angle) / angle) * std::cyl_bessel_i(0.0, b * std::sqrt(inside));
      }
      const double total = std::accumulate(direct.begin(), direct.end(), 0.0);
      for (int i = 0; i < kWindowTaps; ++i) {
        EXPECT_NEAR(taps[i], direct[i] / total, 1e-14) << b << " " << d;
        EXPECT_NEAR(taps[i], mirrored[kWindowTaps - 1 - i], 1e-14);
      }
    }
    EXPECT_EQ(KaiserTaps(b, 0.0), (WindowTaps<double>{0, 0, 1, 0, 0, 0}));
    EXPECT_EQ(KaiserTaps(b, 1.0), (WindowTaps<double>{0, 0, 0, 1, 0, 0}));
  }
}

class WideFootprint : public testing::TestWithParam<Footprint> {
 protected:
  Fit MakeWideFit(double size, std::uint64_t seed = 7) const {
    Fit fit = MakeFit(0);
    fit.footprint = GetParam();
    fit.kaiser_b = kB;
    fit.parameters.resize(MlpParameters(GetParam()));
    std::mt19937_64 random(seed);
    for (double& p : fit.parameters) {
      p = size * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
    }
    return fit;
  }
};
INSTANTIATE_TEST_SUITE_P(Taps, WideFootprint, testing::Values(Footprint::k24, Footprint::k36),
                         [](const auto& test) { return std::to_string(TapCount(test.param)); });

TEST_P(WideFootprint, HeadKeepsTheContractByConstruction) {
  for (const double size : {0.0, 0.05, 1.0, 100.0}) {
    const Fit fit = MakeWideFit(size);
    const auto at = [&](double dx, double dy) { return FitWeights(fit, dx, dy); };
    const double bound = 1e-11 * (1 + size);
    const Weights<double> whole = at(0, 0);
    for (int k = 0; k < kWeights; ++k) {
      EXPECT_NEAR(whole[k], k == kIdentityWeight ? 1 : 0, bound);
    }
    for (const double d : {0.0, 0.2, 0.5, 0.9}) {
      const Weights<double> left = at(0, d), right = at(1, d), w = at(d, 0.3);
      double sum = 0;
      for (int k = 0; k < kWeights; ++k) {
        if (TapX(k) != 0) {
          EXPECT_EQ(left[k], 0);
        } else {
          EXPECT_NEAR(left[k], right[k + 1], bound);
        }
        if (!HasTap(GetParam(), TapX(k), TapY(k))) {
          EXPECT_EQ(w[k], 0);
        }
        sum += w[k];
      }
      EXPECT_NEAR(sum, 1, bound);
      for (int g = 0; g < kSymmetries; ++g) {
        const auto [gx, gy] = MapOffset(g, d, 0.3);
        const Weights<double> image = at(gx, gy);
        for (int k = 0; k < kWeights; ++k) EXPECT_NEAR(image[MapWeight(g, k)], w[k], bound);
      }
    }
  }
}

TEST_P(WideFootprint, ZeroParametersAreTheWideKernel) {
  const Weights<double> w = FitWeights(MakeWideFit(0), 0.3, 0.8);
  const Weights<double> kernel = WideWeights(GetParam(), kB, 0.3, 0.8);
  for (int k = 0; k < kWeights; ++k) EXPECT_NEAR(w[k], kernel[k], 1e-15);
}

TEST_P(WideFootprint, HeadGradientEqualsTheComplexStep) {
  using Complex = std::complex<double>;
  constexpr double kStep = 1e-100;
  const Weights<double> kernel = WideWeights(GetParam(), kB, 0.3, 0.0625);
  const HeadAt<double> head(GetParam(), kernel, 0.3, 0.0625);
  const HeadAt<Complex> complex_head(GetParam(), kernel, Complex(0.3), Complex(0.0625));
  Weights<double> factors{};
  for (int k = 0; k < kWeights; ++k) factors[k] = std::sin(k + 1.0);
  const Weights<double> gradient = head.Backward(factors);
  for (int j = 0; j < kWeights; ++j) {
    Weights<Complex> mean{};
    for (int k = 0; k < kWeights; ++k) mean[k] = Complex(0.1 * (k % 5 - 2), k == j ? kStep : 0);
    const Weights<Complex> w = complex_head.Forward(mean);
    double exact = 0;
    for (int k = 0; k < kWeights; ++k) exact += factors[k] * w[k].imag() / kStep;
    EXPECT_NEAR(gradient[j], exact, 1e-13) << j;
  }
}

TEST_P(WideFootprint, TablesKeepTheContractInEveryFormat) {
  for (const TableFormat format :
       {TableFormat::kI16, TableFormat::kF16, TableFormat::kI8, TableFormat::kF32}) {
    for (const double size : {0.0, 0.1}) {
      const BakedTable table = Quantize(SampleFit(MakeWideFit(size), kNodes), format);
      EXPECT_EQ(table.view().footprint, GetParam());
      EXPECT_EQ(SentenceOf([&] { CheckTable(table.view(), "table"); }), "") << Name(format);
    }
  }
}

TEST_P(WideFootprint, GainAgreesWithADenseGrid) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Weights<double> w = FitWeights(MakeWideFit(0.3, seed), 0.125 * seed, 0.25);
    constexpr int kSteps = 256;
    double dense = 0;
    for (int a = 0; a <= kSteps / 2; ++a) {
      for (int b = 0; b < kSteps; ++b) {
        // The definition.
        std::complex<double> sum = 0;
        for (int k = 0; k < kWeights; ++k) {
          const double phase = 2 * std::numbers::pi / kSteps * (a * TapX(k) + b * TapY(k));
          sum += w[k] * std::polar(1.0, -phase);
        }
        dense = std::max(dense, std::abs(sum));
      }
    }
    const double gain = MaxGain(w).gain;
    EXPECT_GE(gain, dense * (1 - 1e-9));
    EXPECT_LE(gain, dense * (1 + 4e-3));  // what so many steps may miss
  }
}

TEST_P(WideFootprint, FilesSurviveARoundTrip) {
  const std::filesystem::path folder = TestFolder();
  const Fit fit = MakeWideFit(0.1);
  WriteFit(folder / "fit.json", fit);
  const Fit read = ReadFit(folder / "fit.json");
  EXPECT_EQ(read.footprint, GetParam());
  EXPECT_EQ(read.kaiser_b, kB);
  EXPECT_EQ(read.parameters, fit.parameters);
  const BakedFiles files = Bake(read);
  EXPECT_EQ(files.json, Bake(fit).json);
  EXPECT_EQ(files.exr, "");
  WriteBaked(folder, files);
  EXPECT_FALSE(std::filesystem::exists(folder / "test_fit.exr"));
  const LoadedTable loaded = LoadTable(folder / "test_fit.json");
  EXPECT_EQ(loaded.table.view().footprint, GetParam());
  const std::vector<IntegerRow> expected =
      TableIntegers(Quantize(SampleFit(fit, kNodes), TableFormat::kI16).view(), "t");
  EXPECT_EQ(TableIntegers(loaded.table.view(), "t"), expected);
  EXPECT_EQ(TableIntegers(LoadTable(folder / "fit.json").table.view(), "t"), expected);
  const std::string taps = std::to_string(TapCount(GetParam()));
  EXPECT_THAT(files.header, HasSubstr("TableValues(Footprint::k" + taps + ")"));
}

TEST_P(WideFootprint, RefusesWhatDoesNotGoTogether) {
  const std::filesystem::path path = TestFolder() / "fit.json";
  const auto after = [&](const auto& change) {
    WriteFit(path, MakeWideFit(0));
    ordered_json json = ordered_json::parse(ReadFile(path));
    change(json);
    WriteFile(path, json.dump());
    return SentenceOf([&] { ReadFit(path); });
  };
  EXPECT_THAT(after([](auto& j) { j["taps"] = 20; }),
              HasSubstr("field 'taps' is 20; expected 16, 24 or 36"));
  EXPECT_THAT(after([](auto& j) { j.erase("taps"); }), HasSubstr("'prefilter' is missing"));
  EXPECT_THAT(after([](auto& j) { j["kaiser_b"] = 33; }),
              HasSubstr("kaiser_b is 33, expected a number in [0, 32]"));
  EXPECT_THAT(after([](auto& j) { j["version"] = 1; }), HasSubstr("is unknown"));
  EXPECT_THAT(after([](auto& j) { j["parameters"].erase(0); }), HasSubstr("values, expected"));
  EXPECT_THAT(SentenceOf([&] { Bake(WithPrefilter(MakeWideFit(0))); }),
              HasSubstr("taps and a prefilter; expected none but with 16 taps"));
  EXPECT_THAT(SentenceOf([&] { ToReleasedLayout(MakeWideFit(0)); }),
              HasSubstr("taps; expected 16, as the released layout holds no other table"));
  Fit narrow = MakeFit(0);
  narrow.kaiser_b = 4;
  EXPECT_THAT(SentenceOf([&] { Bake(narrow); }), HasSubstr("kaiser_b is 4, expected 0 of 16 taps"));
}

TEST_P(WideFootprint, ATableWithTapsAndPrefilterIsRefused) {
  const std::filesystem::path path = TestFolder() / "table.json";
  ordered_json json = ordered_json::parse(Bake(MakeWideFit(0)).json);
  json["prefilter"] = ordered_json::parse(Bake(WithPrefilter(MakeFit(0))).json)["prefilter"];
  WriteFile(path, json.dump());
  EXPECT_THAT(SentenceOf([&] { LoadTable(path); }),
              HasSubstr("taps and a prefilter; expected none but with 16 taps"));
}

TEST(WideHeader, CompiledHeaderHoldsTheTable) {
  const TableView& view = baked::kTest_24;
  EXPECT_EQ(view.footprint, Footprint::k24);
  EXPECT_EQ(SentenceOf([&] { CheckTable(view, "header"); }), "");
  const std::vector<IntegerRow> rows = TableIntegers(view, "header");
  EXPECT_EQ(rows[0][kIdentityWeight], 1 << FractionBits(view.format));
  EXPECT_NE(rows[RowIndex(kNodes / 2, kNodes / 2)][TapWeight(0, -2)], 0);
}

}  // namespace
}  // namespace warplut
