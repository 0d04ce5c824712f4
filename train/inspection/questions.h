// The questions that frames answer about the convention they are stored in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "train/inspection/convention.h"
#include "train/inspection/inspected_clip.h"
#include "train/inspection/ranking.h"

namespace warplut {

// Motion. Each candidate warps the luma of one frame of every pair of neighbours onto the other at
// about kQuestionPoints pixels; where much of the image rests, at those that do not. The score of a
// pair is -10 log10 of the mean of min(e^2, kOutlier^2) over them; a point outside the image counts
// as an outlier, so that no candidate gains by leaving the image. Where there are fewer than eight
// pairs, each is split into 4 x 4 tiles.
inline constexpr int kQuestionPoints = 16384;
inline constexpr double kOutlier = 0.1;

struct MotionAnswer {
  MotionConvention found;         // that of the manifest where no other one is told from it
  std::vector<Ranking> rankings;  // direction, y, axes, unit, frame
  Verdict verdict = Verdict::kCannotTell;  // on the convention as a whole
  PairedDifference over_stated;            // of the best candidate over the stated one, dB
  PairedDifference over_rest;              // of the found convention over no motion at all, dB
  double largest = 0;               // the 99 % quantile of the length of the found motion, pixels
  std::vector<double> pair_errors;  // mean truncated e^2 of each pair, with the found convention
  std::vector<int> pair_frames;     // index of the later frame of the pair
  std::string reason;               // why nothing is told; empty: something is
};

// `jitter`: one cycle, render pixels; empty: none.
MotionAnswer AskMotion(const Sequence& sequence, const InspectedClip& clip,
                       const std::vector<Vec2>& jitter);

// Jitter, from neighbouring frames warped by `motion`, and from the references: the render-grid
// pixel shows the reference at its centre plus the jitter.
struct JitterAnswer {
  JitterConvention found;
  std::vector<Ranking> rankings;  // of the better evidence: sign, axes, unit, frame
  Verdict verdict = Verdict::kCannotTell;
  PairedDifference over_stated;
  bool from_references = false;  // which evidence
  // Whether the motion has the jitter in it: the slope of its median against the jitter's
  // differences, -1 if it does, 0 if not, from their second differences over frames.
  Ranking contained;
  bool contains_jitter = false;
  // Where the frames lie on their references beside their jitter, render pixels, with standard
  // errors over frames: 0 where the grids are aligned as they should.
  struct Alignment {
    Vec2 offset, standard_error;
  };
  std::optional<Alignment> alignment;
  std::string reason;
};

JitterAnswer AskJitter(const Sequence& sequence, const InspectedClip& clip,
                       const MotionConvention& motion);

// Depth. Its order: what moves away from in front of something uncovers what is farther; a depth
// buffer has nearly all of its values on the side of the far plane. Its curve:
// on planes 1 / view depth is an affine function of the position, view depth is not; and under a
// camera that travels the parallax is one of 1 / view depth (runtime/camera_motion.h).
struct DepthAnswer {
  DepthConvention found;
  Ranking order, curve;
  std::string curve_evidence;  // "planes" or "parallax"
};

DepthAnswer AskDepth(const Sequence& sequence, const InspectedClip& clip,
                     const MotionConvention& motion);

// The motion in pixels of the render grid, y down, from the earlier to the later frame.
Image MotionInPixels(const Image& stored, const MotionConvention& convention, GridSize render,
                     GridSize output);

// The sequence as the answers understand it: what --write writes. Fields that the answers do not
// touch stay as they are.
Sequence WithAnswers(const Sequence& sequence, const MotionAnswer& motion,
                     const JitterAnswer& jitter, const DepthAnswer* depth);

}  // namespace warplut
