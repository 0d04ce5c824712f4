// The section of the report that sets the errors of whole pipelines against their times.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// Every method of the registry on every clip, at both resolutions, with pictures.
ReportSection PipelinesSection(const ReportInputs& inputs);

}  // namespace warplut
