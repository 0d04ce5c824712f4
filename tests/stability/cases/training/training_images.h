// Extreme images.
#pragma once

#include <cstdint>

#include "datasets/image.h"

namespace warplut {

// Of 1 channel, side x side.
Image ConstantImage(int side, float value);
Image ImpulseImage(int side);  // black but for one white pixel in the middle
Image CheckerboardImage(
    int side);  // black and white pixels in turn: the Nyquist frequency in both axes
Image WhiteNoiseImage(int side, std::uint64_t seed);  // uniform in [0, 1)
Image HdrImage(int side, std::uint64_t seed);         // 1e-4 to 1e4, uniform in the logarithm

}  // namespace warplut
