// Data profiles of a study of trainers. Source: More and Wild, "Benchmarking derivative-free
// optimization algorithms", 2009.
#pragma once

#include <functional>
#include <vector>

#include "tools/report/trainer/trainer_study.h"

namespace warplut {

// What work is measured in.
enum class Work : std::uint8_t { kSeconds, kEvaluations };

// (f - best) / (start - best) for the least loss f that the run has found within so much work: 1
// before it has found anything better than the start, 0 at the best known. `best` is of its
// problem. 0 if the start is no worse than the best.
double GapAfter(const TrainerRun& run, double best, Work work, double amount);

// The work after which the gap is at most tau; infinite if it never is.
double WorkToSolve(const TrainerRun& run, double best, double tau, Work work);

// For each amount the share of runs that are solved by then; the runs are those that `selected`
// takes, at least one.
std::vector<double> DataProfile(const TrainerStudy& study,
                                const std::function<bool(const TrainerRun&)>& selected, double tau,
                                Work work, const std::vector<double>& amounts);

}  // namespace warplut
