// Differences of scores between two runs over the same frames, with their standard errors.
#pragma once

#include <vector>

namespace warplut {

// With fewer frames the correlation between neighbours cannot be estimated.
inline constexpr int kLeastDifferingFrames = 4;

struct FrameDifference {
  double mean = 0;            // NaN without frames
  double standard_error = 0;  // of the mean; NaN with fewer than kLeastDifferingFrames
  double independent = 0;     // so many independent frames would tell as much; at least 3
  int frames = 0;

  // Whether the standard error is known.
  bool HasError() const;
  // By how much the mean can be wrong: the standard error times the 99.5 % quantile of Student's t
  // (train/inspection/ranking.h). NaN where the error is not known.
  double Uncertainty() const;
};

// The mean over frames of d = a - b, paired frame by frame. Frames in which one is not finite have
// no part, but where both are the same infinity d = 0.
//
// Neighbouring frames show nearly the same picture, so their differences are alike and tell less
// than independent ones. They are taken as a series of first order: with r the correlation of
// neighbouring differences, n frames tell as much as n' = n (1 - r) / (1 + r) independent ones, and
// the squared standard error is (mean of (d - mean)^2) / (n' - 1). r is estimated from the frames,
// plus its known bias, (1 + 3 r) / n (Kendall, "Note on bias in the estimation of
// autocorrelation", Biometrika 41, 1954), and counts from 0 up; n' is at least 3, as a smaller
// bound gives no fewer false alarms. Of a few frames that are much alike r comes out too small: at
// r = 0.8 zero is taken for a difference in 1 of 10 series of 8 frames, and in 1 of 40 of 60 (with
// Uncertainty, which means 1 of 100).
FrameDifference DifferenceOver(const std::vector<double>& a, const std::vector<double>& b);

// The mean over sequences, each with the same weight, and the error that follows from the errors
// within them: of these sequences, not of all that there are. `independent` is one more than the
// degrees of freedom of Welch and Satterthwaite. At least one.
FrameDifference MeanDifference(const std::vector<FrameDifference>& sequences);

// The same difference the other way round.
FrameDifference Reversed(const FrameDifference& difference);

// What a gain says of the thing that is gained by.
enum class Payoff { kPays, kDoesNotPay, kCannotTell };
constexpr const char* Name(Payoff payoff) {
  return payoff == Payoff::kPays         ? "pays"
         : payoff == Payoff::kDoesNotPay ? "does not pay"
                                         : "cannot tell";
}

// kDoesNotPay where the gain is `least` at most, whatever the error; kPays where it is more than 0,
// whatever the error, and can be more than `least`; else kCannotTell. `least` >= 0.
Payoff PayoffOf(const FrameDifference& gain, double least);

}  // namespace warplut
