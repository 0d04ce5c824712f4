// The configuration of a build that nobody has restricted.
#pragma once

#include "runtime/pipeline_configuration.h"

namespace warplut {

inline constexpr PipelineConfiguration kPipeline{};

}  // namespace warplut
