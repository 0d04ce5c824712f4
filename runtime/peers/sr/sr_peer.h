// A peer of super resolution: the passes that it has of its own.
#pragma once

#include "runtime/peers.h"
#include "runtime/sr/passes.h"

namespace warplut {

struct SrPeerPasses {
  // SrPasses::update. The prediction is not limited; its alpha is the validity. With keeps_state,
  // SrJob::next_state comes as that of the frame before, where the history comes from.
  decltype(SrPasses::update) update;
  // Null, or what is done to the rows [begin, end) of a band that were predicted.
  decltype(SrPasses::predict) limit;
};

struct SrPeer {
  Filter filter;     // of the history, whatever the options say
  bool keeps_state;  // four halves for each output pixel, in [0, 2], that move with the history
  const SrPeerPasses& (*reference)();  // slow and obvious
  const SrPeerPasses& (*fast)();       // the same on vectors
};

}  // namespace warplut
