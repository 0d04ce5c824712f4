// warplut stability: stiff and extreme cases, what must happen in them and what does.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tests/stability/cases/stability_table.h"
#include "tools/commands/command.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"

namespace warplut {
namespace {

struct StabilityArguments {
  std::string group;  // empty: all
  bool quick = false;
  bool markdown = false;
  bool json = false;
};

std::vector<std::string> GroupNames() {
  std::vector<std::string> names;
  for (const StabilityCase& which : StabilityCases()) {
    if (names.empty() || names.back() != which.group) names.emplace_back(which.group);
  }
  return names;
}

std::vector<StabilityOutcome> RunCases(const StabilityArguments& arguments) {
  std::vector<StabilityCase> cases = StabilityCases();
  std::erase_if(cases, [&](const StabilityCase& which) {
    return !arguments.group.empty() && arguments.group != which.group;
  });
  const StabilityEffort effort = arguments.quick ? StabilityEffort::kQuick : StabilityEffort::kFull;
  std::vector<StabilityOutcome> outcomes;
  Progress progress("stability", static_cast<double>(cases.size()), "cases");
  for (const StabilityCase& which : cases) {
    ThrowIfInterrupted("the stability suite", "no table was made");
    progress.Update(static_cast<double>(outcomes.size()), which.name);
    outcomes.push_back(RunStabilityCase(which, effort));
  }
  return outcomes;
}

// One paragraph for each case: tables of sentences are too wide for a terminal.
std::string ToText(const std::vector<StabilityOutcome>& outcomes) {
  std::string text;
  for (const StabilityOutcome& outcome : outcomes) {
    const StabilityCase& which = outcome.stability_case;
    text += fmt::format("{}, {}: {}\n  required: {}\n  observed: {}\n", which.group, which.name,
                        Name(outcome.verdict()), which.required, outcome.result.observed);
    if (which.failing != nullptr) text += fmt::format("  known: {}\n", which.failing);
  }
  return text;
}

std::string Summary(const std::vector<StabilityOutcome>& outcomes) {
  const auto count = [&](StabilityVerdict verdict) {
    return std::count_if(outcomes.begin(), outcomes.end(), [&](const StabilityOutcome& outcome) {
      return outcome.verdict() == verdict;
    });
  };
  double seconds = 0;
  for (const StabilityOutcome& outcome : outcomes) seconds += outcome.seconds;
  return fmt::format("{} cases pass, {} fail as known, {} fail, {} pass though marked; {:.0f} s\n",
                     count(StabilityVerdict::kPassed), count(StabilityVerdict::kKnown),
                     count(StabilityVerdict::kFailed), count(StabilityVerdict::kMended), seconds);
}

std::string Markdown(const std::vector<StabilityOutcome>& outcomes) {
  std::string text = ToMarkdown(StabilityTable(outcomes));
  const std::vector<std::string> remarks = StabilityRemarks(outcomes);
  if (!remarks.empty()) text += "\nKnown to fail:\n\n";
  for (const std::string& remark : remarks) text += "- " + remark + "\n";
  return text;
}

ExitCode RunStability(const StabilityArguments& arguments) {
  const std::vector<StabilityOutcome> outcomes = RunCases(arguments);
  if (arguments.json) {
    PrintJson(ToJson(outcomes));
  } else if (arguments.markdown) {
    Print(Markdown(outcomes));
  } else {
    Print(ToText(outcomes) + "\n" + Summary(outcomes));
  }
  const bool as_expected =
      std::all_of(outcomes.begin(), outcomes.end(), [](const StabilityOutcome& outcome) {
        return outcome.verdict() == StabilityVerdict::kPassed ||
               outcome.verdict() == StabilityVerdict::kKnown;
      });
  return as_expected ? ExitCode::kDone : ExitCode::kMissed;
}

}  // namespace

void AddStabilityCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<StabilityArguments>();
  Command command =
      app.AddCommand("stability", "Run stiff and extreme cases and check their requirements");
  command.Add("--group", arguments->group, "Run the cases of one group alone").OneOf(GroupNames());
  command.AddFlag("--quick", arguments->quick,
                  "Run fewer frames and starts: seconds instead of minutes");
  command.AddFlag("--markdown", arguments->markdown, "Print the table as Markdown");
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunStability(*arguments); }; });
}

}  // namespace warplut
