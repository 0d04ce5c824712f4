// Windowed sincs of six taps per axis: filters to compare with, plain and slow.
//
// Taps -2..3, those of the contract's window; the fraction d is in [0, 1]. The weights of an axis
// are divided by their sum. d = 0 gives the texel itself.
#pragma once

#include <array>

#include "luts/wide_kernel.h"
#include "tools/judge/images/plain_warp.h"

namespace warplut {

inline constexpr int kSixTaps = kWindowTaps;
inline constexpr int kFirstOfSix = kFirstWindowTap;
using SixTaps = WindowTaps<float>;

// sinc(t) sinc(t / 3), t = d - tap in pixels, sinc(t) = sin(pi t) / (pi t). Source: Duchon 1979.
SixTaps LanczosTaps(float d);

// The Kaiser-windowed sinc (luts/wide_kernel.h); b in [0, kLargestKaiser].
SixTaps KaiserSixTaps(float b, float d);

// Six by six texels around the cell of texel (x, y).
inline PlainTexel Sum36(const PlainHistory& history, int x, int y, const SixTaps& wx,
                        const SixTaps& wy) {
  PlainTexel sum;
  for (int j = 0; j < kSixTaps; ++j) {
    PlainTexel row;
    for (int i = 0; i < kSixTaps; ++i) {
      row.Add(wx[static_cast<std::size_t>(i)],
              history.At(x + i + kFirstOfSix, y + j + kFirstOfSix));
    }
    sum.Add(wy[static_cast<std::size_t>(j)], row);
  }
  return sum;
}

}  // namespace warplut
