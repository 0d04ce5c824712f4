#include "tools/filter_scores.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "datasets/error.h"
#include "tools/golden_section.h"
#include "tools/protocol_filter.h"

namespace warplut {
namespace {

ProtocolFilter KeysFilter(double a) {
  return RuntimeFilter(KeysName(a), {.filter = Filter::kKeys, .keys_a = static_cast<float>(a)});
}

[[noreturn]] void RefuseTarget(const std::string& text) {
  throw Error(
      fmt::format("'{}' is not a target; expected FILTER,MARGIN[,half|random[,MAX_WARPS]].", text));
}

}  // namespace

FilterScores ScoreFilter(const ProtocolFilter& filter, const std::vector<Protocol>& protocols,
                         const std::vector<Image>& images, const ProtocolOptions& options) {
  FilterScores scores{.name = filter.name, .ssim = {}, .keys_a = {}};
  for (const Protocol& protocol : protocols) {
    scores.ssim.push_back(ProtocolScore(filter, protocol, images, options));
  }
  return scores;
}

FilterScores ScoreBestKeys(const std::vector<Protocol>& protocols, const std::vector<Image>& images,
                           const ProtocolOptions& options) {
  FilterScores scores{.name = kBestKeys, .ssim = {}, .keys_a = {}};
  for (const Protocol& protocol : protocols) {
    const Maximum best = GoldenSection(
        [&](double a) { return ProtocolScore(KeysFilter(a), protocol, images, options); },
        kBestKeysLow, kBestKeysHigh, kBestKeysWidth);
    scores.ssim.push_back(best.value);
    scores.keys_a.push_back(best.at);
  }
  return scores;
}

double ScoreFilterWarps(const std::vector<Protocol>& protocols, const ProtocolOptions& options,
                        std::size_t images) {
  double warps = 0;
  for (const Protocol& protocol : protocols) warps += ProtocolWarps(protocol, options, images);
  return warps;
}

double ScoreBestKeysWarps(const std::vector<Protocol>& protocols, const ProtocolOptions& options,
                          std::size_t images) {
  return ScoreFilterWarps(protocols, options, images) *
         GoldenSectionEvaluations(kBestKeysLow, kBestKeysHigh, kBestKeysWidth);
}

ScoreTarget ParseScoreTarget(const std::string& text) {
  std::vector<std::string> fields;
  std::istringstream in(text);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  if (fields.size() < 2 || fields.size() > 4) RefuseTarget(text);
  const auto number = [&](const std::string& field) {
    char* end = nullptr;
    const double value = std::strtod(field.c_str(), &end);
    if (field.empty() || *end != '\0' || !(value >= -1 && value <= 1024)) RefuseTarget(text);
    return value;
  };
  ScoreTarget target{
      .against = fields[0], .margin = number(fields[1]), .offsets = {}, .max_warps = 0};
  if (fields.size() > 2) {
    target.offsets = fields[2];
    if (target.offsets != Name(Offsets::kHalf) && target.offsets != Name(Offsets::kRandom) &&
        target.offsets != Name(Offsets::kPan)) {
      RefuseTarget(text);
    }
  }
  if (fields.size() > 3) target.max_warps = static_cast<int>(number(fields[3]));
  return target;
}

std::vector<std::string> MissedProtocols(const ScoreTarget& target, const FilterScores& judged,
                                         const std::vector<FilterScores>& others,
                                         const std::vector<Protocol>& protocols) {
  const auto other = std::find_if(others.begin(), others.end(), [&](const FilterScores& scores) {
    return scores.name == target.against;
  });
  if (other == others.end()) {
    throw Error(fmt::format(
        "the target names '{}', which is not among the filters to compare with.", target.against));
  }
  std::vector<std::string> missed;
  for (std::size_t i = 0; i < protocols.size(); ++i) {
    const Protocol& protocol = protocols[i];
    if (!target.offsets.empty() && target.offsets != Name(protocol.offsets)) continue;
    if (target.max_warps > 0 && protocol.warps > target.max_warps) continue;
    const double gain = judged.ssim[i] - other->ssim[i];
    if (gain > target.margin) continue;
    missed.push_back(fmt::format("{}: {:+.5f} SSIM over {}, more than {:.5f} is wanted.",
                                 Name(protocol), gain, target.against, target.margin));
  }
  return missed;
}

}  // namespace warplut
