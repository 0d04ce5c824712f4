#include "luts/bake/table_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "datasets/images/image_io.h"
#include "luts/bake/bake.h"
#include "luts/bake/released_layout.h"
#include "luts/filters.h"
#include "luts/quantize/quantize.h"
#include "tests/luts/quantization_error.h"
#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

class TableIoTest : public testing::Test {
 protected:
  const std::filesystem::path folder_ = TestFolder();

  std::filesystem::path Written(const Image& image, PixelType type = PixelType::kFloat) {
    WriteImage(folder_ / "table.exr", image, type);
    return folder_ / "table.exr";
  }

  template <class Change>
  std::string SentenceAfter(const Change& change) {
    const std::filesystem::path path = folder_ / "test_fit.json";
    static const ordered_json kGood = ordered_json::parse(Bake(MakeFit(0)).json);
    ordered_json json = kGood;
    change(json);
    WriteFile(path, json.dump());
    const std::string sentence = SentenceOf([&] { LoadTable(path); });
    EXPECT_THAT(sentence, HasSubstr(path.string()));
    return sentence;
  }
};

std::vector<IntegerRow> Integers(const BakedTable& table) {
  return TableIntegers(table.view(), "table");
}

TEST_F(TableIoTest, ReadsEveryBakedFormatAsItWasStored) {
  const Fit fit = MakeFit(0.2);
  for (const TableFormat format :
       {TableFormat::kI16, TableFormat::kF16, TableFormat::kI8, TableFormat::kF32}) {
    WriteBaked(folder_, Bake(fit, {format, kDefaultBlend}));
    const LoadedTable loaded = LoadTable(folder_ / "test_fit.json", TableFormat::kI8);
    EXPECT_EQ(loaded.name, "test_fit");
    EXPECT_EQ(loaded.scale, fit.scale);
    EXPECT_EQ(loaded.table.format(), format);
    EXPECT_EQ(Integers(loaded.table), Integers(Quantize(SampleFit(fit, kNodes), format)));
  }
}

TEST_F(TableIoTest, ReadsAFit) {
  const Fit fit = MakeFit(0.2);
  WriteFit(folder_ / "fit.json", fit);
  const LoadedTable loaded = LoadTable(folder_ / "fit.json", TableFormat::kF16);
  EXPECT_EQ(loaded.name, "test_fit");
  EXPECT_EQ(loaded.scale, 2.0);
  EXPECT_EQ(Integers(loaded.table), Integers(Quantize(SampleFit(fit, kNodes), TableFormat::kF16)));
}

TEST_F(TableIoTest, ReadsTheReleasedLayout) {
  const Fit fit = MakeFit(0.2);
  WriteBaked(folder_, Bake(fit));
  const LoadedTable loaded = LoadTable(folder_ / "test_fit.exr", TableFormat::kF32);
  EXPECT_EQ(loaded.name, "test_fit");
  EXPECT_FALSE(loaded.scale.has_value());
  EXPECT_LT(QuantizationError(SampleFit(fit, kNodes), loaded.table.view()), 1e-4);
}

TEST_F(TableIoTest, ReadsCatmullRomInHalfFloat) {
  const auto path = Written(ToReleasedLayout(MakeFit(0)), PixelType::kHalf);
  const BakedTable table = LoadTable(path).table;
  EXPECT_LT(QuantizationError(SampleFit(MakeFit(0), kNodes), table.view()), kReleasedTolerance);
}

TEST_F(TableIoTest, ReleasedLayoutPutsTapsInTiles) {
  const Image image = ToReleasedLayout(MakeFit(0));
  ASSERT_EQ(image.width, 128);
  ASSERT_EQ(image.height, 128);
  for (const auto& [ix, jy] : {std::pair(0, 0), {3, 17}, {31, 31}, {20, 0}}) {
    const Weights<double> w = KeysWeights(kCatmullRomA, ix / 31.0, jy / 31.0);
    float sum = 0;
    for (int ky = 0; ky < 4; ++ky) {
      for (int kx = 0; kx < 4; ++kx) {
        EXPECT_NEAR(image.at(kx * 32 + ix, ky * 32 + jy), w[TapWeight(kx - 1, ky - 1)], 1e-6);
        sum += image.at(kx * 32 + ix, ky * 32 + jy);
      }
    }
    EXPECT_EQ(sum, 1.0f);
  }
}

