// The part of `warplut eval` that judges methods on sequences.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tools/command.h"
#include "tools/judge/sequence_scores.h"
#include "tools/pipeline.h"

namespace warplut {

// What --target, --pictures, --markdown and --json give is shared with the part that judges on
// images.
struct SequenceEvalArguments {
  std::vector<std::string> sequences;
  std::vector<std::string> modes = {"sr"};
  int every = 2;  // for methods that generate; the others see every frame
  int border = kScoreBorder;
  int settled = 0;  // judged frames that the settled means leave out; 0: there are none
  PipelineArguments pipeline;
  std::vector<std::string> targets;
  std::string pictures;
  bool markdown = false;
  bool json = false;
};

// Adds --sequence (returned), --modes, --every, --border, --settled and the options of tables and
// pipelines.
CLI::Option* AddSequenceOptions(CLI::App& eval, SequenceEvalArguments* arguments);

ExitCode RunSequenceEval(const SequenceEvalArguments& arguments);

}  // namespace warplut
