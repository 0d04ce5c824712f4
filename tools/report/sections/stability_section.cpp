#include "tools/report/sections/stability_section.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "tests/stability/cases/stability_table.h"
#include "tools/report/section_time.h"

namespace warplut {
namespace {

// The group's name begins a row of its table, which is of that group alone.
TextTable WithoutGroup(TextTable table) {
  table.header.erase(table.header.begin());
  for (std::vector<std::string>& row : table.rows) row.erase(row.begin());
  return table;
}

}  // namespace

ReportSection StabilitySection(const ReportInputs& inputs) {
  ReportSection section{.id = "stability", .title = "Stiff and extreme cases"};
  const SectionTime time(inputs.seconds);
  const std::vector<StabilityCase> cases = StabilityCases();
  std::vector<std::pair<std::string, std::vector<StabilityOutcome>>> groups;
  std::map<StabilityVerdict, int> verdicts;
  std::size_t done = 0, quick = 0;
  for (const StabilityCase& one : cases) {
    inputs.progress(static_cast<double>(done++) / static_cast<double>(cases.size()), one.name);
    const bool short_form = inputs.quick || time.Lacks();
    if (short_form) ++quick;
    if (groups.empty() || groups.back().first != one.group) groups.push_back({one.group, {}});
    const StabilityOutcome outcome =
        RunStabilityCase(one, short_form ? StabilityEffort::kQuick : StabilityEffort::kFull);
    ++verdicts[outcome.verdict()];
    if (outcome.verdict() == StabilityVerdict::kFailed) {
      section.failures.push_back(
          fmt::format("{}, {}: {}.", one.group, one.name, outcome.result.observed));
    }
    groups.back().second.push_back(outcome);
  }
  std::string counts;
  for (const auto& [verdict, count] : verdicts) {
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, Name(verdict));
  }
  section.paragraphs.push_back(
      fmt::format("Each case states the behaviour that is required; what was observed stands "
                  "beside it. Of {} cases: {}.",
                  cases.size(), counts));
  for (const auto& [group, outcomes] : groups) {
    section.tables.push_back({.id = "stability-" + group,
                              .caption = fmt::format("Group {}, {} cases", group, outcomes.size()),
                              .table = WithoutGroup(StabilityTable(outcomes))});
    for (const std::string& remark : StabilityRemarks(outcomes)) section.failures.push_back(remark);
  }
  if (quick > 0) {
    section.failures.push_back(
        fmt::format("{} of {} cases ran in their short form: fewer frames and fewer random starts.",
                    quick, cases.size()));
  }
  return section;
}

}  // namespace warplut
