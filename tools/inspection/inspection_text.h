// An inspection as people and programs read it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/inspection/sequence_inspection.h"
#include "train/inspection/inspection.h"

namespace warplut {

// The streams, then the convention question by question, the contradictions and the faults.
// `all`: every candidate of every question, not just the first two.
std::string InspectionText(const Sequence& sequence, const std::vector<StreamInspection>& streams,
                           const Inspection& inspection, bool all);

nlohmann::ordered_json InspectionJson(const Sequence& sequence,
                                      const std::vector<StreamInspection>& streams,
                                      const Inspection& inspection);

}  // namespace warplut
