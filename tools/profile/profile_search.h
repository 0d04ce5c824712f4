// The search for the cheapest pipeline within a bound on the error.
//
// 1. Each omission alone, against the full pipeline.
// 2. In rounds: of the omissions that are left the one with the greatest saving, whose error
//    together with those that are taken stays within the bound, is taken too. What does not stay
//    within it is not tried again; what saves less than can be measured waits.
// 3. What waits and adds no error at all is taken if it is not slower: a pass that is not there has
//    no code and no parameters.
// 4. On all frames: while the error is beyond the bound, what was taken last is given back.
//
// The error is the loss of SSIM, the mean over the judged frames, on the clip where it is greatest;
// it has the same bits on every machine with the same instructions. Times vary: a saving counts as
// measured where its median over kRoundPasses passes is at least kLeastSaving of the full time and
// every pass agrees on its sign. Savings are compared in steps of kSavingStep, so that noise seldom
// decides; within a step the order of Omissions() does.
#pragma once

#include <functional>
#include <vector>

#include "tools/profile/omission.h"
#include "tools/profile/pipeline_meter.h"

namespace warplut {

inline constexpr double kLeastSaving = 0.01;
inline constexpr double kSavingStep = 0.03;
inline constexpr int kRoundPasses = 5;
inline constexpr int kFinalPasses = 7;

// A pipeline against the full one.
struct PipelineCost {
  std::vector<PipelineScore> scores;  // of each clip
  double loss = 0;                    // of SSIM, greatest over the clips
  double psnr_loss =
      0;  // dB, greatest over the clips; NaN where images are equal to their references
  double temporal_growth = 0;  // of the temporal error, greatest over the clips; NaN if unknown
  TimeRatio time;              // of the full pipeline's
};

struct OmissionTrial {
  const Omission* omission = nullptr;
  PipelineCost cost;
};

struct ProfileResult {
  std::vector<PipelineScore> full_scores;  // of the frames that were searched
  double full_milliseconds = 0;            // for a frame, least of the passes
  std::vector<OmissionTrial>
      alone;  // those that the full pipeline can do without, in the order of Omissions()
  std::vector<OmissionTrial>
      taken;  // in the order in which they were taken; cost with those before
  std::vector<OmissionTrial> given_back;  // by the check on all frames, in that order
  ProfiledPipeline chosen;

  // On all frames.
  std::vector<PipelineScore> checked_full_scores;
  double checked_full_milliseconds = 0;
  PipelineCost shipped;  // the method as its registry entry has it
  PipelineCost checked;  // the chosen pipeline
};

// An omission that may still be taken, on top of those that are.
struct Extension {
  const Omission* omission = nullptr;
  ProfiledPipeline pipeline;
  double saving = 0;  // of the full time, median
  bool measured = false;
};

// The greatest loss of SSIM, PSNR and growth of the temporal error over the clips; the time stays
// 0.
PipelineCost CostOf(const std::vector<PipelineScore>& scores,
                    const std::vector<PipelineScore>& full);

class ProfileSearch {
 public:
  // `step` is called with the share of the work that is done.
  ProfileSearch(ProfiledPipeline full, double within, std::function<void(double)> step);

  // Steps 1 to 3, on the clips of the meter.
  ProfileResult Search(PipelineMeter& meter) const;

  // Step 4, on the clips of another meter; `shipped` is measured beside.
  void Check(PipelineMeter& meter, const ProfiledPipeline& shipped, ProfileResult* result) const;

 private:
  void TryAlone(PipelineMeter& meter, ProfileResult* result) const;
  void TakeTogether(PipelineMeter& meter, ProfileResult* result) const;
  bool TakeIfWithin(PipelineMeter& meter, const Extension& extension, double bound,
                    ProfileResult* result) const;

  const ProfiledPipeline full_;
  const double within_;
  const std::function<void(double)> step_;
};

}  // namespace warplut
