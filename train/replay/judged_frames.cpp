#include "train/replay/judged_frames.h"

#include <cmath>
#include <set>

namespace warplut {

bool IsJudged(const MethodInfo& method, const ShownFrame& shown) {
  if (shown.frame < 0) return false;
  return method.generation == Generation::kNone ? shown.frame > 0 : shown.generated;
}

std::vector<int> JudgedFrames(const Clip& clip, const ModeRunOptions& options) {
  const int count = static_cast<int>(clip.frames.size());
  const int every = options.every;
  std::set<int> frames;
  if (options.method->generation == Generation::kNone) {
    for (int i = every; i < count; i += every) frames.insert(i);
    return {frames.begin(), frames.end()};
  }
  const bool extrapolates = options.method->generation == Generation::kExtrapolation;
  for (int begin = extrapolates ? every : 0; begin < count; begin += every) {
    if (!extrapolates && begin + every >= count) break;
    for (const float alpha : Alphas(options)) {
      const double time = begin + static_cast<double>(alpha) * every;
      const double whole = std::round(time);
      if (std::abs(time - whole) < kAlphaStep / 2 && whole < count) {
        frames.insert(static_cast<int>(whole));
      }
    }
  }
  return {frames.begin(), frames.end()};
}

}  // namespace warplut
