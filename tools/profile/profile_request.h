// What a person asks of a profile.
#pragma once

#include <string>
#include <vector>

#include "tools/pipeline.h"

namespace warplut {

struct ProfileRequest {
  std::vector<std::string> sequences;
  std::string mode = "sr";
  std::string out;         // PIPELINE.h
  double within = 0.0005;  // largest loss of SSIM
  int every = 2;           // one frame in so many is rendered, in modes that generate
  PipelineArguments pipeline;
};

}  // namespace warplut
