#include "tests/stability/cases/stability_table.h"

#include <chrono>
#include <exception>

namespace warplut {
namespace {

using Outcome = StabilityOutcome;

const Columns<Outcome> kColumns = {
    {"group", "group",
     [](const Outcome& outcome) { return TextCell(outcome.stability_case.group); }},
    {"case", "case", [](const Outcome& outcome) { return TextCell(outcome.stability_case.name); }},
    {"required", "required",
     [](const Outcome& outcome) { return TextCell(outcome.stability_case.required); }},
    {"observed", "observed",
     [](const Outcome& outcome) { return TextCell(outcome.result.observed); }},
    {"passed", "",
     [](const Outcome& outcome) { return Cell{.value = outcome.result.passed, .text = {}}; }},
    {"verdict", "verdict",
     [](const Outcome& outcome) { return TextCell(Name(outcome.verdict())); }},
    {"seconds", "", [](const Outcome& outcome) { return NumberCell(outcome.seconds, 1); }}};

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

TextTable StabilityTable(const std::vector<StabilityOutcome>& outcomes) {
  return RecordTable(kColumns, outcomes);
}

std::vector<std::string> StabilityRemarks(const std::vector<StabilityOutcome>& outcomes) {
  std::vector<std::string> remarks;
  for (const StabilityOutcome& outcome : outcomes) {
    const StabilityCase& which = outcome.stability_case;
    if (which.failing != nullptr) remarks.push_back(FullName(which) + ": " + which.failing);
  }
  return remarks;
}

Json ToJson(const std::vector<StabilityOutcome>& outcomes) {
  Json list = RecordsJson(kColumns, outcomes);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (const char* failing = outcomes[i].stability_case.failing) list[i]["failing"] = failing;
  }
  return list;
}

}  // namespace warplut
