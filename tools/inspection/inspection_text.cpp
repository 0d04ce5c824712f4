#include "tools/inspection/inspection_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "datasets/json_fields.h"
#include "tools/tables/record_table.h"

namespace warplut {
namespace {

const char* NameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kAgrees:
      return "agrees";
    case Verdict::kContradicts:
      return "CONTRADICTS";
    default:
      return "cannot tell";
  }
}

// All rankings in the order in which they were asked.
std::vector<const Ranking*> Rankings(const Inspection& inspection) {
  std::vector<const Ranking*> all;
  for (const Ranking& ranking : inspection.motion.rankings) all.push_back(&ranking);
  for (const Ranking& ranking : inspection.jitter.rankings) all.push_back(&ranking);
  if (inspection.depth) {
    all.push_back(&inspection.depth->order);
    all.push_back(&inspection.depth->curve);
  }
  return all;
}

std::string MarginText(const RankedCandidate& candidate) {
  return fmt::format("{:+.2f} +- {:.2f}", candidate.margin, candidate.standard_error);
}

void AddRow(const Ranking& ranking, bool all, TextTable* table) {
  std::vector<std::string> row = {ranking.question, ranking.stated, ranking.found,
                                  NameOf(ranking.verdict)};
  if (ranking.verdict == Verdict::kCannotTell) row[2] = "?";
  if (ranking.candidates.size() > 1) {
    row.push_back(ranking.candidates[1].name);
    row.push_back(MarginText(ranking.candidates[1]));
  }
  table->rows.push_back(std::move(row));
  if (!all) return;
  for (std::size_t i = 0; i < ranking.candidates.size(); ++i) {
    const RankedCandidate& candidate = ranking.candidates[i];
    table->rows.push_back({fmt::format("  {}. {}", i + 1, candidate.name), "", "",
                           fmt::format("{:.2f} dB", candidate.score), "",
                           i == 0 ? "" : MarginText(candidate)});
  }
}

std::string ConventionText(const Inspection& inspection, bool all) {
  std::string text;
  TextTable table{
      .header = {"question", "manifest", "frames say", "verdict", "next best", "margin dB"},
      .rows = {}};
  for (const Ranking* ranking : Rankings(inspection)) AddRow(*ranking, all, &table);
  const Ranking& contained = inspection.jitter.contained;
  if (!contained.question.empty() && inspection.answered.motion) {
    const bool told = !contained.found.empty();
    const bool same = contained.found == contained.stated;
    table.rows.push_back({contained.question, contained.stated, told ? contained.found : "?",
                          !told  ? "cannot tell"
                          : same ? "agrees"
                                 : "CONTRADICTS"});
  }
  if (!table.rows.empty()) {
    text += fmt::format(
                "\nConvention, from {} frames (margins over the next best answer, with "
                "standard errors over frames):\n",
                inspection.frames) +
            ToText(table);
  }
  if (inspection.jitter.alignment) {
    const auto& [offset, error] = *inspection.jitter.alignment;
    text += fmt::format(
        "Frames lie at ({:.3f} +- {:.3f}, {:.3f} +- {:.3f}) render pixels on their references, "
        "beside the jitter.\n",
        offset.x, error.x, offset.y, error.y);
  }
  std::vector<std::string> reasons;
  const auto add = [&](const std::string& what, const std::string& reason) {
    if (!reason.empty()) reasons.push_back(fmt::format("{}: {}", what, reason));
  };
  add("motion", inspection.motion.reason);
  add("jitter", inspection.jitter.reason);
  if (inspection.depth) {
    add(inspection.depth->order.question, inspection.depth->order.reason);
    add(inspection.depth->curve.question, inspection.depth->curve.reason);
  }
  for (const std::string& reason : reasons) text += fmt::format("Cannot tell {}.\n", reason);
  return text;
}

std::string ContradictionText(const Inspection& inspection) {
  std::string text;
  for (const Ranking* ranking : Rankings(inspection)) {
    if (ranking->verdict != Verdict::kContradicts) continue;
    const auto stated = std::find_if(ranking->candidates.begin(), ranking->candidates.end(),
                                     [](const RankedCandidate& c) { return c.stated; });
    text += fmt::format("CONTRADICTION: {} is {}, the manifest says {}", ranking->question,
                        ranking->found, ranking->stated);
    if (stated != ranking->candidates.end()) {
      text += fmt::format(" ({:.2f} +- {:.2f} dB worse)", stated->margin, stated->standard_error);
    }
    text += ".\n";
  }
  const Ranking& contained = inspection.jitter.contained;
  if (!contained.found.empty() && contained.found != contained.stated) {
    text += fmt::format("CONTRADICTION: the jitter is {} in the motion, the manifest says {}.\n",
                        contained.found, contained.stated);
  }
  if (text.empty() && inspection.Contradictions() > 0) {
    const PairedDifference& over = inspection.motion.verdict == Verdict::kContradicts
                                       ? inspection.motion.over_stated
                                       : inspection.jitter.over_stated;
    text = fmt::format(
        "CONTRADICTION: another convention explains the frames better by {:.2f} +- "
        "{:.2f} dB, but not which one.\n",
        over.mean, over.standard_error);
  }
  return text;
}

