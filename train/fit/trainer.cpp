#include "train/fit/trainer.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "datasets/error.h"
#include "luts/filters.h"
#include "train/fit/checkpoint.h"
#include "train/fit/evaluation_log.h"
#include "train/fit/minimize.h"
#include "train/fit/objective/gain_limit.h"
#include "train/fit/objective/mlp_objective.h"
#include "train/fit/objective/sr_objective.h"
#include "train/fit/objective/warp_objective.h"
#include "train/fit/random.h"
#include "train/fit/resampler_model.h"
#include "train/fit/rivals/kaiser_family.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rivals/spline_family.h"
#include "train/fit/rollout/crops.h"
#include "train/metrics/luma.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

using Clock = std::chrono::steady_clock;

// Which part of the training a derived seed is for; two per stage.
enum class SeedFor : std::uint64_t { kStart = 0, kValidation = 1, kStages = 3 };

std::uint64_t Seed(const TrainOptions& options, SeedFor part, int index = 0) {
  return DeriveSeed(options.seed, static_cast<std::uint64_t>(part) + index);
}

// Pans per crop: in the training only where they count, in the validation always.
int TrainingPans(const TrainOptions& options) {
  if (!(*options.pan_share > 0)) return 0;
  return options.objective == TrainObjective::kSr ? 4 : 2;
}
constexpr int kValidationPans = 4;

// How a stage differs from the last one: fewer crops, and a smoother objective.
struct Stage {
  int crops = 0;
  double power = 0;
  double penalty_factor = 0;
};

Stage MakeStage(const TrainOptions& options, int index) {
  const int left = options.stages - 1 - index;
  const double softening = std::pow(0.5, std::min(left, 3));
  return {std::max(1, options.crops * (index + 1) / options.stages), kProtocolPower * softening,
          kGainPenaltyFactor * softening};
}

// The objective of the options, resolved; `power` is for objective `warp` alone.
std::unique_ptr<const Objective> MakeObjective(const TrainOptions& options,
                                               std::vector<BorderedPlane> crops, std::uint64_t seed,
                                               int pans_per_crop, double power,
                                               const RivalFamily& rivals, const Objective* like) {
  if (options.objective == TrainObjective::kSr) {
    const SrObjectiveOptions sr{options.scale,
                                *options.blend_a,
                                *options.blend_b,
                                *options.pan_share,
                                pans_per_crop,
                                *options.aliasing,
                                rivals};
    return std::make_unique<SrObjective>(std::move(crops), options.horizons, seed, sr, like);
  }
  const WarpObjectiveOptions warp{power, *options.pan_share, pans_per_crop, rivals};
  return std::make_unique<WarpObjective>(std::move(crops), options.horizons, seed, warp, like);
}

void RequireDisplayRange(const Image& luma, const std::string& name) {
  for (std::size_t i = 0; i < luma.data.size(); ++i) {
    const float value = luma.data[i];
    if (!(value >= 0 && value <= 1)) {
      const auto width = static_cast<std::size_t>(luma.width);
      throw Error(fmt::format(
          "{}: the luma of pixel ({}, {}) is {:.7g}; expected colours as displayed, in [0, 1].",
          name, i % width, i / width, value));
    }
  }
}

bool IsFlat(const Image& luma) {
  return std::all_of(luma.data.begin(), luma.data.end(),
                     [&](float value) { return value == luma.data[0]; });
}

// The largest side of a spline that keeps the bound on gain; 0 without prefilter.
double LargestSide(const TrainOptions& options, int reach) {
  if (options.prefilter == TrainPrefilter::kNone) return 0;
  return LargestSplineSide(options.gain_bound, reach);
}

CheckpointIdentity IdentityOf(const TrainOptions& resolved, const std::vector<TrainImage>& images) {
  CheckpointIdentity identity{.options = resolved.Json(), .images = {}};
  for (const TrainImage& i : images) identity.images.push_back({i.record.name, i.record.sha1});
  return identity;
}

