#include "tools/report/trainer/trainer_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "luts/fit/head.h"
#include "tools/report/trainer/trainer_half_pixel.h"
#include "train/fit/objective/mlp_objective.h"
#include "train/fit/objective/warp_objective.h"
#include "train/fit/random.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rollout/crops.h"
#include "train/fit/train_options.h"

namespace warplut {
namespace {

int LongestWarps(const Objective& objective) {
  int longest = 0;
  for (const Protocol& protocol : objective.protocols()) {
    longest = std::max(longest, protocol.warps);
  }
  return longest;
}

class ObjectiveBased : public TrainerProblem {
 public:
  ObjectiveBased(std::string name, std::unique_ptr<const Objective> objective, double start_factor)
      : TrainerProblem(std::move(name), ProblemKind::kObjective, start_factor),
        objective_(std::move(objective)),
        gain_bound_(DefaultGainBound(LongestWarps(*objective_))),
        penalty_(gain_bound_) {}

  std::unique_ptr<ParameterFunction> Function() const override {
    return std::make_unique<MlpObjective>(*objective_, gain_bound_, kGainPenaltyFactor);
  }
  double Loss(const CanonicalWeights<double>& weights) const override {
    Resampler unused;
    return objective_->Evaluate(weights) +
           kGainPenaltyFactor * penalty_.AddGradient(weights, 0, unused);
  }

 private:
  const std::unique_ptr<const Objective> objective_;
  const double gain_bound_;
  const GainPenalty penalty_;
};

class HalfPixel final : public ObjectiveBased {
 public:
  HalfPixel(std::string name, std::unique_ptr<const Objective> objective, int grid,
            double start_factor)
      : ObjectiveBased(std::move(name), std::move(objective), start_factor),
        optimum_(
            FindHalfPixelOptimum(
                [&](const HalfPixelKernel& kernel) { return Loss(WithHalfPixelKernel(kernel)); },
                grid)
                .loss) {}

  std::optional<double> Optimum() const override { return optimum_; }

 private:
  const double optimum_;
};

double KernelLoss(const CanonicalWeights<double>& weights, const CanonicalWeights<double>& kernel,
                  CanonicalWeights<double>* gradient) {
  double sum = 0;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    for (std::size_t k = 0; k < weights[c].size(); ++k) {
      const double error = weights[c][k] - kernel[c][k];
      sum += error * error;
      if (gradient != nullptr) (*gradient)[c][k] = error / kCanonicalNodes;
    }
  }
  return sum / (2 * kCanonicalNodes);
}

class KernelFunction final : public ParameterFunction {
 public:
  explicit KernelFunction(const CanonicalWeights<double>& kernel) : kernel_(kernel) {}

  double Evaluate(const double* parameters, double* gradient) override {
    const CanonicalWeights<double>& weights = head_.Forward(parameters);
    if (gradient == nullptr) return KernelLoss(weights, kernel_, nullptr);
    CanonicalWeights<double> weight_gradient{};
    const double value = KernelLoss(weights, kernel_, &weight_gradient);
    head_.Backward(parameters, weight_gradient, gradient);
    return value;
  }

 private:
  const CanonicalWeights<double>& kernel_;
  HeadBatch head_;
};

class KernelBased final : public TrainerProblem {
 public:
  KernelBased(std::string name, const CanonicalWeights<double>& kernel, double start_factor)
      : TrainerProblem(std::move(name), ProblemKind::kKernel, start_factor), kernel_(kernel) {}

  std::unique_ptr<ParameterFunction> Function() const override {
    return std::make_unique<KernelFunction>(kernel_);
  }
  double Loss(const CanonicalWeights<double>& weights) const override {
    return KernelLoss(weights, kernel_, nullptr);
  }
  std::optional<double> Optimum() const override { return 0.0; }
  const CanonicalWeights<double>* Kernel() const override { return &kernel_; }

 private:
  const CanonicalWeights<double> kernel_;
};

const char* StartName(double factor) { return factor == 1 ? "near start" : "far start"; }

}  // namespace

