// What the tiles of the content have in common, and the time that the runtime saves by it.
#pragma once

#include <string>
#include <vector>

#include "runtime/frame_tiles.h"
#include "tools/profile/pipeline_meter.h"

namespace warplut {

// Of one clip, summed over its frames.
struct TileShares {
  FrameTiles history;    // super resolution
  FrameTiles generated;  // frame generation
};

// One element for each clip of the meter.
std::vector<TileShares> CountTiles(PipelineMeter& meter, const ProfiledPipeline& pipeline);

// The time of the pipeline by that of the same without a look at what tiles have in common
// (WarpOptions::general_only).
TimeRatio TimeByTiles(PipelineMeter& meter, const ProfiledPipeline& pipeline, int passes);

// Share of tiles in [0, 1]; 0 where none was warped.
double Share(const WarpStats& warped, MotionKind kind);

}  // namespace warplut
