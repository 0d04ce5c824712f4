#include "tools/judge/sequence_judging.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "datasets/error.h"
#include "tools/pictures/sequence_pictures.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/terminal/warning.h"
#include "train/ranks/ranks.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

// One sequence in memory: what is judged by, which is also what methods that see every frame run
// on, and what methods that generate run on.
struct LoadedSequence {
  Clip truth;
  std::optional<Clip> sparse;

  const Clip& ClipFor(const MethodInfo& method) const {
    return Generates(method) ? *sparse : truth;
  }
};

class SequenceJudging {
 public:
  SequenceJudging(const SequenceJudgingOptions& options, const Pipeline& pipeline,
                  const std::vector<Sequence>& sequences)
      : options_(options),
        pipeline_(pipeline),
        sequences_(sequences),
        pool_(options.pipeline.threads) {
    std::vector<double> work;
    for (const Sequence& sequence : sequences) {
      ranges_.push_back(ParseFrames(options.pipeline.frames, sequence));
      const double pixels = static_cast<double>(sequence.output.width) * sequence.output.height;
      work.insert(work.end(), options.runs.size(), pixels * ranges_.back().count);
    }
    owners_ = ContiguousOwners(work, ranks_.count());
    ranks_.RequireSame("the options or the sequences", Identity());
  }

  JudgedSequences Judge() {
    JudgedSequences judged;
    std::vector<std::vector<double>> scores(owners_.size());
    for (std::size_t s = 0; s < sequences_.size(); ++s) JudgeOwn(s, scores, judged.pictures);
    ranks_.Exchange(owners_, scores);
    for (std::size_t s = 0; s < sequences_.size(); ++s) {
      SequenceReport& report = judged.reports.emplace_back();
      report.sequence = sequences_[s].name + (options_.pipeline.texels ? ", texels" : "");
      for (std::size_t r = 0; r < options_.runs.size(); ++r) {
        report.methods.push_back(FromNumbers(options_.runs[r].name, scores[Piece(s, r)]));
      }
      report.notes = JudgingNotes(sequences_[s], JudgedMethods());
      const std::string why =
          options_.jitter ? WhyNoJitterError(sequences_[s], ranges_[s].first, ranges_[s].count)
                          : "";
      if (!why.empty()) {
        report.notes.push_back(
            fmt::format("'{}' has no error of the jitter: {}.", sequences_[s].name, why));
      }
    }
    return judged;
  }

 private:
  std::size_t Piece(std::size_t sequence, std::size_t run) const {
    return sequence * options_.runs.size() + run;
  }

  bool Owns(std::size_t sequence, std::size_t run) const {
    return owners_[Piece(sequence, run)] == ranks_.rank();
  }

  // The methods of the runs, each once.
  std::vector<const MethodInfo*> JudgedMethods() const {
    std::vector<const MethodInfo*> methods;
    for (const JudgedRun& run : options_.runs) {
      if (std::find(methods.begin(), methods.end(), run.method) == methods.end()) {
        methods.push_back(run.method);
      }
    }
    return methods;
  }

