// The section of the report about stiff and extreme cases.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// Runs every case of the registry (tests/stability/cases/stability_case.h) and tells what was
// required and observed.
ReportSection StabilitySection(const ReportInputs& inputs);

}  // namespace warplut
