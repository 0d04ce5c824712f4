#include "tools/judge/images/warp_protocol.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "tools/judge/images/plane.h"

namespace warplut {
namespace {

int Trajectories(const Protocol& protocol, const ProtocolOptions& options) {
  return protocol.offsets == Offsets::kHalf ? 1 : options.trajectories;
}

// Seeds that differ for every (image, trajectory) of an evaluation.
std::uint64_t TrajectorySeed(std::uint64_t seed, std::size_t image, int trajectory) {
  return (seed << 32) + (static_cast<std::uint64_t>(image) << 8) +
         static_cast<std::uint64_t>(trajectory);
}

}  // namespace

std::string Name(const Protocol& protocol) {
  return std::to_string(protocol.warps) + " " + Name(protocol.offsets);
}

Image WarpAlong(const ProtocolFilter& filter, std::span<const Displacement> trajectory,
                const Image& image) {
  Image current = image;
  Image next(image.width, image.height, 1);
  for (const Displacement& v : trajectory) {
    filter.warp(current, v, next);
    for (float& value : next.data) value = std::clamp(value, 0.0f, 1.0f);
    std::swap(current, next);
  }
  return current;
}

Image WarpRepeatedly(const ProtocolFilter& filter, const Protocol& protocol, const Image& image,
                     std::size_t index, int trajectory, std::uint64_t seed) {
  const std::array<int, 1> horizons = {protocol.warps};
  return WarpAlong(filter,
                   MakeTrajectory(protocol.offsets, horizons, kProtocolSteps,
                                  TrajectorySeed(seed, index, trajectory)),
                   image);
}

double ProtocolWarps(const Protocol& protocol, const ProtocolOptions& options, std::size_t images) {
  return static_cast<double>(protocol.warps) * Trajectories(protocol, options) *
         static_cast<double>(images);
}

double ProtocolScore(const ProtocolFilter& filter, const Protocol& protocol,
                     const std::vector<Image>& images, const ProtocolOptions& options) {
  const auto trajectories = static_cast<std::size_t>(Trajectories(protocol, options));
  std::vector<double> scores(images.size() * trajectories);
  tbb::parallel_for(std::size_t{0}, scores.size(), [&](std::size_t item) {
    const std::size_t index = item / trajectories;
    const Image& image = images[index];
    const Image warped = WarpRepeatedly(filter, protocol, image, index,
                                        static_cast<int>(item % trajectories), options.seed);
    scores[item] =
        Ssim(InnerPlane(image, kProtocolBorder)).Mean(InnerPlane(warped, kProtocolBorder));
    if (options.on_warps) options.on_warps(protocol.warps);
  });
  double sum = 0;
  for (const double score : scores) sum += score;
  return sum / static_cast<double>(scores.size());
}

}  // namespace warplut
