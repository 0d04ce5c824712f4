// What a pipeline can do without: one registry that the profile, its documents and the tests walk.
#pragma once

#include <span>

#include "tools/profile/profiled_pipeline.h"

namespace warplut {

struct Omission {
  const char* name;     // lower case and hyphens
  const char* meaning;  // what is left out, or made cheaper
  // Leaves it out of the pipeline; false, and nothing changes, where it is not there or already
  // cheaper.
  bool (*leave_out)(ProfiledPipeline& pipeline);
};

// In the order in which the greatest savings are expected: it decides between savings that
// measurements cannot tell apart.
std::span<const Omission> Omissions();

}  // namespace warplut
