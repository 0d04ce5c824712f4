// Several ranks come to the bits of one. Skipped where there is no mpirun, or the build has no MPI.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "datasets/file.h"
#include "luts/fit/fit.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

using testing::HasSubstr;

// Starts a shell command line on so many ranks.
ProgramResult RunShellOnRanks(int ranks, const std::string& command) {
  // As root, on more ranks than cores, on one machine: what a container has.
  return RunProgram("/bin/sh",
                    {"-c",
                     "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                     "OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none "
                     "OMPI_MCA_plm_rsh_agent=sh exec mpirun --oversubscribe -n " +
                         std::to_string(ranks) + " " + command});
}

ProgramResult RunOnRanks(int ranks, const std::vector<std::string>& arguments) {
  std::string command = WARPLUT_PROGRAM;
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  return RunShellOnRanks(ranks, command);
}

class RanksOfTheProgram : public testing::Test {
 protected:
  void SetUp() override {
    if (RunProgram("/bin/sh", {"-c", "command -v mpirun"}).code != 0) {
      GTEST_SKIP() << "mpirun is not installed";
    }
    const ProgramResult trial = RunShellOnRanks(2, "true");
    if (trial.code != 0) GTEST_SKIP() << "mpirun starts no two ranks here: " << trial.err;
    const ProgramResult list = RunOnRanks(2, {"dataset", "scenes"});
    if (list.err.find("built without MPI") != std::string::npos) {
      GTEST_SKIP() << "the build has no MPI";
    }
    ASSERT_EQ(list.code, 0) << list.err;
    EXPECT_EQ(list.out, RunWarplut({"dataset", "scenes"}).out) << "the root alone prints";
  }

  std::vector<std::string> Training(const std::string& fit) const {
    return {"train",   "--data",     WriteWavyImage(folder_ / "image.png", 256, 256),
            "--out",   fit,          "--name",
            "fit",     "--horizons", "2,6",
            "--crops", "5",          "--iterations",
            "4",       "--stages",   "2"};
  }

  // "one" and "two", which differ.
  void WriteTwoPans() const {
    WritePan(folder_ / "one");
    WritePan(folder_ / "two", {.frames = 5, .jitter = false});
    for (const char* name : {"one", "two"}) {
      const std::filesystem::path file = folder_ / name / "sequence.json";
      nlohmann::ordered_json json = nlohmann::ordered_json::parse(ReadFile(file));
      json["name"] = name;
      WriteFile(file, json.dump());
    }
  }

  const TemporaryFolder folder_;
};

// Removes what is timed, at any depth.
void EraseTimes(nlohmann::json& json, const std::vector<std::string>& names) {
  if (json.is_object()) {
    for (const std::string& name : names) json.erase(name);
  }
  if (!json.is_structured()) return;
  for (auto& child : json) EraseTimes(child, names);
}

TEST_F(RanksOfTheProgram, TrainTheSameBits) {
  const std::string alone = folder_ / "alone.json";
  ASSERT_EQ(RunWarplut(Training(alone)).code, 0);
  for (const int ranks : {2, 3}) {
    const std::string shared = folder_ / ("ranks" + std::to_string(ranks) + ".json");
    const ProgramResult result = RunOnRanks(ranks, Training(shared));
    ASSERT_EQ(result.code, 0) << result.err;
    const Fit a = ReadFit(alone), b = ReadFit(shared);
    EXPECT_EQ(a.parameters, b.parameters) << ranks;
    EXPECT_EQ(a.prefilter.side, b.prefilter.side) << ranks;
    ASSERT_EQ(a.loss.size(), b.loss.size());
    for (std::size_t i = 0; i < a.loss.size(); ++i) {
      EXPECT_EQ(a.loss[i].validation, b.loss[i].validation) << ranks;
    }
    EXPECT_FALSE(std::filesystem::exists(shared + ".checkpoint"));
  }
}

