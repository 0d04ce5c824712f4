// Results against stored hashes: the same bits on every machine of an instruction set.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/golden/golden_hashes.h"

namespace warplut {
namespace {

GoldenHashes Stored() {
  std::ifstream file(WARPLUT_GOLDEN);
  GoldenHashes stored;
  for (std::string name, hash; file >> name >> hash;) stored[name] = hash;
  return stored;
}

// Every hash that is stored of those that were computed; some are, or the test is skipped.
void ExpectStored(const GoldenHashes& hashes) {
  const GoldenHashes stored = Stored();
  ASSERT_FALSE(stored.empty());
  int compared = 0;
  for (const auto& [name, hash] : hashes) {
    const auto at = stored.find(name);
    if (at == stored.end()) continue;
    EXPECT_EQ(hash, at->second) << name;
    ++compared;
  }
  if (compared == 0) {
    GTEST_SKIP() << "no hash is stored of the instruction sets of this processor";
  }
}

TEST(Golden, BakedFilesHaveTheStoredBits) {
  const GoldenHashes hashes = BakeHashes();
  const GoldenHashes stored = Stored();
  for (const auto& [name, hash] : hashes) EXPECT_TRUE(stored.contains(name)) << name << " " << hash;
  ExpectStored(hashes);
}

TEST(Golden, ModesHaveTheStoredBits) { ExpectStored(ModeHashes()); }

TEST(Golden, TrainingsHaveTheStoredBits) { ExpectStored(TrainingHashes()); }

TEST(Golden, CalibrationsHaveTheStoredBits) { ExpectStored(CalibrationHashes()); }

}  // namespace
}  // namespace warplut
