#include "tests/stability/cases/passes/runtime_size_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/core/pixel.h"
#include "runtime/image_buffer.h"
#include "tests/stability/cases/passes/runtime_methods.h"
#include "tests/stability/cases/stability_clip.h"

namespace warplut {
namespace {

constexpr int kSizeFrames = 3;

struct Sizes {
  GridSize render, output;
};

constexpr Sizes kSmall[] = {{{1, 1}, {1, 1}}, {{1, 1}, {4, 4}}, {{1, 1}, {2, 3}}, {{3, 3}, {3, 3}},
                            {{3, 3}, {6, 6}}, {{1, 7}, {2, 9}}, {{9, 1}, {12, 1}}};
constexpr Sizes kOdd[] = {{{13, 11}, {25, 21}}, {{17, 5}, {33, 19}}, {{31, 23}, {61, 47}}};
constexpr Sizes kWide[] = {{{3840, 1}, {7680, 2}}};
constexpr Sizes kScales[] = {{{40, 30}, {40, 30}},
                             {{100, 20}, {101, 21}},
                             {{20, 30}, {26, 39}},
                             {{12, 9}, {48, 36}},
                             {{16, 16}, {16, 64}}};

template <std::size_t n>
StabilityResult ExamineSizes(const Sizes (&list)[n], bool motion_filter = true) {
  Examination examination;
  for (const Sizes& sizes : list) {
    examination.Examine(MovingScene(sizes.render, sizes.output, kSizeFrames), "a moving scene",
                        motion_filter);
  }
  return examination.Result();
}

// The largest difference from the plain warp, in units of its bound, and the range of what came
// out.
struct WarpCheck {
  double worst = 0;
  ValueRange range;
};

WarpCheck CheckWarp(int width, int height, PixelFormat format, const WarpOptions& options) {
  const float white = format == PixelFormat::kRgba8 ? 255.0f : 1.0f;
  ImageBuffer history(width, height, format), fast(width, height, format);
  ImageBuffer plain(width, height, format);
  MotionBuffer motion(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 4; ++c) {
        StoreChannel(format, white * (0.3f + 0.4f * Noise(x, y, c)), history.view().At(x, y), c);
      }
      // Tiles of one motion, of whole pixels, and of motion that differs.
      const int tile = x / 64 + y / 16;
      const float reach = tile % 3 == 0 ? 0.0f : 5.0f;
      const float base = tile % 3 == 1 ? 1.0f : 0.37f;
      motion.view().Row(y)[2 * x] = base + reach * (Noise(x, y, 7) - 0.5f);
      motion.view().Row(y)[2 * x + 1] = -base + reach * (Noise(x, y, 8) - 0.5f);
    }
  }
  Warp(history.view(), motion.view(), options, fast.view());
  WarpReference(history.view(), motion.view(), options, plain.view());
  return {LargestDifference(fast.view(), plain.view()) / WarpBound(format), RangeOf(fast.view())};
}

}  // namespace

StabilityResult WarpSizes(StabilityEffort) {
  constexpr GridSize kSizes[] = {{1, 1}, {3, 3}, {1, 9}, {9, 1}, {37, 19}, {131, 17}, {7680, 3}};
  constexpr double kLow = 0.3, kHigh = 0.7, kCodes = 0.6 / 255;
  const double overshoot = Overshoot(StoredHistoryTable()) * (kHigh - kLow) + kCodes;
  double worst = 0, least = 1, largest = 0;
  for (const auto& [width, height] : kSizes) {
    for (const PixelFormat format : kColorFormats) {
      for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
        const WarpCheck check = CheckWarp(width, height, format, HistoryWarp(lookup));
        worst = std::max(worst, check.worst);
        least = std::min(least, check.range.least);
        largest = std::max(largest, check.range.largest);
      }
    }
  }
  return {
      worst <= 1 && least >= kLow - overshoot && largest <= kHigh + overshoot,
      fmt::format("{:.2f} of the bound from the plain version; values {:.3f} to {:.3f}, allowed "
                  "{:.3f} to {:.3f}",
                  worst, least, largest, kLow - overshoot, kHigh + overshoot)};
}

StabilityResult SmallSizes(StabilityEffort) { return ExamineSizes(kSmall); }

StabilityResult OddSizes(StabilityEffort) { return ExamineSizes(kOdd); }

StabilityResult WideSizes(StabilityEffort effort) {
  return ExamineSizes(kWide, effort == StabilityEffort::kFull);
}

StabilityResult Scales(StabilityEffort) { return ExamineSizes(kScales); }

StabilityResult ConstantAtAnySize(StabilityEffort) {
  constexpr float kColor[3] = {0.2f, 0.6f, 1.0f};  // codes: an 8-bit history holds no others
  double worst = 0;
  int runs = 0;
  std::string where;
  const auto check = [&](const Sizes& sizes) {
    Clip clip = MovingScene(sizes.render, sizes.output, kSizeFrames);
    EditColor(clip, [&](float* rgba, int, int, int) {
      std::copy(std::begin(kColor), std::end(kColor), rgba);
    });
    for (const MethodInfo& method : Methods()) {
      for (const PixelFormat format : kColorFormats) {
        if (!method.super_resolution && format != PixelFormat::kRgba16F) continue;
        for (const ShownImage& shown : RunMethod(clip, method, {.history_format = format})) {
          const ImageView image = shown.image.view();
          double off = 0;
          for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
              const float* pixel = image.Row<float>(y) + 4 * x;
              for (int c = 0; c < 3; ++c) {
                off = std::max(off, static_cast<double>(std::abs(pixel[c] - kColor[c])));
              }
            }
          }
          if (off > worst) where = method.name;
          worst = std::max(worst, off);
        }
        ++runs;
      }
    }
  };
  for (const Sizes& sizes : kSmall) check(sizes);
  for (const Sizes& sizes : kOdd) check(sizes);
  for (const Sizes& sizes : kScales) check(sizes);
  return {worst <= kHalfCode, fmt::format("off by at most {:.2g} of a code value in {} runs ({})",
                                          255 * worst, runs, where)};
}

}  // namespace warplut
