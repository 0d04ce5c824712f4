// Temporally dense rendering: fast against plain, and what it promises of its pixels.
#include "runtime/dense_rendering.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "runtime/image_buffer.h"
#include "tests/runtime/counted_allocations.h"

namespace warplut {
namespace {

constexpr int kWidth = 38, kHeight = 22;

DenseOptions Options(int width = kWidth, int height = kHeight) {
  DenseOptions options;
  options.width = width;
  options.height = height;
  return options;
}

struct Sampled {
  std::array<float, 3> color;
  float mx, my;
};
// What the world shows at a position of the displayed frame, in pixels.
using World = std::function<Sampled(float x, float y)>;

class Player {
 public:
  explicit Player(const DenseOptions& options, PixelFormat format = PixelFormat::kRgba32F)
      : options_(options),
        dense_(options, executor_),
        color_(options.width / 2, options.height / 2, format),
        motion_(options.width / 2, options.height / 2),
        out_(options.width, options.height, PixelFormat::kRgba32F) {}

  void Play(const World& world, bool cut = false) {
    for (int y = 0; y < options_.height / 2; ++y) {
      for (int x = 0; x < options_.width / 2; ++x) {
        const DenseSample at = dense_.Next(x, y);
        const Sampled sample =
            world(static_cast<float>(at.x) + 0.5f + at.dx, static_cast<float>(at.y) + 0.5f + at.dy);
        auto* pixel = static_cast<float*>(color_.view().At(x, y));
        std::copy(sample.color.begin(), sample.color.end(), pixel);
        motion_.view().Row(y)[2 * x] = sample.mx;
        motion_.view().Row(y)[2 * x + 1] = sample.my;
      }
    }
    const Subframe subframe = {std::as_const(color_).view(), std::as_const(motion_).view(), cut};
    std::string why;
    ASSERT_TRUE(dense_.IsProcessable(subframe, out_.view(), &why)) << why;
    dense_.Process(subframe, out_.view());
  }
  float At(int x, int y, int c = 0) const { return out_.view().Row<float>(y)[4 * x + c]; }
  DenseRendering& dense() { return dense_; }
  bool Shows(const Player& other) const {
    for (int y = 0; y < options_.height; ++y) {
      const auto* a = out_.view().Row<float>(y);
      const auto* b = other.out_.view().Row<float>(y);
      if (std::memcmp(a, b, sizeof(float) * 4 * static_cast<std::size_t>(options_.width)) != 0) {
        return false;
      }
    }
    return true;
  }

 private:
  DenseOptions options_;
  SerialExecutor executor_;
  DenseRendering dense_;
  ImageBuffer color_;
  MotionBuffer motion_;
  ImageBuffer out_;
};

// Colours and motion without order; part of it stands still, some of it is broken.
World Noise(unsigned seed) {
  return [random = std::mt19937(seed)](float x, float y) mutable {
    std::uniform_real_distribution<float> unit(0, 1);
    const bool still = x < kWidth / 2.0f && y > kHeight / 3.0f;
    Sampled s = {{unit(random), unit(random), unit(random)},
                 still ? 0 : 6 * unit(random) - 3,
                 still ? 0 : 6 * unit(random) - 3};
    if (unit(random) < 0.02f) s.mx = std::numeric_limits<float>::infinity();
    if (unit(random) < 0.02f) s.color[1] = std::numeric_limits<float>::quiet_NaN();
    return s;
  };
}

TEST(DenseRendering, FastEqualsPlain) {
  for (const OrderRule rule : kOrderRules) {
    for (const auto& [width, height, radius] : {std::array{kWidth, kHeight, 1}, std::array{2, 2, 3},
                                                std::array{4, 34, 0}, std::array{36, 2, 2}}) {
      DenseOptions options = Options(width, height);
      options.order = rule;
      options.motion_radius = radius;
      Player fast(options);
      options.reference = true;
      Player plain(options);
      for (unsigned i = 0; i < 11; ++i) {
        fast.Play(Noise(i), i == 6);
        plain.Play(Noise(i), i == 6);
        ASSERT_TRUE(fast.Shows(plain))
            << Name(rule) << ", " << width << " x " << height << ", " << i;
      }
    }
  }
}

TEST(DenseRendering, ACycleHasEveryPixelOnceInItsOrder) {
  for (const OrderRule rule : {OrderRule::kHourglass, OrderRule::kBowtie, OrderRule::kMixed}) {
    DenseOptions options = Options();
    options.order = rule;
    Player player(options);
    for (int cycle = 0; cycle < 3; ++cycle) {
      std::set<std::pair<int, int>> pixels;
      for (int place = 0; place < kSubframesPerCycle; ++place) {
        for (int y = 0; y < kHeight / 2; ++y) {
          for (int x = 0; x < kWidth / 2; ++x) {
            const DenseSample at = player.dense().Next(x, y);
            pixels.insert({at.x, at.y});
            const int i = at.x % 2 + 2 * (at.y % 2);
            ASSERT_EQ(PlaceInOrder(player.dense().Order(x, y), i), place);
            ASSERT_EQ(at.x / 2, x);
            ASSERT_EQ(at.y / 2, y);
          }
        }
        player.Play(Noise(7));
      }
      ASSERT_EQ(pixels.size(), std::size_t{kWidth} * kHeight);
    }
  }
}

TEST(DenseRendering, AConstantWorldStays) {
  for (const float motion : {0.0f, 0.7f}) {
    Player player(Options());
    for (int i = 0; i < 9; ++i) {
      player.Play([&](float, float) { return Sampled{{0.25f, 0.5f, 1}, motion, -motion}; });
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) ASSERT_NEAR(player.At(x, y, 1), 0.5f, 1e-6f) << i;
      }
    }
  }
}

