#include "runtime/peers/generation/bidirectional.h"

#include "runtime/core/instruction_sets.h"
#include "runtime/peers/generation/generation_peer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/peers/generation/bidirectional.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/peers/generation/bidirectional-inl.h"
#endif

#ifndef WARPLUT_RUNTIME_PEERS_BIDIRECTIONAL_ONCE
#define WARPLUT_RUNTIME_PEERS_BIDIRECTIONAL_ONCE
namespace warplut::peers {
namespace {

// Displacements of frame 1 alone are not read.
RowRange NoForwardRow(const GenerationJob& /*job*/, int /*y*/,
                      const MutableMotionView& /*forward*/) {
  return {0, 0};
}

RowKernels BidirectionalKernels(RowKernels own, decltype(RowKernels::own_motion) motion) {
  own.forward = NoForwardRow;
  own.own_motion = motion;
  return own;
}

RowKernels ReferenceBidirectionalKernels(const RowKernels& own) {
  return BidirectionalKernels(own, BidirectionalRowReference);
}

}  // namespace
}  // namespace warplut::peers
#endif  // WARPLUT_RUNTIME_PEERS_BIDIRECTIONAL_ONCE

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

RowKernels BidirectionalKernelsOfTarget(const RowKernels& own) {
#if HWY_TARGET == HWY_SCALAR
  return ReferenceBidirectionalKernels(own);  // without vectors the formulas are the kernels
#else
  return BidirectionalKernels(own, BidirectionalRow);
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {
namespace peers {

HWY_EXPORT(BidirectionalKernelsOfTarget);

static RowKernels FastBidirectionalKernels(const RowKernels& own) {
  return HWY_DYNAMIC_DISPATCH(BidirectionalKernelsOfTarget)(own);
}

}  // namespace peers

const GenerationPeer kBidirectional = {peers::ReferenceBidirectionalKernels,
                                       peers::FastBidirectionalKernels};

}  // namespace warplut
#endif  // HWY_ONCE
