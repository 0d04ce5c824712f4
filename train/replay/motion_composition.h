// Motion over several frames, put together from the motion of each.
#pragma once

#include <span>

#include "datasets/frame.h"

namespace warplut {

// Motion and depth of one frame, on one grid. Pixel (i, j) was sampled at
// (i + 0.5 + offset.x, j + 0.5 + offset.y), in pixels of this grid.
struct MotionField {
  const Image* motion = nullptr;  // 2 channels, pixels of the grid, from the frame before
  const Image* depth = nullptr;   // 1 channel, of the same size; null: unknown
  Vec2 offset = {};               // the jitter on the render grid, zero on the output grid
};

// The motion of fields[0] from the frame `fields.size()` before it, in its pixels; fields[k] is k
// frames before fields[0]:
//   M_0 = m_0(p),  M_k = M_(k-1) + m_k(p - M_(k-1))
// Where sizes differ (dynamic resolution), positions and motion are scaled from one grid to the
// other.
//
// m_k is read bilinearly between those of the four nearest texels that show the surface of p: whose
// depth differs from the depth where it was read last by at most kSameSurface, or all four if depth
// is unknown. Where none does, the surface was hidden and the nearest texel is read: on recorded
// sequences that was 0.1 dB better than to let the surface go on as it moved. Positions outside the
// image read its border. Texels whose motion is not finite have no part; where m_0(p) or all of
// four are not finite, M is NaN.
//
// Computed in double, in rows on all threads; the result does not depend on their number.
Image ComposeMotion(std::span<const MotionField> fields);

}  // namespace warplut
