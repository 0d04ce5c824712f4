// What a method shows, against the reference of the sequence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/judge/images/compare.h"
#include "train/metrics/jitter_error.h"
#include "train/metrics/temporal_error.h"
#include "train/replay/mode_run.h"

namespace warplut {

inline constexpr int kScoreBorder = 5;

// The streams that judging needs: the output grid's.
inline constexpr Streams kTruthStreams = Streams::kOutputGrid;

// Means without the first judged frames, in which a history is still made.
struct SettledScores {
  int left_out = 0;  // how many
  FrameScore mean;
  double temporal_error =
      0;  // RMS over the pairs whose later frame comes after those; NaN if there is none
};

// Errors of luma that the jitter makes, RMS (train/metrics/jitter_error.h). NaN for methods without
// super resolution.
struct JitterScores {
  double repeating = 0;  // JitterErrorSum; NaN without three whole cycles of jitter
  double lattice = 0;    // LatticeEnergy, over judged frames but the first `settled` ones
};

// Judged frames, named by their number; their means; and what the runtime took.
struct SequenceScores {
  std::string method;
  std::vector<FrameScore> frames;
  std::vector<double>
      // of each of `frames`: RMS against the frame before it; NaN where that has no error
      temporal;
  FrameScore mean;
  double temporal_error = 0;  // RMS over all pairs of frames; NaN if there is none
  double milliseconds =
      0;  // mean of the frames that the runtime made, the first left out if there are more
  std::optional<SettledScores> settled;  // if it was asked for
  std::optional<JitterScores> jitter;    // if it was asked for
};

// All of the scores but the method's name, as numbers that one rank sends to another, and back:
// the same scores. Names of frames are their numbers.
std::vector<double> ToNumbers(const SequenceScores& scores);
SequenceScores FromNumbers(const std::string& method, const std::vector<double>& numbers);

// Why there is no JitterScores::repeating for frames [first, first + count) of the sequence, by
// index; empty if there is.
std::string WhyNoJitterError(const Sequence& sequence, int first, int count);

FrameGeometry ReferenceGeometry(const ClipFrame& frame);

// A shown image as it is judged: R, G, B as a display shows them (train/metrics/displayed_color.h).
Image JudgedImage(const ImageView& image, ColorEncoding encoding);

// What a reader of scores of these methods on the sequence must know, one sentence each: what could
// not be judged and which stream it lacks; which frames generation is judged by; in which values
// linear HDR is judged.
std::vector<std::string> JudgingNotes(const Sequence& sequence,
                                      const std::vector<const MethodInfo*>& methods);

// Judges the frames of one run as they are shown. Methods that generate are judged by their
// generated frames, the others by all but the first, which has no history; in both cases by those
// that have a reference. The temporal error is over pairs of neighbouring frames of the clip that
// were both shown, generated or not, judged or not (but not the first of super resolution); a cut
// ends a pair.
class SequenceJudge {
 public:
  // `truth`: a clip with JudgingStreams of the method, its motion from frame to frame (every = 1);
  // it outlives the judge. Where TrueFrameOf has no depth and motion there is no temporal error.
  // `border`: pixels at each edge that do not count. `settled`: how many judged frames
  // SettledScores leave out, at least 0; 0: there are none. `jitter`: make JitterScores, in the
  // memory of JitterErrorSum.
  SequenceJudge(const Clip& truth, const MethodInfo& method, int border = kScoreBorder,
                int settled = 0, bool jitter = false);

  // Error if the image has no true frame of its size or is too small (CompareImages).
  void Add(const ShownFrame& shown);

  // Error if no frame could be judged, or none that is settled.
  SequenceScores Finish() const;

 private:
  void AddJitterError(const Image& error, int frame, bool judged);

  const Clip& truth_;
  const MethodInfo& method_;
  int border_;
  std::size_t settled_;
  SequenceScores scores_;
  TemporalErrorSum temporal_, settled_temporal_;
  int previous_ = -1;     // index of the frame before that was shown
  Image previous_error_;  // its error
  std::vector<double> seconds_;
  bool has_jitter_scores_;
  std::optional<JitterErrorSum> repeating_;
  ErrorEnergy lattice_;
};

}  // namespace warplut
