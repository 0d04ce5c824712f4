// Candidates for the answer to a question, ranked by paired scores over frames.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace warplut {

// Scores of one candidate, in dB, one for each sample (a pair of frames, or a part of one); NaN
// where it has none.
using SampleScores = std::vector<double>;

// The mean over the samples that both have of a - b, and its standard error. Samples in which both
// are equal have no part, unless all are.
struct PairedDifference {
  double mean = 0;
  double standard_error = 0;
  int samples = 0;

  // Whether the difference is more than noise: at least `least` dB, and beyond the 99.5 % quantile
  // of Student's t for so many samples. Never with fewer than two samples.
  bool IsTold(double least) const;
};

PairedDifference Difference(const SampleScores& a, const SampleScores& b);

double Mean(const SampleScores& scores);

// The 99.5 % quantile of Student's t distribution, `degrees` >= 1. Beyond 30 that of the normal
// distribution with Cornish and Fisher's first correction.
double StudentQuantile(int degrees);

// Margins below this many dB are no answer, however regular they are: filters and aliasing give
// such differences between candidates of which none is right.
inline constexpr double kLeastMargin = 0.05;

enum class Verdict { kCannotTell, kAgrees, kContradicts };

struct RankedCandidate {
  std::string name;
  double score = 0;           // mean, dB
  double margin = 0;          // what the first candidate is better by, dB
  double standard_error = 0;  // of the margin, over samples
  bool stated = false;        // the manifest says so
};

struct Ranking {
  std::string question;
  Verdict verdict = Verdict::kCannotTell;
  std::string found;   // the best candidate's name, or the stated one where nothing is told
  std::string stated;  // as the manifest says; empty: it says nothing
  std::string reason;  // why nothing can be told, a clause; empty: the candidates are too close
  std::vector<RankedCandidate> candidates;  // best first
};

// Ranks the values of one question. values[i] and scores[i] belong to hypothesis i, several of
// which may have the same value: the best of these stands for it. `stated`: the manifest's value.
//   kCannotTell  the best value is not told from the second
//   kAgrees      it is, and is the stated one or nothing is stated
//   kContradicts it is, and another one is stated
Ranking RankValues(const std::string& question, const std::vector<std::string>& values,
                   const std::vector<SampleScores>& scores, const std::string& stated,
                   double least = kLeastMargin);

}  // namespace warplut
