// A device for tests, which tells of wrong calls where it can (the validation layers of Vulkan, a
// debug context of OpenGL ES); and how far GPU frames may be from those of the processor.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "runtime/gpu/gpu_super_resolution.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {

// How far a GPU frame may be from the processor's, in display values or codes. One bound for every
// pass, filter, size and input.
//
// 32-bit: sums are added in another order and multiplied without fusing, and the processor's fast
// passes have rounding of their own: some 2^-20 a frame, which the history hands on. `rare` is the
// share of channels that may exceed `worst`: gates, roundings to the nearest sample and the choice
// of a surface in frame 0 are steps, and where an input lies on one within rounding, the two may
// fall on different sides.
// 16-bit: each pass rounds what it stores to halves, units of 2^-11 near 1; the GPU stores the
// coefficients between the axes, the boxes and the residuals too, the processor only the history.
struct GpuBound {
  double mean, worst, rare;
};
inline constexpr GpuBound kGpuBound32{2e-6, 1e-4, 1e-3};
inline constexpr GpuBound kGpuBound16{1.5e-3, 1.2e-2, 2e-3};

// Filtered motion, in pixels: the camera is fitted in 32 bits in place of 64. `rare` is the share
// of components on the limit, which one replaces and the other keeps.
inline constexpr GpuBound kGpuMotionBound{2e-6, 2e-5, 1e-3};

// Each API has its own program of the same tests.
inline constexpr GpuApi kTestedApi = GpuApi::TESTED_API;

class GpuTest : public testing::Test {
 protected:
  // One device for all tests of the program: drivers start slowly.
  static void SetUpTestSuite() {
    if (device_ != nullptr || !reason_.empty()) return;
    for (const bool validate : {true, false}) {
      try {
        device_ = OpenGpuDevice(kTestedApi, {.validate = validate});
        return;
      } catch (const GpuError& error) {
        reason_ = error.what();
      }
    }
  }

  void SetUp() override {
    if (device_ == nullptr) GTEST_SKIP() << reason_;
  }

  void TearDown() override {
    if (device_ == nullptr) return;
    for (std::size_t i = seen_; i < device_->messages().size(); ++i)
      ADD_FAILURE() << "the device tells: " << device_->messages()[i];
    seen_ = device_->messages().size();
  }

  // For a test that makes wrong calls.
  static void ForgetMessages() { seen_ = device_->messages().size(); }

  static const GpuDevice& device() { return *device_; }

 private:
  static inline std::unique_ptr<GpuDevice> device_;
  static inline std::string reason_;
  static inline std::size_t seen_ = 0;
};

struct ImageDifference {
  double mean = 0, worst = 0;
  double rare = 0;  // share of channels that differ by more than a bound
};

// Over the colour channels of two RGBA32F images.
inline ImageDifference Difference(const ImageBuffer& a, const ImageBuffer& b, double bound) {
  const ImageView image = a.view();
  ImageDifference difference;
  double sum = 0, beyond = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double d = std::abs(static_cast<double>(At(a, x, y, c)) - At(b, x, y, c));
        EXPECT_FALSE(std::isnan(d));
        sum += d;
        beyond += d > bound ? 1 : 0;
        difference.worst = std::max(difference.worst, d);
      }
    }
  }
  const double count = 3.0 * image.width * image.height;
  difference.mean = sum / count;
  difference.rare = beyond / count;
  return difference;
}

inline void ExpectClose(const ImageBuffer& gpu, const ImageBuffer& cpu, const GpuBound& bound,
                        const std::string& what) {
  const ImageDifference difference = Difference(gpu, cpu, bound.worst);
  EXPECT_LE(difference.mean, bound.mean) << what;
  EXPECT_LE(difference.rare, bound.rare) << what << ", worst " << difference.worst;
}

}  // namespace warplut
