#include "train/calibration/clip_loss.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/datasets/expect_error.h"
#include "tests/train/calibration/scene_clip.h"
#include "train/calibration/calibration.h"
#include "train/calibration/clip_crop.h"

namespace warplut {
namespace {

ModeRunOptions Mode(const char* name, int every = 1) {
  ModeRunOptions options;
  options.method = FindMethod(name);
  options.every = every;
  options.generated = std::max(1, every - 1);
  options.shown_format = PixelFormat::kRgba32F;
  return options;
}

class ClipLossTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { clip_ = std::make_shared<const Clip>(SceneClip()); }
  static void TearDownTestSuite() { clip_.reset(); }

  static std::vector<double> Residuals(ClipLoss& loss, const Parameters& parameters = {},
                                       float gate_width = 0) {
    std::vector<double> residuals(loss.Size());
    loss.Evaluate(parameters, gate_width, residuals);
    return residuals;
  }

  static std::shared_ptr<const Clip> clip_;
  SerialExecutor serial_;
};

std::shared_ptr<const Clip> ClipLossTest::clip_;

TEST_F(ClipLossTest, IsTheMeanOfOneMinusSsim) {
  ClipLoss loss({{clip_, Mode("sr")}}, serial_);
  EXPECT_GT(loss.Size(), 16U);
  double mean = 0;
  int judged = 0;
  RunMode(*clip_, Mode("sr"), serial_, [&](const ShownFrame& shown) {
    if (shown.frame == 0) return;
    const ImageView reference =
        clip_->frames[static_cast<std::size_t>(shown.frame)].reference.view();
    mean += 1 - SsimReference(LumaOf(shown.image, ColorEncoding::kDisplay, serial_).view(),
                              LumaOf(reference, ColorEncoding::kDisplay, serial_).view());
    ++judged;
  });
  EXPECT_NEAR(LossOf(Residuals(loss)), mean / judged, kSsimAccuracy);
  EXPECT_NEAR(1 - loss.MeanSsim({})[0], mean / judged, kSsimAccuracy);
}

TEST_F(ClipLossTest, HasTheSameBitsForAnyNumberOfThreads) {
  ThreadPool pool(3);
  for (const char* mode : {"sr", "isr"}) {
    const int every = FindMethod(mode)->generation == Generation::kNone ? 1 : 2;
    ClipLoss serial({{clip_, Mode(mode, every)}}, serial_);
    ClipLoss parallel({{clip_, Mode(mode, every)}}, pool);
    EXPECT_EQ(Residuals(serial), Residuals(parallel));
    EXPECT_EQ(Residuals(serial, kPaperParameters, 0.4f),
              Residuals(parallel, kPaperParameters, 0.4f));
  }
}

// Clips that are loaded again for each evaluation are the same clips.
TEST_F(ClipLossTest, HasTheSameBitsHoweverFewClipsAreHeld) {
  const char* const scenes[] = {"street", "plaza", "still"};
  const auto load = [](const char* scene) {
    return SceneClip({.scene = scene, .width = 64, .height = 48, .frames = 3});
  };
  const std::size_t bytes = ClipBytes(load(scenes[0]));
  ClipShelf all, one(bytes);
  std::vector<ClipRun> kept, streamed;
  for (const char* scene : scenes) {
    const auto load_it = [=] { return load(scene); };
    kept.push_back({.clip = all.Add(load_it), .options = Mode("sr")});
    streamed.push_back({.clip = one.Add(load_it), .options = Mode("sr")});
  }
  ClipLoss expected(kept, serial_), found(streamed, serial_);
  EXPECT_EQ(Residuals(expected), Residuals(found));
  EXPECT_EQ(Residuals(expected, kPaperParameters, 0.4f), Residuals(found, kPaperParameters, 0.4f));
  EXPECT_EQ(all.loads(), 3);
  EXPECT_EQ(all.held(), 3 * bytes);
  EXPECT_GE(one.loads(), 7);
  EXPECT_EQ(one.most_held(), bytes);
}

TEST_F(ClipLossTest, MethodsCountAlike) {
  ClipLoss sr({{clip_, Mode("sr")}}, serial_);
  ClipLoss interpolation({{clip_, Mode("i", 2)}}, serial_);
  ClipLoss extrapolation({{clip_, Mode("e", 2)}}, serial_);
  ClipLoss all(
      {{clip_, Mode("sr")}, {clip_, Mode("i", 2)}, {clip_, Mode("e", 2)}, {clip_, Mode("e", 2)}},
      serial_);
  const double expected = (LossOf(Residuals(sr)) + LossOf(Residuals(interpolation)) +
                           LossOf(Residuals(extrapolation))) /
                          3;
  EXPECT_NEAR(LossOf(Residuals(all)), expected, 1e-12);
  EXPECT_GT(expected, 0);
}

TEST_F(ClipLossTest, RunsOverOneClipShareASource) {
  const auto plaza = std::make_shared<const Clip>(SceneClip({.scene = "plaza", .frames = 3}));
  ClipLoss loss({{clip_, Mode("sr")}, {plaza, Mode("sr")}, {clip_, Mode("i", 2)}}, serial_);
  const int tiles = static_cast<int>(loss.Size()) / 3;
  std::vector<int> sources;
  for (int run = 0; run < 3; ++run) {
    EXPECT_EQ(loss.Source(static_cast<std::size_t>(run * tiles)),
              loss.Source(static_cast<std::size_t>((run + 1) * tiles - 1)));
    sources.push_back(loss.Source(static_cast<std::size_t>(run * tiles)));
  }
  EXPECT_NE(sources[0], sources[1]);
  EXPECT_EQ(sources[0], sources[2]);
}

TEST_F(ClipLossTest, RefusesWhatCannotBeJudged) {
  ExpectError([&] { ClipLoss({}, serial_); }, {"no clip"});
  ExpectError([&] { ClipLoss({{clip_, Mode("sr-paper")}}, serial_); }, {"sr-paper", "constants"});
  ExpectError([&] { ClipLoss({{clip_, Mode("i", 50)}}, serial_); }, {"street", "6 frames"});
  const auto one = std::make_shared<const Clip>(SceneClip({.frames = 1}));
  ExpectError([&] { ClipLoss({{one, Mode("sr")}}, serial_); }, {"street", "1 frames", "judged"});
  Clip blind = SceneClip();
  for (ClipFrame& frame : blind.frames) frame.reference = {};
  const auto without = std::make_shared<const Clip>(std::move(blind));
  ExpectError([&] { ClipLoss({{without, Mode("sr")}}, serial_); }, {"street", "reference"});
  const auto small = std::make_shared<const Clip>(SceneClip({.width = 10, .height = 10}));
  ExpectError([&] { ClipLoss({{small, Mode("sr")}}, serial_); }, {"10 x 10", "11"});
}

TEST_F(ClipLossTest, OneTileIsEnough) {
  const auto small = std::make_shared<const Clip>(SceneClip({.width = 20, .height = 16}));
  ClipLoss loss({{small, Mode("sr")}}, serial_);
  EXPECT_EQ(loss.Size(), 1U);
  CalibrationOptions options;
  options.fitted = {3, 4};
  options.random_starts = 0;
  const CalibrationResult result = Calibrate(options, loss);
  EXPECT_LE(result.best.loss, result.paper_loss);
}

TEST_F(ClipLossTest, ParametersAreThoseThatMethodsRead) {
  EXPECT_EQ(ParametersOf({FindMethod("e")}),
            std::vector<int>{FindParameter("generation_depth_threshold")});
  // By default interpolation has no brightness gate; no other system's parameters are among them.
  const auto both = ParametersOf({FindMethod("sr"), FindMethod("i")});
  EXPECT_EQ(both.size(), 5U);
  EXPECT_EQ(std::count(both.begin(), both.end(), FindParameter("brightness_threshold")), 0);
  EXPECT_EQ(ParametersOf({FindMethod("taau")}),
            (std::vector<int>{FindParameter("taau_blend"), FindParameter("taau_gamma")}));
  EXPECT_TRUE(ParametersOf({FindMethod("bicubic")}).empty());
}

TEST_F(ClipLossTest, PlantedParametersAreFoundAgain) {
  Parameters planted;
  planted.blend_a = 1.2f;
  planted.blend_b = 1.3f;
  const auto clip =
      std::make_shared<const Clip>(WithShownReferences(*clip_, Mode("sr"), planted, serial_));
  ClipLoss loss({{clip, Mode("sr")}}, serial_);
  EXPECT_LT(LossOf(Residuals(loss, planted)), 1e-6);
  CalibrationOptions options;
  options.fitted = {FindParameter("blend_a"), FindParameter("blend_b")};
  options.random_starts = 0;
  const CalibrationResult result = Calibrate(options, loss);
  for (const Candidate& found : {result.best, result.kept}) {
    EXPECT_NEAR(found.parameters.blend_a / planted.blend_a, 1, 0.05);
    EXPECT_NEAR(found.parameters.blend_b / planted.blend_b, 1, 0.05);
  }
}

TEST_F(ClipLossTest, ADenseGridIsNoBetterForTwentyTimesTheRuns) {
  const auto clip =
      std::make_shared<const Clip>(SceneClip({.width = 64, .height = 48, .frames = 4}));
  ClipLoss loss({{clip, Mode("sr")}}, serial_);
  CalibrationOptions options;
  options.fitted = {FindParameter("blend_a"), FindParameter("blend_b")};
  options.random_starts = 0;
  const CalibrationResult result = Calibrate(options, loss);
  constexpr int kSide = 40;
  const SearchSpace space(options.fitted, {});
  double grid = 1;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Point point = {i % kSide / (kSide - 1.0), i / kSide / (kSide - 1.0)};
    grid = std::min(grid, LossOf(Residuals(loss, space.ToParameters(point))));
  }
  EXPECT_LE(result.best.loss, grid + 0.0005);
  EXPECT_LE(result.search_runs, kSide * kSide / 20);
}

