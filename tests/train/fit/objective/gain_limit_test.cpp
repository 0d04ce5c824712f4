#include "train/fit/objective/gain_limit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "luts/certificate/certificate.h"
#include "train/fit/objective/mlp_objective.h"
#include "train/fit/rivals/kaiser_family.h"
#include "train/fit/rivals/spline_family.h"
#include "train/fit/train_options.h"

namespace warplut {
namespace {

double GainOf(const std::vector<double>& parameters) {
  ResamplerModel model;
  return LargestNodeGain(model.Forward(parameters.data()));
}

TEST(GainLimit, TakesAwayNoMoreThanItMust) {
  ResamplerModel model;
  for (const double size : {1.0, 10.0, 1000.0}) {
    for (const double limit : {1.001, 1.01, 1.1}) {
      std::vector<double> parameters = RandomParameters(3);
      for (double& p : parameters) p *= size;
      const double before = GainOf(parameters);
      const double share = LimitGain(limit, model, parameters);
      const double after = GainOf(parameters);
      EXPECT_LE(after, limit + 1e-12);
      EXPECT_EQ(share<1, before> limit);
      if (share < 1) {
        EXPECT_GT(after, 1 + 0.99 * (limit - 1) - 2e-3 * (before - 1));
      }
    }
  }
}

TEST(GainLimit, LeavesWhatKeepsItAlone) {
  ResamplerModel model;
  std::vector<double> parameters = RandomParameters(3);
  for (double& p : parameters) p *= 1e-3;
  const std::vector<double> before = parameters;
  EXPECT_EQ(LimitGain(1.01, model, parameters), 1);
  EXPECT_EQ(parameters, before);
}

TEST(GainLimit, BoundsMoreTaps) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    ResamplerModel model(footprint, 6);
    ASSERT_LE(LargestNodeGain(WideBase(footprint, 6)), 1.01);
    for (const double size : {1e-3, 1.0, 100.0}) {
      std::vector<double> parameters = RandomParameters(3, footprint);
      for (double& p : parameters) p *= size;
      const double before = LargestNodeGain(model.ForwardStored(parameters.data()));
      const double share = LimitGain(1.0109, model, parameters);
      EXPECT_LE(LargestNodeGain(model.ForwardStored(parameters.data())), 1.0109 + 1e-12);
      EXPECT_EQ(share<1, before> 1.0109) << size;
    }
  }
}

TEST(GainLimit, BoundsTheProductWithThePrefilter) {
  struct {
    PrefilterMap map;
    RealPrefilter at;
  } const cases[] = {{PrefilterMap::Recursive(0.178), RecursivePrefilter(0.177)},
                     {PrefilterMap::Fir(4, 0.17), FirPrefilter(0.168, 4)}};
  for (const auto& [map, at] : cases) {
    ResamplerModel model(map);
    for (const double size : {1e-3, 1.0, 100.0}) {
      std::vector<double> parameters = RandomParameters(3);
      for (double& p : parameters) p *= size;
      for (const double number : map.NumbersOf(at)) parameters.push_back(number);
      if (size > 1 && map.size() > 1) parameters.back() += 0.01;
      const double before = LargestNodeGain(model.ForwardStored(parameters.data()));
      const double share = LimitGain(1.0109, model, parameters);
      const Resampler& after = model.ForwardStored(parameters.data());
      EXPECT_LE(LargestNodeGain(after), 1.0109 + 1e-12);
      EXPECT_TRUE(IsValid(Rounded(after.prefilter)));
      EXPECT_EQ(share<1, before> 1.0109) << size;
    }
  }
}

TEST(GainLimit, OfTheDefaultBoundAllowsTheHorizon) {
  for (const int horizon : {2, 6, 64}) {
    const double limit = LargestGain(DefaultGainBound(horizon));
    EXPECT_EQ(SafeWarps(limit * (1 - 1e-12)).value(), horizon);
  }
  EXPECT_GT(LargestGain(1), 1);
}

}  // namespace
}  // namespace warplut
