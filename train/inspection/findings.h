// Faults of frames that no convention mends, and traits that a reader of the scores should know.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "train/inspection/questions.h"

namespace warplut {

enum class Severity {
  kNote,     // worth knowing, nothing is wrong
  kWarning,  // makes results worse
};

struct Finding {
  std::string what;  // a short name: "unmarked cut", "HUD", ...
  Severity severity = Severity::kWarning;
  std::string sentence;
};

// Pairs of neighbouring frames: cuts that the manifest does not mark (the later frame is explained
// no better than by an unrelated part of the earlier one), repeated frames, parts that stay on the
// screen while their motion says that they move (HUD), a vignette. Frames that `clip` lacks are
// loaded; `on_frame` is called after each pair.
std::vector<Finding> FindPairFaults(const Sequence& sequence, const InspectedClip& clip,
                                    const MotionAnswer& motion, const JitterAnswer& jitter,
                                    const std::function<void()>& on_pair);

// Streams by themselves: motion that is quantised, constant where it is invalid, absent in the
// first frame or in the sky, or not that of the cameras; depth with a huge background or few
// values; colour of 8 bits where linear, of another colour space than stated, negative or infinite;
// render-grid colour that is filtered.
std::vector<Finding> FindStreamFaults(const Sequence& sequence, const InspectedClip& clip,
                                      const MotionAnswer& motion, const JitterAnswer& jitter);

// Layers and colour with alpha: straight where premultiplied is stated, and the reverse, in three
// frames of display colour. Layers with few half-transparent pixels, and straight ones that are not
// white, cannot be told.
std::vector<Finding> FindLayerFaults(const Sequence& sequence);

}  // namespace warplut
