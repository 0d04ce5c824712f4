// The programs of docs/INTEGRATE.md run, and each is better than the obvious way to do without it.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include "runtime/executor.h"
#include "runtime/super_resolution.h"
#include "runtime/warp.h"
#include "scene.h"

namespace warplut {
namespace {

// What a program prints; it must end with 0.
std::string Output(const std::string& program) {
  FILE* pipe = popen((EMULATOR " " + program).c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << program;
  return text;
}

// The number behind "PSNR " of the line that begins so, in dB; of the first line by default.
double PrintedPsnr(const std::string& output, const std::string& line = "") {
  const std::size_t at = output.find("PSNR ", output.find(line));
  EXPECT_NE(at, std::string::npos) << output;
  return at == std::string::npos ? 0 : std::strtod(output.c_str() + at + 5, nullptr);
}

TEST(Example, TheTableKeepsMoreThanCatmullRom) {
  constexpr int kSize = 256, kFrames = 24;
  ImageBuffer history(kSize, kSize, PixelFormat::kRgba32F),
      shown = {kSize, kSize, PixelFormat::kRgba32F};
  MotionBuffer motion(kSize, kSize);
  example::DrawWall(0, history);
  example::FillMotion(0.5f, 0.5f, motion.view());
  for (int frame = 0; frame < kFrames; ++frame) {
    Warp(history.view(), motion.view(), {.filter = Filter::kCatmullRom}, shown);
    std::swap(history, shown);
  }
  example::DrawWall(0.5 * kFrames, shown);
  EXPECT_GT(PrintedPsnr(Output(WARP)), example::Psnr(history, shown) + 10);
}

TEST(Example, SuperResolutionIsBetterThanBilinear) {
  SuperResolutionOptions options;
  options.render_width = 160;
  options.render_height = 90;
  options.output_width = 320;
  options.output_height = 180;
  options.history = false;
  SerialExecutor executor;
  SuperResolution bilinear(options, executor);
  example::Scene scene(160, 90, 320, 180);
  ImageBuffer shown(320, 180, PixelFormat::kRgba8);
  bilinear.Process(scene.Render(23), shown);
  EXPECT_GT(PrintedPsnr(Output(SUPER_RESOLUTION)), example::Psnr(shown, scene.Reference(23)) + 6);
}

TEST(Example, AnInterpolatedFrameIsBetterThanTheFrameBefore) {
  example::Scene scene(160, 90, 320, 180), later(160, 90, 320, 180);
  const double repeated = example::Psnr(scene.Reference(10), later.Reference(10.5));
  EXPECT_GT(PrintedPsnr(Output(CHAINED)), repeated + 10);
}

TEST(Example, AMaskAndALayerAreBetterThanNone) {
  const std::string output = Output(MASKS);
  EXPECT_GT(PrintedPsnr(output, "with a reactive mask"),
            PrintedPsnr(output, "sparks without a mask") + 1);
  EXPECT_GT(PrintedPsnr(output, "HUD as a layer"), PrintedPsnr(output, "HUD in the frames") + 3);
}

TEST(Example, JobsOfAnEngineGiveTheSameBits) {
  EXPECT_EQ(Output(EXECUTOR), "on 3 jobs and on one thread: the same bits\n");
}

}  // namespace
}  // namespace warplut
