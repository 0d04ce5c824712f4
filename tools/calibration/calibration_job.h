// A calibration from sequences on disk to a report.
#pragma once

#include "tools/calibration/calibration_report.h"
#include "tools/calibration/calibration_request.h"

namespace warplut {

// Fits the parameters to the clips and judges them, on all ranks; only the root writes. The
// checkpoint next to `request.out` stays where a time limit cut the search. UsageError: a request
// that makes no sense, told before a file is opened. Error: an input or an output that cannot be
// used, ranks that differ, an interruption.
CalibrationReport RunCalibration(const CalibrationRequest& request);

}  // namespace warplut
