// Scores of several filters under several protocols, and targets for them.
#pragma once

#include <string>
#include <vector>

#include "tools/warp_protocol.h"

namespace warplut {

// The name that stands for the Keys kernel whose parameter is the best for the very protocol and images.
inline constexpr const char* kBestKeys = "best-keys";
// Where that parameter is searched, and how closely.
inline constexpr double kBestKeysLow = -1.0;
inline constexpr double kBestKeysHigh = -0.3;
inline constexpr double kBestKeysWidth = 0.01;

struct FilterScores {
  std::string name;
  std::vector<double> ssim;    // one for each protocol
  std::vector<double> keys_a;  // for best-keys, alike; otherwise empty
};

// The filter's score under each protocol.
FilterScores ScoreFilter(const ProtocolFilter& filter, const std::vector<Protocol>& protocols,
                         const std::vector<Image>& images, const ProtocolOptions& options);

// For each protocol, the score of the Keys kernel that is best for it.
FilterScores ScoreBestKeys(const std::vector<Protocol>& protocols, const std::vector<Image>& images,
                           const ProtocolOptions& options);

// How many warps both take, to tell progress.
double ScoreFilterWarps(const std::vector<Protocol>& protocols, const ProtocolOptions& options,
                        std::size_t images);
double ScoreBestKeysWarps(const std::vector<Protocol>& protocols, const ProtocolOptions& options,
                          std::size_t images);

// "The judged filter is better than `against` by `margin`", under all protocols or some.
struct ScoreTarget {
  std::string against;
  double margin = 0;
  std::string offsets;  // "half", "random", or empty for both
  int max_warps = 0;    // 0: any
};

// Reads FILTER,MARGIN[,half|random[,MAX_WARPS]]. An Error names what was found.
ScoreTarget ParseScoreTarget(const std::string& text);

// Why `judged` misses the target: one sentence for each protocol where it does. An Error if `others` lacks the filter.
std::vector<std::string> MissedProtocols(const ScoreTarget& target, const FilterScores& judged,
                                         const std::vector<FilterScores>& others,
                                         const std::vector<Protocol>& protocols);

}  // namespace warplut
