// Every file of the corpora, through the body of its target: none crashes, and each corpus has
// files that are accepted and files that are refused.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "datasets/file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> CorpusOf(const FuzzTarget& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(WARPLUT_CORPORA) / target.name)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class FuzzCorpusTest : public testing::TestWithParam<FuzzTarget> {};

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpusTest, testing::ValuesIn(kFuzzTargets),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(FuzzCorpusTest, IsReadOrRefused) {
  int accepted = 0, refused = 0;
  for (const fs::path& file : CorpusOf(GetParam())) {
    SCOPED_TRACE(file.string());
    const bool good = GetParam().body(ReadFile(file));
    ++(good ? accepted : refused);
    // Names say it, so that a reader that refuses all, or takes all, is seen.
    const std::string name = file.filename().string();
    if (name.starts_with("good")) {
      EXPECT_TRUE(good) << "was refused";
    } else if (name.starts_with("bad")) {
      EXPECT_FALSE(good) << "was accepted";
    }
  }
  EXPECT_GE(accepted, 1);
  EXPECT_GE(refused, 1);
}

// The inputs that a fuzzer tries first.
TEST_P(FuzzCorpusTest, RefusesNothingAndNoise) {
  EXPECT_FALSE(GetParam().body(""));
  EXPECT_FALSE(GetParam().body(std::string_view("\0", 1)));
  std::string noise(4096, '\0');
  std::uint32_t state = 1;
  for (char& c : noise) c = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
  EXPECT_FALSE(GetParam().body(noise));
}

// Every file of the corpus, cut short anywhere: refused or read, and no crash.
TEST_P(FuzzCorpusTest, OutlivesFilesThatAreCutShort) {
  for (const fs::path& file : CorpusOf(GetParam())) {
    const std::string whole = ReadFile(file);
    for (std::size_t part = 1; part < 16; ++part) {
      GetParam().body(std::string_view(whole).substr(0, whole.size() * part / 16));
    }
  }
}

// Headers that promise gigabytes cost no more than their files hold.
TEST(FuzzCorpora, TakeLittleMemory) {
  for (const FuzzTarget& target : kFuzzTargets) {
    for (const fs::path& file : CorpusOf(target)) target.body(ReadFile(file));
  }
  rusage usage = {};
  ASSERT_EQ(getrusage(RUSAGE_SELF, &usage), 0);
  EXPECT_LT(usage.ru_maxrss, 768 * 1024) << "kB at most, of this process so far";
}

}  // namespace
}  // namespace warplut
