// The section of the report that compares trainers.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// Of the study in trainer_study.h, on crops of the clips' references.
ReportSection TrainerSection(const ReportInputs& inputs);

}  // namespace warplut
