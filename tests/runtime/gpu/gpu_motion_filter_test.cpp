// The motion filter on a GPU against the processor's reference: odd sizes, broken input, inputs as
// renderers have them.
#include "runtime/gpu/gpu_motion_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "luts/half.h"
#include "runtime/gpu/image_transfer.h"
#include "runtime/motion_filter.h"
#include "tests/runtime/gpu/gpu_fixture.h"
#include "tests/runtime/motion/camera_frame.h"

namespace warplut {
namespace {

class GpuMotionFilter : public GpuTest {
 protected:
  static MotionBuffer Filtered(const CameraFrame& frame, float limit = kMotionFilterLimit,
                               const InputConventions& conventions = {}) {
    const std::unique_ptr<GpuWorkspace> gpu = device().MakeWorkspace(PixelFormat::kRgba32F);
    const MotionFilterPasses::Images images = {
        gpu->AddImage({TexelFormat::kR32F, frame.width, frame.height}),
        gpu->AddImage({conventions.motion_format, frame.width, frame.height}),
        gpu->AddImage({kFilteredMotionFormat, frame.width, frame.height})};
    const int depth = gpu->AddBufferOf(images.depth), motion = gpu->AddBufferOf(images.motion);
    const int filtered = gpu->AddBufferOf(images.filtered), camera = AddCameraBuffer(*gpu);
    gpu->Allocate();
    const MotionFilterPasses passes(limit, conventions, camera, {images}, *gpu);
    PackDepth(frame.depth.view(), gpu->BytesOf(depth));
    PackMotion(frame.motion.view(), conventions.motion_format, gpu->BytesOf(motion));
    gpu->Run([&] {
      gpu->CopyToImage(depth, images.depth);
      gpu->CopyToImage(motion, images.motion);
      passes.Record(0, frame.width, frame.height, *gpu);
      gpu->CopyToBuffer(images.filtered, filtered);
    });
    MotionBuffer out(frame.width, frame.height);
    UnpackMotion(gpu->BytesOf(filtered), out.view());
    return out;
  }

  static MotionBuffer Reference(const CameraFrame& frame, float limit = kMotionFilterLimit) {
    MotionBuffer out(frame.width, frame.height);
    MotionFilter::Reference(frame.depth.view(), frame.motion.view(), {limit}, out.view());
    return out;
  }

  // What is not finite in one is not finite in the other; the rest within kGpuMotionBound.
  static void ExpectClose(const MotionBuffer& gpu, const MotionBuffer& cpu,
                          const std::string& what) {
    const MotionView found = gpu.view(), expected = cpu.view();
    double sum = 0, worst = 0;
    int beyond = 0, count = 0;
    for (int y = 0; y < found.height; ++y) {
      for (int i = 0; i < 2 * found.width; ++i) {
        const float a = found.Row(y)[i], b = expected.Row(y)[i];
        ASSERT_EQ(std::isfinite(a), std::isfinite(b)) << what;
        if (!std::isfinite(a)) continue;
        const double d = std::abs(static_cast<double>(a) - b);
        sum += d;
        worst = std::max(worst, d);
        beyond += d > kGpuMotionBound.worst ? 1 : 0;
        ++count;
      }
    }
    EXPECT_LE(sum, kGpuMotionBound.mean * count) << what;
    EXPECT_LE(beyond, kGpuMotionBound.rare * count) << what << ", worst " << worst;
  }
};

constexpr int kSizes[][2] = {{1, 1},   {3, 5},   {1, 40},   {40, 1},   {17, 5},
                             {33, 31}, {80, 60}, {321, 97}, {641, 359}};

TEST_F(GpuMotionFilter, AgreesAtAnySize) {
  for (const auto& [width, height] : kSizes) {
    for (const float step : {1 / 64.0f, 0.5f}) {
      CameraFrame frame = CameraFrame::UnderCamera(width, height);
      frame.Quantise(step);
      ExpectClose(Filtered(frame), Reference(frame),
                  std::to_string(width) + " x " + std::to_string(height) + " in steps of " +
                      std::to_string(step));
    }
  }
}

TEST_F(GpuMotionFilter, ExactMotionStays) {
  const CameraFrame frame = CameraFrame::UnderCamera(641, 359);
  ExpectClose(Filtered(frame), frame.truth, "exact");
}

// Motion that no camera explains, and limits below its noise.
TEST_F(GpuMotionFilter, NoiseAgrees) {
  CameraFrame frame = CameraFrame::UnderCamera(160, 90);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-3, 3);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) frame.Set(x, y, noise(random), noise(random));
  }
  for (const float limit : {0.125f, 4.0f})
    ExpectClose(Filtered(frame, limit), Reference(frame, limit), "noise");
}

