// All that frames say of a sequence: its convention and its faults.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "train/inspection/findings.h"

namespace warplut {

struct Inspection {
  int frames = 0;  // that the questions were asked of
  MotionAnswer motion;
  JitterAnswer jitter;
  std::optional<DepthAnswer> depth;
  std::vector<Finding> findings;
  Sequence answered;  // the manifest that works

  // How many of the answers contradict the manifest.
  int Contradictions() const;
};

// How many times Inspect calls `on_step`.
int InspectionSteps(const Sequence& sequence);

// Asks all questions, one after the other: motion, jitter given the motion, motion again if the
// jitter is another one than stated, depth given both; then, with `faults`, looks for these. What
// `on_step` throws ends it.
Inspection Inspect(const Sequence& sequence, const std::function<void()>& on_step,
                   bool faults = true);

}  // namespace warplut
