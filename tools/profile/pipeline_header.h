// A pipeline as C++: the header that the runtime is compiled with
// (runtime/pipeline_configuration.h).
#pragma once

#include <string>
#include <vector>

#include "runtime/pipeline_configuration.h"

namespace warplut {

// "k" and the name in camel case: "edge-aware" -> kEdgeAware, "rgba16f" -> kRgba16F.
std::string Enumerator(const std::string& name);

// The initializer of a PipelineConfiguration, "{...}", with the choices that have a value and the
// members that differ from their defaults, one a line and in the order of declaration.
std::string Initializer(const PipelineConfiguration& configuration);

// The whole header: `banner`, one comment line each; then kPipeline. A pure function.
std::string PipelineHeader(const std::vector<std::string>& banner,
                           const PipelineConfiguration& configuration);

}  // namespace warplut
