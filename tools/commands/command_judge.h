// warplut judge: methods on sequences with references. `warplut eval --sequence` is the same.
#pragma once

#include "tools/commands/command.h"
#include "tools/payoff/judge_job.h"

namespace warplut {

struct JudgeArguments {
  JudgeRequest request;
  bool markdown = false;
  bool json = false;
};

// Adds --sequence (returned), --modes, --every, --border, --settled, --device and the options of
// tables and pipelines.
CommandOption AddSequenceOptions(Command eval, JudgeArguments* arguments);

ExitCode RunJudge(const JudgeArguments& arguments);

}  // namespace warplut
