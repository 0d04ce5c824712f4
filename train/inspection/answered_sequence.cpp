// The manifest that the answers to the questions make.
#include <algorithm>
#include <cmath>
#include <utility>

#include "train/inspection/questions.h"

namespace warplut {
namespace {

MotionUnits UnitsOf(StoredUnit unit) {
  switch (unit) {
    case StoredUnit::kUv:
      return MotionUnits::kUv;
    case StoredUnit::kNdc:
      return MotionUnits::kNdc;
    default:
      return MotionUnits::kPixels;
  }
}

MotionStream Answered(MotionStream stream, const MotionConvention& found, GridSize render,
                      GridSize output, bool is_output) {
  stream.scale = found.scale;
  stream.bias = found.bias;
  stream.units = UnitsOf(found.unit);
  if (found.unit == StoredUnit::kOutputPixels && !is_output) {
    const auto pixels = PixelsPer(found.unit, render, output);
    for (std::size_t k = 0; k < 2; ++k) {
      stream.scale[k] *= pixels[k];
      stream.bias[k] *= pixels[k];
    }
  }
  stream.direction = found.forward   ? MotionDirection::kCurrentToNext
                     : found.negated ? MotionDirection::kCurrentToPrevious
                                     : MotionDirection::kPreviousToCurrent;
  if (found.forward && found.negated) {
    for (std::size_t k = 0; k < 2; ++k) {
      stream.scale[k] = -stream.scale[k];
      stream.bias[k] = -stream.bias[k];
    }
  }
  stream.y = found.y_up ? YAxis::kUp : YAxis::kDown;
  stream.frame_offset = found.frame_offset;
  if (found.swapped) {
    if (!stream.path_x.empty()) {
      std::swap(stream.path_x, stream.path_y);
    } else if (stream.channels.size() == 2) {
      std::swap(stream.channels[0], stream.channels[1]);
    } else {
      stream.channels = {"Y", "X"};
    }
  }
  return stream;
}

}  // namespace

Sequence WithAnswers(const Sequence& sequence, const MotionAnswer& motion,
                     const JitterAnswer& jitter, const DepthAnswer* depth) {
  Sequence answered = sequence;
  if (sequence.motion && !(motion.found == StatedMotion(sequence))) {
    answered.motion =
        Answered(*sequence.motion, motion.found, sequence.render, sequence.output, false);
    // The references are written by the same exporter; only what they say of themselves is like
    // the render grid's is changed with it.
    const bool alike = sequence.reference_motion &&
                       sequence.reference_motion->units == sequence.motion->units &&
                       sequence.reference_motion->direction == sequence.motion->direction &&
                       sequence.reference_motion->y == sequence.motion->y;
    if (alike) {
      answered.reference_motion = Answered(*sequence.reference_motion, motion.found,
                                           sequence.render, sequence.output, true);
    }
  }
  if (answered.motion) answered.motion->contains_jitter = jitter.contains_jitter;
  if (!sequence.jitter.empty() && !(jitter.found == JitterConvention{})) {
    answered.jitter = JitterOf(sequence, jitter.found);
    if (jitter.found.none) answered.jitter.clear();
    for (Vec2& v : answered.jitter) {
      v.x = std::clamp(v.x, -Sequence::kMaxJitter, Sequence::kMaxJitter);
      v.y = std::clamp(v.y, -Sequence::kMaxJitter, Sequence::kMaxJitter);
    }
  }
  if (depth == nullptr || !sequence.depth) return answered;
  const DepthConvention stated = StatedDepth(*sequence.depth);
  const bool same = stated.nearer_is_larger == depth->found.nearer_is_larger &&
                    stated.hyperbolic == depth->found.hyperbolic;
  if (same || (depth->found.nearer_is_larger && !depth->found.hyperbolic)) return answered;
  for (auto* stream : {&answered.depth, &answered.reference_depth}) {
    if (!*stream) continue;
    (*stream)->kind = !depth->found.hyperbolic        ? DepthKind::kLinear
                      : depth->found.nearer_is_larger ? DepthKind::kReversed
                                                      : DepthKind::kForward;
    if (depth->found.hyperbolic && !((*stream)->near > 0)) (*stream)->near = 0.1;
  }
  return answered;
}

}  // namespace warplut