std::vector<double> TrainerProblem::Start(std::uint64_t seed) const {
  std::vector<double> parameters = RandomParameters(seed);
  for (int p = MlpLayerOffset(kMlpLayers - 1); p < kMlpParameters; ++p) {
    parameters[static_cast<std::size_t>(p)] *= start_factor_;
  }
  return parameters;
}

HalfPixelObjective::HalfPixelObjective(std::vector<BorderedPlane> crops, int warps)
    : Objective(std::move(crops), {{warps, Offsets::kHalf}}, {{0, 1, 1.0}}, 1.0) {
  for (std::size_t c = 0; c < this->crops().size(); ++c) {
    AddRollout(c, 0, 1, DrawTrajectory(0, 1, 1));
  }
  SetBaselines({1.0});
}

std::unique_ptr<const TrainerProblem> ObjectiveProblem(std::string name,
                                                       std::unique_ptr<const Objective> objective,
                                                       double start_factor) {
  return std::make_unique<ObjectiveBased>(std::move(name), std::move(objective), start_factor);
}

std::unique_ptr<const TrainerProblem> HalfPixelProblem(
    std::string name, std::unique_ptr<const HalfPixelObjective> objective, int grid,
    double start_factor) {
  return std::make_unique<HalfPixel>(std::move(name), std::move(objective), grid, start_factor);
}

CanonicalWeights<double> KeysByHead(double a) {
  const CanonicalWeights<double> keys = KeysCanonicalWeights(a);
  const CanonicalWeights<double> base = KeysCanonicalWeights(kCatmullRomA);
  CanonicalWeights<double> weights{};
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    const double dx = NodeOffset(i), dy = NodeOffset(j);
    const Weights<double> mask = HeadMask(Footprint::k16, dx, dy);
    Weights<double> raw{};
    for (int k = 0; k < kWeights; ++k) {
      if (mask[k] > 0) raw[k] = (keys[c][k] - base[c][k]) / mask[k];
    }
    weights[c] = HeadAt<double>(dx, dy).Forward(raw);
  }
  return weights;
}

std::unique_ptr<const TrainerProblem> KernelProblem(std::string name,
                                                    const CanonicalWeights<double>& kernel,
                                                    double start_factor) {
  return std::make_unique<KernelBased>(std::move(name), kernel, start_factor);
}

std::vector<std::unique_ptr<const TrainerProblem>> MakeProblems(
    const ProblemSet& set, const std::vector<Content>& contents) {
  std::vector<std::unique_ptr<const TrainerProblem>> problems;
  std::uint64_t drawn = 0;
  for (const Content& content : contents) {
    const auto crops = [&] {
      return DrawCrops({content.luma}, set.crops, DeriveSeed(set.seed, drawn++), set.crop_size);
    };
    problems.push_back(
        HalfPixelProblem(fmt::format("{}, {} half", content.name, set.half_warps),
                         std::make_unique<HalfPixelObjective>(crops(), set.half_warps),
                         set.half_grid, set.starts.front()));
    for (const double scale : set.scales) {
      const std::vector<int> all = DefaultHorizons(scale);
      std::vector<std::vector<int>> mixes = {{all[0], all[1]}};
      if (set.all_horizons) mixes.push_back(all);
      for (const std::vector<int>& horizons : mixes) {
        for (const double start : set.starts) {
          const std::uint64_t seed = DeriveSeed(set.seed, drawn++);
          problems.push_back(
              ObjectiveProblem(fmt::format("{}, x{:g}, {} to {} warps, {}", content.name, scale,
                                           horizons.front(), horizons.back(), StartName(start)),
                               std::make_unique<WarpObjective>(crops(), horizons, seed), start));
        }
      }
    }
  }
  for (const double a : set.kernels) {
    for (const double start : set.starts) {
      problems.push_back(KernelProblem(fmt::format("Keys a = {:g}, {}", a, StartName(start)),
                                       KeysByHead(a), start));
    }
  }
  return problems;
}

}  // namespace warplut
