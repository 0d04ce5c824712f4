#include "tools/profile/pipeline_meter.h"

#include "tools/bench/timed_executor.h"
#include "tools/bench/timing.h"
#include "train/ranks/ranks.h"
#include "train/replay/image_views.h"

namespace warplut {
TimeRatio RatioOf(const std::vector<double>& times, const std::vector<double>& to) {
  std::vector<double> ratios;
  for (std::size_t pass = 0; pass < times.size(); ++pass) ratios.push_back(times[pass] / to[pass]);
  const Timing summary = Summarise(std::move(ratios));
  return {.median = summary.median, .low = summary.min, .high = summary.max};
}

PipelineMeter::PipelineMeter(std::vector<ProfileClip> clips, const ProfiledPipeline& full,
                             const ModeRunOptions& options, int threads,
                             std::function<void()> check)
    : clips_(std::move(clips)), options_(options), pool_(threads), check_(std::move(check)) {
  UseOutputAsReference(full);
}

void PipelineMeter::UseOutputAsReference(const ProfiledPipeline& full) {
  for (ProfileClip& clip : clips_) {
    if (clip.has_reference || !clip.IsLoaded()) continue;
    Run(full, clip, [&](const ShownFrame& shown) {
      if (shown.frame < 0) return;
      ImageBuffer& reference = clip.truth.frames[static_cast<std::size_t>(shown.frame)].reference;
      reference = ImageBuffer(shown.image.width, shown.image.height, shown.image.format);
      CopyPixels(shown.image, reference.view());
    });
  }
}

void PipelineMeter::Run(const ProfiledPipeline& pipeline, const ProfileClip& clip,
                        const ShownFrameSink& sink) {
  RunPipeline(pipeline, clip.input, options_, pool_, [&](const ShownFrame& shown) {
    check_();
    sink(shown);
  });
}

std::vector<std::vector<double>> PipelineMeter::OfEach(
    const std::function<std::vector<double>(const ProfileClip&)>& numbers_of) {
  Ranks& ranks = Ranks::World();
  std::vector<int> owners;
  std::vector<std::vector<double>> numbers;
  for (const ProfileClip& clip : clips_) {
    owners.push_back(clip.owner);
    numbers.push_back(clip.owner == ranks.rank() ? numbers_of(clip) : std::vector<double>());
  }
  ranks.Exchange(owners, numbers);
  return numbers;
}

std::vector<PipelineScore> PipelineMeter::Judge(const ProfiledPipeline& pipeline) {
  const auto numbers = OfEach([&](const ProfileClip& clip) {
    SequenceJudge judge(clip.truth, *pipeline.method);
    Run(pipeline, clip, [&](const ShownFrame& shown) { judge.Add(shown); });
    return ToNumbers(judge.Finish());
  });
  std::vector<PipelineScore> scores;
  for (const std::vector<double>& one : numbers) {
    const SequenceScores finished = FromNumbers(pipeline.method->name, one);
    scores.push_back({.mean = finished.mean, .temporal_error = finished.temporal_error});
  }
  return scores;
}

double PipelineMeter::TimeOnce(const ProfiledPipeline& pipeline, const Clip& clip) {
  TimedExecutor executor;
  double begin = 0;
  int made = 0;
  RunPipeline(pipeline, clip, options_, executor, [&](const ShownFrame& shown) {
    check_();
    // The rendered frames of a method without super resolution were there.
    if (!shown.generated && !pipeline.method->super_resolution) return;
    if (made++ == 0) begin = executor.milliseconds();
  });
  const double total = executor.milliseconds();
  return made > 1 ? (total - begin) / (made - 1) : total;
}

std::vector<std::vector<double>> PipelineMeter::Time(
    std::span<const ProfiledPipeline* const> pipelines, int passes) {
  std::vector<std::vector<double>> times(pipelines.size());
  Ranks& ranks = Ranks::World();
  for (int pass = 0; ranks.IsRoot() && pass < passes; ++pass) {
    for (std::size_t i = 0; i < pipelines.size(); ++i) {
      double sum = 0;
      for (const ProfileClip& clip : clips_) sum += TimeOnce(*pipelines[i], clip.input);
      times[i].push_back(sum / static_cast<double>(clips_.size()));
    }
  }
  ranks.WaitForRoot();
  ranks.Exchange(std::vector<int>(times.size(), 0), times);
  return times;
}

}  // namespace warplut
