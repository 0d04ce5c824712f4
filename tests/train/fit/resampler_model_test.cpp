#include "train/fit/resampler_model.h"

#include <gtest/gtest.h>

#include "luts/fit/head.h"
#include "train/fit/objective/mlp_objective.h"
#include "train/fit/objective/warp_objective.h"
#include "train/fit/rivals/spline_family.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

std::vector<double> Parameters(const PrefilterMap& map, const RealPrefilter& prefilter) {
  std::vector<double> parameters = RandomParameters(7);
  for (int p = MlpLayerOffset(kMlpLayers - 1); p < kMlpParameters; ++p) parameters[p] *= 0.05;
  for (const double number : map.NumbersOf(prefilter)) parameters.push_back(number);
  return parameters;
}

TEST(ResamplerModel, WeightsAreThoseOfTheSlowHead) {
  const PrefilterMap map = PrefilterMap::Recursive(0.2);
  const std::vector<double> parameters = Parameters(map, RecursivePrefilter(0.16));
  ResamplerModel model(map);
  EXPECT_EQ(model.size(), kMlpParameters + 1);
  for (const bool stored : {false, true}) {
    const Resampler& r =
        stored ? model.ForwardStored(parameters.data()) : model.Forward(parameters.data());
    EXPECT_EQ(r.prefilter.kind, PrefilterKind::kRecursive);
    if (stored) {
      EXPECT_EQ(r.prefilter.side, static_cast<double>(static_cast<float>(r.prefilter.side)));
    }
    for (const int c : {0, 1, 40, kCanonicalNodes - 1}) {
      const auto [i, j] = CanonicalPosition(c);
      const Weights<double> expected =
          HeadWeights(parameters.data(), NodeOffset(i), NodeOffset(j), r.prefilter.side);
      for (int k = 0; k < kWeights; ++k) EXPECT_NEAR(r.weights[c][k], expected[k], 1e-12);
    }
  }
}

// J with the penalty at work, through rollouts, head and prefilter. Rollouts compute in float: the
// step is large, and the error of the difference of its square.
TEST(ResamplerModel, GradientOfJEqualsDifferences) {
  std::vector<BorderedPlane> crops;
  for (std::uint64_t i = 0; i < 2; ++i) crops.push_back(ToPlane(NoiseImage(64, 64, i)));
  const WarpObjective objective(std::move(crops), {2, 6}, 5, {2, 0.2, 1, 0.2});
  struct {
    PrefilterMap map;
    RealPrefilter at;
  } const cases[] = {{PrefilterMap::Recursive(0.21), RecursivePrefilter(0.19)},
                     {PrefilterMap::Fir(3, 0.21), FirPrefilter(0.17, 3)},
                     {PrefilterMap::Fixed(0.18), {}}};
  for (const auto& [map, at] : cases) {
    MlpObjective judged(objective, 1.002, 1e-3, ResamplerModel(map));
    std::vector<double> parameters = Parameters(map, at);
    std::vector<double> gradient(parameters.size());
    judged.Evaluate(parameters.data(), gradient.data());
    std::vector<int> tried = {kMlpParameters - 1, kMlpParameters - 11};
    for (int i = 0; i < map.size(); ++i) tried.push_back(kMlpParameters + i);
    for (const int p : tried) {
      const double saved = parameters[p], h = 2e-4;
      parameters[p] = saved + h;
      const double above = judged.Evaluate(parameters.data(), nullptr);
      parameters[p] = saved - h;
      const double below = judged.Evaluate(parameters.data(), nullptr);
      parameters[p] = saved;
      const double expected = (above - below) / (2 * h);
      EXPECT_NEAR(gradient[p], expected, 0.01 * std::abs(expected) + 0.02) << p - kMlpParameters;
    }
  }
}

}  // namespace
}  // namespace warplut
