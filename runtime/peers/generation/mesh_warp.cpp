#include "runtime/peers/generation/mesh_warp.h"

#include "runtime/core/instruction_sets.h"
#include "runtime/motion_tiles.h"
#include "runtime/peers/generation/generation_peer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/peers/generation/mesh_warp.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/peers/generation/mesh_warp-inl.h"
#endif

#ifndef WARPLUT_RUNTIME_PEERS_MESH_WARP_ONCE
#define WARPLUT_RUNTIME_PEERS_MESH_WARP_ONCE
namespace warplut::peers {
namespace {

void DrawRowReference(const GenerationJob& job, const MotionView& forward, int y, RowRange target,
                      const KeyView& keys) {
  if (y + 1 >= job.height()) return;
  const DepthTolerance tolerance(job);
  for (int x = 0; x + 1 < job.width(); ++x) {
    DrawQuad(job, forward, tolerance, x, y, target, keys);
  }
}

void MeshMotionRowReference(const GenerationJob& job, const Arrivals& arrivals, int y,
                            const MutableMotionView& from0, const MutableMotionView& from1,
                            std::uint8_t* disoccluded) {
  for (int x = 0; x < job.width(); ++x) {
    const TargetMotion motion = MeshMotionAt(job, arrivals, x, y);
    StoreMotion(job, motion, x, y, from0, from1, disoccluded);
  }
}

RowKernels ReferenceMeshKernels(const RowKernels& own) {
  return MeshKernels(own, MeshForwardRow, DrawRowReference, MeshMotionRowReference);
}

}  // namespace
}  // namespace warplut::peers
#endif  // WARPLUT_RUNTIME_PEERS_MESH_WARP_ONCE

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

RowKernels MeshKernelsOfTarget(const RowKernels& own) {
#if HWY_TARGET == HWY_SCALAR
  return ReferenceMeshKernels(own);  // without vectors the formulas are the kernels
#else
  return MeshKernels(own, MeshForwardRow, DrawRow, MeshMotionRow);
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {
namespace peers {

HWY_EXPORT(MeshKernelsOfTarget);

static RowKernels FastMeshKernels(const RowKernels& own) {
  return HWY_DYNAMIC_DISPATCH(MeshKernelsOfTarget)(own);
}

}  // namespace peers

const GenerationPeer kMeshWarp = {peers::ReferenceMeshKernels, peers::FastMeshKernels};

}  // namespace warplut
#endif  // HWY_ONCE