class Training {
 public:
  Training(const TrainOptions& options, const std::vector<TrainImage>& images,
           const TrainCallback& progress)
      : options_(options.Resolved()),
        progress_(progress),
        luma_(CheckedLuma(images)),
        penalty_(options_.gain_bound, options_.footprint),
        rivals_{LargestSide(options_, 0), options_.footprint},
        validation_(MakeObjective(
            options_,
            DrawCrops(luma_, options_.crops / 3 + 1, Seed(options_, SeedFor::kValidation)),
            Seed(options_, SeedFor::kValidation, 1), kValidationPans, kProtocolPower, rivals_,
            nullptr)) {
    state_.made_for = IdentityOf(options_, images);
    state_.parameters = RandomParameters(Seed(options_, SeedFor::kStart), options_.footprint);
    if (rivals_.largest_side > 0) StartPrefilter();
    if (options_.footprint != Footprint::k16) StartWide();
    if (options_.resume) {
      state_ = ReadCheckpoint(options_.checkpoint, state_.made_for, state_.parameters.size());
    }
  }

  // Returns false if the callback stopped it. The first stage always begins, however short the time
  // limit is, so that there is a resampler to write.
  bool Run() {
    start_ = Clock::now() - std::chrono::duration_cast<Clock::duration>(
                                std::chrono::duration<double>(state_.seconds));
    while (state_.stage < options_.stages && (state_.best_parameters.empty() || !OutOfTime())) {
      if (!RunStage()) return false;
    }
    // After a cut there is more to do: it stays for --resume.
    if (!options_.checkpoint.empty() && !cut_ && Ranks::World().IsRoot()) {
      std::filesystem::remove(options_.checkpoint);
    }
    return true;
  }

  Fit MakeFit(const std::vector<TrainImage>& images);

  // Whether max_seconds ended it before its last stage.
  bool cut() const { return cut_; }

 private:
  double Seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool OutOfTime() {
    // By the clock of the root, for all ranks.
    const bool out =
        options_.max_seconds > 0 && Ranks::World().OfRoot(Seconds()) >= options_.max_seconds;
    cut_ = cut_ || out;
    return out;
  }
  // L + f P of a resampler by the last stage's measure.
  double Judge(const Objective& objective, const Resampler& resampler) const;
  std::unique_ptr<const Objective> StageObjective(int index) const;
  void StartPrefilter();
  void StartWide();
  bool RunStage();
  // Writes the checkpoint, if there is one to write and `now` or the last one is old.
  void Save(bool now);
  bool Report(int iteration, std::int64_t evaluations, double loss);
  void FinishStage(std::int64_t evaluations, double loss);

  const TrainOptions options_;
  const TrainCallback& progress_;
  const std::vector<Image> luma_;
  const GainPenalty penalty_;
  const RivalFamily rivals_;
  const std::unique_ptr<const Objective> validation_;
  ResamplerModel model_;
  Checkpoint state_;
  bool cut_ = false;
  Clock::time_point start_;
  std::optional<Clock::time_point> saved_;  // nothing before the first: a full disk shows early
  double save_seconds_ = 0;                 // that the last one took
};

double Training::Judge(const Objective& objective, const Resampler& resampler) const {
  Resampler unused;
  return objective.Evaluate(resampler) +
         kGainPenaltyFactor * penalty_.AddGradient(resampler, 0, unused);
}

std::unique_ptr<const Objective> Training::StageObjective(int index) const {
  const Stage stage = MakeStage(options_, index);
  return MakeObjective(options_,
                       DrawCrops(luma_, stage.crops, Seed(options_, SeedFor::kStages, 2 * index)),
                       Seed(options_, SeedFor::kStages, 2 * index + 1), TrainingPans(options_),
                       stage.power, rivals_, validation_.get());
}

