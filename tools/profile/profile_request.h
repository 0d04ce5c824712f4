// What a person asks of a profile.
#pragma once

#include <string>
#include <vector>

#include "tools/pipeline.h"

namespace warplut {

// Losses of SSIM up to this are no loss, where nothing else is asked for.
inline constexpr double kDefaultWithin = 0.0005;

struct ProfileRequest {
  std::vector<std::string> sequences;
  std::string mode = "sr";
  std::string out;                 // PIPELINE.h
  double within = kDefaultWithin;  // largest loss of SSIM
  int every = 2;                   // one frame in so many is rendered, in modes that generate
  PipelineArguments pipeline;
};

}  // namespace warplut
