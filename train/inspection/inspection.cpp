#include "train/inspection/inspection.h"

#include <algorithm>
#include <utility>

namespace warplut {

int Inspection::Contradictions() const {
  const auto contradicts = [](Verdict verdict) { return verdict == Verdict::kContradicts ? 1 : 0; };
  int count = contradicts(motion.verdict) + contradicts(jitter.verdict);
  if (answered.motion && !jitter.contained.found.empty()) {
    count += jitter.contained.stated != jitter.contained.found ? 1 : 0;
  }
  if (depth) count += contradicts(depth->order.verdict) + contradicts(depth->curve.verdict);
  return count;
}

int InspectionSteps(const Sequence& sequence) {
  return static_cast<int>(InspectedIndices(sequence.count).size()) + sequence.count - 1;
}

Inspection Inspect(const Sequence& sequence, const std::function<void()>& on_step, bool faults) {
  Inspection inspection;
  const InspectedClip clip = LoadInspectedClip(sequence, [&](int frames) {
    for (int i = 0; i < frames; ++i) on_step();
  });
  inspection.frames = static_cast<int>(clip.frames.size());
  const bool stated_contained = sequence.motion && sequence.motion->contains_jitter;
  const std::vector<Vec2> stated = stated_contained ? std::vector<Vec2>() : JitterOf(sequence, {});
  inspection.motion = AskMotion(sequence, clip, stated);
  inspection.jitter = AskJitter(sequence, clip, inspection.motion.found);
  const bool other_jitter = !(inspection.jitter.found == JitterConvention{}) ||
                            inspection.jitter.contains_jitter != stated_contained;
  const auto jitter_of_warps = [&] {
    return inspection.jitter.contains_jitter ? std::vector<Vec2>()
                                             : JitterOf(sequence, inspection.jitter.found);
  };
  if (other_jitter) {
    MotionAnswer again = AskMotion(sequence, clip, jitter_of_warps());
    const bool moved = !(again.found == inspection.motion.found);
    inspection.motion = std::move(again);
    if (moved) inspection.jitter = AskJitter(sequence, clip, inspection.motion.found);
  }
  inspection.jitter.contained.stated = stated_contained ? "included" : "excluded";
  if (sequence.depth) {
    inspection.depth = AskDepth(sequence, clip, inspection.motion.found);
  }
  inspection.answered = WithAnswers(sequence, inspection.motion, inspection.jitter,
                                    inspection.depth ? &*inspection.depth : nullptr);
  if (!faults) return inspection;
  inspection.findings =
      FindPairFaults(sequence, clip, inspection.motion, inspection.jitter, on_step);
  for (Finding& finding : FindStreamFaults(sequence, clip, inspection.motion, inspection.jitter)) {
    inspection.findings.push_back(std::move(finding));
  }
  for (Finding& finding : FindLayerFaults(sequence)) {
    inspection.findings.push_back(std::move(finding));
  }
  return inspection;
}

}  // namespace warplut