// 0 left of the edge and 1 right of it, at rest.
TEST(DenseRendering, StaticPixelsShowTheMeanOfFourSamples) {
  constexpr float kEdge = 11.6f;  // two of the four offsets of the pixel lie right of it
  const World world = [](float x, float) {
    const float value = x > kEdge ? 1 : 0;
    return Sampled{{value, value, value}, 0, 0};
  };
  Player player(Options());
  for (int i = 0; i < 5 * kSubframesPerCycle; ++i) player.Play(world);
  for (int i = 0; i < 5; ++i) {
    for (int y = 0; y < kHeight; ++y) {
      EXPECT_EQ(player.At(10, y), 0);
      EXPECT_EQ(player.At(11, y), 0.5f);
      EXPECT_EQ(player.At(12, y), 1);
    }
    player.Play(world);
  }
}

TEST(DenseRendering, PixelsInMotionAreSampledAtTheirCentresAndNewOnesShownAsTheyAre) {
  Player player(Options());
  for (int i = 0; i < 2 * kSubframesPerCycle; ++i) {
    const DenseSample at = player.dense().Next(5, 4);
    EXPECT_EQ(at.dx, 0);
    EXPECT_EQ(at.dy, 0);
    player.Play([](float x, float y) { return Sampled{{x / kWidth, y / kHeight, 0}, 1, 0}; });
    EXPECT_FLOAT_EQ(player.At(at.x, at.y, 0), (static_cast<float>(at.x) + 0.5f) / kWidth);
    EXPECT_FLOAT_EQ(player.At(at.x, at.y, 1), (static_cast<float>(at.y) + 0.5f) / kHeight);
  }
}

// A ramp that moves by two pixels each subframe lies on whole pixels before: reprojection is exact.
TEST(DenseRendering, OldPixelsFollowTheMotion) {
  DenseOptions options = Options();
  options.parameters.gamma = 16;
  Player player(options);
  float shift = 0;
  const World ramp = [&](float x, float) {
    const float value = 0.5f + (x - shift) / 200;
    return Sampled{{value, value, value}, 2, 0};
  };
  for (int i = 0; i < 8; ++i, shift += 2) player.Play(ramp);
  shift -= 2;
  for (int x = 18; x < kWidth; ++x) {
    EXPECT_NEAR(player.At(x, 9), ramp(static_cast<float>(x) + 0.5f, 0).color[0], 1e-5f) << x;
  }
}

TEST(DenseRendering, ACutAndAResetForgetWhatWasShown) {
  const World dark = [](float, float) { return Sampled{{0, 0, 0}, 0, 0}; };
  const World bright = [](float, float) { return Sampled{{1, 1, 1}, 0, 0}; };
  Player cut(Options()), reset(Options());
  for (int i = 0; i < 6; ++i) cut.Play(dark);
  for (int i = 0; i < 6; ++i) reset.Play(dark);
  cut.Play(bright, true);
  reset.dense().Reset();
  reset.Play(bright);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(cut.At(x, y), 1);
      ASSERT_EQ(reset.At(x, y), 1);
    }
  }
}

TEST(DenseRendering, AnyExecutorGivesTheSameBitsAndProcessAllocatesNothing) {
  const DenseOptions options = Options(64, 96);
  SerialExecutor serial;
  ThreadPool pool(3);
  DenseRendering one(options, serial), many(options, pool);
  ImageBuffer color(32, 48, PixelFormat::kRgba16F);
  MotionBuffer motion(32, 48);
  ImageBuffer a(64, 96, PixelFormat::kRgba8), b(64, 96, PixelFormat::kRgba8);
  std::mt19937 random(3);
  for (int i = 0; i < 9; ++i) {
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 32 * 4; ++x) {
        color.view().Row<std::uint16_t>(y)[x] = static_cast<std::uint16_t>(random() % 0x3C00);
      }
      for (int x = 0; x < 32 * 2; ++x) {
        motion.view().Row(y)[x] = static_cast<float>(random() % 100) / 25 - 2;
      }
    }
    const Subframe subframe = {std::as_const(color).view(), std::as_const(motion).view()};
    const int before = CountedAllocations();
    one.Process(subframe, a.view());
    EXPECT_EQ(CountedAllocations(), before);
    many.Process(subframe, b.view());
    for (int y = 0; y < 96; ++y) {
      ASSERT_EQ(std::memcmp(a.view().At(0, y), b.view().At(0, y), 64 * 4), 0) << i;
    }
  }
}

TEST(DenseOptions, EachFieldIsChecked) {
  std::string why;
  EXPECT_TRUE(Options().IsValid(&why)) << why;
  const auto expect_refused = [&](auto change, const char* piece) {
    DenseOptions options = Options();
    change(options);
    EXPECT_FALSE(options.IsValid(&why));
    EXPECT_FALSE(options.IsValid());
    EXPECT_NE(why.find(piece), std::string::npos) << why;
  };
  expect_refused([](auto& o) { o.width = 3; }, "3 x 22");
  expect_refused([](auto& o) { o.height = 0; }, "38 x 0");
  expect_refused([](auto& o) { o.motion_radius = 4; }, "radius is 4");
  expect_refused([](auto& o) { o.window = 0; }, "window is 0");
  expect_refused([](auto& o) { o.window = 5; }, "window is 5");
  for (const DenseParameterInfo& info : kDenseParameters) {
    expect_refused([&](auto& o) { o.parameters.*info.member = std::nextafter(info.max, 100.0f); },
                   info.name);
  }
}

}  // namespace
}  // namespace warplut
