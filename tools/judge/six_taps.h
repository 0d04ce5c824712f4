// Windowed sincs of six taps per axis: filters to compare with, plain and slow.
//
// Taps -2..3, counted from the texel at or before the position; the fraction d is in [0, 1]. The
// weights of an axis are divided by their sum. d = 0 gives the texel itself.
#pragma once

#include <array>

#include "tools/judge/plain_warp.h"

namespace warplut {

inline constexpr int kSixTaps = 6;
inline constexpr int kFirstOfSix = 1 - kSixTaps / 2;
using SixTaps = std::array<float, kSixTaps>;

// sinc(t) sinc(t / 3), t = d - tap in pixels, sinc(t) = sin(pi t) / (pi t). Source: Duchon 1979.
SixTaps LanczosTaps(float d);

// sinc(t) I0(b sqrt(1 - (t / 3)^2)) / I0(b), I0 the modified Bessel function of order 0. b = 0 is
// the truncated sinc; a larger one is blurrier. b in [0, kLargestKaiser]. Source: Kaiser 1974.
SixTaps KaiserTaps(float b, float d);
inline constexpr float kLargestKaiser = 32;

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
