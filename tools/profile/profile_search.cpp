#include "tools/profile/profile_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/bench/timing.h"

namespace warplut {
namespace {

// Shares of the work: the omissions alone, together, and the check.
constexpr double kAloneShare = 0.4, kTogetherShare = 0.9;

// The full pipeline without these.
ProfiledPipeline Without(ProfiledPipeline pipeline, const std::vector<OmissionTrial>& omissions) {
  for (const OmissionTrial& trial : omissions) trial.omission->leave_out(pipeline);
  return pipeline;
}

// Measures what each saves, and sorts by whole steps of it, the greatest first.
void MeasureSavings(PipelineMeter& meter, const ProfiledPipeline& current, double full_milliseconds,
                    std::vector<Extension>& extensions) {
  std::vector<const ProfiledPipeline*> pipelines = {&current};
  for (const Extension& extension : extensions) pipelines.push_back(&extension.pipeline);
  const auto times = meter.Time(pipelines, kRoundPasses);
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    std::vector<double> savings;
    for (std::size_t pass = 0; pass < times[0].size(); ++pass) {
      savings.push_back((times[0][pass] - times[i + 1][pass]) / full_milliseconds);
    }
    const Timing summary = Summarise(std::move(savings));
    extensions[i].saving = summary.median;
    extensions[i].measured = summary.min > 0 && summary.median >= kLeastSaving;
  }
  const auto steps = [](const Extension& extension) {
    return std::lround(extension.saving / kSavingStep);
  };
  std::stable_sort(extensions.begin(), extensions.end(),
                   [&](const Extension& a, const Extension& b) { return steps(a) > steps(b); });
}

// What of these the pipeline can still do without.
std::vector<Extension> ExtensionsOf(const ProfiledPipeline& pipeline,
                                    const std::vector<const Omission*>& omissions) {
  std::vector<Extension> extensions;
  for (const Omission* omission : omissions) {
    Extension extension{.omission = omission, .pipeline = pipeline};
    if (omission->leave_out(extension.pipeline)) extensions.push_back(std::move(extension));
  }
  return extensions;
}

}  // namespace

PipelineCost CostOf(const std::vector<PipelineScore>& scores,
                    const std::vector<PipelineScore>& full) {
  PipelineCost cost{.scores = scores, .time = {}};
  const auto raise = [](double* greatest, double value, bool first) {
    if (first || value > *greatest || std::isnan(value)) *greatest = value;
  };
  for (std::size_t i = 0; i < scores.size(); ++i) {
    raise(&cost.loss, full[i].mean.ssim - scores[i].mean.ssim, i == 0);
    raise(&cost.psnr_loss, full[i].mean.psnr - scores[i].mean.psnr, i == 0);
    raise(&cost.temporal_growth, scores[i].temporal_error - full[i].temporal_error, i == 0);
  }
  return cost;
}

ProfileSearch::ProfileSearch(ProfiledPipeline full, double within, std::function<void(double)> step)
    : full_(std::move(full)), within_(within), step_(std::move(step)) {}

ProfileResult ProfileSearch::Search(PipelineMeter& meter) const {
  ProfileResult result;
  result.chosen = full_;
  step_(0);
  result.full_scores = meter.Judge(full_);
  TryAlone(meter, &result);
  TakeTogether(meter, &result);
  return result;
}

void ProfileSearch::TryAlone(PipelineMeter& meter, ProfileResult* result) const {
  std::vector<ProfiledPipeline> pipelines;
  for (const Omission& omission : Omissions()) {
    ProfiledPipeline without = full_;
    if (!omission.leave_out(without)) continue;
    result->alone.push_back({.omission = &omission, .cost = {}});
    pipelines.push_back(std::move(without));
  }
  std::vector<const ProfiledPipeline*> timed = {&full_};
  for (const ProfiledPipeline& pipeline : pipelines) timed.push_back(&pipeline);
  const auto times = meter.Time(timed, kRoundPasses);
  result->full_milliseconds = Summarise(times[0]).min;
  for (std::size_t i = 0; i < pipelines.size(); ++i) {
    step_(kAloneShare * static_cast<double>(i + 1) / static_cast<double>(pipelines.size() + 1));
    PipelineCost& cost = result->alone[i].cost;
    cost = CostOf(meter.Judge(pipelines[i]), result->full_scores);
    cost.time = RatioOf(times[i + 1], times[0]);
  }
}

bool ProfileSearch::TakeIfWithin(PipelineMeter& meter, const Extension& extension, double bound,
                                 ProfileResult* result) const {
  PipelineCost cost = CostOf(meter.Judge(extension.pipeline), result->full_scores);
  if (!(cost.loss <= bound)) return false;
  const ProfiledPipeline* const timed[] = {&full_, &extension.pipeline};
  const auto times = meter.Time(timed, kRoundPasses);
  cost.time = RatioOf(times[1], times[0]);
  result->chosen = extension.pipeline;
  result->taken.push_back({.omission = extension.omission, .cost = std::move(cost)});
  return true;
}

void ProfileSearch::TakeTogether(PipelineMeter& meter, ProfileResult* result) const {
  std::vector<const Omission*> left;
  for (const OmissionTrial& trial : result->alone) left.push_back(trial.omission);
  const auto all = static_cast<double>(left.size());
  while (true) {
    std::vector<Extension> extensions = ExtensionsOf(result->chosen, left);
    if (extensions.empty()) return;
    MeasureSavings(meter, result->chosen, result->full_milliseconds, extensions);
    const double loss = result->taken.empty() ? 0 : result->taken.back().cost.loss;
    const bool last = std::none_of(extensions.begin(), extensions.end(),
                                   [](const Extension& extension) { return extension.measured; });
    bool taken = false;
    for (const Extension& extension : extensions) {
      const bool tried = last ? extension.saving > -kLeastSaving : extension.measured;
      if (!tried) continue;
      std::erase(left, extension.omission);
      step_(kAloneShare +
            (kTogetherShare - kAloneShare) * (1 - static_cast<double>(left.size()) / all));
      taken = TakeIfWithin(meter, extension, last ? std::min(loss, within_) : within_, result);
      if (taken) break;
    }
    if (last && !taken) return;
  }
}

void ProfileSearch::Check(PipelineMeter& meter, const ProfiledPipeline& shipped,
                          ProfileResult* result) const {
  step_(kTogetherShare);
  result->checked_full_scores = meter.Judge(full_);
  const auto cost_of = [&](const ProfiledPipeline& pipeline) {
    return CostOf(meter.Judge(pipeline), result->checked_full_scores);
  };
  result->shipped = cost_of(shipped);
  result->checked = cost_of(result->chosen);
  while (!(result->checked.loss <= within_) && !result->taken.empty()) {
    result->given_back.push_back(result->taken.back());
    result->taken.pop_back();
    result->chosen = Without(full_, result->taken);
    result->checked = cost_of(result->chosen);
  }
  const ProfiledPipeline* const timed[] = {&full_, &shipped, &result->chosen};
  const auto times = meter.Time(timed, kFinalPasses);
  result->checked_full_milliseconds = Summarise(times[0]).min;
  result->shipped.time = RatioOf(times[1], times[0]);
  result->checked.time = RatioOf(times[2], times[0]);
  step_(1);
}

}  // namespace warplut
