#include "tools/judge/sequence_report.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "datasets/error.h"
#include "tools/judge/score_columns.h"

namespace warplut {
namespace {

using Row = std::vector<std::string>;

void Append(const Row& more, Row& row) { row.insert(row.end(), more.begin(), more.end()); }

Row ScoreCells(const FrameScore& score, double temporal) {
  return RecordRow(kScoreColumns, TimedScore{score, temporal});
}

Row NamedRow(const std::string& name, const FrameScore& score, double temporal) {
  Row row = {name};
  Append(ScoreCells(score, temporal), row);
  return row;
}

std::string SettledName(const SettledScores& settled) {
  return fmt::format("without {}", settled.left_out);
}

Json MeansToJson(const FrameScore& score, double temporal) {
  return RecordJson(kScoreColumns, TimedScore{score, temporal});
}

// The headings behind `first`.
TextTable ScoreHeader(const std::string& first) {
  TextTable table{.header = {first}, .rows = {}};
  Append(RecordHeader(kScoreColumns).header, table.header);
  return table;
}

bool ParseDouble(std::string_view text, double* value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(*value);
}

}  // namespace

TextTable MethodTable(const SequenceReport& report) {
  TextTable table = ScoreHeader(report.sequence);
  const std::optional<SettledScores>& first = report.methods.front().settled;
  if (first) {
    Row settled = RecordHeader(kScoreColumns).header;
    settled.front() = SettledName(*first) + ": " + settled.front();
    Append(settled, table.header);
  }
  const bool jitter = report.methods.front().jitter.has_value();
  if (jitter) Append(RecordHeader(kJitterColumns).header, table.header);
  table.header.emplace_back("ms/frame");
  for (const SequenceScores& scores : report.methods) {
    Row row = NamedRow(scores.method, scores.mean, scores.temporal_error);
    if (first) Append(ScoreCells(scores.settled->mean, scores.settled->temporal_error), row);
    if (jitter) Append(RecordRow(kJitterColumns, *scores.jitter), row);
    row.push_back(scores.milliseconds > 0 ? fmt::format("{:.1f}", scores.milliseconds) : "-");
    table.rows.push_back(row);
  }
  return table;
}

TextTable FrameTable(const SequenceScores& scores) {
  TextTable table = ScoreHeader(scores.method);
  for (std::size_t i = 0; i < scores.frames.size(); ++i) {
    table.rows.push_back(NamedRow(scores.frames[i].name, scores.frames[i], scores.temporal[i]));
  }
  table.rows.push_back(NamedRow("mean", scores.mean, scores.temporal_error));
  if (const auto& settled = scores.settled) {
    table.rows.push_back(
        NamedRow("mean " + SettledName(*settled), settled->mean, settled->temporal_error));
  }
  return table;
}

SequenceReport MeanReport(const std::vector<SequenceReport>& reports) {
  SequenceReport mean{.sequence = "mean", .methods = {}, .notes = {}};
  const auto count = static_cast<double>(reports.size());
  for (std::size_t m = 0; m < reports.front().methods.size(); ++m) {
    SequenceScores scores;
    scores.method = reports.front().methods[m].method;
    std::vector<FrameScore> means, settled_means;
    SettledScores settled;
    for (const SequenceReport& report : reports) {
      means.push_back(report.methods[m].mean);
      scores.temporal_error += report.methods[m].temporal_error / count;
      scores.milliseconds += report.methods[m].milliseconds / count;
      if (const auto& one = report.methods[m].jitter) {
        if (!scores.jitter) scores.jitter.emplace();
        scores.jitter->repeating += one->repeating / count;
        scores.jitter->lattice += one->lattice / count;
      }
      if (const auto& one = report.methods[m].settled) {
        settled.left_out = one->left_out;
        settled.temporal_error += one->temporal_error / count;
        settled_means.push_back(one->mean);
      }
    }
    scores.mean = MeanScore(means);
    if (!settled_means.empty()) {
      settled.mean = MeanScore(settled_means);
      scores.settled = settled;
    }
    mean.methods.push_back(scores);
  }
  return mean;
}

Json ToJson(const SequenceReport& report) {
  Json methods = Json::array();
  for (const SequenceScores& scores : report.methods) {
    Json frames = Json::array();
    for (std::size_t i = 0; i < scores.frames.size(); ++i) {
      frames.push_back({{"name", scores.frames[i].name}});
      frames.back().update(MeansToJson(scores.frames[i], scores.temporal[i]));
    }
    Json method = {{"method", scores.method}};
    method.update(MeansToJson(scores.mean, scores.temporal_error));
    if (const auto& settled = scores.settled) {
      method["settled"] = {{"left_out", settled->left_out}};
      method["settled"].update(MeansToJson(settled->mean, settled->temporal_error));
    }
    if (scores.jitter) method.update(RecordJson(kJitterColumns, *scores.jitter));
    method["milliseconds"] = scores.milliseconds;
    method["frames"] = frames;
    methods.push_back(method);
  }
  return {{"sequence", report.sequence}, {"methods", methods}, {"notes", report.notes}};
}

SequenceTarget ParseSequenceTarget(const std::string& text) {
  const std::string_view all = text;
  const auto first = all.find(','), last = all.rfind(',');
  SequenceTarget target;
  if (first != std::string_view::npos && first > 0 && first < last) {
    target.method = all.substr(0, first);
    if (ParseDouble(all.substr(first + 1, last - first - 1), &target.psnr) &&
        ParseDouble(all.substr(last + 1), &target.ssim)) {
      return target;
    }
  }
  throw Error(
      fmt::format("the target is '{}'; expected METHOD,PSNR,SSIM, as in sr,31.4,.93", text));
}

std::vector<std::string> MissedSequences(const SequenceTarget& target,
                                         const std::vector<SequenceReport>& reports) {
  std::vector<std::string> missed;
  for (const SequenceReport& report : reports) {
    for (const SequenceScores& scores : report.methods) {
      if (scores.method != target.method) continue;
      if (scores.mean.psnr >= target.psnr && scores.mean.ssim >= target.ssim) continue;
      missed.push_back(fmt::format("{} on {} has {} dB and {:.4f}; wanted {:.2f} dB and {:.4f}",
                                   scores.method, report.sequence, PsnrCell(scores.mean.psnr).text,
                                   scores.mean.ssim, target.psnr, target.ssim));
    }
  }
  return missed;
}

}  // namespace warplut
