// Values of an image between its pixels: those of samples of the continuous scene, if the image
// shows all detail of the scene.
#pragma once

#include <span>

#include "train/fit/rollout/stencil.h"

namespace warplut {

// The interpolation kernel is sinc(t) sinc(t / kSincLobes) for |t| < kSincLobes, its weights
// divided by their sum: the identity at pixel centres, and flat to about 0.44 cycles per pixel.
inline constexpr int kSincLobes = 8;

// values[j * xs.size() + i] = the image at position (xs[i], ys[j]), in pixels with centres at
// + 1/2, limited to [0, 1]. Beyond the image its edge pixels repeat. `values` holds xs.size() *
// ys.size().
void SampleBandLimited(const BorderedPlane& image, std::span<const double> xs,
                       std::span<const double> ys, std::span<float> values);

}  // namespace warplut
