#include "tools/profile/tile_shares.h"

namespace warplut {

namespace {

void Append(const FrameTiles& tiles, std::vector<double>& numbers) {
  numbers.push_back(static_cast<double>(tiles.total));
  for (const std::int64_t count : tiles.warped.tiles) {
    numbers.push_back(static_cast<double>(count));
  }
  numbers.push_back(static_cast<double>(tiles.disoccluded));
}

FrameTiles Take(const std::vector<double>& numbers, std::size_t& at) {
  const auto next = [&] { return static_cast<std::int64_t>(numbers.at(at++)); };
  FrameTiles tiles;
  tiles.total = next();
  for (std::int64_t& count : tiles.warped.tiles) count = next();
  tiles.disoccluded = next();
  return tiles;
}

}  // namespace

std::vector<TileShares> CountTiles(PipelineMeter& meter, const ProfiledPipeline& pipeline) {
  const auto counts = meter.OfEach([&](const ProfileClip& clip) {
    TileShares sum;
    meter.Run(pipeline, clip, [&](const ShownFrame& shown) {
      (shown.generated ? sum.generated : sum.history) += shown.tiles;
    });
    std::vector<double> numbers;
    Append(sum.history, numbers);
    Append(sum.generated, numbers);
    return numbers;
  });
  std::vector<TileShares> shares;
  for (const std::vector<double>& numbers : counts) {
    std::size_t at = 0;
    TileShares& share = shares.emplace_back();
    share.history = Take(numbers, at);
    share.generated = Take(numbers, at);
  }
  return shares;
}

TimeRatio TimeByTiles(PipelineMeter& meter, const ProfiledPipeline& pipeline, int passes) {
  ProfiledPipeline general = pipeline;
  WarpOptions warp = pipeline.warp();
  warp.general_only = true;
  general.SetWarp(warp);
  const ProfiledPipeline* const timed[] = {&pipeline, &general};
  const auto times = meter.Time(timed, passes);
  return RatioOf(times[0], times[1]);
}

double Share(const WarpStats& warped, MotionKind kind) {
  std::int64_t total = 0;
  for (const std::int64_t tiles : warped.tiles) total += tiles;
  return total > 0 ? static_cast<double>(warped[kind]) / static_cast<double>(total) : 0;
}

}  // namespace warplut
