#include "tests/stability/cases/gradients/gradient_reference.h"

#include <algorithm>
#include <cmath>

#include "train/fit/random.h"
#include "train/metrics/ssim_reference.h"

namespace warplut {
namespace {

struct ComplexPlane {
  int width = 0, height = 0;
  std::vector<Complex> values;

  ComplexPlane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * h) {}
  explicit ComplexPlane(const BorderedPlane& plane) : ComplexPlane(plane.width(), plane.height()) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) At(x, y) = plane.row(y)[x];
    }
  }
  Complex& At(int x, int y) { return values[static_cast<std::size_t>(y) * width + x]; }
  const Complex& Clamped(int x, int y) const {
    return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width +
                  std::clamp(x, 0, width - 1)];
  }
};

// What leaves [0, 1] is limited to it and depends on nothing any more.
Complex Limited(const Complex& value) {
  if (value.real() <= 0) return 0;
  return value.real() >= 1 ? Complex(1) : value;
}

ComplexPlane Warped(const ComplexPlane& in, const RolloutStep& step,
                    const ComplexWeights& weights) {
  Weights<Complex> looked_up{};
  for (const auto& [node, share] : SharesOf(step)) {
    for (const int k : TapsOf(Footprint::k16)) {
      looked_up[k] += share * weights[node.index][MapWeight(node.symmetry, k)];
    }
  }
  ComplexPlane out(in.width, in.height);
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) {
      Complex sum = 0;
      for (const int k : TapsOf(Footprint::k16)) {
        sum += looked_up[k] * in.Clamped(x + step.cell_x + TapX(k), y + step.cell_y + TapY(k));
      }
      out.At(x, y) = Limited(sum);
    }
  }
  return out;
}

// The derivative is refreshed with samples of zero: what enters from outside depends on no weight.
ComplexPlane Refreshed(ComplexPlane warped, const FrameSamples& frame) {
  BorderedPlane value(warped.width, warped.height), derivative = value, new_value = value,
                                                    new_derivative = value;
  for (int y = 0; y < warped.height; ++y) {
    for (int x = 0; x < warped.width; ++x) {
      value.row(y)[x] = static_cast<float>(warped.At(x, y).real());
      derivative.row(y)[x] = static_cast<float>(Derivative(warped.At(x, y)));
    }
  }
  frame.grid->Refresh(frame.values, value, new_value);
  frame.grid->Refresh(std::vector<float>(frame.values.size()), derivative, new_derivative);
  for (int y = 0; y < warped.height; ++y) {
    for (int x = 0; x < warped.width; ++x) {
      warped.At(x, y) = Seeded(new_value.row(y)[x], new_derivative.row(y)[x]);
    }
  }
  return warped;
}

}  // namespace

ComplexWeights Seed(const CanonicalWeights<double>& weights,
                    const CanonicalWeights<double>& direction) {
  ComplexWeights seeded{};
  for (int c = 0; c < kCanonicalNodes; ++c) {
    for (int k = 0; k < kWeights; ++k) seeded[c][k] = Seeded(weights[c][k], direction[c][k]);
  }
  return seeded;
}

CanonicalWeights<double> RandomSigns(std::uint64_t seed) {
  Random random(seed);
  CanonicalWeights<double> signs{};
  for (auto& node : signs) {
    for (double& sign : node) sign = random.Below(2) == 0 ? -1 : 1;
  }
  return signs;
}

double Dot(const CanonicalWeights<double>& a, const CanonicalWeights<double>& b) {
  double sum = 0;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    for (int k = 0; k < kWeights; ++k) sum += a[c][k] * b[c][k];
  }
  return sum;
}

std::vector<Complex> ReferenceLosses(const Rollout& rollout, const BorderedPlane& target,
                                     const ComplexWeights& weights) {
  std::vector<Complex> losses;
  ComplexPlane image(*rollout.start);
  for (std::size_t i = 0; i < rollout.steps.size(); ++i) {
    image = Warped(image, rollout.steps[i], weights);
    if (!rollout.frames.empty()) image = Refreshed(std::move(image), rollout.frames[i]);
    const std::size_t h = losses.size();
    if (h < rollout.horizons.size() && static_cast<int>(i) + 1 == rollout.horizons[h]) {
      losses.push_back(1.0 - SsimReferenceAs<Complex>(&image.At(kRolloutMargin, kRolloutMargin),
                                                      image.width, InnerView(target)));
    }
  }
  return losses;
}

double ReferenceDerivative(const Objective& objective, const CanonicalWeights<double>& weights,
                           const CanonicalWeights<double>& direction) {
  const ComplexWeights seeded = Seed(weights, direction);
  std::vector<double> losses = objective.Losses(weights);
  std::vector<double> derivatives(losses.size(), 0.0), counts(losses.size(), 0.0);
  for (const JudgedRollout& judged : objective.rollouts()) {
    const auto of_rollout = ReferenceLosses(judged.rollout, objective.crops()[judged.crop], seeded);
    for (std::size_t h = 0; h < of_rollout.size(); ++h) {
      derivatives[judged.first + h] += Derivative(of_rollout[h]);
      counts[judged.first + h] += 1;
    }
  }
  double total = 0;
  for (std::size_t i = 0; i < losses.size(); ++i) {
    const double at = losses[i];
    const auto value = [&](double loss) {
      losses[i] = loss;
      return objective.Value(losses);
    };
    total += FourthOrderDifference(value, at, 1e-5 * at) * derivatives[i] / counts[i];
    losses[i] = at;
  }
  return total;
}

}  // namespace warplut
