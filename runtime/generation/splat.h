// The first two passes: where the pixels of frame 1 go, and which of them is kept at the pixels of
// the generated frame.
#pragma once

#include "runtime/generation/generation_job.h"

namespace warplut::generation {

// Displacement of pixel (x, y) of frame 1 to the generated frame; NaN where it has no motion.
//
// m0 is read at the pixel of frame 0 nearest to p1 - m1, and counts as far as Gate of the depth
// difference there says: m0 = m1 + gate (m0 - m1). Outside of the image, and where it is not
// finite, m0 = m1.
Vector ForwardDisplacement(const GenerationJob& job, int x, int y);

RowRange ForwardRowReference(const GenerationJob& job, int y, const MutableMotionView& forward);
void SplatRowReference(const GenerationJob& job, const MotionView& forward, int y, RowRange target,
                       const KeyView& keys);

}  // namespace warplut::generation
