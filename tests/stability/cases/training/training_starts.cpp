#include "tests/stability/cases/training/training_starts.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/stability/cases/training/training_problem.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

constexpr double kNearBest = 1.01;
constexpr double kLargestDamping = 1e3;  // in units of the largest eigenvalue

TinyProblem StartsProblem(bool full) {
  TinyProblem problem;
  problem.images = {NoiseImage(kTinySide, kTinySide, 1)};
  problem.iterations = full ? 40 : 4;
  return problem;
}

// The loss of one rollout at one horizon; 1/2 sum of r^2 of all is the mean loss.
struct Residuals {
  Eigen::VectorXd r;
  Eigen::MatrixXd jacobian;  // empty where it was not asked for
};

// Rollouts that lose nothing at these weights, as those whose displacements are 0, have no
// residual.
constexpr double kNoLoss = 1e-9;

class LossResiduals {
 public:
  explicit LossResiduals(const Objective& objective) : rollouts_(objective.rollouts()) {}

  Residuals At(const Eigen::VectorXd& parameters, bool with_jacobian) {
    const CanonicalWeights<double> weights = head_.Forward(parameters.data());
    std::vector<double> losses;
    std::vector<Eigen::VectorXd> gradients;
    RolloutWorkspace workspace(kTinySide, kTinySide);
    for (const JudgedRollout& judged : rollouts_) {
      const Rollout& rollout = judged.rollout;
      std::vector<double> of_rollout(rollout.horizons.size());
      workspace.Forward(rollout, weights, of_rollout);
      for (std::size_t h = 0; h < of_rollout.size(); ++h) {
        losses.push_back(of_rollout[h]);
        if (!with_jacobian) continue;
        std::vector<double> factors(of_rollout.size(), 0.0);
        factors[h] = 1;
        Resampler gradient;
        workspace.Backward(rollout, factors, weights, gradient);
        head_.Backward(parameters.data(), gradient.weights,
                       gradients.emplace_back(kMlpParameters).data());
      }
    }
    return Assemble(losses, gradients);
  }

 private:
  static Residuals Assemble(const std::vector<double>& losses,
                            const std::vector<Eigen::VectorXd>& gradients) {
    const auto n = static_cast<Eigen::Index>(losses.size());
    Residuals result{.r = Eigen::VectorXd(n), .jacobian = {}};
    if (!gradients.empty()) result.jacobian = Eigen::MatrixXd::Zero(n, kMlpParameters);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      result.r[i] = std::sqrt(2 * std::max(losses[at], 0.0) / static_cast<double>(n));
      if (gradients.empty() || losses[at] <= kNoLoss) continue;
      result.jacobian.row(i) = gradients[at] / (static_cast<double>(n) * result.r[i]);
    }
    return result;
  }

  const std::vector<JudgedRollout>& rollouts_;
  HeadBatch head_;
};

}  // namespace

StabilityResult TrainFromManyStarts(StabilityEffort effort) {
  const bool full = effort == StabilityEffort::kFull;
  const TinyProblem problem = StartsProblem(full);
  const WarpObjective objective = MakeObjective(problem);
  std::vector<TinyResult> results(full ? 200 : 4);
  tbb::parallel_for(std::size_t{0}, results.size(), [&](std::size_t i) {
    results[i] = RunTiny(problem, objective, RandomParameters(100 + i));
  });
  std::sort(results.begin(), results.end(),
            [](const TinyResult& a, const TinyResult& b) { return a.end < b.end; });
  const double best = results.front().end;
  const auto near = std::count_if(results.begin(), results.end(), [&](const TinyResult& result) {
    return result.end <= kNearBest * best;
  });
  const bool kept = std::all_of(results.begin(), results.end(), [&](const TinyResult& result) {
    return result.KeepsContract() && result.SafeFor(problem.horizons.back());
  });
  const double median = results[results.size() / 2].end, worst = results.back().end;
  return {kept && worst <= 1.2 * best,
          fmt::format("{} starts: best {:.4f}, median {:.4f}, worst {:.4f}; {:.0f} % within 1 % of "
                      "the best",
                      results.size(), best, median, worst,
                      100.0 * static_cast<double>(near) / static_cast<double>(results.size()))};
}

// J has fewer rows than columns, so that J^T J is singular: its other eigenvalues are those of
// K = J J^T, and a damped step is -J^T (K + lambda)^-1 r.
StabilityResult GaussNewtonAtTheEnd(StabilityEffort effort) {
  const bool full = effort == StabilityEffort::kFull;
  TinyProblem problem = StartsProblem(full);
  problem.horizons = full ? std::vector<int>{2, 6, 12} : std::vector<int>{2, 6};
  if (full) problem.images.push_back(NoiseImage(kTinySide, kTinySide, 2));
  const WarpObjective objective = MakeObjective(problem);
  const TinyResult trained = RunTiny(problem, objective, RandomParameters(1));
  Eigen::VectorXd parameters = Eigen::VectorXd::Map(trained.parameters.data(), kMlpParameters);
  LossResiduals residuals(objective);
  const Residuals here = residuals.At(parameters, true);

  const Eigen::MatrixXd kernel = here.jacobian * here.jacobian.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(kernel);
  const Eigen::VectorXd& eigenvalues = solver.eigenvalues();  // ascending
  const double largest = eigenvalues[eigenvalues.size() - 1];
  // Gradients of float images carry about 1e-6 of noise, eigenvalues its square.
  const double floor = 1e-12 * largest;
  const auto rank = (eigenvalues.array() > floor).count();
  const double least = eigenvalues[eigenvalues.size() - rank];

  const double loss = here.r.squaredNorm() / 2;
  std::optional<double> needed;
  for (double damping = kLargestDamping; damping > 1e-12; damping /= 10) {
    Eigen::MatrixXd damped = kernel;
    damped.diagonal().array() += damping * largest;
    const Eigen::VectorXd step = -here.jacobian.transpose() * damped.llt().solve(here.r);
    const double after = residuals.At(parameters + step, false).r.squaredNorm() / 2;
    if (!(after < loss)) break;
    needed = damping;
  }
  return {std::isfinite(largest) && rank > 0 && needed && *needed <= kLargestDamping,
          fmt::format("rank {} of {}, condition number {:.1e} in its range and infinite beyond; "
                      "steps descend from a damping of {} of the largest eigenvalue on",
                      rank, kMlpParameters, largest / least,
                      needed ? fmt::format("{:.0e}", *needed) : "more than 1000")};
}

}  // namespace warplut
