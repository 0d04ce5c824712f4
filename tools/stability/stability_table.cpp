#include "tools/stability/stability_table.h"

#include <chrono>
#include <exception>
#include <nlohmann/json.hpp>

namespace warplut {
namespace {

std::string FullName(const StabilityCase& stability_case) {
  return std::string(stability_case.group) + ", " + stability_case.name;
}

}  // namespace

const char* Name(StabilityVerdict verdict) {
  switch (verdict) {
    case StabilityVerdict::kPassed:
      return "passes";
    case StabilityVerdict::kFailed:
      return "FAILS";
    case StabilityVerdict::kKnown:
      return "fails, as known";
    case StabilityVerdict::kMended:
      return "passes, though marked as failing";
  }
  return "";
}

StabilityVerdict StabilityOutcome::verdict() const {
  if (stability_case.failing == nullptr) {
    return result.passed ? StabilityVerdict::kPassed : StabilityVerdict::kFailed;
  }
  return result.passed ? StabilityVerdict::kMended : StabilityVerdict::kKnown;
}

StabilityOutcome RunStabilityCase(const StabilityCase& stability_case, StabilityEffort effort) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  StabilityOutcome outcome{.stability_case = stability_case, .result = {}};
  try {
    outcome.result = stability_case.run(effort);
  } catch (const std::exception& thrown) {
    outcome.result = {.passed = false, .observed = thrown.what()};
  }
  outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return outcome;
}

TextTable StabilityTable(std::span<const StabilityOutcome> outcomes) {
  TextTable table{.header = {"group", "case", "required", "observed", "verdict"}, .rows = {}};
  for (const StabilityOutcome& outcome : outcomes) {
    const StabilityCase& which = outcome.stability_case;
    table.rows.push_back({which.group, which.name, which.required, outcome.result.observed,
                          Name(outcome.verdict())});
  }
  return table;
}

std::vector<std::string> StabilityRemarks(std::span<const StabilityOutcome> outcomes) {
  std::vector<std::string> remarks;
  for (const StabilityOutcome& outcome : outcomes) {
    const StabilityCase& which = outcome.stability_case;
    if (which.failing != nullptr) remarks.push_back(FullName(which) + ": " + which.failing);
  }
  return remarks;
}

nlohmann::ordered_json ToJson(std::span<const StabilityOutcome> outcomes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const StabilityOutcome& outcome : outcomes) {
    const StabilityCase& which = outcome.stability_case;
    nlohmann::ordered_json row = {{"group", which.group},
                                  {"case", which.name},
                                  {"required", which.required},
                                  {"observed", outcome.result.observed},
                                  {"passed", outcome.result.passed},
                                  {"verdict", Name(outcome.verdict())},
                                  {"seconds", outcome.seconds}};
    if (which.failing != nullptr) row["failing"] = which.failing;
    list.push_back(row);
  }
  return list;
}

}  // namespace warplut
