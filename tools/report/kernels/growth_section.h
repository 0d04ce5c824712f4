// The section of the report that says how time and memory grow.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// With pixels, frames and threads, of super resolution, interpolation and extrapolation with
// default options.
ReportSection GrowthSection(const ReportInputs& inputs);

}  // namespace warplut
