// The HUD of a sequence, drawn over the frames that are shown of it.
#pragma once

#include "datasets/sequence/sequence.h"
#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "train/replay/mode_run.h"

namespace warplut {

class HudLayer {
 public:
  // Of the frames of the sequence from index `first` on. Both outlive the object.
  HudLayer(const Sequence& sequence, int first, Executor& executor);

  // The frame with the HUD of the nearest frame in time over it (of two, the later); without change
  // where the sequence has none. The image ends at the next call. An Error where the HUD cannot be
  // read, or the frame is not on the output grid.
  ShownFrame Over(const ShownFrame& shown);

 private:
  const Sequence& sequence_;
  int first_;
  Executor& executor_;
  int loaded_ = -1;  // index of the frame whose HUD is in hud_
  ImageBuffer hud_, drawn_;
};

}  // namespace warplut
