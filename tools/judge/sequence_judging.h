// Methods on sequences, each on all of them: the work of `judge`, shared among ranks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/executor.h"
#include "tools/judge/sequence_report.h"
#include "tools/pipeline.h"
#include "train/replay/mode_device.h"

namespace warplut {

struct SequenceJudgingOptions {
  std::vector<const MethodInfo*> methods;  // at least one
  int every = 2;                           // for methods that generate; the others see every frame
  int border = kScoreBorder;
  int settled = 0;  // judged frames that the settled means leave out; 0: there are none
  std::filesystem::path pictures;  // folder of the windows where the first method errs most
  ModeDevice* device = nullptr;    // outlives the call; null: the processor
  PipelineArguments pipeline;
};

struct JudgedSequences {
  std::vector<SequenceReport> reports;
  std::vector<std::string> pictures;  // one line for each that was written, on the root alone
};

// Judges every method on every sequence. A collective call of Ranks::World(): a method on a
// sequence is a piece of work, whose owner loads the sequence and runs the method from the first
// frame to the last; neighbouring pieces go to one rank (ContiguousOwners). Every rank receives
// all reports: the same bits for any number of ranks and threads, but for milliseconds, which are
// those of the owner. The root writes the pictures. A rank holds one sequence in memory at a time.
// `pipeline` is made from the same arguments. Errors: ranks with other options or sequences; as
// ParseFrames, Pipeline::Load, RunMode and SequenceJudge; an interruption.
JudgedSequences JudgeSequences(const SequenceJudgingOptions& options, const Pipeline& pipeline,
                               const std::vector<Sequence>& sequences);

}  // namespace warplut
