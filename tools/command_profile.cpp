// warplut profile: what content can do without, and the pipeline that is left as a header.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "datasets/file.h"
#include "datasets/hash.h"
#include "luts/bake/table_io.h"
#include "tools/command.h"
#include "tools/interrupt.h"
#include "tools/pipeline_options.h"
#include "tools/profile/pipeline_header.h"
#include "tools/profile/profile_report.h"
#include "tools/progress.h"
#include "tools/thread_limit.h"
#include "tools/warning.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

struct ProfileArguments {
  std::vector<std::string> sequences;
  std::string mode = "sr";
  std::string out;
  double within = 0.0005;
  int every = 2;
  bool json = false;
  bool markdown = false;
  bool generated_given = false;
  PipelineArguments pipeline;
};

// Shares of the work: the search with its check, and the smaller tables.
constexpr double kSearchShare = 0.7;

const MethodInfo& ProfiledMethod(const ProfileArguments& arguments) {
  const MethodInfo& method = MethodOf(arguments.mode);
  RequireUsage(
      !method.parameters.empty(),
      fmt::format("the mode {} is a baseline, which has no pass to leave out; expected one "
                  "that is calibrated, as sr or i",
                  arguments.mode));
  RequireUsage(!method.peer,
               fmt::format("the mode {} is another system, whose passes cannot be left out; "
                           "expected one of this project, as sr or i",
                           arguments.mode));
  return method;
}

// The sequences of a profile and their clips.
class Content {
 public:
  Content(const ProfileArguments& arguments, const Pipeline& pipeline, const MethodInfo& method)
      : arguments_(arguments), pipeline_(pipeline), method_(method) {
    for (const std::string& path : arguments.sequences) {
      sequences_.push_back(ReadSequenceFor(pipeline, path, {&method}));
      if (sequences_.back().color_space != sequences_.front().color_space) {
        throw Error(fmt::format(
            "'{}' and '{}' have different colour spaces; a pipeline is profiled for one",
            sequences_.front().name, sequences_.back().name));
      }
    }
  }

  int every() const { return method_.generation == Generation::kNone ? 1 : arguments_.every; }

  ColorEncoding encoding() const {
    return sequences_.front().color_space == ColorSpace::kLinear ? ColorEncoding::kLinearHdr
                                                                 : ColorEncoding::kDisplay;
  }

  bool OneGrid() const {
    return std::all_of(sequences_.begin(), sequences_.end(),
                       [](const Sequence& sequence) { return sequence.render == sequence.output; });
  }

  // `frames`: as on the command line.
  std::vector<ProfileClip> Load(const std::string& frames) const {
    std::vector<FrameRange> ranges;
    std::vector<double> work;
    for (const Sequence& sequence : sequences_) {
      ranges.push_back(ParseFrames(frames, sequence));
      const double pixels = static_cast<double>(sequence.output.width) * sequence.output.height;
      work.push_back(pixels * ranges.back().count);
    }
    const std::vector<int> owners = BalancedOwners(work, Ranks::World().count());
    std::vector<ProfileClip> clips;
    for (std::size_t i = 0; i < sequences_.size(); ++i) {
      clips.push_back(LoadOne(sequences_[i], ranges[i], owners[i]));
    }
    return clips;
  }

  // All that decides the scores, beside the files' contents.
  std::string Identity() const {
    const PipelineArguments& a = arguments_.pipeline;
    std::string text = fmt::format("{} {} {} {} {} {} {} {} {} {}", pipeline_.filter_name(),
                                   a.lookup, a.params, a.frames, a.generated, a.motion_filter,
                                   a.history, a.texels, every(), arguments_.within);
    for (const float alpha : a.alphas) text += fmt::format(" {}", alpha);
    text += method_.name;
    for (const Sequence& sequence : sequences_) text += SequenceJson(sequence);
    return text;
  }

  std::vector<ProfiledSequence> Names() const {
    std::vector<ProfiledSequence> names;
    for (const Sequence& sequence : sequences_) {
      names.push_back({.name = sequence.name,
                       .sha1 = Sha1OfFile(sequence.folder / Sequence::kManifest),
                       .has_reference = HasReference(sequence)});
    }
    return names;
  }

 private:
  ProfileClip LoadOne(const Sequence& sequence, const FrameRange& range, int owner) const {
    ProfileClip clip;
    clip.has_reference = HasReference(sequence);
    clip.owner = owner;
    const Ranks& ranks = Ranks::World();
    if (ranks.rank() != owner && !ranks.IsRoot()) return clip;
    clip.input = pipeline_.Load(sequence, range, {&method_}, Streams::kNone, every(), true);
    if (method_.super_resolution) {
      // Without super resolution the rendered frames are shown, not the references.
      for (ClipFrame& frame : clip.input.frames) frame.reference = ImageBuffer();
    }
    const Streams truth = AvailableStreams(sequence) & kTruthStreams;
    clip.truth = LoadClip(sequence, range.first, range.count, truth);
    if (ranks.rank() == owner) WarnOfLimitedColor({&clip.input, &clip.truth});
    return clip;
  }

  // Whether the method's frames are on the grid of references.
  bool HasReference(const Sequence& sequence) const {
    const Streams available = AvailableStreams(sequence);
    return Contains(available, Streams::kReference) &&
           (method_.super_resolution || GeneratesFromReferences(available));
  }

  const ProfileArguments& arguments_;
  const Pipeline& pipeline_;
  const MethodInfo& method_;
  std::vector<Sequence> sequences_;
};

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

