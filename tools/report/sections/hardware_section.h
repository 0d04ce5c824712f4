// The section of the report that says what it was made with.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

ReportSection HardwareSection(const ReportInputs& inputs);

}  // namespace warplut
