#include "runtime/generation/drawn_anew.h"

#include <algorithm>

#include "runtime/generation/blend.h"
#include "runtime/generation/generation_job.h"

namespace warplut::generation {

void FindStillRow(const ImageView& depth, const ImageView& moving, int y,
                  const MutableImageView& still_depth, std::int32_t* column) {
  const float* from = depth.Row<float>(y);
  const float* moves = moving.Row<float>(y);
  float* to = still_depth.Row<float>(y);
  const int width = depth.width;
  for (int x = 0; x < width;) {
    if (moves[x] == 0) {
      to[x] = from[x];
      column[x] = x;
      ++x;
      continue;
    }
    int end = x;
    while (end < width && moves[end] != 0) ++end;
    const int left = x - 1, right = end < width ? end : -1;
    const bool takes_right =
        right >= 0 && (left < 0 || CleanDepth(from[right]) > CleanDepth(from[left]));
    const int source = takes_right ? right : left;
    for (; x < end; ++x) {
      column[x] = source < 0 ? x : source;
      to[x] = from[column[x]];
    }
  }
}

void DrawOverRow(const ImageView& drawn, bool linear, int y, const MutableImageView& out) {
  const auto load = [&](PixelFormat format, const void* pixel) {
    return linear ? LoadHdr(format, pixel) : LoadRgb(format, pixel);
  };
  for (int x = 0; x < out.width; ++x) {
    const void* pixel = drawn.At(x, y);
    const float alpha = LoadChannel(drawn.format, pixel, 3) * (1.0f / ChannelScale(drawn.format));
    if (!(alpha > 0)) continue;
    const Rgb over = load(drawn.format, pixel);
    Rgb color = load(out.format, out.At(x, y));
    for (int c = 0; c < 3; ++c) color.c[c] += std::min(alpha, 1.0f) * (over.c[c] - color.c[c]);
    StoreRgb(color, out.format, out.At(x, y));
  }
}

}  // namespace warplut::generation
