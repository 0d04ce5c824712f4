// A table judged on images, under protocols of repeated warps: what `warplut eval` does.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/judge/images/eval_report.h"
#include "tools/pipeline.h"

namespace warplut {

struct EvalRequest {
  std::vector<std::string> images;
  std::vector<int> warps = {6, 12, 24, 64};
  std::vector<std::string> offsets = {Name(Offsets::kHalf), Name(Offsets::kRandom),
                                      Name(Offsets::kPan)};
  std::vector<std::string> against = {"bilinear", "catmull-rom", "keys:-0.58", kBestKeys};
  std::string format = Name(TableFormat::kI16);  // of a fit or an .exr
  int trajectories = 3;                          // random ones of each image
  int crop = 448;                                // side of the judged windows, 0: whole images
  std::uint64_t seed = 1;
  std::vector<std::string> targets;
  std::string pictures;  // a folder; empty: none
  PipelineArguments pipeline;
};

// Judges the table. `print` takes the report before the pictures are written, which may fail.
// UsageError: a request that makes no sense. Error: an input or an output that cannot be used, an
// interruption.
void EvalImages(const EvalRequest& request, const std::function<void(const EvalReport&)>& print);

}  // namespace warplut
