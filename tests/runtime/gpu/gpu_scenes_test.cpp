// Whole runs of `sr` on the built-in scenes: the GPU's frames beside the processor's.
#include <gtest/gtest.h>

#include <cmath>

#include "luts/baked/warplut_iir_x2.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/runtime/gpu/gpu_fixture.h"
#include "tools/judge/sequence_scores.h"
#include "tools/scene_rendering.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

// Bounds on whole runs of 32 frames, dB: the least PSNR of the GPU's frames against the
// processor's, and the most that the PSNR against the references may change.
constexpr double kLeastPsnr32 = 60, kLeastPsnr16 = 50, kScoreChange = 0.02;
constexpr int kFrames = 32;

class GpuScenesTest : public GpuTest, public testing::WithParamInterface<std::string> {};

std::vector<std::string> SceneNames() {
  std::vector<std::string> names;
  for (const SceneInfo& scene : Scenes()) names.emplace_back(scene.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Scenes, GpuScenesTest, testing::ValuesIn(SceneNames()),
                         [](const auto& test) { return test.param; });

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

TEST_P(GpuScenesTest, FramesAndScoresAreThoseOfTheProcessor) {
  const TemporaryFolder folder;
  RenderOptions rendering;
  rendering.width = 160;
  rendering.height = 90;
  rendering.frames = kFrames;
  rendering.samples = 2;
  const Streams streams = Streams::kRenderGrid | Streams::kReference | Streams::kReferenceDepth |
                          Streams::kReferenceMotion;
  RenderScene(GetParam(), rendering, streams, folder / "scene", [] {});
  const Clip clip = LoadClip(ReadSequence(folder / "scene"), 0, kFrames, streams);
  const Table table(baked::kWarplutIirX2);
  ModeRunOptions run;
  run.method = FindMethod("sr");
  run.shown_format = PixelFormat::kRgba32F;
  run.super_resolution.warp = {.filter = Filter::kLut, .table = &table};
  for (const PixelFormat format : {PixelFormat::kRgba32F, PixelFormat::kRgba16F}) {
    run.super_resolution.history_format = format;
    const SuperResolutionOptions options = EffectiveSuperResolution(clip, run);
    SerialExecutor executor;
    SuperResolution cpu(options, executor);
    GpuSuperResolution gpu(device(), options);
    ImageBuffer expected = OutputOf(options), found = OutputOf(options);
    SequenceJudge cpu_judge(clip, *run.method), gpu_judge(clip, *run.method);
    double squares = 0;
    for (int i = 0; i < kFrames; ++i) {
      const RenderedFrame frame = clip.frames[static_cast<std::size_t>(i)].Rendered();
      cpu.Process(frame, expected.view());
      gpu.Process(frame, found.view());
      const ImageView cpu_image = static_cast<const ImageBuffer&>(expected).view();
      const ImageView gpu_image = static_cast<const ImageBuffer&>(found).view();
      squares += SquaredError(cpu_image, gpu_image) / kFrames;
      const auto time = static_cast<double>(i);
      cpu_judge.Add({.time = time, .frame = i, .image = cpu_image});
      gpu_judge.Add({.time = time, .frame = i, .image = gpu_image});
    }
    const bool half = format == PixelFormat::kRgba16F;
    const double psnr = -10 * std::log10(std::max(squares, 1e-15));
    EXPECT_GT(psnr, half ? kLeastPsnr16 : kLeastPsnr32) << Name(format);
    const SequenceScores cpu_scores = cpu_judge.Finish(), gpu_scores = gpu_judge.Finish();
    EXPECT_NEAR(gpu_scores.mean.psnr, cpu_scores.mean.psnr, kScoreChange) << Name(format);
    std::printf("%s %s: %.1f dB to the processor, score %.3f dB, change %.4f dB\n",
                GetParam().c_str(), Name(format), psnr, cpu_scores.mean.psnr,
                gpu_scores.mean.psnr - cpu_scores.mean.psnr);
  }
}

}  // namespace
}  // namespace warplut
