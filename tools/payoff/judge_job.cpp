#include "tools/payoff/judge_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "datasets/file.h"
#include "tools/judge/sequence_judging.h"
#include "tools/thread_limit.h"
#include "tools/usage_error.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

using MethodList = std::vector<const MethodInfo*>;

// Methods that read no parameter are there to compare with.
bool IsBaseline(const MethodInfo& method) {
  return method.parameters.empty() && !method.optical_flow;
}

void AddOnce(const MethodInfo& method, MethodList& methods) {
  if (std::find(methods.begin(), methods.end(), &method) == methods.end()) {
    methods.push_back(&method);
  }
}

// The baselines to compare the methods with.
MethodList BaselinesOf(const MethodList& asked) {
  MethodList baselines;
  for (const MethodInfo& method : Methods()) {
    if (!IsBaseline(method)) continue;
    if (std::any_of(asked.begin(), asked.end(),
                    [&](const MethodInfo* one) { return AreComparable(*one, method); })) {
      baselines.push_back(&method);
    }
  }
  return baselines;
}

// The methods and targets, or a UsageError.
struct CheckedRequest {
  MethodList methods;       // that were asked for, then baselines
  VariantOptions variants;  // of the same methods
  std::vector<SequenceTarget> targets;
};

CheckedRequest Check(const JudgeRequest& request) {
  CheckedRequest checked;
  VariantOptions& variants = checked.variants;
  for (const std::string& mode : request.modes) AddOnce(MethodOf(mode), variants.methods);
  variants.beside = BaselinesOf(variants.methods);
  variants.against = request.against;
  CheckAgainst(variants);
  checked.methods = variants.methods;
  for (const MethodInfo* baseline : variants.beside) AddOnce(*baseline, checked.methods);
  CheckDevice(request.device);
  CheckArguments(request.pipeline);
  for (const std::string& text : request.targets) {
    const SequenceTarget target = ParseSequenceTarget(text);
    if (std::none_of(checked.methods.begin(), checked.methods.end(),
                     [&](const MethodInfo* method) { return target.method == method->name; })) {
      throw Error(fmt::format("the target '{}' names a method that --modes does not", text));
    }
    checked.targets.push_back(target);
  }
  return checked;
}

struct CheckedRuns {
  std::optional<PipelineVariants> variants;  // with --against
  std::vector<JudgedRun> runs;
};

CheckedRuns RunsFor(CheckedRequest& checked, const PipelineArguments& arguments,
                    const std::vector<Sequence>& sequences) {
  CheckedRuns runs;
  if (checked.variants.against.empty()) {
    runs.runs = RunsOf(checked.methods);
    return runs;
  }
  checked.variants.one_grid =
      std::all_of(sequences.begin(), sequences.end(),
                  [](const Sequence& sequence) { return sequence.render == sequence.output; });
  runs.variants.emplace(checked.variants, arguments);
  runs.runs = runs.variants->runs();
  return runs;
}

}  // namespace

JudgeOutcome Judge(const JudgeRequest& request) {
  const ThreadLimit limit(request.pipeline.threads);
  CheckedRequest checked = AsUsage([&] { return Check(request); });
  const std::unique_ptr<ModeDevice> device = OpenDevice(request.device);
  if (!request.pictures.empty() && Ranks::World().IsRoot()) {
    RequireWritableFolder(request.pictures);
  }
  const Pipeline pipeline(request.pipeline);
  std::vector<Sequence> sequences;
  for (const std::string& path : request.sequences) {
    sequences.push_back(ReadSequenceFor(pipeline, path, checked.methods));
  }
  CheckedRuns runs = RunsFor(checked, request.pipeline, sequences);
  JudgedSequences judged = JudgeSequences({.runs = runs.runs,
                                           .every = request.every,
                                           .border = request.border,
                                           .settled = request.settled,
                                           .jitter = request.jitter,
                                           .pictures = request.pictures,
                                           .device = device.get(),
                                           .pipeline = request.pipeline},
                                          pipeline, sequences);
  JudgeOutcome outcome{.filter = pipeline.filter_name(),
                       .texels = request.pipeline.texels,
                       .reports = std::move(judged.reports),
                       .pictures = std::move(judged.pictures),
                       .payoff = {},
                       .missed = {}};
  if (runs.variants) {
    outcome.payoff = MakePayoffReport(runs.variants->list(), outcome.reports, outcome.filter,
                                      !request.pipeline.lut.empty(), request.pipeline.params);
  }
  for (const SequenceTarget& target : checked.targets) {
    for (std::string& sentence : MissedSequences(target, outcome.reports)) {
      outcome.missed.push_back(std::move(sentence));
    }
  }
  return outcome;
}

std::string ToText(const JudgeOutcome& outcome, bool markdown) {
  std::vector<SequenceReport> reports = outcome.reports;
  if (reports.size() > 1) reports.push_back(MeanReport(reports));
  std::string text;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const TextTable table =
        outcome.payoff ? ToTable(outcome.payoff->tables[i]) : MethodTable(reports[i]);
    text += (markdown ? ToMarkdown(table) : ToText(table)) + "\n";
    for (const std::string& note : reports[i].notes) text += note + "\n";
  }
  if (outcome.payoff) text += PayoffText(*outcome.payoff, markdown);
  for (const std::string& line : outcome.pictures) text += line + "\n";
  for (const std::string& sentence : outcome.missed) text += "missed: " + sentence + "\n";
  return text;
}

Json ToJson(const JudgeOutcome& outcome) {
  Json sequences = Json::array();
  for (const SequenceReport& report : outcome.reports) sequences.push_back(ToJson(report));
  Json document = {{"filter", outcome.filter},
                   {"texels", outcome.texels},
                   {"sequences", sequences},
                   {"pictures", outcome.pictures},
                   {"missed", outcome.missed}};
  if (outcome.payoff) document["payoff"] = ToJson(*outcome.payoff);
  return document;
}

}  // namespace warplut
