#pragma once

#include "tests/runtime/pipelines/lean_configurations.h"

namespace warplut {

inline constexpr PipelineConfiguration kPipeline = kInterpolationConfiguration;

}  // namespace warplut
