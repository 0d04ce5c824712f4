#include "tools/judge/images/filter_scores.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <sstream>

#include "datasets/error.h"
#include "tools/judge/images/protocol_filter.h"
#include "train/fit/rivals/golden_section.h"

namespace warplut {
namespace {

[[noreturn]] void RefuseTarget(const std::string& text) {
  throw Error(fmt::format("'{}' is not a target; expected {}.", text, kScoreTargetForm));
}

}  // namespace

double FilterScores::Mean() const {
  return std::accumulate(ssim.begin(), ssim.end(), 0.0) / static_cast<double>(ssim.size());
}

FilterScores ScoreNamed(const std::string& name, const std::vector<Protocol>& protocols,
                        const std::vector<Image>& images, const ProtocolOptions& options) {
  const FilterFamily* family = FindFamily(name);
  return family != nullptr ? ScoreBest(*family, protocols, images, options)
                           : ScoreFilter(NamedFilter(name), protocols, images, options);
}

FilterScores ScoreFilter(const ProtocolFilter& filter, const std::vector<Protocol>& protocols,
                         const std::vector<Image>& images, const ProtocolOptions& options) {
  FilterScores scores{.name = filter.name, .ssim = {}, .parameters = {}};
  for (const Protocol& protocol : protocols) {
    scores.ssim.push_back(ProtocolScore(filter, protocol, images, options));
  }
  return scores;
}

FilterScores ScoreBest(const FilterFamily& family, const std::vector<Protocol>& protocols,
                       const std::vector<Image>& images, const ProtocolOptions& options) {
  FilterScores scores{.name = family.name, .ssim = {}, .family = &family, .parameters = {}};
  for (const Protocol& protocol : protocols) {
    const Maximum best = family.Best([&](double parameter) {
      return ProtocolScore(family.make(parameter), protocol, images, options);
    });
    scores.ssim.push_back(best.value);
    scores.parameters.push_back(best.at);
  }
  return scores;
}

double ScoreFilterWarps(const std::vector<Protocol>& protocols, const ProtocolOptions& options,
                        std::size_t images) {
  double warps = 0;
  for (const Protocol& protocol : protocols) warps += ProtocolWarps(protocol, options, images);
  return warps;
}

double ScoreNamedWarps(const std::string& name, const std::vector<Protocol>& protocols,
                       const ProtocolOptions& options, std::size_t images) {
  const FilterFamily* family = FindFamily(name);
  return ScoreFilterWarps(protocols, options, images) *
         (family != nullptr ? family->Evaluations() : 1);
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
  if (fields.size() == 3 && fields[2] == "mean") {
    target.mean = true;
  } else if (fields.size() > 2) {
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
  const auto require = [&](const std::string& name, double gain) {
    if (gain > target.margin) return;
    missed.push_back(fmt::format("{}: {:+.5f} SSIM over {}, more than {:.5f} is wanted.", name,
                                 gain, target.against, target.margin));
  };
  if (target.mean) {
    require("mean", judged.Mean() - other->Mean());
    return missed;
  }
  for (std::size_t i = 0; i < protocols.size(); ++i) {
    const Protocol& protocol = protocols[i];
    if (!target.offsets.empty() && target.offsets != Name(protocol.offsets)) continue;
    if (target.max_warps > 0 && protocol.warps > target.max_warps) continue;
    require(Name(protocol), judged.ssim[i] - other->ssim[i]);
  }
  return missed;
}

}  // namespace warplut
