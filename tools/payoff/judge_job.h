// Methods judged on sequences with references: the work of `warplut judge`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/device.h"
#include "tools/judge/sequence_report.h"
#include "tools/judge/sequence_scores.h"
#include "tools/payoff/payoff_report.h"
#include "tools/pipeline.h"

namespace warplut {

struct JudgeRequest {
  std::vector<std::string> sequences;
  std::vector<std::string> modes = {"sr"};  // baselines are added
  int every = 2;                            // for methods that generate; the others see every frame
  int border = kScoreBorder;
  int settled = 0;      // judged frames that the settled means leave out; 0: there are none
  bool jitter = false;  // JitterScores
  std::string device = DeviceNames().front();
  PipelineArguments pipeline;
  std::vector<std::string> against;  // filters, tables and methods: what pays is judged too
  std::vector<std::string> targets;  // METHOD,PSNR,SSIM
  std::string pictures;              // a folder; empty: none
};

struct JudgeOutcome {
  std::string filter;
  bool texels = false;
  std::vector<SequenceReport> reports;  // one for each sequence
  std::vector<std::string> pictures;    // sentences about those that were written
  std::optional<PayoffReport> payoff;   // with `against`
  std::vector<std::string> missed;      // a sentence for each target
};

// UsageError: a request that makes no sense, told before a file is opened. Error: a sequence, a
// table, a device or a folder that cannot be used.
JudgeOutcome Judge(const JudgeRequest& request);

// A table for each sequence, one of their means where there are several, and the sentences.
std::string ToText(const JudgeOutcome& outcome, bool markdown);
Json ToJson(const JudgeOutcome& outcome);

}  // namespace warplut