// At the spline that the first stage likes best.
void Training::StartPrefilter() {
  const int reach = FirReach(options_);
  const double largest = LargestSide(options_, reach);
  const auto objective = StageObjective(0);
  const auto loss = [&](double side) {
    return Judge(*objective, SplineResampler(SplinePrefilter(side, reach)));
  };
  const RealPrefilter start = SplinePrefilter(BestSplineSide(loss, largest), reach);
  switch (options_.prefilter) {
    case TrainPrefilter::kSpline:
      model_ = ResamplerModel(PrefilterMap::Fixed(start.side));
      break;
    case TrainPrefilter::kIir:
      model_ = ResamplerModel(PrefilterMap::Recursive(largest));
      break;
    case TrainPrefilter::kFir:
      model_ = ResamplerModel(PrefilterMap::Fir(reach, largest));
      break;
    case TrainPrefilter::kNone:
      return;
  }
  for (const double number : model_.map().NumbersOf(start)) state_.parameters.push_back(number);
}

// At the wide kernel within the limit on gain that the first stage likes best.
void Training::StartWide() {
  const auto objective = StageObjective(0);
  const auto loss = [&](double b) { return Judge(*objective, WideBase(options_.footprint, b)); };
  const std::optional<double> best =
      BestKaiser(loss, options_.footprint, LargestGain(options_.gain_bound));
  if (!best) {
    throw Error(fmt::format(
        "No kernel of {} taps to start from has a gain within the bound of {}; expected a larger "
        "one.",
        TapCount(options_.footprint), options_.gain_bound));
  }
  model_ = ResamplerModel(options_.footprint, *best);
}

bool Training::Report(int iteration, std::int64_t evaluations, double loss) {
  if (!progress_) return true;
  const double done = state_.stage + static_cast<double>(iteration) / options_.iterations;
  double fraction = done / options_.stages;
  if (options_.max_seconds > 0) fraction = std::max(fraction, Seconds() / options_.max_seconds);
  const double validation = state_.loss.empty() ? 0 : state_.loss.back().validation;
  return progress_(
      {Seconds(), state_.evaluations + evaluations, loss, validation, std::min(fraction, 1.0)});
}

bool Training::RunStage() {
  const auto stage_objective = StageObjective(state_.stage);
  MlpObjective objective(*stage_objective, options_.gain_bound,
                         MakeStage(options_, state_.stage).penalty_factor, model_);
  LoggedFunction logged(objective, state_.parameters.size(), &state_.begun, [&] { Save(false); });
  std::vector<double> parameters = state_.parameters;
  AdamState adam = state_.adam;
  int iteration = 0;
  double loss = 0;
  bool stopped = false;
  const MinimizeCallback callback = [&](const double*, double value) {
    loss = value;
    const auto evaluations = static_cast<std::int64_t>(logged.evaluations());
    stopped = Ranks::World().Any(!Report(++iteration, evaluations, value));
    return !stopped && !(iteration < options_.iterations && OutOfTime());
  };
  if (options_.optimizer == Optimizer::kAdam) {
    MinimizeAdam(logged, options_.iterations, callback, adam, parameters);
  } else {
    MinimizeLbfgs(logged, options_.iterations, callback, parameters);
  }
  if (stopped || cut_) Save(true);
  if (stopped) return false;
  state_.parameters = std::move(parameters);
  state_.adam = std::move(adam);
  FinishStage(static_cast<std::int64_t>(logged.evaluations()), loss);
  return true;
}

void Training::Save(bool now) {
  // Seconds between two checkpoints, which is what a kill may lose, and that as a multiple of what
  // one takes.
  constexpr double kSaveSeconds = 2, kSaveShare = 20;
  if (options_.checkpoint.empty() || !Ranks::World().IsRoot()) return;
  const auto since = [](Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  };
  if (!now && saved_ && since(*saved_) < std::max(kSaveSeconds, kSaveShare * save_seconds_)) return;
  const Clock::time_point begin = Clock::now();
  state_.seconds = Seconds();
  WriteCheckpoint(options_.checkpoint, state_);
  saved_ = Clock::now();
  save_seconds_ = since(begin);
}

