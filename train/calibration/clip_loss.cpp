#include "train/calibration/clip_loss.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "datasets/error.h"
#include "train/ranks/ranks.h"
#include "train/replay/judged_frames.h"

namespace warplut {

// One run of this rank and the frames that it is judged by.
class ClipLoss::Judge {
 public:
  // `clip`: of the run.
  Judge(ClipRun run, const Clip& clip, Executor& executor)
      : run_(std::move(run)), executor_(executor), grid_(CheckedGrid(run_, clip)) {
    for (const int frame : JudgedFrames(clip, run_.options)) {
      if (TruthOf(clip, frame).width == 0) {
        throw Error(fmt::format(
            "the sequence '{}' has no stream 'reference', by which a calibration judges",
            clip.name));
      }
      judged_.insert(frame);
    }
    if (judged_.empty()) {
      throw Error(fmt::format(
          "the method {} shows no frame of '{}' ({} frames, one in {} rendered) that can be judged",
          run_.options.method->name, clip.name, clip.frames.size(), run_.options.every));
    }
  }

  std::size_t tiles() const { return static_cast<std::size_t>(grid_.count()); }

  // The share of each tile in the SSIM.
  std::vector<double> Shares() const {
    std::vector<double> shares;
    for (int tile = 0; tile < grid_.count(); ++tile) shares.push_back(grid_.Share(tile));
    return shares;
  }

  // The mean over judged frames of 1 - SSIM in each tile.
  std::vector<double> TileLosses(const Parameters& parameters, float gate_width) {
    run_.options.super_resolution.parameters = parameters;
    run_.options.super_resolution.gate_width = gate_width;
    run_.options.generation.parameters = parameters;
    run_.options.generation.gate_width = gate_width;
    std::vector<double> losses(tiles());
    const std::shared_ptr<const Clip> clip = run_.clip.Take();
    RunMode(*clip, run_.options, executor_, [&](const ShownFrame& shown) {
      if (!IsJudged(*run_.options.method, shown) || !judged_.contains(shown.frame)) return;
      const LumaPlane truth = LumaOf(TruthOf(*clip, shown.frame), clip->encoding, executor_);
      const LumaPlane luma = LumaOf(shown.image, clip->encoding, executor_);
      executor_.ForEach(grid_.count(), [&](int tile) {
        const Ssim ssim(grid_.Window(truth.view(), tile));
        losses[static_cast<std::size_t>(tile)] +=
            std::max(0.0, 1 - ssim.Mean(grid_.Window(luma.view(), tile)));
      });
    });
    for (double& loss : losses) loss /= static_cast<double>(judged_.size());
    return losses;
  }

 private:
  ImageView TruthOf(const Clip& clip, int frame) const {
    const GridSize grid = ShownGrid(clip, *run_.options.method);
    return TrueFrameOf(clip.frames[static_cast<std::size_t>(frame)], grid.width, grid.height).image;
  }

  static TileGrid CheckedGrid(const ClipRun& run, const Clip& clip) {
    std::string why;
    if (!run.options.IsValid(clip, &why)) throw Error(why);
    const MethodInfo& method = *run.options.method;
    if (method.paper) {
      throw Error(fmt::format(
          "the method {} runs with the paper's constants; expected one that can be calibrated",
          method.name));
    }
    const GridSize grid = ShownGrid(clip, method);
    if (grid.width < kSsimWindow || grid.height < kSsimWindow) {
      throw Error(fmt::format("the frames of '{}' are {} x {}; expected at least {} x {}",
                              clip.name, grid.width, grid.height, kSsimWindow, kSsimWindow));
    }
    return {grid.width, grid.height};
  }

  ClipRun run_;
  Executor& executor_;
  TileGrid grid_;
  std::set<int> judged_;  // indices of frames
};

ClipLoss::ClipLoss(std::vector<ClipRun> runs, Executor& executor) {
  if (runs.empty()) throw Error("there is no clip to calibrate on; expected at least one.");
  Ranks& ranks = Ranks::World();
  std::map<const MethodInfo*, int> clips;  // of each method
  for (const ClipRun& run : runs) {
    ++clips[run.options.method];
    owners_.push_back(run.owner);
  }
  std::vector<std::string> names;
  for (ClipRun& run : runs) {
    weights_.push_back(1.0 / static_cast<double>(clips.size()) / clips[run.options.method]);
    names.push_back(run.name);
    judges_.emplace_back();
    shares_.emplace_back();
    if (run.owner != ranks.rank()) continue;
    const std::shared_ptr<const Clip> clip = run.clip.Take();
    names.back() = clip->name;
    judges_.back() = std::make_unique<Judge>(std::move(run), *clip, executor);
    shares_.back() = judges_.back()->Shares();
  }
  ranks.Exchange(owners_, shares_);
  std::map<std::string, int> sources;
  for (std::size_t r = 0; r < judges_.size(); ++r) {
    const int next = static_cast<int>(sources.size());
    sources_.insert(sources_.end(), shares_[r].size(),
                    sources.try_emplace(names[r], next).first->second);
  }
}

ClipLoss::~ClipLoss() = default;

std::vector<std::vector<double>> ClipLoss::TileLosses(const Parameters& parameters,
                                                      float gate_width) {
  std::vector<std::vector<double>> losses(judges_.size());
  for (std::size_t r = 0; r < judges_.size(); ++r) {
    if (judges_[r]) losses[r] = judges_[r]->TileLosses(parameters, gate_width);
  }
  Ranks::World().Exchange(owners_, losses);
  return losses;
}

void ClipLoss::Evaluate(const Parameters& parameters, float gate_width,
                        std::span<double> residuals) {
  const std::vector<std::vector<double>> losses = TileLosses(parameters, gate_width);
  std::size_t at = 0;
  for (std::size_t r = 0; r < losses.size(); ++r) {
    for (std::size_t tile = 0; tile < losses[r].size(); ++tile) {
      residuals[at++] = std::sqrt(2 * weights_[r] * shares_[r][tile] * losses[r][tile]);
    }
  }
}

std::vector<double> ClipLoss::MeanSsim(const Parameters& parameters) {
  const std::vector<std::vector<double>> losses = TileLosses(parameters, 0);
  std::vector<double> means;
  for (std::size_t r = 0; r < losses.size(); ++r) {
    double loss = 0;
    for (std::size_t tile = 0; tile < losses[r].size(); ++tile) {
      loss += shares_[r][tile] * losses[r][tile];
    }
    means.push_back(1 - loss);
  }
  return means;
}

std::vector<int> ParametersOf(const std::vector<const MethodInfo*>& methods) {
  std::set<int> indices;
  for (const MethodInfo* method : methods) {
    indices.insert(method->parameters.begin(), method->parameters.end());
  }
  return {indices.begin(), indices.end()};
}

}  // namespace warplut
