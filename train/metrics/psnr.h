// Peak signal-to-noise ratio of images with values in [0, 1].
#pragma once

#include "datasets/image.h"

namespace warplut {

// Mean squared difference over all pixels at least `border` from each edge, and all channels; in
// double precision. Both images have the same size and channels, and pixels are left within the
// border (not checked).
double MeanSquaredError(const Image& a, const Image& b, int border = 0);

// 10 log10(1 / mean squared error) in dB; +infinity for equal images.
double Psnr(double mean_squared_error);

}  // namespace warplut
