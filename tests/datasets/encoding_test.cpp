#include "datasets/encoding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/datasets/expect_error.h"

namespace warplut {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Image Row(std::initializer_list<float> values) {
  Image image(static_cast<int>(values.size()), 1, 1);
  image.data = values;
  return image;
}

DepthStream Depth(DepthKind kind, double near, double far) {
  DepthStream stream;
  stream.kind = kind;
  stream.near = near;
  stream.far = far;
  return stream;
}

TEST(Rgba8Base255, CodesOfKnownValues) {
  using Code = std::array<std::uint8_t, 4>;
  EXPECT_EQ(PackRgba8Base255(0), (Code{0, 0, 0, 0}));
  EXPECT_EQ(PackRgba8Base255(1), (Code{255, 0, 0, 0}));
  EXPECT_EQ(PackRgba8Base255(1.0 / 255), (Code{1, 0, 0, 0}));
  EXPECT_EQ(PackRgba8Base255(0.5), (Code{127, 127, 127, 128}));
  EXPECT_DOUBLE_EQ(UnpackRgba8Base255({10, 20, 30, 40}),
                   (10 + (20 + (30 + 40 / 255.0) / 255.0) / 255.0) / 255.0);
}

TEST(Rgba8Base255, PackedValuesComeBackWithinHalfACode) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 10000; ++i) {
    const double v = uniform(random);
    EXPECT_NEAR(UnpackRgba8Base255(PackRgba8Base255(v)), v, 0.5 / std::pow(255, 4) * 1.001);
  }
}

TEST(DecodeDepth, EachKind) {
  const float n = 0.5F, f = 100;
  EXPECT_FLOAT_EQ(DecodeDepth(Row({25}), Depth(DepthKind::kLinear, 0, 100), "").data[0], 0.25F);
  EXPECT_EQ(DecodeDepth(Row({kInfinity}), Depth(DepthKind::kLinear, 0, 100), "").data[0],
            kInfinity);
  const Image forward = DecodeDepth(Row({0, 1, 0.99F}), Depth(DepthKind::kForward, n, f), "");
  EXPECT_FLOAT_EQ(forward.data[0], n / f);
  EXPECT_FLOAT_EQ(forward.data[1], 1);
  EXPECT_NEAR(forward.data[2] * f, n * f / (f - 0.99 * (f - n)), 1e-4);
  const Image reversed = DecodeDepth(Row({1, 0, 0.01F}), Depth(DepthKind::kReversed, n, f), "");
  EXPECT_FLOAT_EQ(reversed.data[0], n / f);
  EXPECT_FLOAT_EQ(reversed.data[1], 1);
  EXPECT_NEAR(reversed.data[2], forward.data[2], 1e-6);
  const Image infinite =
      DecodeDepth(Row({1, 0.5F, 0}),
                  Depth(DepthKind::kReversed, n, std::numeric_limits<double>::infinity()), "");
  EXPECT_FLOAT_EQ(infinite.data[0], 1);
  EXPECT_FLOAT_EQ(infinite.data[1], 2);
  EXPECT_EQ(infinite.data[2], kInfinity);
}

TEST(DecodeDepth, ScaleAndBias) {
  DepthStream stream = Depth(DepthKind::kLinear, 0, 10);
  stream.scale = -4;
  stream.bias = 5;
  EXPECT_FLOAT_EQ(DecodeDepth(Row({0.5F}), stream, "").data[0], 0.3F);
}

TEST(DecodeDepth, RefusesWhatIsNoDepth) {
  const DepthStream linear = Depth(DepthKind::kLinear, 0, 1),
                    forward = Depth(DepthKind::kForward, 1, 2);
  ExpectError(
      [&] {
        DecodeDepth(Row({0, -0.1F}), linear, "a.exr");
      },
      {"a.exr", "pixel (1, 0)", "-0.1", "expected"});
  ExpectError([&] { DecodeDepth(Row({kNan}), linear, "a.exr"); }, {"a.exr", "nan"});
  ExpectError([&] { DecodeDepth(Row({-kInfinity}), linear, "a.exr"); }, {"-inf"});
  ExpectError([&] { DecodeDepth(Row({1.01F}), forward, "a.exr"); }, {"1.01", "0 to 1"});
  ExpectError([&] { DecodeDepth(Row({kInfinity}), forward, "a.exr"); }, {"inf", "0 to 1"});
  EXPECT_FLOAT_EQ(DecodeDepth(Row({1.003F}), forward, "").data[0], 1);
}

TEST(EncodeDepth, IsTheInverseOfDecodeDepth) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.02F, 1);
  Image depth(50, 20, 1);
  for (float& d : depth.data) d = uniform(random);
  for (const DepthKind kind : {DepthKind::kLinear, DepthKind::kForward, DepthKind::kReversed}) {
    for (const Encoding encoding : {Encoding::kFloat, Encoding::kRgba8Base255}) {
      DepthStream stream = Depth(kind, 0.5, 30);
      stream.encoding = encoding;
      if (kind == DepthKind::kLinear) stream.scale = 30;
      const Image back = DecodeDepth(EncodeDepth(depth, stream, ""), stream, "");
      for (std::size_t i = 0; i < depth.data.size(); ++i) {
        // A float z near 1 of a hyperbolic kind resolves depth to 2^-24 far / near.
        ASSERT_NEAR(back.data[i], depth.data[i], 4e-6) << static_cast<int>(kind);
      }
    }
  }
}

