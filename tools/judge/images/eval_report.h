// Scores as tables for people and as JSON for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/judge/images/filter_scores.h"
#include "tools/tables/table_text.h"

namespace warplut {

struct EvalReport {
  std::string lut;     // the file
  std::string name;    // of the table
  std::string lookup;  // "nearest" or "bilinear"
  std::size_t images = 0;
  int tone_mapped = 0;  // of them: linear HDR, judged as displayed
  int crop = 0;         // side of the judged windows, 0: whole images
  std::vector<Protocol> protocols;
  FilterScores judged;
  std::vector<FilterScores> others;
  std::vector<std::string> missed;  // targets, one sentence each
};

// Rows: each filter's SSIM, the parameters of the best of a family, and the judged filter's gain
// over each other one. Columns: the protocols, and their mean.
TextTable ScoreTable(const EvalReport& report);

// The table below a line that says what was judged.
std::string ToText(const EvalReport& report);

nlohmann::ordered_json ToJson(const EvalReport& report);

}  // namespace warplut