void TryTables(const ProfileArguments& arguments, PipelineMeter& meter, Progress& progress,
               ProfileReport& report) {
  if (arguments.pipeline.lut.empty()) return;
  const ProfiledPipeline& chosen = report.result.chosen;
  report.tables_in_chosen = chosen.ReadsTable();
  const LoadedTable loaded = LoadTable(arguments.pipeline.lut, TableFormat::kF32);
  report.tables = TrySmallerTables(
      meter, report.tables_in_chosen ? chosen : report.full, ToRealTable(loaded.table.view()),
      report.result.full_scores, [&](double share) {
        progress.Update(kSearchShare + (1 - kSearchShare) * share, "smaller tables");
      });
  if (!report.tables_in_chosen) return;
  const SmallerTable* smallest = SmallestWithin(report.tables, chosen.warp().lookup, report.within);
  if (smallest == nullptr) return;
  report.table = *smallest;
  if (IsFit(arguments.pipeline.lut)) {
    const std::filesystem::path folder = std::filesystem::path(arguments.out).parent_path();
    report.bake =
        fmt::format("warplut bake {} --format {} --out {}", ShellQuoted(arguments.pipeline.lut),
                    Name(smallest->format), ShellQuoted(folder.empty() ? "." : folder.string()));
  }
}

ProfileReport Profile(const ProfileArguments& arguments, const MethodInfo& method,
                      const Pipeline& pipeline, const Content& content) {
  const ModeRunOptions options = pipeline.Options(method, content.every());
  const auto check = [] { ThrowIfInterrupted("profile", "nothing was written"); };
  ProfileReport report{.version = WARPLUT_VERSION,
                       .mode = arguments.mode,
                       .filter = pipeline.filter_name(),
                       .within = arguments.within,
                       .sequences = content.Names(),
                       .searched_frames = arguments.pipeline.frames,
                       .full = FullPipeline(options, content.OneGrid()),
                       .result = {},
                       .tables = {},
                       .table = {},
                       .tiles = {},
                       .time_by_tiles = {}};
  Progress progress("profiling", 1, "");
  const ProfileSearch search(report.full, arguments.within, [&](double share) {
    progress.Update(kSearchShare * share, "pipelines");
  });
  const auto meter_of = [&](const std::string& frames) {
    return PipelineMeter(content.Load(frames), report.full, options, arguments.pipeline.threads,
                         check);
  };
  PipelineMeter meter = meter_of(arguments.pipeline.frames);
  report.result = search.Search(meter);
  const ProfiledPipeline shipped = ShippedPipeline(options, content.OneGrid());
  if (arguments.pipeline.frames.empty()) {
    search.Check(meter, shipped, &report.result);
  } else {
    PipelineMeter whole = meter_of("");
    search.Check(whole, shipped, &report.result);
  }
  report.tiles = CountTiles(meter, report.full);
  report.time_by_tiles = TimeByTiles(meter, report.full, kRoundPasses);
  TryTables(arguments, meter, progress, report);
  return report;
}

std::string Markdown(const ProfileReport& report) {
  std::string text = ToMarkdown(SummaryTable(report));
  for (const TextTable& table :
       {AloneTable(report), TogetherTable(report), TablesTable(report), TileTable(report)}) {
    if (!table.rows.empty()) text += '\n' + ToMarkdown(table);
  }
  return text;
}

ExitCode RunProfile(ProfileArguments arguments) {
  if (!arguments.generated_given) arguments.pipeline.generated = std::max(1, arguments.every - 1);
  RequireUsage(arguments.within >= 0 && std::isfinite(arguments.within),
               fmt::format("--within is {}; expected at least 0", arguments.within));
  const MethodInfo* method = AsUsage([&] {
    const MethodInfo* known = &ProfiledMethod(arguments);
    CheckArguments(arguments.pipeline);
    return known;
  });
  const std::filesystem::path out = arguments.out;
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) RequireWritable(out);
  const ThreadLimit limit(arguments.pipeline.threads);
  const Pipeline pipeline(arguments.pipeline);
  const Content content(arguments, pipeline, *method);
  ranks.RequireSame("the options or the sequences", content.Identity());
  const ProfileReport report = Profile(arguments, *method, pipeline, content);
  if (!ranks.IsRoot()) return ExitCode::kDone;
  if (out.has_parent_path()) CreateFolder(out.parent_path());
  WriteFile(out, PipelineHeader(Banner(report),
                                ConfigurationOf(report.result.chosen, content.encoding())));
  if (arguments.json) {
    Json json = {{"pipeline", arguments.out}};
    json.update(ToJson(report));
    PrintJson(json);
  } else {
    Print(arguments.markdown ? Markdown(report) : ToText(report));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddProfileCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<ProfileArguments>();
  ProfileArguments& a = *arguments;
  Command command =
      app.AddCommand("profile", "Find the passes that content can do without and write PIPELINE.h");
  command.Add("--sequence", a.sequences, "Sequences to profile, best with references").Required();
  command.Add("--mode", a.mode, "Method to profile: sr, i, e, isr or esr").ShowDefault();
  command.Add("--out", a.out, "Header to write").Required();
  command
      .Add("--within", a.within,
           "Largest loss of SSIM against the full pipeline, on the worst sequence")
      .ShowDefault();
  command.Add("--every", a.every, "Render every N-th frame, in modes that generate")
      .Within(2, 64)
      .ShowDefault();
  AddTableOptions(command, &a.pipeline);
  AddPipelineOptions(command, &a.pipeline);
  CommandOption markdown =
      command.AddFlag("--markdown", a.markdown, "Print the tables as Markdown");
  markdown.Excludes(AddJsonOption(command, &a.json));
  command.OnParsed([arguments, run, command] {
    arguments->generated_given = command.Given("--generated") || command.Given("--alpha");
    *run = [arguments] { return RunProfile(*arguments); };
  });
}

}  // namespace warplut