TEST(EncodeDepth, BackgroundAndNearAreHeldWhereTheEncodingEnds) {
  const double infinity = std::numeric_limits<double>::infinity();
  DepthStream packed = Depth(DepthKind::kLinear, 0, 1);
  packed.encoding = Encoding::kRgba8Base255;
  const auto back = [](float d, const DepthStream& s) {
    return DecodeDepth(EncodeDepth(Row({d}), s, ""), s, "").data[0];
  };
  EXPECT_EQ(back(kInfinity, packed), 1);
  EXPECT_EQ(back(kInfinity, Depth(DepthKind::kLinear, 0, 1)), kInfinity);
  for (const DepthKind kind : {DepthKind::kForward, DepthKind::kReversed}) {
    EXPECT_FLOAT_EQ(back(kInfinity, Depth(kind, 1, 4)), 1);
    EXPECT_FLOAT_EQ(back(0, Depth(kind, 1, 4)), 0.25F);
  }
  EXPECT_EQ(back(kInfinity, Depth(DepthKind::kReversed, 1, infinity)), kInfinity);
  EXPECT_EQ(back(8, Depth(DepthKind::kReversed, 1, infinity)), 8);
  ExpectError([&] { EncodeDepth(Row({kNan}), packed, "a"); }, {"nan"});
  packed.bias = 0.5;
  ExpectError([&] { EncodeDepth(Row({0.4F}), packed, "a.png"); }, {"a.png", "code from 0 to 1"});
}

float Motion(float stored, int component, const MotionStream& stream) {
  Image image(20, 10, 1), motion(20, 10, 2);
  image.data.assign(image.data.size(), stored);
  DecodeMotion(image, stream, component, "", &motion);
  return motion.at(3, 4, component);
}

TEST(DecodeMotion, UnitsDirectionAndAxis) {
  MotionStream stream;
  EXPECT_EQ(Motion(2, 0, stream), 2);
  EXPECT_EQ(Motion(2, 1, stream), 2);
  stream.units = MotionUnits::kUv;
  EXPECT_EQ(Motion(0.5F, 0, stream), 10);
  EXPECT_EQ(Motion(0.5F, 1, stream), 5);
  stream.units = MotionUnits::kNdc;
  EXPECT_EQ(Motion(0.5F, 0, stream), 5);
  EXPECT_EQ(Motion(0.5F, 1, stream), 2.5F);
  stream.y = YAxis::kUp;
  EXPECT_EQ(Motion(0.5F, 0, stream), 5);
  EXPECT_EQ(Motion(0.5F, 1, stream), -2.5F);
  stream.direction = MotionDirection::kCurrentToPrevious;
  EXPECT_EQ(Motion(0.5F, 0, stream), -5);
  EXPECT_EQ(Motion(0.5F, 1, stream), 2.5F);
  stream.scale = {2, 4};
  stream.bias = {-1, 1};
  EXPECT_EQ(Motion(0.75F, 0, stream), -5);
  EXPECT_EQ(Motion(0.75F, 1, stream), 20);
}

TEST(DecodeMotion, RefusesWhatIsNotFinite) {
  ExpectError([] { Motion(kNan, 0, {}); }, {"pixel (0, 0)", "nan", "finite motion"});
  ExpectError([] { Motion(kInfinity, 1, {}); }, {"inf"});
}

TEST(EncodeMotion, IsTheInverseOfDecodeMotion) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-9, 9);
  Image motion(20, 10, 2);
  for (float& m : motion.data) m = uniform(random);
  for (const Encoding encoding : {Encoding::kFloat, Encoding::kRgba8Base255}) {
    for (const MotionUnits units : {MotionUnits::kPixels, MotionUnits::kUv, MotionUnits::kNdc}) {
      MotionStream stream;
      stream.encoding = encoding;
      stream.units = units;
      stream.y = YAxis::kUp;
      stream.direction = MotionDirection::kCurrentToPrevious;
      if (encoding != Encoding::kFloat) {
        stream.scale = {40, -40};
        stream.bias = {-20, 20};
      }
      Image back(20, 10, 2);
      for (int c = 0; c < 2; ++c)
        DecodeMotion(EncodeMotion(motion, stream, c, ""), stream, c, "", &back);
      for (std::size_t i = 0; i < motion.data.size(); ++i)
        ASSERT_NEAR(back.data[i], motion.data[i], 1e-6);
    }
  }
  MotionStream packed;
  packed.encoding = Encoding::kRgba8Base255;
  ExpectError([&] { EncodeMotion(motion, packed, 0, "x.png"); }, {"x.png", "code from 0 to 1"});
}

}  // namespace
}  // namespace warplut
