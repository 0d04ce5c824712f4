#include "tests/stability/cases/stability_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "datasets/error.h"

namespace warplut {
namespace {

StabilityResult Pass(StabilityEffort effort) {
  return {true, effort == StabilityEffort::kQuick ? "quick" : "full"};
}
StabilityResult Fail(StabilityEffort) { return {false, "7 of 3"}; }
StabilityResult Throw(StabilityEffort) { throw Error("The box is locked."); }

StabilityCase Case(StabilityResult (*run)(StabilityEffort), const char* failing = nullptr) {
  return {
      .group = "group", .name = "a case", .required = "nothing", .run = run, .failing = failing};
}

StabilityVerdict VerdictOf(const StabilityCase& which) {
  return RunStabilityCase(which, StabilityEffort::kQuick).verdict();
}

TEST(StabilityTable, AMarkTurnsFailuresIntoKnownOnesAndPassesIntoMendedOnes) {
  EXPECT_EQ(VerdictOf(Case(Pass)), StabilityVerdict::kPassed);
  EXPECT_EQ(VerdictOf(Case(Fail)), StabilityVerdict::kFailed);
  EXPECT_EQ(VerdictOf(Case(Fail, "It fails.")), StabilityVerdict::kKnown);
  EXPECT_EQ(VerdictOf(Case(Pass, "It fails.")), StabilityVerdict::kMended);
}

TEST(StabilityTable, WhatACaseThrowsIsAFailureThatTellsTheSentence) {
  const StabilityOutcome outcome = RunStabilityCase(Case(Throw), StabilityEffort::kQuick);
  EXPECT_EQ(outcome.verdict(), StabilityVerdict::kFailed);
  EXPECT_EQ(outcome.result.observed, "The box is locked.");
}

TEST(StabilityTable, EffortReachesTheCase) {
  EXPECT_EQ(RunStabilityCase(Case(Pass), StabilityEffort::kQuick).result.observed, "quick");
  EXPECT_EQ(RunStabilityCase(Case(Pass), StabilityEffort::kFull).result.observed, "full");
}

TEST(StabilityTable, HasARowForEachOutcomeAndRemarksForMarkedCases) {
  const std::vector<StabilityOutcome> outcomes = {
      RunStabilityCase(Case(Pass), StabilityEffort::kFull),
      RunStabilityCase(Case(Fail, "It shows the wrong side."), StabilityEffort::kFull)};
  const TextTable table = StabilityTable(outcomes);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_THAT(table.rows[0], testing::ElementsAre("group", "a case", "nothing", "full", "passes"));
  EXPECT_EQ(table.rows[1][4], Name(StabilityVerdict::kKnown));
  EXPECT_THAT(StabilityRemarks(outcomes),
              testing::ElementsAre("group, a case: It shows the wrong side."));
  const auto json = ToJson(outcomes);
  EXPECT_EQ(json[0]["observed"], "full");
  EXPECT_FALSE(json[0].contains("failing"));
  EXPECT_EQ(json[1]["failing"], "It shows the wrong side.");
}

}  // namespace
}  // namespace warplut
