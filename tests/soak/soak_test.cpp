// Every method for many frames: memory stays, values stay in [0, 1], and the error does not grow.
// WARPLUT_SOAK_FRAMES: frames of each method (default: 400); with it a row of a table is printed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "luts/baked/warplut_sr_x2.h"
#include "tests/soak/soaked_method.h"

namespace warplut {
namespace {

constexpr int kFrames = 400;
constexpr int kParts = 10;               // the first is left out: buffers and histories fill
constexpr double kMostGrowth = 1 << 20;  // bytes
constexpr double kMostDrift = 0.05;      // of the mean error, from part to part

double ResidentBytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::vector<const MethodInfo*> MethodsWithState() {
  std::vector<const MethodInfo*> methods;
  for (const MethodInfo& method : Methods()) {
    if (method.super_resolution || method.configure_generation != nullptr) {
      methods.push_back(&method);
    }
  }
  return methods;
}

class SoakTest : public testing::TestWithParam<const MethodInfo*> {};

INSTANTIATE_TEST_SUITE_P(Methods, SoakTest, testing::ValuesIn(MethodsWithState()),
                         [](const auto& test) {
                           std::string name = test.param->name;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST_P(SoakTest, StaysAsItIs) {
  const char* const asked = std::getenv("WARPLUT_SOAK_FRAMES");
  const int frames = asked != nullptr ? std::atoi(asked) : kFrames;
  ASSERT_GE(frames, kParts);
  const Table table(baked::kWarplutSrX2);
  SerialExecutor executor;
  SoakedMethod method(*GetParam(), table, executor);
  ShownValues parts[kParts];
  double resident = 0;
  for (int part = 0; part < kParts; ++part) {
    for (int i = 0; i < frames / kParts; ++i) method.Advance(&parts[part]);
    if (part == 0) resident = ResidentBytes();
    EXPECT_TRUE(parts[part].finite);
    EXPECT_GE(parts[part].least, 0);
    EXPECT_LE(parts[part].largest, 1);
  }
  const double growth = ResidentBytes() - resident;
  EXPECT_LE(growth, kMostGrowth);
  const ShownValues &first = parts[1], &last = parts[kParts - 1];
  EXPECT_LE(last.MeanError(), first.MeanError() * (1 + kMostDrift));
  if (asked == nullptr) return;
  std::printf("| %s | %d | %.0f | %.4f to %.4f | %.5f | %.5f |\n", GetParam()->name, frames,
              growth / 1024, static_cast<double>(last.least), static_cast<double>(last.largest),
              first.MeanError(), last.MeanError());
}

}  // namespace
}  // namespace warplut
