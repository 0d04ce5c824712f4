// The main function of test programs whose tests run kernels: every test runs once on each
// instruction set that this processor and build have.
#include "tests/kernel_main.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "runtime/warp.h"

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

bool on_widest = true;

// Iteration i of the tests runs on instruction set i.
class EachInstructionSet final : public testing::EmptyTestEventListener {
 public:
  explicit EachInstructionSet(std::vector<std::int64_t> targets) : targets_(std::move(targets)) {}

  void OnTestIterationStart(const testing::UnitTest&, int iteration) override {
    target_ = targets_[static_cast<std::size_t>(iteration) % targets_.size()];
    on_widest = target_ == targets_.front();
    std::printf("Instruction set: %s\n", hwy::TargetName(target_));
  }

  // A test may leave another instruction set behind.
  void OnTestStart(const testing::TestInfo&) override { hwy::SetSupportedTargetsForTest(target_); }

  void OnTestEnd(const testing::TestInfo&) override {
    EXPECT_STREQ(warplut::WarpTarget(), hwy::TargetName(target_)) << "the kernels ran elsewhere";
  }

 private:
  const std::vector<std::int64_t> targets_;
  std::int64_t target_ = 0;
};

}  // namespace

bool warplut::LongRuns() { return on_widest && !kSanitized; }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  // The narrower ones take longest, and differ in the length of their vectors alone.
  if (kSanitized && targets.size() > 2) targets.resize(2);
  if (!GTEST_FLAG_GET(list_tests)) {
    GTEST_FLAG_SET(repeat, GTEST_FLAG_GET(repeat) * static_cast<int>(targets.size()));
  }
  testing::UnitTest::GetInstance()->listeners().Append(new EachInstructionSet(targets));
  return RUN_ALL_TESTS();
}