// A rank that dies ends the others; what was saved goes on, on another number of ranks.
TEST_F(RanksOfTheProgram, GoOnAfterOneDied) {
  const std::string alone = folder_ / "alone.json", fit = folder_ / "fit.json";
  ASSERT_EQ(RunWarplut(Training(alone)).code, 0);
  const std::filesystem::path script = folder_ / "rank.sh";
  std::string train = WARPLUT_PROGRAM;
  for (const std::string& argument : Training(fit)) train += " '" + argument + "'";
  std::ofstream(script) << "if [ \"$OMPI_COMM_WORLD_RANK\" = 0 ]; then exec " << train << "; fi\n"
                        << train << " &\n"
                        << "while [ ! -e '" << fit << ".checkpoint' ]; do sleep 0.01; done\n"
                        << "kill -9 $!\nwait $!\n";
  const ProgramResult died = RunShellOnRanks(2, "sh " + script.string());
  EXPECT_NE(died.code, 0);
  EXPECT_FALSE(std::filesystem::exists(fit));
  ASSERT_TRUE(std::filesystem::exists(fit + ".checkpoint")) << died.err;
  std::vector<std::string> resume = Training(fit);
  resume.emplace_back("--resume");
  const ProgramResult resumed = RunOnRanks(3, resume);
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(ReadFit(alone).parameters, ReadFit(fit).parameters);
}

TEST_F(RanksOfTheProgram, CalibrateTheSameBits) {
  WriteTwoPans();
  const auto calibrate = [&](const std::string& out) -> std::vector<std::string> {
    return {"calibrate", "--sequence", folder_ / "one", folder_ / "two", "--modes",
            "sr,i",      "--filter",   "catmull-rom",   "--out",         out,
            "--starts",  "0",          "--fit",         "blend_a"};
  };
  const std::string alone = folder_ / "alone.json", shared = folder_ / "shared.json";
  const ProgramResult one = RunWarplut(calibrate(alone));
  ASSERT_EQ(one.code, 0) << one.err;
  const ProgramResult two = RunOnRanks(2, calibrate(shared));
  ASSERT_EQ(two.code, 0) << two.err;
  auto a = nlohmann::json::parse(ReadFile(alone)), b = nlohmann::json::parse(ReadFile(shared));
  EXPECT_EQ(a["parameters"], b["parameters"]);
  a["calibration"].erase("seconds");
  b["calibration"].erase("seconds");
  EXPECT_EQ(a["calibration"], b["calibration"]);
}

// A rank has some methods of one or both of two sequences.
TEST_F(RanksOfTheProgram, JudgeTheSameBits) {
  WriteTwoPans();
  const std::vector<std::string> judge = {
      "judge",      "--sequence",         folder_ / "one", folder_ / "two", "--modes",
      "sr,i",       "--filter",           "bilinear",      "--settled",     "1",
      "--pictures", folder_ / "pictures", "--json"};
  const ProgramResult alone = RunWarplut(judge);
  ASSERT_EQ(alone.code, 0) << alone.err;
  auto expected = nlohmann::json::parse(alone.out);
  EraseTimes(expected, {"milliseconds"});
  for (const int ranks : {2, 3}) {
    const ProgramResult shared = RunOnRanks(ranks, judge);
    ASSERT_EQ(shared.code, 0) << shared.err;
    auto json = nlohmann::json::parse(shared.out);
    EraseTimes(json, {"milliseconds"});
    EXPECT_EQ(json, expected) << ranks;
  }
}

// The times decide which passes are taken together; the scores of each alone and of all tables are
// the same.
TEST_F(RanksOfTheProgram, ProfileTheSameScores) {
  WriteTwoPans();
  const auto profile = [&](const std::string& out) -> std::vector<std::string> {
    return {"profile",  "--sequence", folder_ / "one", folder_ / "two", "--mode", "sr",
            "--filter", "bilinear",   "--out",         folder_ / out,   "--json"};
  };
  const ProgramResult alone = RunWarplut(profile("alone.h"));
  ASSERT_EQ(alone.code, 0) << alone.err;
  auto expected = nlohmann::json::parse(alone.out);
  for (const int ranks : {2, 3}) {
    const ProgramResult shared = RunOnRanks(ranks, profile("shared.h"));
    ASSERT_EQ(shared.code, 0) << shared.err;
    auto json = nlohmann::json::parse(shared.out);
    for (const char* part : {"alone", "shipped", "sequences"}) {
      ASSERT_TRUE(expected.contains(part)) << part;
      EraseTimes(json[part], {"time", "chosen"});
      EraseTimes(expected[part], {"time", "chosen"});
      EXPECT_EQ(json[part], expected[part]) << ranks << " " << part;
    }
    EXPECT_TRUE(std::filesystem::exists(folder_ / "shared.h"));
  }
}