TEST_F(TableIoTest, RefusesAnotherFile) {
  const auto sentence = [](const std::filesystem::path& path) {
    return SentenceOf([&] { LoadTable(path); });
  };
  EXPECT_THAT(sentence(folder_ / "a.txt"),
              HasSubstr("a.txt' is no table: expected a fit or baked table"));
  EXPECT_THAT(sentence(folder_ / "none.json"), HasSubstr("none.json"));
  EXPECT_THAT(sentence(folder_ / "none.exr"), HasSubstr("none.exr"));
  WriteFile(folder_ / "a.json", R"({"format":"warplut-sequence"})");
  EXPECT_THAT(
      sentence(folder_ / "a.json"),
      HasSubstr(
          "field 'format' is \"warplut-sequence\"; expected \"warplut-fit\" or \"warplut-table\""));
}

TEST_F(TableIoTest, RefusesADamagedTable) {
  EXPECT_THAT(SentenceAfter([](auto& j) { j["version"] = 3; }),
              HasSubstr("field 'version' is 3; expected 1 to 2"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["version"] = 2; }),
              HasSubstr("field 'prefilter' is missing"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["nodes"] = 16; }),
              HasSubstr("field 'nodes' is 16; expected 32"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["scale"] = 0; }),
              HasSubstr("field 'scale' is 0; expected at least 1"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["fraction_bits"] = 6; }),
              HasSubstr("field 'fraction_bits' is 6; expected 14"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["storage"] = "i32"; }),
              HasSubstr("field 'storage' is \"i32\"; expected i16 or f16 or i8 or f32"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["values"].erase(0); }),
              HasSubstr("field 'values' has 16383 values; expected 16384"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["values"][7] = 32768; }),
              HasSubstr("field 'values[7]' is 32768, which i16 cannot store"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["values"][7] = 0.5; }),
              HasSubstr("field 'values[7]' is 0.5; expected a whole number"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["values"][16 * 40 + 5] = 0; }),
              HasSubstr("the weights of node (8, 1) sum to"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j.erase("certificate"); }),
              HasSubstr("field 'certificate' is missing"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["x"] = 1; }), HasSubstr("field 'x' is unknown"));
}

TEST_F(TableIoTest, RefusesAnImageThatIsNotTheLayout) {
  const auto sentence = [this](const Image& image) {
    const auto path = Written(image);
    const std::string text = SentenceOf([&] { LoadTable(path); });
    EXPECT_THAT(text, HasSubstr(path.string()));
    return text;
  };
  EXPECT_THAT(sentence(Image(64, 128, 1)),
              HasSubstr("is 64 x 128 with 1 channel(s), expected 128 x 128 with one"));
  EXPECT_THAT(sentence(Image(128, 128, 3)), HasSubstr("with 3 channel(s)"));
  EXPECT_THAT(sentence(Image(128, 128, 1)),
              HasSubstr("the weights of node (0, 0) sum to 0, expected 1 within"));
  const Image good = ToReleasedLayout(MakeFit(0));
  Image image = good;
  image.at(32, 32) = 0.5f;
  image.at(64, 32) = 0.5f;
  EXPECT_THAT(sentence(image), HasSubstr("weight 6 of node (0, 0) is 0.5, expected 0 within"));
  image = good;
  image.at(32 + 0, 32 + 7) += 0.25f;
  image.at(32 + 0, 64 + 7) -= 0.25f;
  EXPECT_THAT(sentence(image),
              HasSubstr("the weights at node 7 of the first and last column differ by 0.25"));
  image = good;
  image.at(3, 4) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(sentence(image), HasSubstr("is nan"));
}

}  // namespace
}  // namespace warplut
