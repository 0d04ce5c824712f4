// Frames for the tests of frame generation.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "runtime/executor.h"
#include "runtime/frame_generation.h"
#include "tests/runtime/warp/warp_fixture.h"

namespace warplut::generation {

struct TestFrame {
  TestFrame(int width, int height, PixelFormat format, float far = 0.5f)
      : color(width, height, format),
        depth(width, height, PixelFormat::kR32F, 8),
        motion(width, height, 0, 0, 3) {
    depth.Fill(far);
    color.Fill(0);
  }

  DisplayedFrame view(bool cut = false) const {
    return {color.history(), depth.history(), motion.view(), cut};
  }

  TestImage color;
  TestImage depth;
  TestMotion motion;
};

// Values in [0, 1] become codes.
inline float Code(PixelFormat format, float value) {
  return format == PixelFormat::kRgba8 ? 255 * value : value;
}

// Random colour, rectangles at several depths that move each on its own, a few depths and motion
// vectors that are no numbers.
inline TestFrame RandomFrame(int width, int height, PixelFormat format, unsigned seed,
                             bool wild = true) {
  TestFrame frame(width, height, format);
  std::mt19937 random(seed);
  const auto uniform = [&](float from, float to) {
    return std::uniform_real_distribution<float>(from, to)(random);
  };
  frame.motion = TestMotion(width, height, uniform(-3, 3), uniform(-3, 3), 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 4; ++c) frame.color.Set(x, y, c, Code(format, uniform(0, 1)));
    }
  }
  for (int i = 0; i < 8; ++i) {
    const int x0 = static_cast<int>(uniform(0, static_cast<float>(width)));
    const int y0 = static_cast<int>(uniform(0, static_cast<float>(height)));
    const int x1 = std::min(width, x0 + 1 + static_cast<int>(uniform(0, 20)));
    const int y1 = std::min(height, y0 + 1 + static_cast<int>(uniform(0, 20)));
    const float depth = uniform(0, 0.4f), mx = uniform(-9, 9), my = uniform(-9, 9);
    const float zoom = uniform(-0.3f, 0.3f);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        frame.depth.Set(x, y, 0, depth);
        frame.motion.Set(x, y, mx + zoom * static_cast<float>(x - x0),
                         my + zoom * static_cast<float>(y - y0));
      }
    }
  }
  if (!wild) return frame;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const float odd[] = {kInfinity, -kInfinity, kNan, -1.0f, -0.0f, 1e30f, 3e38f, 0.0f};
  for (int i = 0; i < width * height / 16; ++i) {
    const int x = static_cast<int>(random() % static_cast<unsigned>(width));
    const int y = static_cast<int>(random() % static_cast<unsigned>(height));
    if (i % 2 == 0) {
      frame.depth.Set(x, y, 0, odd[random() % 8]);
    } else {
      frame.motion.Set(x, y, odd[random() % 8], odd[random() % 8]);
    }
    if (format != PixelFormat::kRgba8 && i % 8 == 0) {
      frame.color.Set(x, y, static_cast<int>(random() % 3), odd[random() % 8]);
    }
  }
  return frame;
}

// Options with quadratic motion, which reads single pixels. Tests of the perspective model choose
// theirs.
inline FrameGenerationOptions OptionsFor(const TestFrame& frame) {
  FrameGenerationOptions options;
  options.motion_model = MotionModel::kQuadratic;
  options.width = frame.color.width();
  options.height = frame.color.height();
  return options;
}

inline TestImage Generate(const FrameGenerationOptions& options, const DisplayedFrame& frame0,
                          const DisplayedFrame& frame1, float alpha, bool interpolates,
                          PixelFormat format, Executor& executor) {
  FrameGeneration generation(options, executor);
  TestImage out(options.width, options.height, format, format == PixelFormat::kRgba8 ? 12 : 16);
  std::string why;
  EXPECT_TRUE(generation.IsGenerable(frame0, frame1, alpha, out.view(), &why)) << why;
  if (interpolates) {
    generation.Interpolate(frame0, frame1, alpha, out.view());
  } else {
    generation.Extrapolate(frame0, frame1, alpha, out.view());
  }
  return out;
}

inline TestImage Generate(const FrameGenerationOptions& options, const DisplayedFrame& frame0,
                          const DisplayedFrame& frame1, float alpha, bool interpolates,
                          PixelFormat format) {
  SerialExecutor executor;
  return Generate(options, frame0, frame1, alpha, interpolates, format, executor);
}

}  // namespace warplut::generation
