#include "tools/bench/warp_content.h"

#include <cmath>
#include <random>

#include "luts/filters.h"
#include "luts/wide_kernel.h"
#include "runtime/core/pixel.h"

namespace warplut {

void FillWarpImage(const WarpImage& image) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(-0.1f, 0.1f);
  const float scale = ChannelScale(image.view.format);
  for (int y = 0; y < image.view.height; ++y) {
    for (int x = 0; x < image.view.width; ++x) {
      for (int c = 0; c < Channels(image.view.format); ++c) {
        const float wave = std::sin(0.07f * x + 0.05f * y + c);
        StoreChannel(image.view.format, scale * (0.5f + 0.35f * wave + noise(random)),
                     image.view.At(x, y), c);
      }
    }
  }
}

void FillWarpMotion(const std::string& kind, WarpMotion& motion) {
  for (int y = 0; y < motion.view.height; ++y) {
    for (int x = 0; x < motion.view.width; ++x) {
      float* m = motion.xy.data() + 2 * (static_cast<std::size_t>(y) * motion.view.width + x);
      if (kind == "smooth") {
        m[0] = 5.3f * std::sin(0.003f * x + 0.002f * y);
        m[1] = 4.1f * std::cos(0.002f * x - 0.004f * y);
      } else if (kind == "uniform") {
        m[0] = 3.37f;
        m[1] = -1.61f;
      } else if (kind == "whole") {
        m[0] = 3;
        m[1] = -2;
      } else {
        m[0] = 0;
        m[1] = 0;
      }
    }
  }
}

std::vector<std::int16_t> MakeWarpTable(Footprint footprint) {
  constexpr double kKaiser = 4.5;
  const FootprintTaps& taps = TapsOf(footprint);
  std::vector<std::int16_t> table;
  table.reserve(static_cast<std::size_t>(TableValues(footprint)));
  const double one = 1 << FractionBits(TableFormat::kI16);
  for (int row = 0; row < kRows; ++row) {
    const double dx = NodeOffset(row % kNodes), dy = NodeOffset(row / kNodes);
    const Weights<double> w = footprint == Footprint::k16 ? KeysWeights(kCatmullRomA, dx, dy)
                                                          : WideWeights(footprint, kKaiser, dx, dy);
    int rest = static_cast<int>(one);
    std::size_t identity = 0;
    for (const int k : taps) {
      if (k == kIdentityWeight) identity = table.size();
      table.push_back(static_cast<std::int16_t>(std::lround(w[k] * one)));
      rest -= table.back();
    }
    table[identity] = static_cast<std::int16_t>(table[identity] + rest);
  }
  return table;
}

}  // namespace warplut
