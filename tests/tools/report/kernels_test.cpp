// The kernels that the report compares equal what they say they equal.
#include <gtest/gtest.h>

#include <cmath>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tools/report/kernels/kernel_scores.h"
#include "tools/report/kernels/resampling_kernels.h"
#include "tools/report/report_lut.h"

namespace warplut {
namespace {

class ReportKernels : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const ReportLut lut_ = ShippedWarpLut(folder_ / "");
  const std::vector<ResamplingKernel> kernels_ = ResamplingKernels(lut_, -0.6f);
};

TEST_F(ReportKernels, KeepConstantsAndEqualTheReference) {
  for (const PixelFormat format : kColorFormats) {
    for (const ResamplingKernel& kernel : kernels_) {
      if (!kernel.Takes(format) || kernel.slow) continue;
      EXPECT_EQ(CheckKernel(kernel, format), "") << Name(format);
    }
  }
}

TEST_F(ReportKernels, AreAllThere) {
  int runtime = 0, plain = 0, opencv = 0;
  for (const ResamplingKernel& kernel : kernels_) {
    ++(kernel.family == KernelFamily::kRuntime ? runtime
       : kernel.family == KernelFamily::kPlain ? plain
                                               : opencv);
  }
  EXPECT_EQ(runtime, 3 + 2 * 4);
  EXPECT_EQ(plain, 6 + 2 * 4 + 1);
  EXPECT_EQ(opencv, 3);
}

TEST_F(ReportKernels, ATableAloneHasNoExactWeights) {
  ReportLut table = ShippedWarpLut(folder_ / "");
  table.fit.reset();
  for (const ResamplingKernel& kernel : ResamplingKernels(table, -0.6f))
    EXPECT_FALSE(kernel.slow) << kernel.name;
}

TEST_F(ReportKernels, WarpingByNothingHasNoError) {
  KernelProblem problem;
  problem.image = Image(64, 64, 1);
  for (std::size_t i = 0; i < problem.image.data.size(); ++i) {
    problem.image.data[i] = static_cast<float>(i * 37 % 256) / 255;
  }
  for (auto& trajectory : problem.trajectories) trajectory.assign(kErrorWarps.back(), {});
  for (const ResamplingKernel& kernel : kernels_) {
    if (kernel.slow) continue;
    for (const auto& source : JudgeKernel(kernel, PixelFormat::kRgba8, {problem})) {
      for (const KernelError& error : source) EXPECT_NEAR(error.loss, 0, 1e-5) << kernel.name;
    }
  }
}

}  // namespace
}  // namespace warplut
