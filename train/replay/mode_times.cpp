// The times of generated frames.
#include <fmt/format.h>

#include "train/replay/mode_run.h"

namespace warplut {

std::vector<float> Alphas(const ModeRunOptions& options) {
  if (!options.alphas.empty()) return options.alphas;
  std::vector<float> alphas;
  for (int k = 1; k <= options.generated; ++k) {
    alphas.push_back(static_cast<float>(k) / static_cast<float>(options.generated + 1));
  }
  return alphas;
}

bool AreTimesValid(const ModeRunOptions& options, std::string* why) {
  std::string reason;
  if (options.generated < 1 || options.generated > kMostGenerated) {
    reason = fmt::format("generated is {}; expected 1 to {}", options.generated, kMostGenerated);
  }
  float last = 0;
  for (const float alpha : options.alphas) {
    if (!(alpha >= kAlphaStep && alpha <= 1 - kAlphaStep)) {
      reason = fmt::format("alpha is {}; expected a time in (0, 1), at least {} from both ends",
                           alpha, kAlphaStep);
    } else if (!(alpha - last >= 0.99f * kAlphaStep)) {
      reason = fmt::format("alpha {} comes after {}; expected ascending times, at least {} apart",
                           alpha, last, kAlphaStep);
    }
    if (!reason.empty()) break;
    last = alpha;
  }
  if (why != nullptr) *why = reason;
  return reason.empty();
}

}  // namespace warplut
