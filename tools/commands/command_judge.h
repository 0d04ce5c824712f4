// warplut judge: methods on sequences with references. `warplut eval --sequence` is the same.
#pragma once

#include <string>
#include <vector>

#include "tools/commands/command.h"
#include "tools/device.h"
#include "tools/judge/sequence_scores.h"
#include "tools/pipeline.h"

namespace warplut {

struct JudgeArguments {
  std::vector<std::string> sequences;
  std::vector<std::string> modes = {"sr"};
  int every = 2;  // for methods that generate; the others see every frame
  int border = kScoreBorder;
  int settled = 0;  // judged frames that the settled means leave out; 0: there are none
  std::string device = DeviceNames().front();
  PipelineArguments pipeline;
  std::vector<std::string> against;  // filters, tables and methods: what pays is judged too
  std::vector<std::string> targets;
  std::string pictures;
  bool markdown = false;
  bool json = false;
};

// Adds --sequence (returned), --modes, --every, --border, --settled, --device and the options of
// tables and pipelines.
CommandOption AddSequenceOptions(Command eval, JudgeArguments* arguments);

ExitCode RunJudge(const JudgeArguments& arguments);

}  // namespace warplut