std::string StreamText(const Sequence& sequence, const std::vector<StreamInspection>& streams) {
  std::string text = fmt::format(
      "{}: frames {} to {}, {} x {} rendered, {} x {} wanted, {} colour, {} jitter offsets, {}, {} "
      "cuts\n",
      sequence.name, sequence.first, sequence.LastNumber(), sequence.render.width,
      sequence.render.height, sequence.output.width, sequence.output.height,
      sequence.color_space == ColorSpace::kLinear ? "linear" : "srgb", sequence.jitter.size(),
      sequence.camera.empty() ? "no cameras" : "cameras", sequence.cuts.size());
  TextTable table{.header = {"stream", "frames", "least", "greatest", "mean"}, .rows = {}};
  for (const StreamInspection& stream : streams) {
    table.rows.push_back(
        {stream.name, fmt::format("{}", stream.frames), fmt::format("{:.4g}", stream.least),
         fmt::format("{:.4g}", stream.greatest), fmt::format("{:.4g}", stream.mean)});
  }
  text += ToText(table) + "Depth is without background; motion is its length in pixels.\n";
  for (const StreamInspection& stream : streams) {
    if (!stream.problems.empty()) text += ProblemText(stream) + "\n";
  }
  return text;
}

Json RankingJson(const Ranking& ranking) {
  Json candidates = Json::array();
  for (const RankedCandidate& candidate : ranking.candidates) {
    candidates.push_back({{"name", candidate.name},
                          {"score", FiniteJson(candidate.score)},
                          {"margin", FiniteJson(candidate.margin)},
                          {"standard_error", FiniteJson(candidate.standard_error)}});
  }
  return {{"question", ranking.question}, {"stated", ranking.stated},
          {"found", ranking.found},       {"verdict", NameOf(ranking.verdict)},
          {"reason", ranking.reason},     {"candidates", candidates}};
}

}  // namespace

std::string InspectionText(const Sequence& sequence, const std::vector<StreamInspection>& streams,
                           const Inspection& inspection, bool all) {
  std::string text = StreamText(sequence, streams);
  text += ConventionText(inspection, all);
  const std::string contradictions = ContradictionText(inspection);
  if (!contradictions.empty()) text += "\n" + contradictions;
  if (!inspection.findings.empty()) text += "\n";
  for (const Finding& finding : inspection.findings) {
    text += fmt::format("{} {}: {}\n", finding.severity == Severity::kNote ? "note" : "warning",
                        finding.what, finding.sentence);
  }
  return text;
}

Json InspectionJson(const Sequence& sequence, const std::vector<StreamInspection>& streams,
                    const Inspection& inspection) {
  Json list = Json::array();
  for (const StreamInspection& stream : streams) {
    list.push_back({{"name", stream.name},
                    {"frames", stream.frames},
                    {"least", stream.least},
                    {"greatest", stream.greatest},
                    {"mean", stream.mean},
                    {"problems", stream.problems}});
  }
  Json questions = Json::array(), findings = Json::array();
  for (const Ranking* ranking : Rankings(inspection)) questions.push_back(RankingJson(*ranking));
  if (!inspection.jitter.contained.question.empty()) {
    questions.push_back(RankingJson(inspection.jitter.contained));
  }
  for (const Finding& finding : inspection.findings) {
    findings.push_back({{"what", finding.what},
                        {"severity", finding.severity == Severity::kNote ? "note" : "warning"},
                        {"sentence", finding.sentence}});
  }
  return {{"name", sequence.name},
          {"first", sequence.first},
          {"frames", sequence.count},
          {"render", {sequence.render.width, sequence.render.height}},
          {"output", {sequence.output.width, sequence.output.height}},
          {"color_space", sequence.color_space == ColorSpace::kLinear ? "linear" : "srgb"},
          {"jitter_offsets", sequence.jitter.size()},
          {"cameras", sequence.camera.size()},
          {"cuts", sequence.cuts},
          {"streams", list},
          {"questions", questions},
          {"contradictions", inspection.Contradictions()},
          {"findings", findings}};
}

}  // namespace warplut
