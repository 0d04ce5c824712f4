// What a person asks of a calibration.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/pipeline.h"

namespace warplut {

struct CalibrationRequest {
  std::vector<std::string> sequences;
  std::vector<std::string> modes = {"sr"};
  std::string out;                    // the parameters; a checkpoint stands next to them meanwhile
  std::vector<std::string> hold_out;  // names of sequences to judge by
  bool split_frames = false;          // instead: the second half of each clip
  std::vector<std::string> fit;       // names of parameters; empty: all that the modes read
  std::string keep = "near";          // or "optimum"
  int starts = 2;
  std::uint64_t seed = 1;
  double max_seconds = 0;  // 0: no limit
  int every = 2;           // one frame in so many is rendered, in the modes that generate
  int max_pixels = 0;      // of a frame, in its middle; 0: whole frames
  int max_frames = 0;      // of a clip; 0: all
  std::string memory;      // as ParseMemorySize takes it; empty: all clips are kept
  bool resume = false;
  PipelineArguments pipeline;
};

}  // namespace warplut
