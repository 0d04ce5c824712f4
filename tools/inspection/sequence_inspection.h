// What a sequence holds, and which of its files are missing or damaged.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "datasets/sequence/sequence.h"
#include "train/inspection/inspection.h"

namespace warplut {

// One stream over all frames. The range is that of the stored quantity in the one convention:
// colour value, depth (without background), length of the motion in pixels of its grid.
struct StreamInspection {
  std::string name;
  int frames = 0;  // that could be loaded
  double least = 0;
  double greatest = 0;
  double mean = 0;
  // values that are, which do not count in these: background, or linear colour
  std::int64_t infinite = 0;
  std::vector<std::string> problems;  // one sentence for each frame that could not be loaded
};

// The first problem of a stream, and how many more there are; empty without problems.
std::string ProblemText(const StreamInspection& stream);

// Loads every frame of every stream that the manifest names. `on_load` is called after each; what
// it throws ends the inspection.
std::vector<StreamInspection> InspectSequence(const Sequence& sequence,
                                              const std::function<void()>& on_load);

// Inspect (train/inspection/inspection.h), with libraries that write of damaged files to standard
// error kept quiet: InspectSequence tells of those.
Inspection InspectQuietly(const Sequence& sequence, const std::function<void()>& on_step,
                          bool faults);

}  // namespace warplut
