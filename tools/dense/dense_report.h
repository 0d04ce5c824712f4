// The comparison of displays, on one or several worlds, as tables for people and programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/dense/dense_display.h"
#include "tools/dense/dense_scores.h"
#include "tools/tables/record_table.h"

namespace warplut {

struct DenseSettings {
  DenseWorldOptions world;
  // Subframes that are shown before those that are judged; both are multiples of kSlowStep. TAA has
  // settled after the first.
  int warm_up = 64, judged = 16;
  DenseOptions dense;  // the size is that of the world

  // Otherwise *why (if not null) names the setting and its range.
  bool IsValid(std::string* why = nullptr) const;
};

struct DenseReport {
  std::string scene;
  std::vector<DenseScores> displays;
};

// Judges ComparedDisplays. Where `pictures` is not empty, the last integrals and the last subframe
// of every display are written there: SCENE-DISPLAY-fixed.png, -tracking.png, -shown.png.
DenseReport MeasureDense(const std::string& scene, const DenseWorld& world,
                         const DenseSettings& settings, const std::filesystem::path& pictures);

// The means over reports of the same displays, under the name "mean"; a flicker that a scene lacks
// has no part.
DenseReport MeanDenseReport(const std::vector<DenseReport>& reports);

// Rows: displays.
TextTable DenseTable(const DenseReport& report);
Json ToJson(const DenseReport& report);

}  // namespace warplut
