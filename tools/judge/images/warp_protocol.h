// The protocols that resampling filters are judged by: an image is warped again and again along a
// trajectory that ends where it began, and compared with what it was.
//
// After each warp the values are clamped to [0, 1]. The score is the mean SSIM
// (train/metrics/ssim.h) against the original, over the image without kProtocolBorder pixels at
// each edge, where repeated edge texels are no fault of the filter. Source: Mob-FGSR, figure 4b
// (six warps by half a pixel); random offsets and longer runs are ours.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "datasets/image.h"
#include "train/fit/rollout/trajectory.h"
#include "train/metrics/ssim.h"

namespace warplut {

inline constexpr int kProtocolBorder = 16;
// The smallest side of an image that can be judged.
inline constexpr int kProtocolMinSide = 2 * kProtocolBorder + kSsimWindow;
// Offsets of random trajectories are multiples of 1 / kProtocolSteps of a pixel: any offset, for
// every purpose.
inline constexpr int kProtocolSteps = 1 << 16;

// "6 half"
std::string Name(const Protocol& protocol);

// What is judged: a name, and one warp. `warp(in, v, out)` makes out(p) = in(p - v) for 1-channel
// images of the same size; it may be called by several threads at once.
struct ProtocolFilter {
  std::string name;
  std::function<void(const Image& in, const Displacement& v, Image& out)> warp;
};

struct ProtocolOptions {
  int trajectories = 3;    // random ones for each image
  std::uint64_t seed = 1;  // of the random trajectories
  // Called after each trajectory with its number of warps, by any thread; what it throws ends the
  // evaluation.
  std::function<void(int warps)> on_warps;
};

// The image after the warps of a trajectory, clamped after each.
Image WarpAlong(const ProtocolFilter& filter, std::span<const Displacement> trajectory,
                const Image& image);

// The image after `warps` warps of the given trajectory of image number `index`
// (clamped after each warp).
Image WarpRepeatedly(const ProtocolFilter& filter, const Protocol& protocol, const Image& image,
                     std::size_t index, int trajectory, std::uint64_t seed);

// How many warps an evaluation of `images` images makes.
double ProtocolWarps(const Protocol& protocol, const ProtocolOptions& options, std::size_t images);

// The mean over images, and over the trajectories of each, of the score. Images have 1 channel and
// sides of at least kProtocolMinSide (not checked). The same bits for any number of threads.
double ProtocolScore(const ProtocolFilter& filter, const Protocol& protocol,
                     const std::vector<Image>& images, const ProtocolOptions& options);

}  // namespace warplut
