// The section of the report that says where the error comes from.
#pragma once

#include "runtime/method.h"
#include "tools/report/budget/budget_ladder.h"
#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// One method's budgets, clip by clip.
struct MethodBudget {
  const MethodInfo* method = nullptr;
  BudgetPlan plan;
  std::vector<ErrorBudget> clips;
};

struct BudgetStudy {
  std::vector<MethodBudget> methods;  // sr, i, e; those without a clip are left out
  std::vector<std::string> failures;  // clips that were left out, and why
};

BudgetStudy StudyBudget(const ReportInputs& inputs);

ReportSection BudgetSection(const ReportInputs& inputs);

}  // namespace warplut
