// What a worker of frame generation owns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/core/band.h"
#include "runtime/frame_tiles.h"
#include "runtime/image_buffer.h"
#include "runtime/pipeline.h"

namespace warplut::generation {

// What one worker needs for one band; frame 0 counts in interpolation alone.
struct BandBuffers {
  explicit BandBuffers(int width)
      : color1(static_cast<std::size_t>(width) * BytesPerPixel(kColorFormat), kBandRows),
        from1(width, kBandRows),
        disoccluded(static_cast<std::size_t>(TileCount(width, kTileWidth))) {
    if constexpr (!kPipeline.interpolation) return;
    color0 = RowBuffer(static_cast<std::size_t>(width) * BytesPerPixel(kColorFormat), kBandRows);
    from0 = MotionBuffer(width, kBandRows);
  }

  std::size_t bytes() const {
    return color0.size() + color1.size() + from0.bytes() + from1.bytes() + disoccluded.size();
  }

  // Of warped pixels, the largest that there are.
  static constexpr PixelFormat kColorFormat = kWarpedFrameFormat.value_or(PixelFormat::kRgba32F);

  RowBuffer color0, color1;
  MotionBuffer from0, from1;
  std::vector<std::uint8_t> disoccluded;  // per tile of a band: 1 where a pixel is filled
  FrameTiles tiles;                       // of the bands that this worker took
};

}  // namespace warplut::generation
