#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "luts/filters.h"
#include "luts/fit/fit.h"
#include "luts/quantize/quantize.h"
#include "luts/quantize/real_table.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/luts/test_fits.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"
#include "tools/judge/images/sr_cross.h"
#include "train/fit/rivals/keys_search.h"

namespace warplut {
namespace {

// A fit whose residual is zero: Catmull-Rom.
class CrossCommand : public testing::Test {
 protected:
  CrossCommand() {
    WriteFit(Path("zero.json"), MakeFit(0, 1, "zero"));
    WriteWavyImage(Path("image.png"), 160, 140);
  }
  std::string Path(const std::string& name) const { return folder_ / name; }
  ProgramResult Cross(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {
        "cross", "--luts", Path("zero.json"), "--images", Path("image.png"), "--crops", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunWarplut(arguments);
  }

  const TemporaryFolder folder_;
};

TEST_F(CrossCommand, ATableOfCatmullRomScoresLikeIt) {
  const ProgramResult result = Cross({"--scales", "1,1.3", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto factors = nlohmann::json::parse(result.out)["factors"];
  ASSERT_EQ(factors.size(), 2U);
  EXPECT_EQ(factors[1]["scale"], 1.3);
  for (const auto& factor : factors) {
    const auto& scores = factor["scores"];
    ASSERT_EQ(scores.size(), 3U);
    EXPECT_EQ(scores[0]["filter"], "catmull-rom");
    EXPECT_EQ(scores[1]["filter"], "zero");
    EXPECT_NEAR(scores[0]["loss"], scores[1]["loss"].get<double>(), 1e-2);
    EXPECT_LE(scores[2]["loss"], scores[0]["loss"]);
    EXPECT_EQ(scores[0]["ssim"].size(), factor["protocols"].size());
  }
}

TEST_F(CrossCommand, PrintsTheSameTableForAnyNumberOfThreads) {
  const auto print = [&](const std::string& threads) {
    return Cross({"--scales", "1", "--markdown", "--threads", threads}).out;
  };
  const std::string one = print("1");
  EXPECT_THAT(one, testing::HasSubstr("| L at factor | 1 |"));
  EXPECT_EQ(one, print("2"));
}

TEST_F(CrossCommand, RefusesWhatItCannotJudge) {
  const ProgramResult scale = Cross({"--scales", "5"});
  EXPECT_EQ(scale.code, 1);
  EXPECT_THAT(scale.err, testing::HasSubstr("scale is 5"));
  WriteWavyImage(Path("image.png"), 100, 140);
  const ProgramResult small = Cross({"--scales", "1"});
  EXPECT_EQ(small.code, 2);
  EXPECT_THAT(small.err, testing::HasSubstr("100 x 140"));
}

TEST(SrCross, WeightsOfATableAreThoseOfItsFirstOctant) {
  const RealTable keys =
      SampleWeights("keys", kNodes, [](double dx, double dy) { return KeysWeights(-0.6, dx, dy); });
  const CanonicalWeights<double> expected = KeysCanonicalWeights(-0.6);
  const CanonicalWeights<double> weights =
      TableResampler(Quantize(keys, TableFormat::kI16)).weights;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    for (int k = 0; k < kWeights; ++k) EXPECT_NEAR(weights[c][k], expected[c][k], 3e-4);
  }
}

}  // namespace
}  // namespace warplut
