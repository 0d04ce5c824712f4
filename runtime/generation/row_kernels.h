// The passes, a row at a time: the plain version of each and the one with vectors, which gives the
// same bits.
//
// Rows are independent of each other within a pass, and each pass reads only what the passes before
// it have finished: any distribution of rows over threads gives the same result.
#pragma once

#include "runtime/generation/blend.h"
#include "runtime/generation/generation_job.h"
#include "runtime/generation/hdr_rows.h"
#include "runtime/generation/motion/target_motion.h"
#include "runtime/generation/splat.h"

namespace warplut::generation {

struct RowKernels {
  // Writes the forward displacements of row y of frame 1 into `forward`. Nothing arrives outside of
  // the rows it returns.
  RowRange (*forward)(const GenerationJob& job, int y, const MutableMotionView& forward);
  // Adds what of row y of frame 1 arrives at `target` rows to the keys of these.
  void (*splat)(const GenerationJob& job, const MotionView& forward, int y, RowRange target,
                const KeyView& keys);
  // Writes row y of the target motion; from0 is left alone if the job extrapolates. Marks the tiles
  // with filled pixels.
  void (*target_motion)(const GenerationJob& job, const Arrivals& arrivals, int y,
                        const MutableMotionView& from0, const MutableMotionView& from1,
                        std::uint8_t* disoccluded);
  // The same without splatting, from the forward displacements in from1.
  void (*own_motion)(const GenerationJob& job, int y, const MutableMotionView& from0,
                     const MutableMotionView& from1);
  // Writes row y of the output.
  void (*blend)(const GenerationJob& job, const WarpedFrames& warped, int y,
                const MutableImageView& out);
  // Row y of linear HDR to codes, and back (runtime/generation/hdr_rows.h).
  void (*encode_hdr)(const ImageView& linear, int y, const MutableImageView& to);
  void (*decode_hdr)(const ImageView& codes, int y, const MutableImageView& to);
};

// Null for passes that the build does not contain.
RowKernels ReferenceRowKernels();
RowKernels FastRowKernels();

}  // namespace warplut::generation
