// Temporally dense rendering judged on scenes: the work of `warplut dense`.
#pragma once

#include <string>
#include <vector>

#include "tools/dense/dense_report.h"

namespace warplut {

// A report of each scene, then their mean if there are several. `pictures`: a folder, made where it
// is not there; empty: none. `scenes` are names of scenes, or of groups of them (SelectScenes); a
// UsageError names what is neither. Error: a folder that cannot be made, an interruption.
std::vector<DenseReport> JudgeScenes(const std::vector<std::string>& scenes,
                                     const DenseSettings& settings, const std::string& pictures);

}  // namespace warplut