TEST_F(ClipLossTest, AConstantImageNeedsNoParameter) {
  Clip grey = SceneClip({.width = 48, .height = 48, .frames = 3});
  for (ClipFrame& frame : grey.frames) {
    Image color = ToImage(frame.color.view()), reference = ToImage(frame.reference.view());
    std::fill(color.data.begin(), color.data.end(), 0.5f);
    std::fill(reference.data.begin(), reference.data.end(), 0.5f);
    frame.color = ToBuffer(color, PixelFormat::kRgba32F);
    frame.reference = ToBuffer(reference, PixelFormat::kRgba32F);
  }
  ClipLoss loss({{std::make_shared<const Clip>(std::move(grey)), Mode("sr")}}, serial_);
  CalibrationOptions options;
  options.fitted = ParametersOf({FindMethod("sr")});
  options.random_starts = 0;
  const CalibrationResult result = Calibrate(options, loss);
  EXPECT_LT(result.best.loss, kFlatProfile);
  for (const CalibratedParameter& parameter : result.parameters) {
    EXPECT_TRUE(parameter.NotNeeded()) << kParameters[parameter.parameter].name;
  }
}

TEST(TileGrid, TilesMakeUpTheMap) {
  for (const auto& [width, height] : {std::pair{11, 11}, {12, 40}, {128, 96}, {333, 200}}) {
    Image a(width, height, 1), b(width, height, 1);
    for (std::size_t i = 0; i < a.data.size(); ++i) {
      a.data[i] = static_cast<float>((i * 37) % 101) / 101;
      b.data[i] = static_cast<float>((i * 53) % 97) / 97;
    }
    const PlaneView x{a.data.data(), width, height, width}, y{b.data.data(), width, height, width};
    const TileGrid grid(width, height);
    double mean = 0, shares = 0;
    for (int tile = 0; tile < grid.count(); ++tile) {
      mean += grid.Share(tile) * SsimReference(grid.Window(x, tile), grid.Window(y, tile));
      shares += grid.Share(tile);
    }
    EXPECT_NEAR(shares, 1, 1e-12);
    EXPECT_NEAR(mean, SsimReference(x, y), 1e-12);
  }
}

