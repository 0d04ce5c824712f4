#include "train/replay/judged_frames.h"

#include <cmath>
#include <set>

namespace warplut {

bool IsJudged(const MethodInfo& method, const ShownFrame& shown) {
  if (shown.frame < 0) return false;
  return method.generation == Generation::kNone ? shown.frame > 0 : shown.generated;
}

Streams JudgingStreams(const MethodInfo& method, Streams available) {
  const bool rendered = !method.super_resolution && Contains(available, Streams::kRenderGrid) &&
                        !GeneratesFromReferences(available);
  if (rendered) return Streams::kRenderGrid | (available & Streams::kOutputGrid);
  return Streams::kReference | (available & Streams::kOutputGrid);
}

TrueFrame TrueFrameOf(const ClipFrame& frame, int width, int height) {
  const auto fits = [&](const auto& view) { return view.width == width && view.height == height; };
  TrueFrame truth;
  if (fits(frame.reference.view())) {
    truth.image = frame.reference.view();
  } else if (fits(frame.color.view())) {
    truth.image = frame.color.view();
  }
  if (fits(frame.reference_depth.view()) && fits(frame.reference_motion.view())) {
    truth.depth = frame.reference_depth.view();
    truth.motion = frame.reference_motion.view();
  } else if (fits(frame.depth.view()) && fits(frame.motion.view())) {
    truth.depth = frame.depth.view();
    truth.motion = frame.motion.view();
  }
  return truth;
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
