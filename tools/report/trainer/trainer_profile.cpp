#include "tools/report/trainer/trainer_profile.h"

#include <algorithm>
#include <limits>

namespace warplut {
namespace {

double Amount(const TracePoint& point, Work work) {
  return work == Work::kSeconds ? point.seconds : point.evaluations;
}

}  // namespace

double GapAfter(const TrainerRun& run, double best, Work work, double amount) {
  const double whole = run.start - best;
  if (!(whole > 0)) return 0;
  double loss = run.start;
  for (const TracePoint& point : run.trace) {
    if (Amount(point, work) > amount) break;
    loss = std::min(loss, point.loss);
  }
  return (loss - best) / whole;
}

double WorkToSolve(const TrainerRun& run, double best, double tau, Work work) {
  for (const TracePoint& point : run.trace) {
    if (point.loss <= best + tau * (run.start - best)) return Amount(point, work);
  }
  return std::numeric_limits<double>::infinity();
}

std::vector<double> DataProfile(const TrainerStudy& study,
                                const std::function<bool(const TrainerRun&)>& selected, double tau,
                                Work work, const std::vector<double>& amounts) {
  std::vector<double> shares(amounts.size(), 0.0);
  int runs = 0;
  for (const TrainerRun& run : study.runs) {
    if (!selected(run)) continue;
    ++runs;
    const double needed = WorkToSolve(run, study.best[run.problem], tau, work);
    for (std::size_t i = 0; i < amounts.size(); ++i) shares[i] += needed <= amounts[i] ? 1 : 0;
  }
  for (double& share : shares) share /= std::max(runs, 1);
  return shares;
}

}  // namespace warplut
