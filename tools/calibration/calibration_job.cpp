#include "tools/calibration/calibration_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "datasets/file.h"
#include "datasets/json_fields.h"
#include "tools/calibration/calibration_clips.h"
#include "tools/memory_size.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/thread_limit.h"
#include "tools/usage_error.h"
#include "train/ranks/ranks.h"
#include "train/replay/parameters_file.h"

namespace warplut {
namespace {

std::vector<const MethodInfo*> CalibratedMethods(const std::vector<std::string>& names) {
  const std::vector<const MethodInfo*> methods = MethodsOf(names, "--modes");
  for (const MethodInfo* method : methods) {
    RequireUsage(!method->paper && !method->parameters.empty(),
                 fmt::format("the mode {} has no parameters to calibrate; expected one that has",
                             method->name));
  }
  return methods;
}

std::vector<int> FittedOf(const CalibrationRequest& request,
                          const std::vector<const MethodInfo*>& methods) {
  const std::vector<int> read = ParametersOf(methods);
  if (request.fit.empty()) return read;
  std::set<int> fitted;
  for (const std::string& name : request.fit) {
    const int index = FindParameter(name);
    RequireUsage(index >= 0, fmt::format("--fit has '{}'; expected {}", name, ParameterNames()));
    RequireUsage(std::find(read.begin(), read.end(), index) != read.end(),
                 fmt::format("--fit has {}, which none of the modes reads", name));
    fitted.insert(index);
  }
  return {fitted.begin(), fitted.end()};
}

void AddScores(const std::vector<ClipRun>& runs, bool held_out, const Parameters& calibrated,
               const Parameters& base, Executor& executor, CalibrationReport& report) {
  if (runs.empty()) return;
  ClipLoss loss(runs, executor);
  const std::vector<double> at_calibrated = loss.MeanSsim(calibrated);
  const std::vector<double> at_base = loss.MeanSsim(base);
  const std::vector<double> at_paper = loss.MeanSsim(kPaperParameters);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    report.scores.push_back({.clip = runs[i].name,
                             .mode = runs[i].options.method->name,
                             .held_out = held_out,
                             .calibrated = at_calibrated[i],
                             .defaults = at_base[i],
                             .paper = at_paper[i]});
  }
}

CalibrationResult Search(const CalibrationOptions& options, ClipLoss& loss) {
  Progress progress("calibrating", 1, "");
  CalibrationOptions with_progress = options;
  with_progress.progress = [&](const CalibrationProgress& state) {
    progress.Update(std::min(1.0, state.fraction),
                    fmt::format("{} runs, loss {:.5f}", state.runs, state.loss));
    return !Interrupted();
  };
  return Calibrate(with_progress, loss);
}

CalibrationOptions OptionsOf(const CalibrationRequest& request,
                             const std::vector<const MethodInfo*>& methods) {
  CalibrationOptions options;
  options.fitted = FittedOf(request, methods);
  if (!request.pipeline.params.empty()) {
    options.base = ReadParameters(request.pipeline.params);
  }
  options.near_base = request.keep == "near";
  options.random_starts = request.starts;
  options.seed = request.seed;
  options.max_seconds = request.max_seconds;
  options.checkpoint = request.out + ".checkpoint";
  options.resume = request.resume;
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  return options;
}

}  // namespace

CalibrationReport RunCalibration(const CalibrationRequest& request) {
  const std::vector<const MethodInfo*> methods = AsUsage([&] {
    std::vector<const MethodInfo*> known = CalibratedMethods(request.modes);
    CheckArguments(request.pipeline);
    return known;
  });
  CalibrationOptions options = OptionsOf(request, methods);
  const std::size_t memory = AsUsage([&] { return ParseMemorySize(request.memory); });
  const ThreadLimit limit(request.pipeline.threads);
  const std::filesystem::path out = request.out;
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) {
    RequireWritable(out);
    RequireWritable(options.checkpoint);
  }

  const Pipeline pipeline(request.pipeline);
  const std::vector<CalibrationPart> parts = CalibrationParts(request, pipeline, methods);
  ClipShelf shelf(memory);
  const CalibrationRuns runs = LoadCalibrationRuns(request, pipeline, methods, parts, shelf);
  options.data = CalibrationData(request, pipeline, parts);
  ranks.RequireSame("the options or the sequences", options.Identity());
  ThreadPool pool(request.pipeline.threads);
  if (!runs.held_out.empty()) ClipLoss(runs.held_out, pool);  // an Error now rather than at the end

  CalibrationReport report{.filter = pipeline.filter_name(),
                           .modes = request.modes,
                           .every = request.every,
                           .max_pixels = request.max_pixels,
                           .seed = request.seed,
                           .result = {},
                           .scores = {}};
  if (ranks.IsRoot() && out.has_parent_path()) CreateFolder(out.parent_path());
  {
    ClipLoss loss(runs.fitted, pool);
    report.result = Search(options, loss);
  }
  if (report.result.stop == RunLog::Stop::kAsked) {
    throw Error(
        fmt::format("calibration was interrupted; the same command with --resume goes on from {}.",
                    options.checkpoint.string()));
  }
  const Parameters& kept = report.result.kept.parameters;
  AddScores(runs.fitted, false, kept, options.base, pool, report);
  AddScores(runs.held_out, true, kept, options.base, pool, report);
  if (!ranks.IsRoot()) return report;
  WriteFile(out, ParametersJson(kept, JsonText(ToJson(report))));
  if (report.result.stop == RunLog::Stop::kNone) std::filesystem::remove(options.checkpoint);
  return report;
}

}  // namespace warplut
