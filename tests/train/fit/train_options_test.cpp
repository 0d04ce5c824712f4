#include "train/fit/train_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "luts/certificate/certificate.h"
#include "runtime/parameters.h"

namespace warplut {
namespace {

TEST(TrainOptions, DefaultsAreValidAndResolve) {
  std::string why;
  EXPECT_TRUE(TrainOptions().IsValid(&why)) << why;
  const TrainOptions resolved = TrainOptions().Resolved();
  EXPECT_TRUE(resolved.IsValid(&why)) << why;
  EXPECT_EQ(resolved.horizons, (std::vector<int>{6, 12, 24, 64}));
  EXPECT_GT(resolved.gain_bound, 1);
  EXPECT_GT(resolved.crops, 0);
  EXPECT_GT(resolved.iterations, 0);
}

TEST(TrainOptions, HorizonsOfEveryFactorAreValidAndGrow) {
  int last = 0;
  for (const double scale : {1.0, 1.3, 1.5, 1.7, 2.0, 3.0, 4.0}) {
    TrainOptions options;
    options.scale = scale;
    options.horizons = DefaultHorizons(scale);
    std::string why;
    EXPECT_TRUE(options.IsValid(&why)) << why;
    EXPECT_GT(options.horizons.back(), last);
    last = options.horizons.back();
    EXPECT_LE(std::pow(DefaultGainBound(last), last), kSafeGrowth);
  }
}

TEST(TrainOptions, BlendAndPansOfObjectiveSrResolveToThePipelines) {
  TrainOptions options;
  EXPECT_EQ(options.Resolved().Json().find("blend"), std::string::npos);
  EXPECT_EQ(*options.Resolved().pan_share, kPanShare);
  options.prefilter = TrainPrefilter::kNone;
  EXPECT_EQ(*options.Resolved().pan_share, kPlainPanShare);
  options.objective = TrainObjective::kSr;
  const TrainOptions resolved = options.Resolved();
  EXPECT_EQ(static_cast<float>(*resolved.blend_a), Parameters().blend_a);
  EXPECT_EQ(static_cast<float>(*resolved.blend_b), Parameters().blend_b);
  EXPECT_EQ(*resolved.pan_share, kSrPanShare);
  EXPECT_EQ(*resolved.aliasing, kSrAliasing);
  options.blend_a = 2.5;
  options.blend_b = 0.8;
  const std::string json = options.Resolved().Json();
  EXPECT_NE(json.find("\"objective\":\"sr\",\"blend_a\":2.5,\"blend_b\":0.8"), std::string::npos)
      << json;
}

TEST(TrainOptions, PrefiltersHaveNames) {
  EXPECT_EQ(PrefilterName({}), "iir");
  for (const std::string name : {"none", "spline", "iir", "fir:3", "fir:15"}) {
    TrainOptions options;
    ASSERT_TRUE(SetPrefilter(name, &options));
    EXPECT_EQ(PrefilterName(options), name);
    EXPECT_TRUE(options.IsValid(nullptr)) << name;
    EXPECT_NE(options.Resolved().Json().find("\"prefilter\":\"" + name + "\""), std::string::npos);
  }
  for (const std::string name : {"", "fir", "fir:", "fir:9x", "IIR", "keys"}) {
    TrainOptions options;
    EXPECT_FALSE(SetPrefilter(name, &options)) << name;
    EXPECT_EQ(options.prefilter, TrainPrefilter::kIir);
  }
}

TEST(TrainOptions, MoreTapsStandAlone) {
  TrainOptions options;
  options.footprint = Footprint::k24;
  std::string why;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_EQ(why, "taps is 24 with prefilter iir; expected prefilter none with more than 16 taps.");
  options.prefilter = TrainPrefilter::kNone;
  EXPECT_TRUE(options.IsValid(&why));
  EXPECT_NE(options.Resolved().Json().find("\"taps\":24"), std::string::npos);
  EXPECT_EQ(*options.Resolved().pan_share, kWidePanShare);
  EXPECT_EQ(options.Resolved().crops, kDefaultWideCropWarps / 64);
  EXPECT_EQ(TrainOptions().Resolved().Json().find("taps"), std::string::npos);
}

TEST(TrainOptions, EachBadValueIsNamed) {
  const std::vector<std::pair<std::string, std::function<void(TrainOptions&)>>> cases = {
      {"scale", [](TrainOptions& o) { o.scale = 0.9; }},
      {"scale", [](TrainOptions& o) { o.scale = NAN; }},
      {"scale", [](TrainOptions& o) { o.scale = 4.1; }},
      {"horizon 5",
       [](TrainOptions& o) {
         o.horizons = {2, 5};
       }},
      {"horizon 4",
       [](TrainOptions& o) {
         o.horizons = {6, 4};
       }},
      {"horizon 2000", [](TrainOptions& o) { o.horizons = {2000}; }},
      {"horizon 0", [](TrainOptions& o) { o.horizons = {0}; }},
      {"fir_taps is 4", [](TrainOptions& o) { SetPrefilter("fir:4", &o); }},
      {"fir_taps is 17", [](TrainOptions& o) { SetPrefilter("fir:17", &o); }},
      {"fir_taps is 1", [](TrainOptions& o) { SetPrefilter("fir:1", &o); }},
      {"fir_taps is 9", [](TrainOptions& o) { o.fir_taps = 9; }},
      {"threads", [](TrainOptions& o) { o.threads = -1; }},
      {"max_seconds", [](TrainOptions& o) { o.max_seconds = -1; }},
      {"max_seconds", [](TrainOptions& o) { o.max_seconds = NAN; }},
      {"stages", [](TrainOptions& o) { o.stages = 0; }},
      {"iterations", [](TrainOptions& o) { o.iterations = -2; }},
      {"gain_bound", [](TrainOptions& o) { o.gain_bound = 0.5; }},
      {"pan_share", [](TrainOptions& o) { o.pan_share = 1; }},
      {"blend_a", [](TrainOptions& o) { o.blend_a = 0.5; }},
      {"aliasing is set", [](TrainOptions& o) { o.aliasing = 0.5; }},
      {"aliasing is -1",
       [](TrainOptions& o) {
         o.objective = TrainObjective::kSr;
         o.aliasing = -1;
       }},
      {"blend_a is 9",
       [](TrainOptions& o) {
         o.objective = TrainObjective::kSr;
         o.blend_a = 9;
       }},
      {"blend_b is -1",
       [](TrainOptions& o) {
         o.objective = TrainObjective::kSr;
         o.blend_b = -1;
       }},
      {"crops", [](TrainOptions& o) { o.crops = -1; }},
      {"checkpoint", [](TrainOptions& o) { o.resume = true; }},
  };
  for (const auto& [name, change] : cases) {
    TrainOptions options;
    change(options);
    std::string why;
    EXPECT_FALSE(options.IsValid(&why)) << name;
    EXPECT_NE(why.find(name), std::string::npos) << why;
    EXPECT_EQ(why.back(), '.');
  }
}

}  // namespace
}  // namespace warplut
