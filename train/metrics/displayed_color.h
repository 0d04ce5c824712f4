// Colour as a display shows it. Images are judged and losses computed in it.
#pragma once

#include <algorithm>

#include "datasets/srgb_curve.h"
#include "datasets/tone_map.h"
#include "runtime/color_encoding.h"

namespace warplut {

// (r, g, b) to display values, in place. kDisplay: as it is. kLinearHdr: limited (LimitHdr),
// tone-mapped by 1 / (1 + largest channel), then the sRGB curve; so 1 is shown as 0.735, and no
// exposure is chosen for the content.
inline void ToDisplay(ColorEncoding encoding, float* rgb) {
  if (encoding == ColorEncoding::kDisplay) return;
  for (int c = 0; c < 3; ++c) rgb[c] = LimitHdr(rgb[c]);
  const float factor = ToneMapFactor(std::max({rgb[0], rgb[1], rgb[2]}));
  for (int c = 0; c < 3; ++c) rgb[c] = SrgbCurve(rgb[c] * factor);
}

}  // namespace warplut
