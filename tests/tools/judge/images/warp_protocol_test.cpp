#include <gtest/gtest.h>

#include "tests/tools/test_images.h"
#include "tools/judge/images/filter_scores.h"
#include "tools/judge/images/protocol_filter.h"

namespace warplut {
namespace {

const ProtocolOptions kOptions{.trajectories = 2, .seed = 3, .on_warps = {}};

double Score(const std::string& filter, const Protocol& protocol,
             const std::vector<Image>& images) {
  return ProtocolScore(NamedFilter(filter), protocol, images, kOptions);
}

TEST(WarpProtocol, AFilterThatDoesNothingIsPerfect) {
  const ProtocolFilter identity{
      .name = "identity",
      .warp = [](const Image& in, const Displacement&, Image& out) { out = in; }};
  const std::vector<Image> images = {WavyImage(64, 64, 1), WavyImage(70, 60, 1)};
  EXPECT_NEAR(ProtocolScore(identity, {.warps = 6, .offsets = Offsets::kRandom}, images, kOptions),
              1, 1e-6);
}

TEST(WarpProtocol, ATrajectoryEndsWhereItBegan) {
  // A ramp is reproduced exactly by every filter that sums to 1 and is linear-exact, but for where
  // it is.
  Image ramp(64, 64, 1);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) ramp.at(x, y) = 0.1f + 0.01f * static_cast<float>(x);
  }
  const Image warped = WarpRepeatedly(NamedFilter("catmull-rom"),
                                      {.warps = 12, .offsets = Offsets::kRandom}, ramp, 0, 0, 5);
  for (int x = 28; x < 36; ++x) EXPECT_NEAR(warped.at(x, 32), ramp.at(x, 32), 1e-4);
}

TEST(WarpProtocol, SharperFiltersKeepMore) {
  const std::vector<Image> images = {WavyImage(80, 80, 1)};
  for (const Offsets offsets : {Offsets::kHalf, Offsets::kRandom}) {
    const Protocol protocol{.warps = 6, .offsets = offsets};
    const double bilinear = Score("bilinear", protocol, images);
    const double catmull_rom = Score("catmull-rom", protocol, images);
    EXPECT_LT(bilinear, catmull_rom);
    EXPECT_LT(catmull_rom, Score("keys:-0.6", protocol, images));
    EXPECT_LT(Score("catmull-rom", {.warps = 24, .offsets = offsets}, images), catmull_rom);
  }
}

TEST(WarpProtocol, KeysIsCatmullRomAtMinusOneHalf) {
  const std::vector<Image> images = {WavyImage(64, 64, 1)};
  const Protocol protocol{.warps = 4, .offsets = Offsets::kRandom};
  EXPECT_NEAR(Score("keys:-0.5", protocol, images), Score("catmull-rom", protocol, images), 1e-6);
}

TEST(WarpProtocol, TheBestOfAFamilyIsAtLeastAsGoodAsAnyOther) {
  const std::vector<Image> images = {WavyImage(64, 64, 1)};
  const std::vector<Protocol> protocols = {{.warps = 6, .offsets = Offsets::kHalf}};
  const auto expect_best = [&](const char* family, const std::vector<const char*>& others) {
    const FilterScores best = ScoreNamed(family, protocols, images, kOptions);
    ASSERT_EQ(best.parameters.size(), 1U) << family;
    EXPECT_EQ(best.family, FindFamily(family));
    for (const char* other : others) {
      EXPECT_GE(best.ssim[0] + 1e-4, Score(other, protocols[0], images)) << other;
    }
  };
  expect_best(kBestKeys, {"keys:-0.5", "keys:-0.6", "keys:-0.8", "keys:-0.95"});
  expect_best(kBestSpline, {"spline:0", "spline:1/84", "o-moms", "spline:0.05"});
}

TEST(WarpProtocol, APanOfAnyLengthEndsWhereItBegan) {
  const std::vector<Image> images = {WavyImage(80, 80, 1)};
  for (const int warps : {5, 6, 12}) {
    const Protocol pan{.warps = warps, .offsets = Offsets::kPan};
    EXPECT_GT(Score("spline:1/84", pan, images), 0.99) << warps;
  }
}

TEST(WarpProtocol, ExceptionsOfTheCallbackEndIt) {
  ProtocolOptions options = kOptions;
  options.on_warps = [](int) { throw std::runtime_error("stop"); };
  EXPECT_THROW(ProtocolScore(NamedFilter("bilinear"), {}, {WavyImage(64, 64, 1)}, options),
               std::runtime_error);
}

}  // namespace
}  // namespace warplut
