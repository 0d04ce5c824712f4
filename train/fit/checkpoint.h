// The state of a training, for going on inside a stage too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "luts/fit/fit.h"
#include "train/fit/evaluation_log.h"
#include "train/fit/minimize.h"

namespace warplut {

// What a training's result depends on.
struct CheckpointIdentity {
  std::string options;  // TrainOptions::Json
  struct ImageIdentity {
    std::string name, sha1;
  };
  std::vector<ImageIdentity> images;

  // What of `other` is not as here, as "seed is 1 there and 2 here"; empty if the result is the
  // same. A limit of time may differ, and the names of images.
  std::string DifferenceFrom(const CheckpointIdentity& other) const;
};

struct Checkpoint {
  CheckpointIdentity made_for;  // another training's checkpoint is refused
  int stage = 0;                // stages that are complete
  double seconds = 0;
  std::int64_t evaluations = 0;    // of the stages that are complete
  std::vector<double> parameters;  // where the last stage ended
  std::vector<double>
      best_parameters;  // of the stage with the least validation loss; empty before the first ended
  double best_validation = 0;
  AdamState adam;  // where the last stage ended
  std::vector<FitLoss> loss;
  std::vector<Evaluation> begun;  // of the stage that was begun
};

// Writes atomically, as JSON; doubles keep all their bits.
void WriteCheckpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

// Reads one for a training with so many parameters. An Error names what is damaged, or says in
// which option or image the training differs that it was made for.
Checkpoint ReadCheckpoint(const std::filesystem::path& path, const CheckpointIdentity& made_for,
                          std::size_t parameters);

}  // namespace warplut
