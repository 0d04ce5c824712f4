// Moves a picture by half a pixel, 24 times, with a table and its prefilter.
#include <cstdio>
#include <utility>

#include "luts/baked/warplut_iir_x2.h"
#include "runtime/prefilter.h"
#include "runtime/warp.h"
#include "scene.h"

int main() {
  using namespace warplut;
  constexpr int kSize = 256, kFrames = 24;
  constexpr PixelFormat kFormat = PixelFormat::kRgba32F;
  const Table table(baked::kWarplutIirX2);
  const WarpOptions options = {.filter = Filter::kLut, .table = &table};
  SerialExecutor executor;
  PrefilterPass prefilter(table.prefilter(), kSize, kSize, executor.Threads());

  ImageBuffer history(kSize, kSize, kFormat), shown(kSize, kSize, kFormat);
  ImageBuffer coefficients(kSize, kSize, CoefficientFormat(kFormat));
  MotionBuffer motion(kSize, kSize);
  example::DrawWall(0, history);
  example::FillMotion(0.5f, 0.5f, motion.view());
  for (int frame = 0; frame < kFrames; ++frame) {
    prefilter.Apply(history, executor, coefficients);
    Warp(PrefilteredImage{history, coefficients}, motion.view(), options, shown);
    std::swap(history, shown);
  }

  example::DrawWall(0.5 * kFrames, shown);
  std::printf("%d warps by half a pixel: PSNR %.2f dB\n", kFrames, example::Psnr(history, shown));
}
