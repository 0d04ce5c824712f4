// Both orders of temporally dense rendering on a pattern that moves at many speeds in many
// directions: the data behind the rules that choose an order.
#pragma once

#include <vector>

#include "tools/dense/dense_report.h"

namespace warplut {

struct SweepSettings {
  DenseSettings dense;
  int angles = 9;     // from 0 to 90 degrees, both included; at least 2
  int fractions = 8;  // of the length, from 0 in equal steps; at least 1
  int whole = 1;      // pixels per subframe that are added to the fraction

  bool IsValid(std::string* why = nullptr) const;
};

// One motion of the pattern.
struct SweepCell {
  double angle = 0;     // degrees
  double fraction = 0;  // of the length
  DenseScores hourglass, bowtie;
};

// Angle after angle.
std::vector<SweepCell> MeasureSweep(const SweepSettings& settings);

// What a rule would have chosen: means over the cells, of both orders where it chooses at random.
struct RuleScore {
  std::string rule;
  double fixed_psnr = 0, tracking_psnr = 0, temporal_error = 0;
};
// Those of every rule, and of the choice that is best in each cell ("best").
std::vector<RuleScore> ScoreRules(const std::vector<SweepCell>& cells,
                                  const DenseParameters& parameters, int whole);

// Rows: angles; columns: fractions. How many dB the hourglass is above the bowtie for an eye that
// tracks; in brackets what the mixed rule takes: h, b, or ? at random.
TextTable SweepTable(const std::vector<SweepCell>& cells, const DenseParameters& parameters,
                     int whole);
TextTable RuleTable(const std::vector<RuleScore>& rules);
Json ToJson(const std::vector<SweepCell>& cells, const std::vector<RuleScore>& rules);

}  // namespace warplut
