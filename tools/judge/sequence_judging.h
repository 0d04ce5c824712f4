// Methods on sequences, each on all of them: the work of `judge`, shared among ranks.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/executor.h"
#include "tools/judge/sequence_report.h"
#include "tools/pipeline.h"
#include "train/replay/mode_device.h"

namespace warplut {

// Shows the frames of a clip, from the first to the last.
using ClipRunner = std::function<void(const Clip& clip, const ModeRunOptions& options,
                                      Executor& executor, const ShownFrameSink& sink)>;

// One way to make frames, which is judged.
struct JudgedRun {
  std::string name;  // of its scores; no two runs have the same
  const MethodInfo* method =
      nullptr;          // decides which frames are judged, and which streams it takes
  ClipRunner run = {};  // with the options of the pipeline; empty: RunMode
  bool drawn = true;    // has a panel in the pictures
};

// RunMode of each method.
std::vector<JudgedRun> RunsOf(const std::vector<const MethodInfo*>& methods);

struct SequenceJudgingOptions {
  std::vector<JudgedRun> runs;  // at least one
  int every = 2;                // for methods that generate; the others see every frame
  int border = kScoreBorder;
  int settled = 0;      // judged frames that the settled means leave out; 0: there are none
  bool jitter = false;  // JitterScores
  std::filesystem::path pictures = {};  // folder of the windows where the first run errs most
  ModeDevice* device = nullptr;         // outlives the call; null: the processor
  PipelineArguments pipeline;
};

struct JudgedSequences {
  std::vector<SequenceReport> reports;
  std::vector<std::string> pictures;  // one line for each that was written, on the root alone
};

// Judges every run on every sequence. A collective call of Ranks::World(): a run on a sequence is a
// piece of work, whose owner loads the sequence and shows it from the first frame to the last;
// neighbouring pieces go to one rank (ContiguousOwners). Every rank receives all reports: the same
// bits for any number of ranks and threads, but for milliseconds, which are those of the owner. The
// root writes the pictures. A rank holds one sequence in memory at a time. `pipeline` is made from
// the same arguments. Errors: ranks with other options or sequences; as ParseFrames,
// Pipeline::Load, RunMode and SequenceJudge; an interruption.
JudgedSequences JudgeSequences(const SequenceJudgingOptions& options, const Pipeline& pipeline,
                               const std::vector<Sequence>& sequences);

}  // namespace warplut
