// A profile from sequences on disk to PIPELINE.h and a report.
#pragma once

#include <string>

#include "tools/profile/profile_report.h"
#include "tools/profile/profile_request.h"

namespace warplut {

// Searches the pipeline and writes `request.out`, on all ranks; only the root writes. `version`: of
// the program. UsageError: a request that makes no sense, told before a file is opened. Error: an
// input or an output that cannot be used, ranks that differ, an interruption.
ProfileReport RunProfile(const ProfileRequest& request, const std::string& version);

}  // namespace warplut