TEST_F(GpuMotionFilter, BrokenInputAgrees) {
  for (const auto& [width, height] : kSizes) {
    CameraFrame frame = CameraFrame::UnderCamera(width, height);
    frame.Quantise(0.5f);
    const float depths[] = {kNaN, kInfinity, -1.0f, 0.0f, -0.0f, 1e-30f, 2e30f};
    const float motions[] = {kNaN, kInfinity, -kInfinity};
    for (int i = 0; i < width * height; i += 5) {
      const int x = i % width, y = i / width;
      frame.Depth(x, y) = depths[i % 7];
      if (i % 2 == 0) frame.Set(x, y, motions[i % 3], i % 4 == 0 ? 2.0f : kNaN);
    }
    ExpectClose(Filtered(frame), Reference(frame),
                "broken, " + std::to_string(width) + " x " + std::to_string(height));
  }
}

TEST_F(GpuMotionFilter, MovingObjectsStayToTheBit) {
  CameraFrame frame = CameraFrame::UnderCamera(320, 180);
  frame.Quantise(0.5f);
  for (int y = 30; y < 130; ++y) {
    for (int x = 60; x < 260; ++x) frame.Set(x, y, 20.5f, -7.0f);
  }
  const MotionBuffer found = Filtered(frame);
  for (int y = 30; y < 130; ++y) {
    for (int x = 60; x < 260; ++x) {
      EXPECT_EQ(found.view().Row(y)[2 * x], 20.5f);
      EXPECT_EQ(found.view().Row(y)[2 * x + 1], -7.0f);
    }
  }
  ExpectClose(found, Reference(frame), "an object");
}

// Motion in RG16F as NDC to the frame before, y up, and a reversed depth buffer.
TEST_F(GpuMotionFilter, ConventionsAreConverted) {
  CameraFrame frame = CameraFrame::UnderCamera(160, 90), stored(160, 90);
  InputConventions conventions = InputConventions::DepthBuffer(0.1f, 100.0f, true);
  conventions.motion_format = TexelFormat::kRg16F;
  conventions.motion_scale_x = -frame.width / 2.0f;
  conventions.motion_scale_y = frame.height / 2.0f;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const float* m = std::as_const(frame.motion).view().Row(y) + 2 * x;
      const float ndc_x = HalfToFloat(FloatToHalf(m[0] / conventions.motion_scale_x));
      const float ndc_y = HalfToFloat(FloatToHalf(m[1] / conventions.motion_scale_y));
      stored.Set(x, y, ndc_x, ndc_y);
      frame.Set(x, y, ndc_x * conventions.motion_scale_x, ndc_y * conventions.motion_scale_y);
      // The background is at the far plane, whose depth is 0.
      const double view = std::min(1.0, static_cast<double>(frame.Depth(x, y))) * 100;
      const auto z = static_cast<float>(0.1 * (100 - view) / (view * (100 - 0.1)));
      stored.Depth(x, y) = z;
      frame.Depth(x, y) = 1 / (conventions.depth_a + conventions.depth_b * z);
    }
  }
  ExpectClose(Filtered(stored, kMotionFilterLimit, conventions), Reference(frame), "converted");
}

}  // namespace
}  // namespace warplut
