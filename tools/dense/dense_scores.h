// Displays judged as an eye sees them: four subframes integrated, against the same integral of
// ideal frames.
#pragma once

#include <string>
#include <vector>

#include "datasets/frame.h"
#include "tools/judge/images/compare.h"

namespace warplut {

// Gradients of luma from which a pixel that stands still is a static edge.
inline constexpr double kStaticEdge = 0.1;

// Scores of one display. An eye integrates kSlowStep subframes, those of one frame at 60 Hz.
//   fixed     the eye rests: means of the frames as they are
//   tracking  the eye follows what moves: each frame is read where the surface of each pixel of the
//             last subframe was, by Catmull-Rom and the composed motion of the reference
struct DenseScores {
  std::string display;
  int samples_per_pixel = 0;  // in kSlowStep subframes
  FrameScore fixed, tracking;
  // Of the single subframes along the motion (train/metrics/temporal_error.h).
  double temporal_error = 0;
  // The root mean over static edges of the variance in time of the luma's error; NaN where there is
  // none. A static edge stands still in all frames and has a gradient of kStaticEdge in the mean of
  // the references.
  double static_flicker = 0;
};

// The ideal frames of consecutive subframes and what is made of them once.
class DenseJudge {
 public:
  // As many as a multiple of kSlowStep, at least 2 of them; frames with all three references.
  explicit DenseJudge(std::vector<Frame> references);

  // Of the frames shown in the same subframes.
  DenseScores Judge(const std::vector<Image>& shown) const;

  // The integrals over subframes kSlowStep k to kSlowStep k + 3.
  Image Fixed(const std::vector<Image>& shown, int k) const;
  Image Tracking(const std::vector<Image>& shown, int k) const;
  int Integrals() const;
  // The ideal frames as if they were shown.
  const std::vector<Image>& Ideal() const { return ideal_; }

 private:
  double TemporalErrorOf(const std::vector<Image>& shown) const;
  double StaticFlickerOf(const std::vector<Image>& shown) const;

  std::vector<Frame> references_;
  std::vector<Image> ideal_;
  std::vector<Image> motion_;              // from each subframe to the last of its integral
  std::vector<std::size_t> static_edges_;  // pixels
};

}  // namespace warplut
