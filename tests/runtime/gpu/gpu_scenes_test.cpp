// Whole runs of the modes on the built-in scenes: the GPU's frames beside the processor's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "luts/baked/warplut_iir_x2.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/runtime/gpu/gpu_fixture.h"
#include "tools/gpu_modes.h"
#include "tools/judge/sequence_scores.h"
#include "tools/scene_rendering.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

// Bounds on whole runs of 32 frames, dB: the least PSNR of the GPU's frames against the
// processor's, and the most that the PSNR against the references may change. A score above that
// of halves may change by more: there the rounding of the frames is a part of their error.
constexpr double kLeastPsnr32 = 60, kLeastPsnr16 = 50, kScoreChange = 0.02;
constexpr int kFrames = 32, kEvery = 2;

class GpuScenesTest : public GpuTest,
                      public testing::WithParamInterface<std::tuple<std::string, const char*>> {};

std::vector<std::string> SceneNames() {
  std::vector<std::string> names;
  for (const SceneInfo& scene : Scenes()) names.emplace_back(scene.name);
  return names;
}
std::string NameOf(const testing::TestParamInfo<GpuScenesTest::ParamType>& test) {
  std::string name = std::get<0>(test.param) + "_" + std::get<1>(test.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Scenes, GpuScenesTest,
                         testing::Combine(testing::ValuesIn(SceneNames()),
                                          testing::Values("sr", "i", "e")),
                         NameOf);
// Motion that is quadratic on the screen.
INSTANTIATE_TEST_SUITE_P(Quadratic, GpuScenesTest,
                         testing::Combine(testing::Values(SceneNames().back()),
                                          testing::Values("i-quadratic", "e-quadratic")),
                         NameOf);
// Super resolution hands its frames to frame generation.
INSTANTIATE_TEST_SUITE_P(Chained, GpuScenesTest,
                         testing::Combine(testing::Values(SceneNames().front(),
                                                          SceneNames().back()),
                                          testing::Values("isr", "esr")),
                         NameOf);

double SquaredError(const ImageView& a, const ImageView& b) {
  double sum = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double d =
            static_cast<double>(a.Row<float>(y)[4 * x + c]) - b.Row<float>(y)[4 * x + c];
        sum += d * d;
      }
    }
  }
  return sum / (3.0 * a.width * a.height);
}

// What methods run on, with every second frame rendered where they generate, and are judged by.
struct SceneClips {
  Clip dense, sparse;
};

SceneClips ClipsOf(const std::string& scene) {
  const TemporaryFolder folder;
  RenderOptions rendering;
  rendering.width = 160;
  rendering.height = 90;
  rendering.frames = kFrames;
  rendering.samples = 2;
  const Streams streams = Streams::kRenderGrid | Streams::kReference | Streams::kReferenceDepth |
                          Streams::kReferenceMotion;
  RenderScene(scene, rendering, streams, folder / "scene", [] {});
  const Sequence sequence = ReadSequence(folder / "scene");
  return {LoadClip(sequence, 0, kFrames, streams), LoadClip(sequence, 0, kFrames, streams, kEvery)};
}

// The colours of the references in a float format: the processor rounds what it warps to the
// format of the colours, which 8 bits would show.
void ConvertReferences(PixelFormat format, Clip* clip) {
  for (ClipFrame& frame : clip->frames) {
    const ImageView from = std::as_const(frame.reference).view();
    ImageBuffer to(from.width, from.height, format);
    for (int y = 0; y < from.height; ++y) {
      for (int x = 0; x < 4 * from.width; ++x) {
        StoreChannel(format, LoadChannel(from.format, from.At(0, y), x) / ChannelScale(from.format),
                     to.view().At(0, y), x);
      }
    }
    frame.reference = std::move(to);
  }
}

// A run with its frames, as RGBA32F, and its scores.
struct SceneRun {
  std::vector<ImageBuffer> frames;
  SequenceScores scores;
};

SceneRun RunScene(const Clip& clip, const Clip& truth, const ModeRunOptions& options) {
  SceneRun run;
  SequenceJudge judge(truth, *options.method);
  SerialExecutor executor;
  RunMode(clip, options, executor, [&](const ShownFrame& shown) {
    judge.Add(shown);
    const ImageView from = shown.image;
    ImageBuffer& frame = run.frames.emplace_back(from.width, from.height, PixelFormat::kRgba32F);
    for (int y = 0; y < from.height; ++y) {
      for (int x = 0; x < 4 * from.width; ++x)
        frame.view().Row<float>(y)[x] = LoadChannel(from.format, from.At(0, y), x);
    }
  });
  run.scores = judge.Finish();
  return run;
}

void ExpectSameRun(const SceneRun& gpu, const SceneRun& cpu, PixelFormat format,
                   const std::string& what) {
  ASSERT_EQ(gpu.frames.size(), cpu.frames.size());
  double squares = 0;
  for (std::size_t i = 0; i < cpu.frames.size(); ++i) {
    squares +=
        SquaredError(std::as_const(cpu.frames[i]).view(), std::as_const(gpu.frames[i]).view()) /
        static_cast<double>(cpu.frames.size());
  }
  const double psnr = -10 * std::log10(std::max(squares, 1e-15));
  EXPECT_GT(psnr, format == PixelFormat::kRgba16F ? kLeastPsnr16 : kLeastPsnr32) << what;
  // Of frames without any error both are infinite.
  const double score = cpu.scores.mean.psnr, found = gpu.scores.mean.psnr;
  const double change = found == score ? 0 : found - score;
  const double bound = score <= kLeastPsnr16 ? kScoreChange : 10 * kScoreChange;
  EXPECT_LE(std::abs(change), bound) << what << ": " << found << " in place of " << score;
  std::printf("%s: %.1f dB to the processor, score %.3f dB, change %.4f dB\n", what.c_str(), psnr,
              score, change);
}

// Every mode of the registry that the paper has not changed, in 32 and in 16 bits.
TEST_P(GpuScenesTest, FramesAndScoresAreThoseOfTheProcessor) {
  const auto [scene, mode] = GetParam();
  SceneClips clips = ClipsOf(scene);
  const Table table(baked::kWarplutIirX2);
  GpuModes modes("gpu", device());
  ModeRunOptions options;
  options.method = FindMethod(mode);
  const bool generates = options.method->generation != Generation::kNone;
  options.every = generates ? kEvery : 1;
  Clip& clip = generates ? clips.sparse : clips.dense;
  options.super_resolution.warp = {.filter = Filter::kLut, .table = &table};
  options.generation.warp = options.super_resolution.warp;
  for (const PixelFormat format : {PixelFormat::kRgba32F, PixelFormat::kRgba16F}) {
    if (generates) ConvertReferences(format, &clip);
    options.super_resolution.history_format = format;
    options.shown_format = format;
    std::string why;
    ASSERT_TRUE(options.IsValid(clip, &why)) << why;
    options.device = nullptr;
    const SceneRun cpu = RunScene(clip, clips.dense, options);
    options.device = &modes;
    const SceneRun gpu = RunScene(clip, clips.dense, options);
    ExpectSameRun(gpu, cpu, format, scene + " " + mode + " " + Name(format));
  }
}

}  // namespace
}  // namespace warplut
