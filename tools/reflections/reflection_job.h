// Screen-space reflections of built-in scenes: the work of `warplut reflections`.
#pragma once

#include <string>
#include <vector>

#include "tools/reflections/reflection_scores.h"
#include "tools/tables/record_table.h"

namespace warplut {

// A report of each scene, then their mean if there are several. `scenes` are names of scenes, or of
// groups of them (SelectScenes); a UsageError names what is neither. Settings are valid. Error: an
// interruption.
std::vector<ReflectionReport> MeasureReflections(const std::vector<std::string>& scenes,
                                                 const ReflectionSettings& settings);

// Rows: methods and thicknesses. Shares are in percent.
TextTable ReflectionTable(const ReflectionReport& report);
Json ToJson(const ReflectionReport& report);

}  // namespace warplut
