// The tables that a report is made with.
#pragma once

#include <filesystem>

#include "tools/report/report_inputs.h"

namespace warplut {

// A table from any file that LoadTable reads; of a fit the MLP is kept beside the table. Errors as
// LoadTable.
ReportLut LoadReportLut(const std::filesystem::path& path);

// The two fits of x2 that ship: written into `folder`, where they stay, so that the report's
// commands can be repeated.
ReportLut ShippedWarpLut(const std::filesystem::path& folder);
ReportLut ShippedPipelineLut(const std::filesystem::path& folder);

}  // namespace warplut
