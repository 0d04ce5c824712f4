#include "tools/report/trainer/trainer_half_pixel.h"

#include <limits>

#include "luts/filters.h"
#include "train/fit/rivals/keys_search.h"

namespace warplut {
namespace {

constexpr double kCornerReach = 0.06;
constexpr double kEdgeCentre = -0.07, kEdgeReach = 0.09;
constexpr int kRefinedGrid = 5;

}  // namespace

CanonicalWeights<double> WithHalfPixelKernel(const HalfPixelKernel& kernel) {
  CanonicalWeights<double> weights = KeysCanonicalWeights(kCatmullRomA);
  Weights<double>& half =
      weights[static_cast<std::size_t>(ToCanonical(kHalfNode, kHalfNode).index)];
  for (const int k : TapsOf(Footprint::k16)) {
    const bool outer_x = TapX(k) == -1 || TapX(k) == 2;
    const bool outer_y = TapY(k) == -1 || TapY(k) == 2;
    half[static_cast<std::size_t>(k)] = outer_x && outer_y   ? kernel.corner
                                        : outer_x || outer_y ? kernel.edge
                                                             : kernel.inner();
  }
  return weights;
}

HalfPixelOptimum FindHalfPixelOptimum(const std::function<double(const HalfPixelKernel&)>& loss,
                                      int grid) {
  HalfPixelOptimum best{.kernel = {0, kEdgeCentre},
                        .loss = std::numeric_limits<double>::infinity()};
  const auto search = [&](HalfPixelKernel centre, double corner_step, double edge_step, int count) {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const HalfPixelKernel kernel{centre.corner + (i - count / 2) * corner_step,
                                     centre.edge + (j - count / 2) * edge_step};
        const double value = loss(kernel);
        ++best.evaluations;
        if (value < best.loss) {
          best.kernel = kernel;
          best.loss = value;
        }
      }
    }
  };
  double corner_step = 2 * kCornerReach / (grid - 1), edge_step = 2 * kEdgeReach / (grid - 1);
  search(best.kernel, corner_step, edge_step, grid);
  while (corner_step > kHalfPixelStep || edge_step > kHalfPixelStep) {
    corner_step /= 2;
    edge_step /= 2;
    search(best.kernel, corner_step, edge_step, kRefinedGrid);
  }
  return best;
}

}  // namespace warplut
