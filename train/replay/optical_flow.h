// Motion found in the colours of two frames, for methods that are not given any: dense inverse
// search (Kroeger et al., Fast Optical Flow using Dense Inverse Search, ECCV 2016), OpenCV's,
// preset "medium".
#pragma once

#include <memory>

#include "runtime/color_encoding.h"
#include "runtime/image_view.h"

namespace warplut {

class OpticalFlow {
 public:
  // For frames of one size and encoding. OpenCV runs on one thread from then on: its pieces depend
  // on the number of threads, and with them its bits.
  OpticalFlow(int width, int height, ColorEncoding encoding);
  ~OpticalFlow();

  // The motion of each pixel of `now` since `before`, in pixels: it was seen at p - m. Both are
  // taken as displayed, as luma of 8 bits; channels that are not finite count as 0. All motion is
  // finite; that of images whose sides are shorter than kLeastFlowSize is 0.
  void Find(const ImageView& before, const ImageView& now, const MutableMotionView& motion);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

inline constexpr int kLeastFlowSize = 16;  // two patches of the search

}  // namespace warplut
