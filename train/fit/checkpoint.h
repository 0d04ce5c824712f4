// The state of a training after its last complete stage, for going on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "luts/fit/fit.h"
#include "train/fit/minimize.h"

namespace warplut {

struct Checkpoint {
  std::string made_for;  // options and data; another training's checkpoint is refused
  int stage = 0;         // stages that are complete
  double seconds = 0;
  std::int64_t evaluations = 0;
  std::vector<double> parameters;       // where the last stage ended
  std::vector<double> best_parameters;  // of the stage with the least validation loss
  double best_validation = 0;
  AdamState adam;
  std::vector<FitLoss> loss;
};

// Writes atomically, as JSON; doubles keep all their bits.
void WriteCheckpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

// Reads one for a training with so many parameters. An Error names what is damaged, or says that it
// was made for another training.
Checkpoint ReadCheckpoint(const std::filesystem::path& path, const std::string& made_for,
                          std::size_t parameters);

}  // namespace warplut
