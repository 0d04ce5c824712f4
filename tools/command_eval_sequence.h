// The part of `warplut eval` that judges methods on sequences.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tools/command.h"
#include "tools/pipeline.h"
#include "tools/sequence_scores.h"

namespace warplut {

struct SequenceEvalArguments {
  std::vector<std::string> sequences;
  std::vector<std::string> modes = {"sr"};
  int every = 2;  // for methods that generate; the others see every frame
  int border = kScoreBorder;
  PipelineArguments pipeline;
  std::vector<std::string> targets;
  std::string pictures;
  bool markdown = false;
  bool json = false;
};

// Adds --sequence (returned), --modes, --every, --border and the options of the pipeline but --lut, --lookup and --threads.
CLI::Option* AddSequenceOptions(CLI::App& eval, SequenceEvalArguments* arguments);

ExitCode RunSequenceEval(const SequenceEvalArguments& arguments);

}  // namespace warplut
