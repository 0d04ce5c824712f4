#include "train/fit/checkpoint.h"

#include <gtest/gtest.h>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "train/fit/mlp_objective.h"

namespace warplut {
namespace {

Checkpoint Make() {
  Checkpoint c;
  c.made_for = "these options";
  c.stage = 2;
  c.seconds = 1.25;
  c.evaluations = 77;
  c.parameters = RandomParameters(1);
  c.best_parameters = RandomParameters(2);
  c.best_validation = 0.1 + 0.2;
  c.adam = {5, RandomParameters(3), RandomParameters(4)};
  c.loss = {{0.5, 30, 1.0 / 3, 0.7}};
  return c;
}

TEST(Checkpoint, RoundTripKeepsEveryBit) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "c.checkpoint";
  const Checkpoint written = Make();
  WriteCheckpoint(path, written);
  const Checkpoint read = ReadCheckpoint(path, written.made_for, written.parameters.size());
  EXPECT_EQ(read.stage, written.stage);
  EXPECT_EQ(read.seconds, written.seconds);
  EXPECT_EQ(read.evaluations, written.evaluations);
  EXPECT_EQ(read.parameters, written.parameters);
  EXPECT_EQ(read.best_parameters, written.best_parameters);
  EXPECT_EQ(read.best_validation, written.best_validation);
  EXPECT_EQ(read.adam.step, written.adam.step);
  EXPECT_EQ(read.adam.mean, written.adam.mean);
  EXPECT_EQ(read.adam.variance, written.adam.variance);
  ASSERT_EQ(read.loss.size(), 1u);
  EXPECT_EQ(read.loss[0].loss, 1.0 / 3);
}

TEST(Checkpoint, RefusesDamageAndOtherTrainings) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "c.checkpoint";
  WriteCheckpoint(path, Make());
  ExpectError([&] { ReadCheckpoint(path, "other options", kMlpParameters); },
              {"c.checkpoint", "other options or data"});
  const std::string text = ReadFile(path);
  WriteFile(path, text.substr(0, text.size() / 2));
  ExpectError([&] { ReadCheckpoint(path, "these options", kMlpParameters); }, {"c.checkpoint"});
  ExpectError([&] { ReadCheckpoint(folder.path() / "none", "x", kMlpParameters); }, {"none"});
  WriteFile(path, "{\"format\": \"warplut-checkpoint\", \"version\": 9}");
  ExpectError([&] { ReadCheckpoint(path, "x", kMlpParameters); }, {"version"});
}

}  // namespace
}  // namespace warplut
