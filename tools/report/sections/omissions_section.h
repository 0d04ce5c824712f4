// The section of the report about what content can do without.
#pragma once

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// Profiles super resolution on each clip alone, as `warplut profile` does: what each pass buys in
// error and in time, and the cheapest pipeline within kReportWithin.
ReportSection OmissionsSection(const ReportInputs& inputs);

// SSIM that may be lost against every pass together.
inline constexpr double kReportWithin = 0.0005;

}  // namespace warplut
