#include "tools/report/budget/budget_ladder.h"

#include <fmt/format.h>

#include "datasets/error.h"
#include "tools/judge/sequence_scores.h"
#include "train/metrics/psnr.h"

namespace warplut {
namespace {

FrameScore MeanRung(const std::vector<FrameScore>& scores) {
  FrameScore mean = MeanScore(scores);
  mean.psnr = Psnr(mean.mean_squared_error);
  return mean;
}

}  // namespace

std::vector<double> ErrorBudget::Shares() const {
  std::vector<double> shares(rungs.size(), 0.0);
  const double whole = rungs.front().mean_squared_error;
  if (!(whole > 0)) return shares;
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    const double next = k + 1 < rungs.size() ? rungs[k + 1].mean_squared_error : 0;
    shares[k] = (rungs[k].mean_squared_error - next) / whole;
  }
  return shares;
}

void BudgetSum::Add(const std::vector<const Image*>& rungs, const Image& reference) {
  scores_.resize(rungs.size());
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    scores_[k].push_back(CompareImages(budget_.clip, *rungs[k], reference, kScoreBorder));
  }
  ++budget_.frames;
}

ErrorBudget BudgetSum::Finish() const {
  if (budget_.frames == 0) {
    throw Error(fmt::format("'{}' has no frame that an error budget can be made of", budget_.clip));
  }
  ErrorBudget budget = budget_;
  for (const auto& scores : scores_) budget.rungs.push_back(MeanRung(scores));
  return budget;
}

ErrorBudget MeanBudget(const std::string& name, const std::vector<ErrorBudget>& budgets) {
  ErrorBudget mean{.clip = name, .frames = 0, .rungs = {}};
  for (const ErrorBudget& budget : budgets) mean.frames += budget.frames;
  for (std::size_t k = 0; k < budgets.front().rungs.size(); ++k) {
    std::vector<FrameScore> scores;
    for (const ErrorBudget& budget : budgets) scores.push_back(budget.rungs[k]);
    mean.rungs.push_back(MeanRung(scores));
  }
  return mean;
}

}  // namespace warplut