// The report's studies compare with what one rank computes.
TEST_F(RanksOfTheProgram, StudyTrainersTogether) {
  const ProgramResult studied =
      RunShellOnRanks(2, std::filesystem::read_symlink("/proc/self/exe").string() +
                             " --gtest_filter=StudyTrainers.*");
  EXPECT_EQ(studied.code, 0) << studied.out;
}

TEST_F(RanksOfTheProgram, ReportOnOnePage) {
  WriteTwoPans();
  const ProgramResult report =
      RunOnRanks(2, {"report", "--out", folder_ / "report", "--quick", "--sequence",
                     folder_ / "one", folder_ / "two", "--sections", "hardware", "--json"});
  if (report.err.find("gnuplot") != std::string::npos) GTEST_SKIP() << report.err;
  ASSERT_EQ(report.code, 0) << report.err;
  const auto json = nlohmann::json::parse(report.out);
  EXPECT_EQ(json["parts"].size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report/index.html"));
}

TEST_F(RanksOfTheProgram, RenderTheSameFiles) {
  const auto render = [&](const std::string& out) -> std::vector<std::string> {
    return {"dataset", "render",    "still",    "--out",     folder_ / out,
            "--width", "64",        "--height", "48",        "--frames",
            "5",       "--samples", "2",        "--streams", "color,reference"};
  };
  const auto files = [&](const std::string& out) {
    std::map<std::string, std::string> contents;
    const std::filesystem::path root = folder_ / out;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (entry.is_regular_file()) {
        contents[std::filesystem::relative(entry.path(), root)] = ReadFile(entry.path());
      }
    }
    return contents;
  };
  ASSERT_EQ(RunWarplut(render("alone")).code, 0);
  const ProgramResult shared = RunOnRanks(2, render("shared"));
  ASSERT_EQ(shared.code, 0) << shared.err;
  EXPECT_EQ(files("alone"), files("shared"));
  EXPECT_EQ(files("alone").size(), 11U);
}

// The scripts for clusters, with two ranks here.
TEST_F(RanksOfTheProgram, StartByTheScripts) {
  const std::string setup =
      "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      "OMPI_MCA_rmaps_base_oversubscribe=1 WARPLUT=" WARPLUT_PROGRAM
      " RANKS=2; "
      "unset SLURM_NTASKS SLURM_CPUS_PER_TASK; " WARPLUT_SOURCE "/tools/cluster/";
  const std::string expected = RunWarplut({"dataset", "scenes"}).out;
  for (const char* script : {"slurm.sh", "hosts.sh localhost:2"}) {
    const ProgramResult result = RunProgram("/bin/sh", {"-c", setup + script + " dataset scenes"});
    EXPECT_EQ(result.code, 0) << script << ": " << result.err;
    EXPECT_EQ(result.out, expected) << script;
  }
}

TEST_F(RanksOfTheProgram, TellTheirTimesIfAsked) {
  const ProgramResult result =
      RunShellOnRanks(2, "-x WARPLUT_RANK_TIMES=1 " WARPLUT_PROGRAM " dataset scenes");
  EXPECT_EQ(result.code, 0) << result.err;
  for (const char* piece : {"rank 0: ", "rank 1: ", " 0 exchanges, 0 bytes"}) {
    EXPECT_THAT(result.err, HasSubstr(piece));
  }
}

TEST_F(RanksOfTheProgram, TellWhatFailed) {
  const ProgramResult wrong = RunOnRanks(2, {"bake", "fit.json", "--out", folder_ / "out"});
  EXPECT_NE(wrong.code, 0);
  EXPECT_THAT(wrong.err, HasSubstr("the command 'bake' runs on one rank"));
  const ProgramResult missing =
      RunOnRanks(2, {"train", "--data", folder_ / "nothing.png", "--out", folder_ / "fit.json"});
  EXPECT_NE(missing.code, 0);
  EXPECT_THAT(missing.err, HasSubstr("nothing.png"));
  EXPECT_THAT(missing.err, testing::Not(HasSubstr("rank 1:"))) << "the root tells for all";
  const ProgramResult unknown = RunOnRanks(2, {"train", "--nonsense"});
  EXPECT_NE(unknown.code, 0);
  EXPECT_THAT(unknown.err, testing::Not(HasSubstr("rank 1:")));
}

}  // namespace
}  // namespace warplut
