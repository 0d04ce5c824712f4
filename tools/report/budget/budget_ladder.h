// An error budget: what is left of the error when one cause after the other is replaced by ground
// truth.
//
// Rung 0 is what a method shows; on rung k the first k replacements hold. The share of replacement
// k is the drop of the mean squared error from rung k to rung k + 1, the last rung is what remains,
// so that the shares add up to the whole. They depend on the order. A share is negative where a
// replacement does harm.
#pragma once

#include <string>
#include <vector>

#include "datasets/image.h"
#include "tools/judge/images/compare.h"

namespace warplut {

// The first two causes of every plan are how the motion is stored; from this rung on it is exact.
inline constexpr int kExactMotionRung = 2;

struct BudgetCause {
  const char* name;
  const char* replacement;  // what stands in its place from here on, as part of a sentence
};

// A method's causes in the order of replacement; what remains has a name and a meaning as well.
struct BudgetPlan {
  std::vector<BudgetCause> causes;
  BudgetCause remainder;

  int rungs() const { return static_cast<int>(causes.size()) + 1; }
};

struct ErrorBudget {
  std::string clip;
  int frames = 0;
  std::vector<FrameScore> rungs;  // means over frames; the PSNR is that of the mean error

  // Of the first rung's mean squared error, for each cause and the remainder; all 0 if nothing is
  // wrong.
  std::vector<double> Shares() const;
};

// Scores the rungs of one frame after the other.
class BudgetSum {
 public:
  explicit BudgetSum(std::string clip) { budget_.clip = std::move(clip); }

  // Images of one frame, rung by rung; R, G, B. Pixels within kScoreBorder of an edge do not count.
  // Error: as CompareImages.
  void Add(const std::vector<const Image*>& rungs, const Image& reference);

  // Error if no frame was added.
  ErrorBudget Finish() const;

 private:
  ErrorBudget budget_;
  std::vector<std::vector<FrameScore>> scores_;  // by rung
};

// The mean over budgets of one plan, each counting alike: of errors, PSNR and SSIM. `budgets` is
// not empty.
ErrorBudget MeanBudget(const std::string& name, const std::vector<ErrorBudget>& budgets);

}  // namespace warplut
