// Scores of several filters under several protocols, and targets for them.
#pragma once

#include <string>
#include <vector>

#include "tools/judge/images/filter_family.h"
#include "tools/judge/images/warp_protocol.h"

namespace warplut {

struct FilterScores {
  std::string name;
  std::vector<double> ssim;              // one for each protocol
  const FilterFamily* family = nullptr;  // whose best filter was searched for
  std::vector<double> parameters;        // for a family, alike; otherwise empty

  // Over all protocols, each with the same weight; NaN without any.
  double Mean() const;
};

// The scores under each protocol of the filter named so, or of the best of the family named so. An
// Error names what else was found.
FilterScores ScoreNamed(const std::string& name, const std::vector<Protocol>& protocols,
                        const std::vector<Image>& images, const ProtocolOptions& options);

// The filter's score under each protocol.
FilterScores ScoreFilter(const ProtocolFilter& filter, const std::vector<Protocol>& protocols,
                         const std::vector<Image>& images, const ProtocolOptions& options);

// For each protocol, the score of the filter of the family that is best for it.
FilterScores ScoreBest(const FilterFamily& family, const std::vector<Protocol>& protocols,
                       const std::vector<Image>& images, const ProtocolOptions& options);

// How many warps ScoreFilter takes, and ScoreNamed, to tell progress.
double ScoreFilterWarps(const std::vector<Protocol>& protocols, const ProtocolOptions& options,
                        std::size_t images);
double ScoreNamedWarps(const std::string& name, const std::vector<Protocol>& protocols,
                       const ProtocolOptions& options, std::size_t images);

// "The judged filter is better than `against` by more than `margin`", under each protocol, under
// some, or in the mean over all.
struct ScoreTarget {
  std::string against;
  double margin = 0;
  bool mean = false;
  std::string offsets;  // "half", "random" or "pan"; empty for all
  int max_warps = 0;    // 0: any
};

// What ParseScoreTarget reads.
inline constexpr const char* kScoreTargetForm =
    "FILTER,MARGIN[,half|random|pan[,MAX_WARPS]] or FILTER,MARGIN,mean";

// An Error names what was found.
ScoreTarget ParseScoreTarget(const std::string& text);

// Why `judged` misses the target: one sentence for each protocol where it does, or for the mean. An
// Error if `others` lacks the filter.
std::vector<std::string> MissedProtocols(const ScoreTarget& target, const FilterScores& judged,
                                         const std::vector<FilterScores>& others,
                                         const std::vector<Protocol>& protocols);

}  // namespace warplut
