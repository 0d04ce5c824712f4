// Where samples count as aliased, and what that does to the update.
#include "runtime/sr/aliasing.h"

#include <random>
#include <vector>

#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

constexpr int kWidth = 70, kHeight = 41;  // 5 x 3 tiles, the outermost partial
constexpr int kColumns = 5, kRows = 3;
constexpr float kArea = 4;
constexpr float kMostSmoothing = MostSmoothing(kArea);

float Variance(float deviation) { return deviation * deviation; }

void SetAll(AliasingMap& map, float variance) {
  for (int row = 0; row < kRows; ++row) {
    std::fill_n(map.Variances(row), kColumns, variance);
  }
}

// Row j of the map; empty where it is 0.
std::vector<float> RowOf(const AliasingMap& map, int j) {
  std::vector<float> room(kWidth + 3 * kAliasingTile, -1.0f);
  if (!map.FillRow(j, room.data() + kAliasingTile)) return {};
  return {room.begin() + kAliasingTile, room.begin() + kAliasingTile + kWidth};
}

TEST(ResidualVariance, IsAboutTheMeanOfEachChannel) {
  const float changed[3] = {4 * 0.5f, 4 * -0.25f, 0};  // 4 residuals, equal in each channel
  EXPECT_EQ(ResidualVariance(4 * (0.25f + 0.0625f), changed, 4), 0.0f);
  const float none[3] = {};
  EXPECT_FLOAT_EQ(ResidualVariance(12 * 0.04f, none, 4), 0.04f);
  const float rounded[3] = {1.0f, 0, 0};
  EXPECT_EQ(ResidualVariance(0.999999f, rounded, 1), 0.0f);
}

TEST(AliasingMap, SmoothsLessWhereSamplesAreFew) {
  EXPECT_EQ(MostSmoothing(1), 0.7f);
  EXPECT_FLOAT_EQ(MostSmoothing(4), 0.7f);
  EXPECT_FLOAT_EQ(MostSmoothing(16), 0.175f);
}

TEST(AliasingMap, IsARampOfTheDeviation) {
  AliasingMap map(kWidth, kHeight, kArea);
  SetAll(map, Variance(kLeastAliasing));
  map.Finish();
  for (int j = 0; j < kHeight; ++j) EXPECT_TRUE(RowOf(map, j).empty());
  const auto expect = [&](float deviation, float smoothing) {
    SetAll(map, Variance(deviation));
    map.Finish();
    for (int j = 0; j < kHeight; ++j) {
      const std::vector<float> row = RowOf(map, j);
      ASSERT_EQ(row.size(), static_cast<std::size_t>(kWidth));
      for (const float value : row) EXPECT_NEAR(value, smoothing, 1e-5f) << j;
    }
  };
  expect((kLeastAliasing + kMostAliasing) / 2, kMostSmoothing / 2);
  expect(kMostAliasing, kMostSmoothing);
  expect(1.0f, kMostSmoothing);
}

TEST(AliasingMap, RampIsInUnitsOfTheContrast) {
  constexpr float kContrast = 0.25f;
  AliasingMap map(kWidth, kHeight, kArea, kContrast);
  SetAll(map, Variance(kContrast * kMostAliasing));
  map.Finish();
  for (const float value : RowOf(map, 3)) EXPECT_NEAR(value, kMostSmoothing, 1e-5f);
  SetAll(map, Variance(kContrast * kLeastAliasing));
  map.Finish();
  EXPECT_TRUE(RowOf(map, 3).empty());
}

// Tiles are blurred and interpolated: no step from one sample to the next, and nothing four tiles
// away.
TEST(AliasingMap, ChangesSmoothlyFromTileToTile) {
  AliasingMap map(8 * kAliasingTile, 8 * kAliasingTile, kArea);
  for (int row = 0; row < 8; ++row) std::fill_n(map.Variances(row), 8, 0.0f);
  map.Variances(0)[0] = 1.0f;
  map.Finish();
  std::vector<float> room(11 * kAliasingTile);
  float* row = room.data() + kAliasingTile;
  float before = kMostSmoothing;
  for (int j = 0; j < 4 * kAliasingTile; ++j) {
    if (!map.FillRow(j, row)) std::fill(room.begin(), room.end(), 0.0f);
    for (int i = 1; i < 8 * kAliasingTile; ++i) {
      EXPECT_LE(row[i], row[i - 1]);
      EXPECT_LE(row[i - 1] - row[i], 1.01f * kMostSmoothing / kAliasingTile);
    }
    EXPECT_LE(row[0], before);
    EXPECT_LE(before - row[0], 1.01f * kMostSmoothing / kAliasingTile);
    before = row[0];
    EXPECT_EQ(row[4 * kAliasingTile], 0.0f);
  }
  EXPECT_FALSE(map.FillRow(4 * kAliasingTile, row));
}

// Mean squared error of the last of some still frames, whose samples are `color` and noise of
// `deviation`.
double ErrorUnderNoise(HistoryForm form, float deviation) {
  constexpr float kColor = 0.5f;
  SuperResolutionOptions options = TestOptions(48, 40, 96, 80);
  options.form = form;
  options.clamp = ColorClamp::kNone;
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  TestFrame frame(48, 40);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> noise(-1.7320508f * deviation, 1.7320508f * deviation);
  for (int k = 0; k < 24; ++k) {
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 48; ++x) {
        const float grey = kColor + noise(random);
        frame.SetColor(x, y, grey, grey, grey);
      }
    }
    frame.jitter_x = k % 2 == 0 ? 0.25f : -0.25f;
    frame.jitter_y = k % 4 < 2 ? 0.25f : -0.25f;
    sr.Process(frame.View(), out.view());
  }
  double sum = 0;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 96; ++x) sum += std::pow(At(out, x, y, 0) - kColor, 2.0);
  }
  return sum / (80 * 96);
}

TEST(AdaptiveForm, AveragesSamplesThatDisagreeAtRandom) {
  constexpr float kLittle = 0.2f * kLeastAliasing, kMuch = 1.5f * kMostAliasing;
  EXPECT_EQ(ErrorUnderNoise(HistoryForm::kAdaptive, kLittle),
            ErrorUnderNoise(HistoryForm::kResidual, kLittle));
  EXPECT_LT(ErrorUnderNoise(HistoryForm::kAdaptive, kMuch),
            0.4 * ErrorUnderNoise(HistoryForm::kResidual, kMuch));
}

// A change of light is no noise: the history follows at the full share.
TEST(AdaptiveForm, FollowsAChangeOfAllSamples) {
  SuperResolutionOptions options = TestOptions(48, 40, 48, 40);
  options.clamp = ColorClamp::kNone;
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  TestFrame frame(48, 40);
  sr.Process(frame.View(), out.view());
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 48; ++x) frame.SetColor(x, y, 0.9f, 0.9f, 0.9f);
  }
  sr.Process(frame.View(), out.view());
  const float expected = 0.5f + BlendShare(options.parameters.blend_a, 1.0f) * 0.4f;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 48; ++x) ASSERT_NEAR(At(out, x, y, 0), expected, 2e-3f) << x << ", " << y;
  }
}

}  // namespace
}  // namespace warplut
