#include "tools/profile/tile_shares.h"

namespace warplut {

std::vector<TileShares> CountTiles(PipelineMeter& meter, const ProfiledPipeline& pipeline) {
  std::vector<TileShares> shares;
  for (const ProfileClip& clip : meter.clips()) {
    TileShares& sum = shares.emplace_back();
    meter.Run(pipeline, clip, [&](const ShownFrame& shown) {
      (shown.generated ? sum.generated : sum.history) += shown.tiles;
    });
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
