// The section of the report that sets the errors of resampling kernels against their times.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// One Pareto plot and one table for each of RGBA8, RGBA16F and RGBA32F.
ReportSection KernelsSection(const ReportInputs& inputs);

}  // namespace warplut
