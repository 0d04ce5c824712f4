// Frames of a sequence as they are stored: what its convention is found from.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "datasets/sequence/sequence.h"

namespace warplut {

// One frame. Images that the sequence lacks or that cannot be loaded are empty.
struct InspectedFrame {
  int index = 0;
  bool cut = false;  // it shares nothing with the frame before, or the frame before is not loaded
  Vec2 jitter;       // as the manifest says
  Image luma;        // render grid, as displayed, smoothed (binomial 3 x 3): 1 channel
  Image sharp_luma;  // the same, not smoothed
  Image motion;      // as stored, before scale and bias; 2 channels
  Image depth;       // as stored, before scale and bias; 1 channel
  Image reference;   // output grid, luma as displayed: 1 channel
  bool Follows(const InspectedFrame& before) const { return !cut && index == before.index + 1; }
};

struct InspectedClip {
  GridSize render, output;
  std::vector<InspectedFrame> frames;  // ascending
};

// How many frames the questions are asked of. Of a longer sequence runs of kRunFrames consecutive
// frames are taken, evenly spread.
inline constexpr int kInspectedFrames = 16;
inline constexpr int kRunFrames = 4;

std::vector<int> InspectedIndices(int count);

// The sequence with its motion and depth described as plain numbers, so that LoadFrame returns what
// the files hold. Without cameras, which would fill gaps.
Sequence AsStored(const Sequence& sequence);

// Loads frames on all threads. `on_frame` is called by this thread after each batch, with how many
// frames were loaded.
InspectedClip LoadInspectedClip(const Sequence& sequence,
                                const std::function<void(int)>& on_frames);

// Frames of a sequence one after the other: those of a clip, and those that it lacks, loaded as
// they are asked for. The last four stay in memory.
class InspectedWindow {
 public:
  InspectedWindow(const Sequence& sequence, const InspectedClip& clip);
  const InspectedFrame& At(int index);

 private:
  const Sequence& sequence_;
  Sequence stored_;
  const InspectedClip& clip_;
  std::deque<InspectedFrame> loaded_;
};

// The luma, as displayed, of R, G, B. Weights of Rec. 709.
Image DisplayLuma(const Image& color, bool linear);

// The binomial filter (1, 2, 1) / 4 in both axes, edges repeated, of 1 channel.
Image Smoothed(const Image& luma);

// The value at (x, y), in texels from the centre of the first, of 1 channel; bilinear, NaN outside
// the centres of the edge.
float BilinearAt(const Image& image, double x, double y);

}  // namespace warplut
