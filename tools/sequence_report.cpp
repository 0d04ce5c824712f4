#include "tools/sequence_report.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "datasets/error.h"

namespace warplut {
namespace {

std::string PsnrText(double psnr) {
  return std::isfinite(psnr) ? fmt::format("{:.2f}", psnr) : "equal";
}

std::string TemporalText(double error) {
  return std::isfinite(error) ? fmt::format("{:.4f}", error) : "-";
}

std::vector<std::string> ScoreCells(const std::string& name, const FrameScore& score,
                                    double temporal) {
  return {name, PsnrText(score.psnr), fmt::format("{:.4f}", score.ssim), TemporalText(temporal)};
}

// A score in JSON: null where it is not finite (equal images; no pair of frames).
nlohmann::ordered_json Finite(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

bool ParseDouble(std::string_view text, double* value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(*value);
}

}  // namespace

TextTable MethodTable(const SequenceReport& report) {
  TextTable table{.header = {report.sequence, "PSNR dB", "SSIM", "temporal", "ms/frame"},
                  .rows = {}};
  for (const SequenceScores& scores : report.methods) {
    table.rows.push_back(ScoreCells(scores.method, scores.mean, scores.temporal_error));
    table.rows.back().push_back(scores.milliseconds > 0 ? fmt::format("{:.1f}", scores.milliseconds)
                                                        : "-");
  }
  return table;
}

TextTable FrameTable(const SequenceScores& scores) {
  TextTable table{.header = {scores.method, "PSNR dB", "SSIM", "temporal"}, .rows = {}};
  for (std::size_t i = 0; i < scores.frames.size(); ++i) {
    table.rows.push_back(ScoreCells(scores.frames[i].name, scores.frames[i], scores.temporal[i]));
  }
  table.rows.push_back(ScoreCells("mean", scores.mean, scores.temporal_error));
  return table;
}

SequenceReport MeanReport(const std::vector<SequenceReport>& reports) {
  SequenceReport mean{.sequence = "mean", .methods = {}};
  const auto count = static_cast<double>(reports.size());
  for (std::size_t m = 0; m < reports.front().methods.size(); ++m) {
    SequenceScores scores;
    scores.method = reports.front().methods[m].method;
    std::vector<FrameScore> means;
    for (const SequenceReport& report : reports) {
      means.push_back(report.methods[m].mean);
      scores.temporal_error += report.methods[m].temporal_error / count;
      scores.milliseconds += report.methods[m].milliseconds / count;
    }
    scores.mean = MeanScore(means);
    mean.methods.push_back(scores);
  }
  return mean;
}

nlohmann::ordered_json ToJson(const SequenceReport& report) {
  nlohmann::ordered_json methods = nlohmann::ordered_json::array();
  for (const SequenceScores& scores : report.methods) {
    nlohmann::ordered_json frames = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < scores.frames.size(); ++i) {
      frames.push_back({{"name", scores.frames[i].name},
                        {"psnr", Finite(scores.frames[i].psnr)},
                        {"ssim", scores.frames[i].ssim},
                        {"temporal_error", Finite(scores.temporal[i])}});
    }
    methods.push_back({{"method", scores.method},
                       {"psnr", Finite(scores.mean.psnr)},
                       {"ssim", scores.mean.ssim},
                       {"temporal_error", Finite(scores.temporal_error)},
                       {"milliseconds", scores.milliseconds},
                       {"frames", frames}});
  }
  return {{"sequence", report.sequence}, {"methods", methods}};
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
                                   scores.method, report.sequence, PsnrText(scores.mean.psnr),
                                   scores.mean.ssim, target.psnr, target.ssim));
    }
  }
  return missed;
}

}  // namespace warplut
