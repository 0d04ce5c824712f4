// NaN and infinite texels of float images spread over what is warped from them: there the warp is
// done anew without them.
#pragma once

#include "runtime/image_view.h"
#include "runtime/warp.h"

namespace warplut::generation {

// Row y of `warped`, which came of `color` and `motion`: pixels with a channel that is not finite
// are computed again by the formula of the warp with such channels of the texels as 0; with a
// prefilter they are copies, and become 0. Does nothing for RGBA8.
void RepairRow(const ImageView& color, const MotionView& motion, const WarpOptions& options, int y,
               const MutableImageView& warped);

}  // namespace warplut::generation
