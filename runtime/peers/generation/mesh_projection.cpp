#include "runtime/peers/generation/mesh_projection.h"

#include "runtime/core/instruction_sets.h"
#include "runtime/motion_tiles.h"
#include "runtime/peers/generation/generation_peer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/peers/generation/mesh_projection.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/peers/generation/mesh_projection-inl.h"
#endif

#ifndef WARPLUT_RUNTIME_PEERS_MESH_PROJECTION_ONCE
#define WARPLUT_RUNTIME_PEERS_MESH_PROJECTION_ONCE
namespace warplut::peers {
namespace {

RowRange PlaceVertexRowReference(const GenerationJob& job, int y, const MutableMotionView& buffer) {
  return PlaceVertices(job, y, buffer, [](const GenerationJob& of, int x0, int x1, int y0, int y1) {
    return SteepestPixel(of.depth1, x0, x1, y0, y1);
  });
}

void DrawQuadRowReference(const GenerationJob& job, const MotionView& buffer, int y,
                          RowRange target, const KeyView& keys) {
  DrawQuads(job, buffer, y, target, keys, DrawTriangleRows);
}

void ProjectedMotionRowReference(const GenerationJob& job, const Arrivals& arrivals, int y,
                                 const MutableMotionView& from0, const MutableMotionView& from1,
                                 std::uint8_t* disoccluded) {
  const VertexGrid grid(job, arrivals.forward);
  for (int x = 0; x < job.width(); ++x) {
    const TargetMotion motion = ProjectedMotionAt(job, grid, arrivals.keys, x, y);
    StoreMotion(job, motion, x, y, from0, from1, disoccluded);
  }
  if (job.still_column != nullptr) AvoidMoving(job, y, 0, job.width(), from1);
}

RowKernels ReferenceProjectionKernels(const RowKernels& own) {
  return MeshKernels(own, PlaceVertexRowReference, DrawQuadRowReference,
                     ProjectedMotionRowReference);
}

}  // namespace
}  // namespace warplut::peers
#endif  // WARPLUT_RUNTIME_PEERS_MESH_PROJECTION_ONCE

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

RowKernels ProjectionKernelsOfTarget(const RowKernels& own) {
#if HWY_TARGET == HWY_SCALAR
  return ReferenceProjectionKernels(own);  // without vectors the formulas are the kernels
#else
  return MeshKernels(own, PlaceVertexRow, DrawQuadRow, ProjectedMotionRow);
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {
namespace peers {

HWY_EXPORT(ProjectionKernelsOfTarget);

static RowKernels FastProjectionKernels(const RowKernels& own) {
  return HWY_DYNAMIC_DISPATCH(ProjectionKernelsOfTarget)(own);
}

}  // namespace peers

const GenerationPeer kMeshProjection = {peers::ReferenceProjectionKernels,
                                        peers::FastProjectionKernels, peers::VertexGrid::Bytes};

}  // namespace warplut
#endif  // HWY_ONCE
