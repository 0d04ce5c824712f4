// Measures a pipeline on clips: its error, and the processor time that it takes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "runtime/executor.h"
#include "tools/judge/sequence_scores.h"
#include "tools/profile/profiled_pipeline.h"

namespace warplut {

// One sequence in memory. Its frames are loaded on its owner, which judges it, and on the root,
// which measures times; elsewhere they are missing.
struct ProfileClip {
  Clip input;  // what pipelines run on
  // What they are judged by: streams of the output grid, motion from frame to frame. Without
  // references, what the full pipeline shows of `input`, and no temporal error without depth and
  // motion.
  Clip truth;
  bool has_reference = true;
  int owner = 0;  // the rank that judges it

  bool IsLoaded() const { return !input.frames.empty(); }
};

// Judged frames of one clip.
struct PipelineScore {
  FrameScore mean;
  double temporal_error = 0;  // NaN where no pair of frames has one
};

// Ratios of processor times, one for each pass over the clips.
struct TimeRatio {
  double median = 0, low = 0, high = 0;
};

// Ratio of the times of one pipeline to those of another, pass by pass; both have the same number,
// at least 1, of positive times.
TimeRatio RatioOf(const std::vector<double>& times, const std::vector<double>& to);

// Shares its work among Ranks::World(): the constructor, Judge, OfEach and Time are collective
// calls, and every rank receives what they return.
class PipelineMeter {
 public:
  // `full`: what clips without references take them from. `options`: times and format of shown
  // frames. Runs that are judged use `threads` threads (0: one per core), runs that are timed one.
  // `check` is called for every frame that is shown; what it throws ends the run.
  PipelineMeter(std::vector<ProfileClip> clips, const ProfiledPipeline& full,
                const ModeRunOptions& options, int threads, std::function<void()> check);

  // One run over one of the clips.
  void Run(const ProfiledPipeline& pipeline, const ProfileClip& clip, const ShownFrameSink& sink);

  // Of each clip, by its owner: the same for any number of ranks. An Error if a clip does not fit,
  // or no frame of it can be judged.
  std::vector<PipelineScore> Judge(const ProfiledPipeline& pipeline);

  // Milliseconds of processor time that the passes of each pipeline take for a frame that it makes,
  // mean over the clips: [pipeline][pass]. One thread of the root, while the other ranks rest; the
  // pipelines take turns, so that what disturbs one pass disturbs all of them alike. The first
  // frame that a run makes does not count if there are more, and neither does what lies outside of
  // the passes' bands.
  std::vector<std::vector<double>> Time(std::span<const ProfiledPipeline* const> pipelines,
                                        int passes);

  // numbers_of(clip) of each clip, by its owner.
  std::vector<std::vector<double>> OfEach(
      const std::function<std::vector<double>(const ProfileClip&)>& numbers_of);

 private:
  void UseOutputAsReference(const ProfiledPipeline& full);
  double TimeOnce(const ProfiledPipeline& pipeline, const Clip& clip);

  std::vector<ProfileClip> clips_;
  ModeRunOptions options_;
  ThreadPool pool_;
  std::function<void()> check_;
};

}  // namespace warplut
