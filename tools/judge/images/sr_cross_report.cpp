#include "tools/judge/images/sr_cross_report.h"

#include <fmt/format.h>

#include <string>

namespace warplut {

TextTable LossTable(const std::vector<CrossFilter>& filters,
                    const std::vector<CrossColumn>& columns) {
  TextTable table{.header = {"L at factor"}, .rows = {}};
  for (const CrossFilter& filter : filters) table.rows.push_back({filter.name});
  table.rows.push_back({"best Keys kernel"});
  table.rows.push_back({"its a"});
  for (const CrossColumn& column : columns) {
    table.header.push_back(fmt::format("{}", column.options.scale));
    for (std::size_t i = 0; i < filters.size(); ++i) {
      table.rows[i].push_back(fmt::format("{:.4f}", column.scores[i].loss));
    }
    table.rows[filters.size()].push_back(fmt::format("{:.4f}", column.keys.loss));
    table.rows[filters.size() + 1].push_back(fmt::format("{:.2f}", column.keys_a));
  }
  return table;
}

TextTable SsimTable(const std::vector<CrossFilter>& filters, const CrossColumn& column) {
  TextTable table{.header = {fmt::format("SSIM at factor {}", column.options.scale)}, .rows = {}};
  table.header.insert(table.header.end(), column.protocols.begin(), column.protocols.end());
  const auto add = [&](const std::string& name, const CrossScore& score) {
    std::vector<std::string>& row = table.rows.emplace_back(1, name);
    for (const double ssim : score.ssim) row.push_back(fmt::format("{:.4f}", ssim));
  };
  for (std::size_t i = 0; i < filters.size(); ++i) add(filters[i].name, column.scores[i]);
  add(fmt::format("keys:{:.2f}", column.keys_a), column.keys);
  return table;
}

Json ToJson(const std::vector<CrossFilter>& filters, const std::vector<CrossColumn>& columns) {
  Json factors = Json::array();
  for (const CrossColumn& column : columns) {
    Json scores = Json::array();
    const auto add = [&](const std::string& name, const CrossScore& score) {
      scores.push_back({{"filter", name}, {"loss", score.loss}, {"ssim", score.ssim}});
    };
    for (std::size_t i = 0; i < filters.size(); ++i) add(filters[i].name, column.scores[i]);
    add("keys", column.keys);
    factors.push_back({{"scale", column.options.scale},
                       {"blend_a", *column.options.blend_a},
                       {"blend_b", *column.options.blend_b},
                       {"pan_share", *column.options.pan_share},
                       {"crops", column.options.crops},
                       {"keys_a", column.keys_a},
                       {"protocols", column.protocols},
                       {"scores", scores}});
  }
  return {{"factors", factors}};
}

}  // namespace warplut
