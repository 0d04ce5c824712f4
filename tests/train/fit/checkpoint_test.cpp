#include "train/fit/checkpoint.h"

#include <gtest/gtest.h>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "train/fit/objective/mlp_objective.h"

namespace warplut {
namespace {

CheckpointIdentity Identity() {
  return {.options = R"({"scale":2,"seed":1,"max_seconds":5})",
          .images = {{"a.png", "1234"}, {"b.png", "5678"}}};
}

Checkpoint Make() {
  Checkpoint c;
  c.made_for = Identity();
  c.stage = 2;
  c.seconds = 1.25;
  c.evaluations = 77;
  c.parameters = RandomParameters(1);
  c.best_parameters = RandomParameters(2);
  c.best_validation = 0.1 + 0.2;
  c.adam = {5, RandomParameters(3), RandomParameters(4)};
  c.loss = {{0.5, 30, 1.0 / 3, 0.7}};
  c.begun = {{1.0 / 7, RandomParameters(5)}, {0.5, {}}};
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
  ASSERT_EQ(read.begun.size(), 2u);
  EXPECT_EQ(read.begun[0].value, 1.0 / 7);
  EXPECT_EQ(read.begun[0].gradient, written.begun[0].gradient);
  EXPECT_TRUE(read.begun[1].gradient.empty());
}

TEST(Checkpoint, RefusesDamageAndOtherTrainings) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "c.checkpoint";
  WriteCheckpoint(path, Make());
  CheckpointIdentity other = Identity();
  other.options = R"({"scale":2,"seed":2,"max_seconds":5})";
  ExpectError([&] { ReadCheckpoint(path, other, kMlpParameters); },
              {"c.checkpoint", "another training: seed is 1 there and 2 here"});
  const std::string text = ReadFile(path);
  WriteFile(path, text.substr(0, text.size() / 2));
  ExpectError([&] { ReadCheckpoint(path, Identity(), kMlpParameters); }, {"c.checkpoint"});
  ExpectError([&] { ReadCheckpoint(folder.path() / "none", Identity(), kMlpParameters); },
              {"none"});
  WriteFile(path, "{\"format\": \"warplut-checkpoint\", \"version\": 9}");
  ExpectError([&] { ReadCheckpoint(path, Identity(), kMlpParameters); }, {"version"});
}

TEST(CheckpointIdentity, NamesWhatDiffersButForTheTimeLimit) {
  const auto difference = [](const std::string& options,
                             std::vector<CheckpointIdentity::ImageIdentity> images) {
    return CheckpointIdentity{.options = options, .images = std::move(images)}.DifferenceFrom(
        Identity());
  };
  const std::string same = R"({"seed":1,"scale":2.0,"max_seconds":9})";
  const auto images = Identity().images;
  EXPECT_EQ(difference(same, images), "");
  EXPECT_EQ(difference(same, {{"moved/a.png", "1234"}, {"b.png", "5678"}}), "");
  EXPECT_EQ(difference(R"({"seed":1,"scale":3})", images), "scale is 2 there and 3 here");
  EXPECT_EQ(difference(R"({"seed":1,"scale":2,"blend_a":0.5})", images),
            "blend_a is not set there and 0.5 here");
  EXPECT_EQ(difference(same, {{"a.png", "1234"}, {"c.png", "9"}}),
            "image 2 is b.png there and c.png here, of other content");
  EXPECT_EQ(difference(same, {{"a.png", "1234"}}), "there are 2 images there and 1 here");
}

}  // namespace
}  // namespace warplut
