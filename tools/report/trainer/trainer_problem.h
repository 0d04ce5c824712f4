// The problems that trainers are compared on: functions of the MLP's parameters, small enough to be
// minimised many times.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "datasets/image.h"
#include "train/fit/objective/canonical_nodes.h"
#include "train/fit/objective/objective.h"
#include "train/fit/parameter_function.h"

namespace warplut {

// kObjective: repeated warps of crops, with the bound on gain
// (train/fit/objective/mlp_objective.h). kKernel: the weights of a known kernel.
enum class ProblemKind : std::uint8_t { kObjective, kKernel };

class TrainerProblem {
 public:
  // `start_factor`: of the last layer of RandomParameters, whose own factor (kLastLayerScale)
  // starts near Catmull-Rom.
  TrainerProblem(std::string name, ProblemKind kind, double start_factor)
      : name_(std::move(name)), kind_(kind), start_factor_(start_factor) {}
  virtual ~TrainerProblem() = default;

  const std::string& name() const { return name_; }
  ProblemKind kind() const { return kind_; }

  // The loss as a function of the parameters, for one thread; the problem outlives it.
  virtual std::unique_ptr<ParameterFunction> Function() const = 0;
  // The same loss of some weights.
  virtual double Loss(const CanonicalWeights<double>& weights) const = 0;
  // The least loss that any weights of the contract have, where it is known.
  virtual std::optional<double> Optimum() const { return std::nullopt; }
  // The weights that are wanted (kKernel), else null.
  virtual const CanonicalWeights<double>* Kernel() const { return nullptr; }

  // Where trainers begin.
  std::vector<double> Start(std::uint64_t seed) const;

 private:
  std::string name_;
  ProblemKind kind_;
  double start_factor_;
};

// 1 - SSIM after `warps` half-pixel warps, as it is.
class HalfPixelObjective final : public Objective {
 public:
  // warps even; crops of one size.
  HalfPixelObjective(std::vector<BorderedPlane> crops, int warps);
};

// J = L + kGainPenaltyFactor P with the bound of the objective's longest horizon
// (DefaultGainBound).
std::unique_ptr<const TrainerProblem> ObjectiveProblem(std::string name,
                                                       std::unique_ptr<const Objective> objective,
                                                       double start_factor);

// The same for half-pixel warps, with its optimum.
std::unique_ptr<const TrainerProblem> HalfPixelProblem(
    std::string name, std::unique_ptr<const HalfPixelObjective> objective, int grid,
    double start_factor);

// 1/2 sum of (w(theta) - kernel)^2 over the canonical nodes and their weights, divided by the
// number of nodes.
std::unique_ptr<const TrainerProblem> KernelProblem(std::string name,
                                                    const CanonicalWeights<double>& kernel,
                                                    double start_factor);

// The Keys kernel with what the head of the MLP makes of it (luts/fit/head.h): its first moment is
// the offset, so that the MLP can come as near to it as it likes.
CanonicalWeights<double> KeysByHead(double a);

// Which problems a study has: every content, upscale factor (its DefaultHorizons), mix of horizons
// (the two shortest; all) and start; half-pixel warps of every content; KeysByHead of several a to
// be fitted.
struct ProblemSet {
  std::vector<double> scales = {1.5, 2};
  std::vector<double> starts = {1, 10};  // start_factor
  std::vector<double> kernels = {-0.4, -0.6, -0.75};
  bool all_horizons = true;  // else only the mix of the two shortest
  int crops = 2;             // of each content
  int crop_size = 56;        // pixels
  int half_warps = 6;
  int half_grid = 21;  // per axis, of HalfPixelProblem
  std::uint64_t seed = 1;
};

struct Content {
  std::string name;
  Image luma;  // at least crop_size in each axis
};

std::vector<std::unique_ptr<const TrainerProblem>> MakeProblems(
    const ProblemSet& set, const std::vector<Content>& contents);

}  // namespace warplut
