// Every command line of its corpus is parsed or refused, as the name of its file says.
#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

TEST(CommandLineCorpus, IsParsedOrRefused) {
  int accepted = 0, refused = 0;
  for (const auto& entry : fs::directory_iterator(WARPLUT_COMMAND_LINE_CORPUS)) {
    const std::string name = entry.path().filename().string();
    const bool good = FuzzCommandLine(ReadFile(entry.path()));
    ++(good ? accepted : refused);
    if (name.starts_with("good")) {
      EXPECT_TRUE(good) << name << " was refused";
    } else if (name.starts_with("bad")) {
      EXPECT_FALSE(good) << name << " was accepted";
    }
  }
  EXPECT_GE(accepted, 10);
  EXPECT_GE(refused, 5);
}

// What a fuzzer tries first, and every line of the corpus cut short anywhere.
TEST(CommandLineCorpus, OutlivesNothingNoiseAndPieces) {
  EXPECT_FALSE(FuzzCommandLine(""));
  EXPECT_FALSE(FuzzCommandLine(std::string_view("\0", 1)));
  std::string noise(4096, '\0');
  std::uint32_t state = 1;
  for (char& c : noise) c = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
  EXPECT_FALSE(FuzzCommandLine(noise));
  for (const auto& entry : fs::directory_iterator(WARPLUT_COMMAND_LINE_CORPUS)) {
    const std::string whole = ReadFile(entry.path());
    for (std::size_t part = 1; part < 8; ++part) {
      FuzzCommandLine(std::string_view(whole).substr(0, whole.size() * part / 8));
    }
  }
}

}  // namespace
}  // namespace warplut
