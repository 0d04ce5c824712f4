#include "train/inspection/ranking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace warplut {

double StudentQuantile(int degrees) {
  constexpr std::array kQuantiles = {63.66, 9.92, 5.84, 4.60, 4.03, 3.71, 3.50, 3.36, 3.25, 3.17,
                                     3.11,  3.05, 3.01, 2.98, 2.95, 2.92, 2.90, 2.88, 2.86, 2.85,
                                     2.83,  2.82, 2.81, 2.80, 2.79, 2.78, 2.77, 2.76, 2.76, 2.75};
  if (degrees <= static_cast<int>(kQuantiles.size())) {
    return kQuantiles[static_cast<std::size_t>(std::max(degrees, 1) - 1)];
  }
  constexpr double kNormal = 2.5758;
  return kNormal + (kNormal * kNormal * kNormal + kNormal) / (4.0 * degrees);
}

double Mean(const SampleScores& scores) {
  double sum = 0;
  int count = 0;
  for (const double score : scores) {
    if (std::isnan(score)) continue;
    sum += score;
    ++count;
  }
  return count == 0 ? std::nan("") : sum / count;
}

PairedDifference Difference(const SampleScores& a, const SampleScores& b) {
  SampleScores differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!std::isnan(a[i]) && !std::isnan(b[i])) differences.push_back(a[i] - b[i]);
  }
  // Where both say exactly the same, nothing is decided.
  const auto ties = std::remove(differences.begin(), differences.end(), 0.0);
  if (ties != differences.begin()) differences.erase(ties, differences.end());
  PairedDifference difference;
  difference.samples = static_cast<int>(differences.size());
  if (differences.empty()) return difference;
  difference.mean = Mean(differences);
  if (difference.samples < 2) return difference;
  double squares = 0;
  for (const double d : differences) squares += (d - difference.mean) * (d - difference.mean);
  difference.standard_error = std::sqrt(squares / (difference.samples - 1.0) / difference.samples);
  return difference;
}

bool PairedDifference::IsTold(double least) const {
  return samples >= 2 && mean >= least && mean >= StudentQuantile(samples - 1) * standard_error;
}

Ranking RankValues(const std::string& question, const std::vector<std::string>& values,
                   const std::vector<SampleScores>& scores, const std::string& stated,
                   double least) {
  std::map<std::string, std::size_t> best_of;  // value to hypothesis
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(Mean(scores[i]))) continue;
    const auto [at, added] = best_of.emplace(values[i], i);
    if (!added && Mean(scores[i]) > Mean(scores[at->second])) at->second = i;
  }
  Ranking ranking;
  ranking.question = question;
  ranking.stated = stated;
  ranking.found = stated;
  std::vector<std::size_t> order;
  for (const auto& [value, hypothesis] : best_of) order.push_back(hypothesis);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double score_a = Mean(scores[a]), score_b = Mean(scores[b]);
    return score_a != score_b ? score_a > score_b : values[a] == stated && values[b] != stated;
  });
  bool told = order.size() > 1;
  for (const std::size_t hypothesis : order) {
    const PairedDifference margin = Difference(scores[order[0]], scores[hypothesis]);
    ranking.candidates.push_back({values[hypothesis], Mean(scores[hypothesis]), margin.mean,
                                  margin.standard_error, values[hypothesis] == stated});
    if (hypothesis != order[0] && !margin.IsTold(least)) told = false;
  }
  if (told) {
    ranking.found = ranking.candidates[0].name;
    const bool agrees = stated.empty() || ranking.found == stated;
    ranking.verdict = agrees ? Verdict::kAgrees : Verdict::kContradicts;
  }
  return ranking;
}

}  // namespace warplut
