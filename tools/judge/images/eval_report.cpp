#include "tools/judge/images/eval_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/judge/images/image_set.h"

namespace warplut {
namespace {

nlohmann::ordered_json ToJson(const FilterScores& scores) {
  nlohmann::ordered_json json = {
      {"filter", scores.name}, {"ssim", scores.ssim}, {"mean", scores.Mean()}};
  if (scores.family != nullptr) json[scores.family->parameter] = scores.parameters;
  return json;
}

template <class Text>
std::vector<std::string> Row(const std::string& name, const std::vector<double>& values,
                             const Text& text) {
  std::vector<std::string> row = {name};
  for (const double value : values) row.push_back(text(value));
  return row;
}

std::string ScoreText(double score) { return fmt::format("{:.4f}", score); }
std::string GainText(double gain) { return fmt::format("{:+.4f}", gain); }

// The score under each protocol and their mean.
std::vector<double> WithMean(const FilterScores& scores) {
  std::vector<double> values = scores.ssim;
  values.push_back(scores.Mean());
  return values;
}

}  // namespace

TextTable ScoreTable(const EvalReport& report) {
  TextTable table{.header = {"SSIM after"}, .rows = {}};
  for (const Protocol& protocol : report.protocols) table.header.push_back(Name(protocol));
  table.header.emplace_back("mean");
  const std::vector<double> judged = WithMean(report.judged);
  for (const FilterScores& other : report.others) {
    table.rows.push_back(Row(other.name, WithMean(other), ScoreText));
    if (const FilterFamily* family = other.family) {
      table.rows.push_back(
          Row(fmt::format("  its {}", family->symbol), other.parameters,
              [&](double parameter) { return fmt::format("{:.{}f}", parameter, family->digits); }));
    }
  }
  table.rows.push_back(Row(report.judged.name, judged, ScoreText));
  for (const FilterScores& other : report.others) {
    std::vector<double> gains = WithMean(other);
    for (std::size_t i = 0; i < gains.size(); ++i) gains[i] = judged[i] - gains[i];
    table.rows.push_back(Row("gain over " + other.name, gains, GainText));
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
          {"tone_mapped", report.tone_mapped},
          {"crop", report.crop},
          {"protocols", protocols},
          {"judged", ToJson(report.judged)},
          {"others", others},
          {"missed", report.missed}};
}

std::string ToText(const EvalReport& report) {
  return fmt::format("{} on {} images, {} lookup\n", report.name, report.images, report.lookup) +
         ToneMappedText(report.tone_mapped, report.images) + ToText(ScoreTable(report));
}

}  // namespace warplut
