// The registry of stability cases, one test for each.
#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <set>
#include <string>

#include "tests/stability/cases/stability_table.h"

namespace warplut {

void PrintTo(const StabilityCase& which, std::ostream* out) {
  *out << which.group << ", " << which.name;
}

namespace {

std::string TestName(const StabilityCase& which) {
  std::string name = std::string(which.group) + "_" + which.name;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

class StabilitySuite : public testing::TestWithParam<StabilityCase> {};

TEST_P(StabilitySuite, Quick) {
  const StabilityCase& which = GetParam();
  const StabilityOutcome outcome = RunStabilityCase(which, StabilityEffort::kQuick);
  switch (outcome.verdict()) {
    case StabilityVerdict::kPassed:
      break;
    case StabilityVerdict::kKnown:
      GTEST_SKIP() << which.failing << "; observed: " << outcome.result.observed;
    case StabilityVerdict::kFailed:
      FAIL() << "required: " << which.required << "\nobserved: " << outcome.result.observed;
    case StabilityVerdict::kMended:
      FAIL() << "The case passes (" << outcome.result.observed
             << "): remove the mark that says: " << which.failing;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, StabilitySuite, testing::ValuesIn(StabilityCases()),
                         [](const auto& test) { return TestName(test.param); });

TEST(StabilityRegistry, NamesAreUniqueAndPlain) {
  std::set<std::string> names;
  for (const StabilityCase& which : StabilityCases()) {
    const std::string name = which.name;
    EXPECT_TRUE(names.insert(TestName(which)).second) << name << " is there twice";
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                     "0123456789 -_,."),
              std::string::npos)
        << name;
    EXPECT_STRNE(which.required, "") << name;
    if (which.failing != nullptr) {
      EXPECT_STRNE(which.failing, "") << name;
    }
  }
}

TEST(StabilityRegistry, GroupsStandTogether) {
  std::set<std::string> left;
  std::string group;
  for (const StabilityCase& which : StabilityCases()) {
    if (group == which.group) continue;
    EXPECT_TRUE(left.insert(which.group).second) << which.group << " stands in two places";
    group = which.group;
  }
  EXPECT_EQ(left, (std::set<std::string>{"training", "gates", "gradients", "history", "runtime"}));
}

}  // namespace
}  // namespace warplut
