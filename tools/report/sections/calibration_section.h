// The section of the report that says what calibration costs and finds.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// Of the study in calibration_study.h, for super resolution and its a, b and T_D, on small pieces
// of some of the clips.
ReportSection CalibrationSection(const ReportInputs& inputs);

}  // namespace warplut