void Training::FinishStage(std::int64_t evaluations, double loss) {
  ++state_.stage;
  state_.evaluations += evaluations;
  LimitGain(LargestGain(options_.gain_bound), model_, state_.parameters);
  const double validation = Judge(*validation_, model_.ForwardStored(state_.parameters.data()));
  state_.seconds = Seconds();
  state_.loss.push_back({state_.seconds, state_.evaluations, loss, validation});
  if (state_.best_parameters.empty() || validation < state_.best_validation) {
    state_.best_validation = validation;
    state_.best_parameters = state_.parameters;
  }
  state_.begun.clear();
  // A cut stage is not complete: what was saved of it goes on.
  if (!cut_) Save(true);
}

Fit Training::MakeFit(const std::vector<TrainImage>& images) {
  Fit fit;
  fit.scale = options_.scale;
  fit.objective = Name(options_.objective);
  fit.optimizer = Name(options_.optimizer);
  fit.horizons = options_.horizons;
  fit.gain_bound = options_.gain_bound;
  fit.seed = options_.seed;
  fit.options = options_.Json();
  fit.cut = cut_;
  if (!state_.best_parameters.empty()) {
    fit.parameters.assign(state_.best_parameters.begin(),
                          state_.best_parameters.begin() + model_.mlp_size());
  }
  fit.loss = state_.loss;
  for (const TrainImage& image : images) fit.data.push_back(image.record);
  if (fit.parameters.empty()) return fit;

  const Resampler trained = model_.ForwardStored(state_.best_parameters.data());
  fit.prefilter = Rounded(trained.prefilter);
  fit.footprint = model_.footprint();
  fit.kaiser_b = model_.kaiser_b();
  fit.keys_a = FitKeys(*validation_);
  const auto add = [&](const char* filter, const Resampler& resampler) {
    const std::vector<double> losses = validation_->Losses(resampler);
    for (std::size_t i = 0; i < losses.size(); ++i) {
      const Protocol& protocol = validation_->protocols()[i];
      fit.validation.push_back({filter, protocol.warps, Name(protocol.offsets), 1 - losses[i]});
    }
  };
  add("lut", trained);
  if (HasPrefilter(fit.prefilter)) {
    const double side = BestSplineSide(
        [&](double s) { return Judge(*validation_, SplineResampler(RecursivePrefilter(s))); },
        rivals_.largest_side);
    fit.spline_k = SplineK(side);
    add("spline", SplineResampler(RecursivePrefilter(side)));
    add("spline-1/84", SplineResampler(RecursivePrefilter(SplineSide(kMiddleSplineK))));
  }
  if (fit.footprint != Footprint::k16) add("kaiser6-4.5", KaiserResampler(kComparedKaiser));
  add("keys", KeysCanonicalWeights(fit.keys_a));
  add("catmull-rom", KeysCanonicalWeights(kCatmullRomA));
  return fit;
}

}  // namespace

std::vector<Image> CheckedLuma(const std::vector<TrainImage>& images) {
  if (images.empty()) throw Error("There are no training images; expected at least one.");
  std::vector<Image> luma;
  luma.reserve(images.size());
  bool flat = true;
  for (const TrainImage& image : images) {
    const Image& checked = luma.emplace_back(Luma(image.image));
    if (checked.width < kCropSize || checked.height < kCropSize) {
      throw Error(fmt::format("{} is {} x {}; expected a training image of at least {} x {}.",
                              image.record.name, checked.width, checked.height, kCropSize,
                              kCropSize));
    }
    RequireDisplayRange(checked, image.record.name);
    flat = flat && IsFlat(checked);
  }
  if (flat) {
    throw Error("Every training image is of one value; expected at least one with detail.");
  }
  return luma;
}

TrainResult Train(const TrainOptions& options, const std::vector<TrainImage>& images,
                  const TrainCallback& progress) {
  std::string why;
  if (!options.IsValid(&why)) throw Error("Training options: " + why);
  const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const CheckpointIdentity identity = IdentityOf(options.Resolved(), images);
  std::string made_for = identity.options;
  for (const auto& image : identity.images) made_for += '\n' + image.sha1;
  Ranks::World().RequireSame("the options or the images", made_for);
  Training training(options, images, progress);
  TrainResult result;
  result.interrupted = !training.Run();
  result.cut = training.cut();
  result.fit = training.MakeFit(images);
  return result;
}

}  // namespace warplut
