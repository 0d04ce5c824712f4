#include "tools/training/training_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "luts/fit/prefilter_json.h"
#include "tools/tables/table_text.h"

namespace warplut {
namespace {

// Rows are filters, columns the protocols of the validation.
TextTable ValidationTable(const std::vector<FitScore>& scores) {
  TextTable table{.header = {"SSIM after"}, .rows = {}};
  for (const FitScore& score : scores) {
    const std::string column = fmt::format("{} {}", score.warps, score.offsets);
    auto place = std::find(table.header.begin() + 1, table.header.end(), column);
    if (place == table.header.end()) place = table.header.insert(place, column);
    const auto index = static_cast<std::size_t>(place - table.header.begin());
    auto row = std::find_if(table.rows.begin(), table.rows.end(),
                            [&](const auto& cells) { return cells[0] == score.filter; });
    if (row == table.rows.end()) row = table.rows.insert(row, {score.filter});
    row->resize(std::max(row->size(), index + 1));
    (*row)[index] = fmt::format("{:.4f}", score.ssim);
  }
  return table;
}

}  // namespace

Json ToJson(const TrainResult& result, int tone_mapped, const std::string& out) {
  const Fit& fit = result.fit;
  Json validation = Json::array();
  for (const FitScore& score : fit.validation) {
    validation.push_back({{"filter", score.filter},
                          {"warps", score.warps},
                          {"offsets", score.offsets},
                          {"ssim", score.ssim}});
  }
  const FitLoss last = fit.loss.empty() ? FitLoss{} : fit.loss.back();
  Json json = {{"fit", out},
               {"name", fit.name},
               {"scale", fit.scale},
               {"objective", fit.objective},
               {"images", fit.data.size()},
               {"tone_mapped", tone_mapped},
               {"seconds", last.seconds},
               {"evaluations", last.evaluations},
               {"loss", last.loss},
               {"validation_loss", last.validation},
               {"keys_a", fit.keys_a},
               {"cut", result.cut},
               {"validation", validation}};
  if (HasPrefilter(fit.prefilter)) {
    json["prefilter"] = ToJson(fit.prefilter);
    json["spline_k"] = fit.spline_k;
  }
  return json;
}

std::string ToText(const TrainResult& result, const std::string& out) {
  const Fit& fit = result.fit;
  const FitLoss last = fit.loss.empty() ? FitLoss{} : fit.loss.back();
  std::string text = fmt::format(
      "{}: trained in {:.1f} s with {} evaluations on {} images; loss {:.6f}, validation {:.6f}, "
      "best Keys a = {:.3f}\n",
      out, last.seconds, last.evaluations, fit.data.size(), last.loss, last.validation, fit.keys_a);
  if (HasPrefilter(fit.prefilter)) {
    text +=
        fmt::format("prefilter {} of side {:.5f}; best spline k = {:.5f} (1 / {:.1f})\n",
                    Name(fit.prefilter.kind), fit.prefilter.side, fit.spline_k, 1 / fit.spline_k);
  }
  if (result.cut) {
    text +=
        "--max-seconds ended the training before all of its work was done; the same command with "
        "--resume and a larger limit goes on.\n";
  }
  if (!fit.validation.empty()) text += ToText(ValidationTable(fit.validation));
  return text;
}

}  // namespace warplut
