// Training crops: square pieces of the images, as bordered planes.
#pragma once

#include <cstdint>
#include <vector>

#include "datasets/image.h"
#include "train/fit/rollout/stencil.h"

namespace warplut {

inline constexpr int kCropSize = 128;

// `count` crops of `size` x `size` pixels at random places, shared evenly among the images. Flat
// places (sky), where every filter is right, are left out: a crop needs a mean absolute gradient of
// kMinCropGradient, or is the liveliest of several tries. Images are single-channel and at least
// `size` in each axis (not checked). The same arguments give the same crops.
std::vector<BorderedPlane> DrawCrops(const std::vector<Image>& luma, int count, std::uint64_t seed,
                                     int size = kCropSize);

inline constexpr double kMinCropGradient = 0.008;  // per pixel, of values in [0, 1]

}  // namespace warplut
