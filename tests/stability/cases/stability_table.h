// Runs stability cases and tells how they ended.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/stability/cases/stability_case.h"
#include "tools/tables/record_table.h"

namespace warplut {

enum class StabilityVerdict : std::uint8_t {
  kPassed,
  kFailed,
  kKnown,   // fails, and is marked as failing
  kMended,  // passes, and is marked as failing: the mark is to be removed
};

const char* Name(StabilityVerdict verdict);

struct StabilityOutcome {
  StabilityCase stability_case;
  StabilityResult result;
  double seconds = 0;  // wall time of the run

  StabilityVerdict verdict() const;
};

// Runs one case. An exception that it throws becomes a failed result that observed the sentence.
StabilityOutcome RunStabilityCase(const StabilityCase& stability_case, StabilityEffort effort);

// Group, case, required, observed, verdict; one row for each outcome.
TextTable StabilityTable(const std::vector<StabilityOutcome>& outcomes);

// What the product does in each case that is marked as failing: one sentence each, begun by the
// case.
std::vector<std::string> StabilityRemarks(const std::vector<StabilityOutcome>& outcomes);

Json ToJson(const std::vector<StabilityOutcome>& outcomes);

}  // namespace warplut
