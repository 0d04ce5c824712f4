// A build without MPI, started by the launchers of MPI.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "datasets/error.h"
#include "train/ranks/launch.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

TEST(Launch, IsToldByTheEnvironment) {
  const auto launched = [](const char* variable, const char* value) {
    setenv(variable, value, 1);
    const int count = LaunchedRanks();
    unsetenv(variable);
    return count;
  };
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "SLURM_NTASKS"}) {
    unsetenv(variable);
  }
  EXPECT_EQ(LaunchedRanks(), 0);
  EXPECT_EQ(launched("OMPI_COMM_WORLD_SIZE", "3"), 3);
  EXPECT_EQ(launched("PMI_SIZE", "2"), 2);
  EXPECT_EQ(launched("PMI_SIZE", "none"), 0);
  EXPECT_EQ(launched("SLURM_NTASKS", "8"), 0) << "srun starts every program";
  setenv("PMIX_RANK", "0", 1);
  EXPECT_EQ(launched("SLURM_NTASKS", "8"), 8);
  unsetenv("PMIX_RANK");
}

// In a process of its own: World is made once.
TEST(OneRankDeathTest, SeveralAreRefused) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(
      {
        setenv("OMPI_COMM_WORLD_SIZE", "2", 1);
        try {
          Ranks::World();
        } catch (const Error& refused) {
          std::fputs(refused.what(), stderr);
          std::exit(Ranks::Started() == nullptr ? 2 : 3);
        }
      },
      testing::ExitedWithCode(2), "built without MPI");
}

}  // namespace
}  // namespace warplut
