// A peer of frame generation: the passes that it has of its own.
#pragma once

#include <cstddef>

#include "runtime/frame_generation.h"
#include "runtime/generation/row_kernels.h"
#include "runtime/peers.h"
#include "runtime/pipeline.h"

namespace warplut {

struct GenerationPeer {
  // The kernels of frame generation with those of the peer in their places: slow and obvious, and
  // the same on vectors.
  generation::RowKernels (*reference)(const generation::RowKernels& own);
  generation::RowKernels (*fast)(const generation::RowKernels& own);
  // Null, or the peer takes DisplayedFrame::reprojection: the least bytes of the buffer that others
  // have for displacements.
  std::size_t (*buffer_bytes)(int width, int height) = nullptr;
};

namespace peers {

// The kernels of frame generation with those of a mesh in their places.
inline generation::RowKernels MeshKernels(generation::RowKernels own,
                                          decltype(generation::RowKernels::forward) place,
                                          decltype(generation::RowKernels::splat) draw,
                                          decltype(generation::RowKernels::target_motion) motion) {
  own.forward = place;
  own.splat = draw;
  own.target_motion = motion;
  return own;
}

}  // namespace peers

// Whether the options name a peer that takes DisplayedFrame::reprojection.
inline bool Projects(const FrameGenerationOptions& options) {
  return kPipeline.peers && options.peer != nullptr && options.peer->buffer_bytes != nullptr;
}

}  // namespace warplut
