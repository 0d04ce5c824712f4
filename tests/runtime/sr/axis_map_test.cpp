#include "runtime/sr/axis_map.h"

#include <gtest/gtest.h>

namespace warplut {
namespace {

struct Sizes {
  int render, output;
};
constexpr Sizes kSizes[] = {{1, 1}, {1, 4}, {3, 4}, {5, 5}, {7, 12}, {20, 34}, {33, 66}, {10, 40}};
constexpr float kJitters[] = {-1.0f, -0.5f, -0.3f, 0.0f, 0.25f, 0.5f, 1.0f};

template <class Check>
void ForEachMap(const Check& check) {
  for (const Sizes& size : kSizes) {
    for (const float jitter : kJitters) {
      SCOPED_TRACE(testing::Message() << size.render << " to " << size.output << ", " << jitter);
      AxisMap map(size.render, size.output);
      map.SetJitter(jitter);
      check(map, static_cast<double>(size.output) / size.render, jitter);
    }
  }
}

TEST(AxisMap, NearestAndOffsetGiveThePositionAmongTheSamples) {
  ForEachMap([](const AxisMap& map, double scale, double jitter) {
    for (int x = 0; x < map.output(); ++x) {
      ASSERT_GE(map.nearest()[x], 0);
      ASSERT_LT(map.nearest()[x], map.render());
      EXPECT_NEAR(map.nearest()[x] + map.offset()[x], (x + 0.5) / scale - 0.5 - jitter, 1e-5);
    }
  });
}

TEST(AxisMap, CellAndFractionAreThePositionLimitedToTheSamples) {
  ForEachMap([](const AxisMap& map, double scale, double jitter) {
    for (int x = 0; x < map.output(); ++x) {
      const double u = (x + 0.5) / scale - 0.5 - jitter;
      EXPECT_NEAR(map.cell()[x] + map.fraction()[x], std::clamp(u, 0.0, map.render() - 1.0), 1e-5);
      EXPECT_GE(map.fraction()[x], 0.0f);
      EXPECT_LT(map.fraction()[x], 1.0f + 1e-6f);
    }
  });
}

TEST(AxisMap, TexelAndShareAreThePositionOfTheSampleInTheOutput) {
  ForEachMap([](const AxisMap& map, double scale, double jitter) {
    for (int i = 0; i < map.render(); ++i) {
      const double v = (i + 0.5 + jitter) * scale - 0.5;
      EXPECT_NEAR(map.texel()[i] + map.share()[i], std::clamp(v, 0.0, map.output() - 1.0), 1e-4);
      EXPECT_GE(map.texel()[i], 0);
      EXPECT_LE(map.texel()[i], std::max(0, map.output() - 2));
    }
  });
}

TEST(AxisMap, ASampleLiesWhereTheOutputPixelThereSaysItDoes) {
  AxisMap map(8, 16);
  map.SetJitter(0.25f);  // sample i at output position 2 i + 1
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(map.texel()[i], 2 * i + 1);
    EXPECT_EQ(map.share()[i], 0.0f);
    EXPECT_EQ(map.nearest()[2 * i + 1], i);
    EXPECT_EQ(map.offset()[2 * i + 1], 0.0f);
  }
}

}  // namespace
}  // namespace warplut