TEST(CropClip, TakesTheMiddleOfBothGrids) {
  const Clip clip = SceneClip({.width = 120, .height = 90, .scale = 1.5, .frames = 2});
  const Clip crop =
      CropClip(SceneClip({.width = 120, .height = 90, .scale = 1.5, .frames = 2}), 50 * 50);
  EXPECT_LE(crop.output.width * crop.output.height, 50 * 50);
  EXPECT_EQ(crop.output.width * clip.render.width, crop.render.width * clip.output.width);
  EXPECT_EQ(crop.output.height * clip.render.height, crop.render.height * clip.output.height);
  const int x = (clip.output.width - crop.output.width) / 2 / 3 * 3;
  const int y = (clip.output.height - crop.output.height) / 2 / 3 * 3;
  const ImageView whole = clip.frames[1].reference.view(), part = crop.frames[1].reference.view();
  EXPECT_EQ(part.Row<float>(3)[4 * 5], whole.Row<float>(y + 3)[4 * (x + 5)]);
  EXPECT_EQ(crop.frames[1].motion.view().Row(2)[7],
            clip.frames[1].motion.view().Row(y / 3 * 2 + 2)[2 * (x / 3 * 2) + 7]);
  std::string why;
  EXPECT_TRUE(Mode("sr").IsValid(crop, &why)) << why;
}

TEST(CropClip, LeavesSmallClipsAndRefusesImpossibleWindows) {
  const SceneClipOptions options{.width = 62, .height = 62, .scale = 62.0 / 31, .frames = 1};
  EXPECT_EQ(CropClip(SceneClip(options), 62 * 62).output, (GridSize{62, 62}));
  EXPECT_EQ(CropClip(SceneClip(options), 0).output, (GridSize{62, 62}));
  ExpectError([&] { CropClip(SceneClip(options), 100); }, {"62 x 62", "100"});
}

}  // namespace
}  // namespace warplut
