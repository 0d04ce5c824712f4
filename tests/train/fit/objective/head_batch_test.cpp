#include "train/fit/objective/head_batch.h"

#include <gtest/gtest.h>

#include "luts/fit/head.h"
#include "train/fit/objective/mlp_objective.h"
#include "train/fit/random.h"

namespace warplut {
namespace {

TEST(CanonicalNodes, EveryNodeMapsToItsCanonicalOne) {
  for (int jy = 0; jy <= kNodes; ++jy) {
    for (int ix = 0; ix <= kNodes; ++ix) {
      const CanonicalNode node = ToCanonical(ix, jy);
      ASSERT_GE(node.index, 0);
      ASSERT_LT(node.index, kCanonicalNodes);
      EXPECT_EQ(MapOffset(node.symmetry, ix, jy, kNodes), CanonicalPosition(node.index));
    }
  }
}

constexpr double kKaiser = 4.5;

HeadBatch BatchOf(Footprint footprint) {
  return footprint == Footprint::k16 ? HeadBatch() : HeadBatch(footprint, kKaiser);
}

class HeadBatchOf : public testing::TestWithParam<Footprint> {};
INSTANTIATE_TEST_SUITE_P(Taps, HeadBatchOf, testing::ValuesIn(kFootprints),
                         [](const auto& test) { return std::to_string(TapCount(test.param)); });

TEST_P(HeadBatchOf, EqualsTheSlowHeadAtEveryNode) {
  for (const double size : {0.1, 1.0, 30.0}) {
    std::vector<double> parameters = RandomParameters(7, GetParam());
    for (double& p : parameters) p *= size;
    HeadBatch batch = BatchOf(GetParam());
    const auto& weights = batch.Forward(parameters.data());
    for (int jy = 0; jy <= kNodes; jy += 3) {
      for (int ix = 0; ix <= kNodes; ++ix) {
        const CanonicalNode node = ToCanonical(ix, jy);
        const double dx = NodeOffset(ix), dy = NodeOffset(jy);
        const Weights<double> expected =
            GetParam() == Footprint::k16
                ? HeadWeights(parameters.data(), dx, dy)
                : HeadWeights(GetParam(), kKaiser, parameters.data(), dx, dy);
        for (int k = 0; k < kWeights; ++k) {
          EXPECT_NEAR(weights[node.index][MapWeight(node.symmetry, k)], expected[k], 1e-12 * size);
        }
      }
    }
  }
}

TEST_P(HeadBatchOf, BackwardEqualsDifferences) {
  std::vector<double> parameters = RandomParameters(3, GetParam());
  for (double& p : parameters) p *= 1.5;
  CanonicalWeights<double> factors{};
  Random random(5);
  for (auto& node : factors) {
    for (double& f : node) f = random.Uniform() - 0.5;
  }
  HeadBatch batch = BatchOf(GetParam());
  const auto loss = [&] {
    const auto& weights = batch.Forward(parameters.data());
    double sum = 0;
    for (int c = 0; c < kCanonicalNodes; ++c) {
      for (int k = 0; k < kWeights; ++k) sum += factors[c][k] * weights[c][k];
    }
    return sum;
  };
  loss();
  const int size = MlpParameters(GetParam());
  std::vector<double> gradient(size);
  batch.Backward(parameters.data(), factors, gradient.data());
  for (int p = 0; p < size; p += 61) {
    const double saved = parameters[p];
    const double h = 1e-5;
    parameters[p] = saved + h;
    const double above = loss();
    parameters[p] = saved - h;
    const double below = loss();
    parameters[p] = saved;
    EXPECT_NEAR(gradient[p], (above - below) / (2 * h), 1e-6 * (1 + std::abs(gradient[p]))) << p;
  }
}

}  // namespace
}  // namespace warplut
