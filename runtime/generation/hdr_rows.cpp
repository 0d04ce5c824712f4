#include "runtime/generation/hdr_rows.h"

#include <algorithm>

#include "runtime/color_encoding.h"
#include "runtime/core/pixel.h"
#include "runtime/filter.h"
#include "runtime/generation/blend.h"
#include "runtime/motion/motion_split.h"

namespace warplut::generation {
namespace {

constexpr int kChannels = 4;

// Each channel of `limit` becomes the greatest of itself and the 4 x 4 texels of which (x, y) is
// tap 0.
void RaiseToTexels(const ImageView& codes, int x, int y, float (&limit)[kChannels]) {
  for (int ky = 0; ky < kTaps; ++ky) {
    const float* row = codes.Row<float>(std::clamp(y + kFirstTap + ky, 0, codes.height - 1));
    for (int kx = 0; kx < kTaps; ++kx) {
      const float* texel = row + kChannels * std::clamp(x + kFirstTap + kx, 0, codes.width - 1);
      for (int c = 0; c < kChannels; ++c) limit[c] = std::max(limit[c], texel[c]);
    }
  }
}

}  // namespace

void EncodeHdrRowReference(const ImageView& linear, int y, const MutableImageView& to) {
  for (int x = 0; x < linear.width; ++x) {
    Rgb color = LoadHdr(linear.format, linear.At(x, y));
    for (float& channel : color.c) channel = HdrCode(channel);
    StoreRgb(color, to.format, to.At(x, y));
  }
}

void DecodeHdrRowReference(const ImageView& codes, int y, const MutableImageView& to) {
  for (int x = 0; x < codes.width; ++x) {
    Rgb color = LoadRgb(codes.format, codes.At(x, y));
    for (float& channel : color.c) channel = HdrValue(channel);
    StoreRgb(color, to.format, to.At(x, y));
  }
}

void LimitHdrRow(const ImageView& codes, const MotionView& motion, int y,
                 const MutableImageView& warped) {
  const float unlimited = HdrCode(kUnlimitedHdr);
  float* pixel = warped.Row<float>(y);
  for (int x = 0; x < warped.width; ++x, pixel += kChannels) {
    if (!(std::max({pixel[0], pixel[1], pixel[2]}) > unlimited)) continue;
    const MotionSplit sx = SplitMotion(motion.Row(y)[2 * x]);
    const MotionSplit sy = SplitMotion(motion.Row(y)[2 * x + 1]);
    float limit[kChannels] = {unlimited, unlimited, unlimited, unlimited};
    RaiseToTexels(codes, SampledTexel(x, sx.whole, codes.width),
                  SampledTexel(y, sy.whole, codes.height), limit);
    for (int c = 0; c < 3; ++c) pixel[c] = std::min(pixel[c], limit[c]);
  }
}

}  // namespace warplut::generation
