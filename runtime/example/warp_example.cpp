// Moves a picture 12 pixels in 24 warps of half a pixel and prints what each filter loses.
#include <cmath>
#include <cstdio>
#include <vector>

#include "luts/baked/warplut_iir_x2.h"
#include "runtime/executor.h"
#include "runtime/prefilter.h"
#include "runtime/warp.h"

int main() {
  using namespace warplut;
  constexpr int kSize = 256, kWarps = 24, kMoved = kWarps / 2, kMargin = 32;
  std::vector<float> picture(kSize * kSize), motion(kSize * kSize * 2, 0.5f);
  for (int i = 0; i < kSize * kSize; ++i) {  // rings that get finer towards the edge
    const int x = i % kSize - kSize / 2, y = i / kSize - kSize / 2;
    picture[i] = 0.5f + 0.4f * std::sin(0.004f * static_cast<float>(x * x + y * y));
  }
  const Table table(baked::kWarplutIirX2);
  const MotionView moves = {motion.data(), kSize, kSize, kSize * 8};
  SerialExecutor executor;
  std::printf("Warp runs on %s\n", WarpTarget());
  for (const FilterInfo& filter : kFilters) {
    WarpOptions options;
    options.filter = filter.filter;
    options.table = &table;
    const Prefilter prefilter = PrefilterOf(options);  // of the table, or of the spline
    std::vector<float> now = picture, next = picture, coefficients = picture;
    for (int i = 0; i < kWarps; ++i) {
      const ImageView history = {now.data(), kSize, kSize, kSize * 4, PixelFormat::kR32F};
      const MutableImageView out = {next.data(), kSize, kSize, kSize * 4, PixelFormat::kR32F};
      if (HasPrefilter(prefilter)) {
        const MutableImageView filtered = {coefficients.data(), kSize, kSize, kSize * 4,
                                           PixelFormat::kR32F};
        // A renderer makes the pass once and calls Apply each frame.
        PrefilterPass(prefilter, kSize, kSize, executor.Threads())
            .Apply(history, executor, filtered);
        Warp(PrefilteredImage{history, filtered}, moves, options, out);
      } else {
        Warp(history, moves, options, out);
      }
      now.swap(next);
    }
    double sum = 0, count = 0;
    for (int y = kMargin; y < kSize - kMargin; ++y) {
      for (int x = kMargin; x < kSize - kMargin; ++x, ++count) {
        sum += std::pow(now[y * kSize + x] - picture[(y - kMoved) * kSize + x - kMoved], 2);
      }
    }
    std::printf("%-12s PSNR %6.2f dB\n", filter.name, -10 * std::log10(sum / count));
  }
}
