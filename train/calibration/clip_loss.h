// The loss of parameters: 1 - SSIM of the frames that the runtime shows of clips.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/executor.h"
#include "train/calibration/luma_plane.h"
#include "train/calibration/residual_function.h"
#include "train/calibration/tile_grid.h"
#include "train/replay/clip_shelf.h"
#include "train/replay/mode_run.h"

namespace warplut {

// One method over one clip. Its own parameters and gate width do not matter.
struct ClipRun {
  ClipSource clip;  // none on the ranks that do not own the run
  ModeRunOptions options;
  std::string name = {};  // of the clip
  int owner = 0;          // the rank that runs it
};

// The mean over methods of the mean over clips of the mean over judged frames of 1 - SSIM of luma.
// Judged are the generated frames of methods that generate and all but the first frame of the
// others (a first frame has no history), where there is a reference. One residual for each run and
// tile, sqrt(2 weight (1 - SSIM)) with SSIM the mean over the tile and the frames: frames show the
// same things again, so they are no data of their own.
//
// Clips are taken one after the other, in the constructor and for every evaluation: a ClipShelf
// bounds their memory. What is kept of each run does not grow with its pixels and frames, but for a
// number for each tile.
class ClipLoss final : public ResidualFunction {
 public:
  // The executor outlives the object; the residuals do not depend on it. Error: no run, a method
  // that the paper's constants are part of, a run that cannot be made (ModeRunOptions::IsValid),
  // images too small for the SSIM window, no judged frame. This, Evaluate and MeanSsim are
  // collective calls of Ranks::World(): each rank has the same runs, and computes its own.
  ClipLoss(std::vector<ClipRun> runs, Executor& executor);
  ~ClipLoss() override;

  std::size_t Size() const override { return sources_.size(); }
  // Runs over clips of one name share a source.
  int Source(std::size_t k) const override { return sources_[k]; }
  void Evaluate(const Parameters& parameters, float gate_width,
                std::span<double> residuals) override;

  // The mean SSIM of each run at the parameters, hard gates.
  std::vector<double> MeanSsim(const Parameters& parameters);

 private:
  class Judge;

  // The losses of each run's tiles.
  std::vector<std::vector<double>> TileLosses(const Parameters& parameters, float gate_width);

  std::vector<int> owners_;                     // of each run
  std::vector<std::unique_ptr<Judge>> judges_;  // of each run; null where another rank owns it
  std::vector<std::vector<double>> shares_;     // of each run's tiles in its SSIM
  std::vector<double> weights_;                 // of each run in the loss
  std::vector<int> sources_;                    // of the residuals
};

// Which parameters the methods read: indices of kParameters, ascending.
std::vector<int> ParametersOf(const std::vector<const MethodInfo*>& methods);

}  // namespace warplut
