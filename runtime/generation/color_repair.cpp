#include "runtime/generation/color_repair.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "runtime/core/pixel.h"
#include "runtime/motion/motion_split.h"

namespace warplut::generation {
namespace {

// The highest bit of what is returned is set if all bits of the exponent are.
std::uint16_t ExponentSum(std::uint16_t half) {
  return static_cast<std::uint16_t>((half & 0x7FFFu) + 0x0400u);
}
std::uint32_t ExponentSum(float value) {
  return (std::bit_cast<std::uint32_t>(value) & 0x7FFFFFFFu) + 0x00800000u;
}

template <class T>
bool AnyUnusable(const T* channels, int count) {
  decltype(ExponentSum(T())) any = 0;
  for (int i = 0; i < count; ++i) any |= ExponentSum(channels[i]);
  return any >> (8 * sizeof(any) - 1) != 0;
}

bool IsUnusable(float value) { return !IsFinite(value); }

template <class T>
void Repair(const ImageView& color, const MotionView& motion, const WarpOptions& options, int y,
            const MutableImageView& warped) {
  constexpr int kChannels = 4;
  const T* row = warped.Row<const T>(y);
  if (!AnyUnusable(row, warped.width * kChannels)) return;
  const bool prefiltered = HasPrefilter(PrefilterOf(options));
  const Footprint footprint = FootprintOf(options);
  for (int x = 0; x < warped.width; ++x) {
    if (!AnyUnusable(row + x * kChannels, kChannels)) continue;
    const MotionSplit sx = SplitMotion(motion.Row(y)[2 * x]);
    const MotionSplit sy = SplitMotion(motion.Row(y)[2 * x + 1]);
    const int tx = SampledTexel(x, sx.whole, color.width);
    const int ty = SampledTexel(y, sy.whole, color.height);
    Weights<float> weights = FilterWeights(options, sx.offset, sy.offset);
    if (prefiltered) {  // which spreads no such channel: this is a copy
      weights.fill(0.0f);
      weights[kIdentityWeight] = 1.0f;
    }
    for (int c = 0; c < kChannels; ++c) {
      Weights<float> texels{};
      for (const int k : TapsOf(footprint)) {
        const float value = LoadChannel(color.format,
                                        color.At(std::clamp(tx + TapX(k), 0, color.width - 1),
                                                 std::clamp(ty + TapY(k), 0, color.height - 1)),
                                        c);
        texels[k] = IsUnusable(value) ? 0.0f : value;
      }
      StoreChannel(warped.format, ApplyWeights(footprint, weights, texels), warped.At(x, y), c);
    }
  }
}

}  // namespace

void RepairRow(const ImageView& color, const MotionView& motion, const WarpOptions& options, int y,
               const MutableImageView& warped) {
  if (warped.format == PixelFormat::kRgba16F) {
    Repair<std::uint16_t>(color, motion, options, y, warped);
  } else if (warped.format == PixelFormat::kRgba32F) {
    Repair<float>(color, motion, options, y, warped);
  }
}

}  // namespace warplut::generation
