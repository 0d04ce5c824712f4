// The scores of rays, in a world of which everything is known: a floor before a wall.
#include <gtest/gtest.h>

#include <cmath>

#include "tools/reflections/reflection_job.h"

namespace warplut {
namespace {

constexpr int kWidth = 96, kHeight = 64;
constexpr peers::Pinhole kPinhole = {80, 80, 48, 32};
constexpr double kFloor = 1, kWall = 8;  // below the camera, before it

struct Hall {
  std::vector<float> depth;

  Hall() {
    for (int y = 0; y < kHeight; ++y) {
      const double down = (y + 0.5 - kPinhole.cy) / kPinhole.fy;
      const double z = down * kWall > kFloor ? kFloor / down : kWall;
      depth.insert(depth.end(), kWidth, static_cast<float>(z));
    }
  }
  ImageView view() const {
    return {depth.data(), kWidth, kHeight, sizeof(float) * kWidth, PixelFormat::kR32F};
  }
};

// Rays from the floor that meet the wall, away from the edge between them: the mesh cuts it off.
std::vector<SceneReflection> OfFloor() {
  std::vector<SceneReflection> reflections(1);  // sky
  for (int y = 53; y < kHeight; y += 4) {
    for (int x = 8; x < kWidth - 8; x += 8) {
      const double z = kFloor / ((y + 0.5 - kPinhole.cy) / kPinhole.fy);
      SceneReflection r;
      r.is_surface = r.is_hit = true;
      const double across = (x + 0.5 - kPinhole.cx) / kPinhole.fx;
      r.origin = {across * z, kFloor - z / kPinhole.fx, z};
      r.direction = {across, -kFloor / z, 1};
      const double s = kWall - z, top = r.origin[1] + s * r.direction[1];
      r.position = {kPinhole.cx + kPinhole.fx * (r.origin[0] + s * across) / kWall,
                    kPinhole.cy + kPinhole.fy * top / kWall};
      r.is_visible = r.position.y > 0;
      reflections.push_back(r);
    }
  }
  return reflections;
}

ReflectionSettings Exact() {
  ReflectionSettings settings;
  settings.within = 1;
  settings.tiles = {8};
  settings.thicknesses = {0.1};
  return settings;
}

TEST(ReflectionScores, AllIsFoundWhereAllIsPlane) {
  const Hall hall;
  const ReflectionReport report =
      ScoreReflections("hall", hall.view(), kPinhole, OfFloor(), Exact());
  EXPECT_EQ(report.rays, 30);
  EXPECT_GT(report.findable, 0.5);
  ASSERT_EQ(report.methods.size(), 3U);
  for (const ReflectionScores& scores : report.methods) {
    EXPECT_EQ(scores.found, 1) << scores.method;
    EXPECT_EQ(scores.misplaced, 0);
    EXPECT_GE(scores.cells, 1);
    EXPECT_EQ(scores.triangles > 0, scores.method == "mesh 8");
  }
}

TEST(ReflectionScores, EachHitCountsOnce) {
  const Hall hall;
  std::vector<SceneReflection> reflections = OfFloor();
  int moved = 0, hidden = 0, all = 0;
  for (SceneReflection& r : reflections) {
    if (!r.is_visible) continue;
    ++all;
    if (all % 3 == 0) r.position.x += 5, ++moved;
    if (all % 3 == 1) r.is_visible = false, ++hidden;
  }
  for (const ReflectionScores& scores :
       ScoreReflections("hall", hall.view(), kPinhole, reflections, Exact()).methods) {
    EXPECT_DOUBLE_EQ(scores.misplaced, static_cast<double>(moved) / (all - hidden));
    EXPECT_DOUBLE_EQ(scores.found, 1 - scores.misplaced);
    EXPECT_DOUBLE_EQ(scores.false_hits, static_cast<double>(hidden) / (30 - (all - hidden)));
  }
}

TEST(ReflectionScores, SharesOfNothingHaveNoPartInMeans) {
  const Hall hall;
  std::vector<SceneReflection> hidden = OfFloor();
  for (SceneReflection& r : hidden) r.is_visible = false;
  const ReflectionReport none = ScoreReflections("none", hall.view(), kPinhole, hidden, Exact());
  const ReflectionReport some = ScoreReflections("some", hall.view(), kPinhole, OfFloor(), Exact());
  EXPECT_TRUE(std::isnan(none.methods[0].found));
  const ReflectionReport mean = MeanReflections({none, some});
  EXPECT_EQ(mean.scene, "mean");
  EXPECT_EQ(mean.methods[0].found, 1);
  EXPECT_DOUBLE_EQ(mean.findable, some.findable / 2);
  EXPECT_DOUBLE_EQ(mean.methods[2].cells, (none.methods[2].cells + some.methods[2].cells) / 2);
  EXPECT_EQ(ToJson(none)["methods"][0]["found"], nullptr);
  EXPECT_EQ(ReflectionTable(mean).rows.size(), 3U);
}

TEST(ReflectionSettings, NeedATileAndAThickness) {
  std::string why;
  ReflectionSettings settings;
  EXPECT_TRUE(settings.IsValid(&why));
  settings.tiles.clear();
  EXPECT_FALSE(settings.IsValid(&why));
  EXPECT_NE(why.find("no tile"), std::string::npos);
}

}  // namespace
}  // namespace warplut