  // All that decides the scores, beside the files' contents.
  std::string Identity() const {
    const PipelineArguments& a = options_.pipeline;
    std::string text =
        fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", pipeline_.filter_name(), a.lookup,
                    a.params, a.generated, a.motion_filter, a.coherent_share, a.history, a.texels,
                    options_.every, options_.border, options_.jitter,
                    options_.device != nullptr ? options_.device->name() : "");
    for (const float alpha : a.alphas) text += fmt::format(" {}", alpha);
    for (const JudgedRun& run : options_.runs) text += fmt::format(" {}", run.name);
    for (std::size_t s = 0; s < sequences_.size(); ++s) {
      text +=
          fmt::format(" {} {} {}", SequenceJson(sequences_[s]), ranges_[s].first, ranges_[s].count);
    }
    return text;
  }

  // The pieces of one sequence that this rank owns, and the pictures if it is the root.
  void JudgeOwn(std::size_t s, std::vector<std::vector<double>>& scores,
                std::vector<std::string>& pictures) {
    std::vector<std::size_t> own;
    for (std::size_t r = 0; r < options_.runs.size(); ++r) {
      if (Owns(s, r)) own.push_back(r);
    }
    const bool draws = !options_.pictures.empty() && ranks_.IsRoot();
    if (own.empty() && !draws) return;
    const LoadedSequence loaded = Load(s);
    Progress progress("judging " + sequences_[s].name, static_cast<double>(own.size()), "runs");
    for (const std::size_t r : own) {
      const JudgedRun& run = options_.runs[r];
      SequenceJudge judge(loaded.truth, *run.method, options_.border, options_.settled,
                          options_.jitter);
      Run(loaded, run, [&](const ShownFrame& shown) { judge.Add(shown); });
      scores[Piece(s, r)] = ToNumbers(judge.Finish());
      progress.Add(1);
    }
    if (!draws) return;
    for (const std::string& line : WritePictures(loaded)) pictures.push_back(line);
  }

  LoadedSequence Load(std::size_t s) const {
    const Sequence& sequence = sequences_[s];
    std::vector<const MethodInfo*> dense, sparse;
    Streams truth = Streams::kNone;
    for (const MethodInfo* method : JudgedMethods()) {
      (Generates(*method) ? sparse : dense).push_back(method);
      truth = truth | JudgingStreams(*method, AvailableStreams(sequence));
    }
    LoadedSequence loaded;
    loaded.truth = pipeline_.Load(sequence, ranges_[s], dense, truth, 1);
    if (!sparse.empty()) {
      loaded.sparse = pipeline_.Load(sequence, ranges_[s], sparse, Streams::kNone, options_.every);
    }
    if (Owns(s, 0)) WarnOfLimitedColor({&loaded.truth, loaded.sparse ? &*loaded.sparse : nullptr});
    return loaded;
  }

  void Run(const LoadedSequence& loaded, const JudgedRun& run, const ShownFrameSink& sink) {
    const MethodInfo& method = *run.method;
    ModeRunOptions options = pipeline_.Options(method, Generates(method) ? options_.every : 1);
    options.device = options_.device;
    const Clip& clip = loaded.ClipFor(method);
    std::string why;
    if (!options.IsValid(clip, &why)) throw Error(why);
    const ShownFrameSink interruptible = [&](const ShownFrame& shown) {
      ThrowIfInterrupted("judging", "nothing was printed");
      sink(shown);
    };
    if (run.run) {
      run.run(clip, options, pool_, interruptible);
    } else {
      RunMode(clip, options, pool_, interruptible);
    }
  }

  void RunJudged(const LoadedSequence& loaded, const JudgedRun& run, const ShownFrameSink& sink) {
    Run(loaded, run, [&](const ShownFrame& shown) {
      if (IsJudged(*run.method, shown)) sink(shown);
    });
  }

  std::vector<std::string> WritePictures(const LoadedSequence& loaded) {
    WindowChooser chooser(loaded.truth);
    RunJudged(loaded, options_.runs.front(), [&](const ShownFrame& shown) { chooser.Add(shown); });
    SequencePictures pictures(loaded.truth, chooser.Windows());
    for (const JudgedRun& run : options_.runs) {
      if (!run.drawn) continue;
      RunJudged(loaded, run, [&](const ShownFrame& shown) { pictures.Add(run.name, shown); });
    }
    return pictures.Write(options_.pictures);
  }

  const SequenceJudgingOptions& options_;
  const Pipeline& pipeline_;
  const std::vector<Sequence>& sequences_;
  Ranks& ranks_ = Ranks::World();
  ThreadPool pool_;
  std::vector<FrameRange> ranges_;
  std::vector<int> owners_;  // of each run on each sequence, sequence by sequence
};

}  // namespace

std::vector<JudgedRun> RunsOf(const std::vector<const MethodInfo*>& methods) {
  std::vector<JudgedRun> runs;
  for (const MethodInfo* method : methods) runs.push_back({.name = method->name, .method = method});
  return runs;
}

JudgedSequences JudgeSequences(const SequenceJudgingOptions& options, const Pipeline& pipeline,
                               const std::vector<Sequence>& sequences) {
  return SequenceJudging(options, pipeline, sequences).Judge();
}

}  // namespace warplut
