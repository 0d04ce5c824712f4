// The coefficients of displayed frames, where the filter of frame generation has a prefilter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "runtime/executor.h"
#include "runtime/frame_generation.h"
#include "runtime/image_buffer.h"
#include "runtime/prefilter.h"

namespace warplut::generation {

// Holds those of two frames, so that a frame is filtered once for all that is generated from it.
class FrameCoefficients {
 public:
  FrameCoefficients() = default;
  // Allocates what Of needs. `prefilter` is not none.
  FrameCoefficients(const Prefilter& prefilter, const FrameGenerationOptions& options, int threads);

  // Whether there is a prefilter.
  explicit operator bool() const { return pass_ != nullptr; }

  // A colour and the id of its frame (DisplayedFrame::id).
  struct Source {
    ImageView samples;
    std::uint64_t id = 0;
  };

  // The two with their coefficients: those that are kept of a frame with an id, or new ones. Valid
  // until the next call.
  std::array<PrefilteredImage, 2> OfBoth(const Source& frame0, const Source& frame1,
                                         Executor& executor);
  PrefilteredImage Of(const Source& frame, Executor& executor);

  std::size_t bytes() const;

 private:
  struct Slot {
    RowBuffer rows;
    std::uint64_t id = 0;  // of the frame that it holds; 0: of none that can be found again
  };

  int Find(std::uint64_t id) const;  // the slot that holds the frame, or -1
  PrefilteredImage Fill(Slot& slot, const Source& frame, Executor& executor);

  bool reference_ = false;
  Prefilter prefilter_;
  std::unique_ptr<PrefilterPass> pass_;
  std::array<Slot, 2> slots_;
};

}  // namespace warplut::generation
