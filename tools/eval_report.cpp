#include "tools/eval_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace warplut {
namespace {

nlohmann::ordered_json ToJson(const FilterScores& scores) {
  nlohmann::ordered_json json = {{"filter", scores.name}, {"ssim", scores.ssim}};
  if (!scores.keys_a.empty()) json["keys_a"] = scores.keys_a;
  return json;
}

std::vector<std::string> Row(const std::string& name, const std::vector<double>& values,
                             fmt::format_string<const double&> format) {
  std::vector<std::string> row = {name};
  for (const double value : values) row.push_back(fmt::format(format, value));
  return row;
}

}  // namespace

TextTable ScoreTable(const EvalReport& report) {
  TextTable table{.header = {"SSIM after"}, .rows = {}};
  for (const Protocol& protocol : report.protocols) table.header.push_back(Name(protocol));
  for (const FilterScores& other : report.others) {
    table.rows.push_back(Row(other.name, other.ssim, "{:.4f}"));
    if (!other.keys_a.empty()) table.rows.push_back(Row("  its a", other.keys_a, "{:.2f}"));
  }
  table.rows.push_back(Row(report.judged.name, report.judged.ssim, "{:.4f}"));
  for (const FilterScores& other : report.others) {
    std::vector<double> gains;
    for (std::size_t i = 0; i < other.ssim.size(); ++i) {
      gains.push_back(report.judged.ssim[i] - other.ssim[i]);
    }
    table.rows.push_back(Row("gain over " + other.name, gains, "{:+.4f}"));
  }
  return table;
}

nlohmann::ordered_json ToJson(const EvalReport& report) {
  nlohmann::ordered_json protocols = nlohmann::ordered_json::array();
  for (const Protocol& protocol : report.protocols) {
    protocols.push_back({{"warps", protocol.warps}, {"offsets", Name(protocol.offsets)}});
  }
  nlohmann::ordered_json others = nlohmann::ordered_json::array();
  for (const FilterScores& other : report.others) others.push_back(ToJson(other));
  return {{"lut", report.lut},
          {"name", report.name},
          {"lookup", report.lookup},
          {"images", report.images},
          {"crop", report.crop},
          {"protocols", protocols},
          {"judged", ToJson(report.judged)},
          {"others", others},
          {"missed", report.missed}};
}

}  // namespace warplut
