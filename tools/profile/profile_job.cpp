#include "tools/profile/profile_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "datasets/file.h"
#include "luts/bake/table_io.h"
#include "tools/profile/pipeline_header.h"
#include "tools/profile/profile_content.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/thread_limit.h"
#include "tools/usage_error.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

// Shares of the work: the search with its check, and the smaller tables.
constexpr double kSearchShare = 0.7;

const MethodInfo& ProfiledMethod(const ProfileRequest& request) {
  const MethodInfo& method = MethodOf(request.mode);
  RequireUsage(
      !method.parameters.empty(),
      fmt::format("the mode {} is a baseline, which has no pass to leave out; expected one "
                  "that is calibrated, as sr or i",
                  request.mode));
  RequireUsage(!method.peer,
               fmt::format("the mode {} is another system, whose passes cannot be left out; "
                           "expected one of this project, as sr or i",
                           request.mode));
  return method;
}

// The text as one word of a shell's command line.
std::string ShellQuoted(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) ||
           std::string_view("/._-+=:,@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

void TryTables(const ProfileRequest& request, PipelineMeter& meter, Progress& progress,
               ProfileReport& report) {
  if (request.pipeline.lut.empty()) return;
  const ProfiledPipeline& chosen = report.result.chosen;
  report.tables_in_chosen = chosen.ReadsTable();
  const LoadedTable loaded = LoadTable(request.pipeline.lut, TableFormat::kF32);
  report.tables = TrySmallerTables(
      meter, report.tables_in_chosen ? chosen : report.full, ToRealTable(loaded.table.view()),
      report.result.full_scores, [&](double share) {
        progress.Update(kSearchShare + (1 - kSearchShare) * share, "smaller tables");
      });
  if (!report.tables_in_chosen) return;
  const SmallerTable* smallest = SmallestWithin(report.tables, chosen.warp().lookup, report.within);
  if (smallest == nullptr) return;
  report.table = *smallest;
  if (IsFit(request.pipeline.lut)) {
    const std::filesystem::path folder = std::filesystem::path(request.out).parent_path();
    report.bake =
        fmt::format("warplut bake {} --format {} --out {}", ShellQuoted(request.pipeline.lut),
                    Name(smallest->format), ShellQuoted(folder.empty() ? "." : folder.string()));
  }
}

ProfileReport Profile(const ProfileRequest& request, const std::string& version,
                      const MethodInfo& method, const Pipeline& pipeline,
                      const ProfileContent& content) {
  const ModeRunOptions options = pipeline.Options(method, content.every());
  const auto check = [] { ThrowIfInterrupted("profile", "nothing was written"); };
  ProfileReport report{.version = version,
                       .mode = request.mode,
                       .filter = pipeline.filter_name(),
                       .within = request.within,
                       .sequences = content.Names(),
                       .searched_frames = request.pipeline.frames,
                       .full = FullPipeline(options, content.OneGrid()),
                       .result = {},
                       .tables = {},
                       .table = {},
                       .tiles = {},
                       .time_by_tiles = {}};
  Progress progress("profiling", 1, "");
  const ProfileSearch search(report.full, request.within, [&](double share) {
    progress.Update(kSearchShare * share, "pipelines");
  });
  const auto meter_of = [&](const std::string& frames) {
    return PipelineMeter(content.Load(frames), report.full, options, request.pipeline.threads,
                         check);
  };
  PipelineMeter meter = meter_of(request.pipeline.frames);
  report.result = search.Search(meter);
  const ProfiledPipeline shipped = ShippedPipeline(options, content.OneGrid());
  if (request.pipeline.frames.empty()) {
    search.Check(meter, shipped, &report.result);
  } else {
    PipelineMeter whole = meter_of("");
    search.Check(whole, shipped, &report.result);
  }
  report.tiles = CountTiles(meter, report.full);
  report.time_by_tiles = TimeByTiles(meter, report.full, kRoundPasses);
  TryTables(request, meter, progress, report);
  return report;
}

}  // namespace

ProfileReport RunProfile(const ProfileRequest& request, const std::string& version) {
  RequireUsage(request.within >= 0 && std::isfinite(request.within),
               fmt::format("--within is {}; expected at least 0", request.within));
  const MethodInfo& method = *AsUsage([&] {
    const MethodInfo* known = &ProfiledMethod(request);
    CheckArguments(request.pipeline);
    return known;
  });
  const std::filesystem::path out = request.out;
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) RequireWritable(out);
  const ThreadLimit limit(request.pipeline.threads);
  const Pipeline pipeline(request.pipeline);
  const ProfileContent content(request, pipeline, method);
  ranks.RequireSame("the options or the sequences", content.Identity());
  ProfileReport report = Profile(request, version, method, pipeline, content);
  if (!ranks.IsRoot()) return report;
  if (out.has_parent_path()) CreateFolder(out.parent_path());
  WriteFile(out, PipelineHeader(Banner(report),
                                ConfigurationOf(report.result.chosen, content.encoding())));
  return report;
}

}  // namespace warplut
