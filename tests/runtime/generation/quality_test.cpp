// What is generated of a scene whose frames between are known.
#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

constexpr int kWidth = 160, kHeight = 96;

// A textured background and, before it, a disc; each moves with its own speed and acceleration.
struct Layer {
  double speed_x, speed_y, acceleration_x, acceleration_y;

  double X(double time) const { return speed_x * time + 0.5 * acceleration_x * time * time; }
  double Y(double time) const { return speed_y * time + 0.5 * acceleration_y * time * time; }
};
constexpr Layer kBackground = {3.3, -1.2, 1.5, 0.6};
constexpr Layer kDisc = {-6.5, 2.0, 2.5, -1.0};

bool InDisc(double x, double y, double time) {
  const double dx = x - 80 - kDisc.X(time), dy = y - 48 - kDisc.Y(time);
  return dx * dx + dy * dy < 20 * 20;
}

double Texture(double u, double v, int c) {
  return 0.5 + 0.2 * std::sin(0.35 * u + 0.2 * v + c) + 0.2 * std::sin(0.27 * v - 0.31 * u + 2 * c);
}

TestFrame FrameAt(double time) {
  TestFrame frame(kWidth, kHeight, PixelFormat::kRgba8);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool disc = InDisc(x, y, time);
      const Layer& layer = disc ? kDisc : kBackground;
      for (int c = 0; c < 3; ++c) {
        const double value = Texture(x - layer.X(time) + (disc ? 500 : 0), y - layer.Y(time), c);
        frame.color.Set(x, y, c, static_cast<float>(255 * value));
      }
      frame.depth.Set(x, y, 0, disc ? 0.1f : 0.6f);
      frame.motion.Set(x, y, static_cast<float>(layer.X(time) - layer.X(time - 1)),
                       static_cast<float>(layer.Y(time) - layer.Y(time - 1)));
    }
  }
  return frame;
}

// Mean squared difference in code values, off the borders.
double Error(const TestImage& a, const TestImage& b) {
  double sum = 0;
  int count = 0;
  for (int y = 8; y < kHeight - 8; ++y) {
    for (int x = 8; x < kWidth - 8; ++x) {
      for (int c = 0; c < 3; ++c, ++count) sum += std::pow(a.Get(x, y, c) - b.Get(x, y, c), 2);
    }
  }
  return sum / count;
}

TEST(Quality, BeatsLinearMotionAndRepetition) {
  const TestFrame frame0 = FrameAt(0), frame1 = FrameAt(1);
  const FrameGenerationOptions options = OptionsFor(frame0);
  FrameGenerationOptions linear = options;
  linear.motion_model = MotionModel::kLinear;
  for (const double alpha : {0.25, 0.5, 0.75}) {
    for (const bool interpolates : {true, false}) {
      const TestFrame truth = FrameAt(interpolates ? alpha : 1 + alpha);
      const auto error = [&](const FrameGenerationOptions& o) {
        return Error(Generate(o, frame0.view(), frame1.view(), static_cast<float>(alpha),
                              interpolates, PixelFormat::kRgba8),
                     truth.color);
      };
      const double own = error(options);
      EXPECT_LT(own, 0.85 * error(linear)) << alpha;
      const TestFrame& nearer = interpolates && alpha < 0.5 ? frame0 : frame1;
      EXPECT_LT(own, 0.3 * Error(nearer.color, truth.color)) << alpha;
    }
  }
}

}  // namespace
}  // namespace warplut::generation
