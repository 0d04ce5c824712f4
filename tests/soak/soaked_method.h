// One method that runs on and on, as in a game: a frame after the other, without a cut.
#pragma once

#include <optional>

#include "luts/table.h"
#include "runtime/executor.h"
#include "runtime/method.h"
#include "train/replay/clip.h"

namespace warplut {

// The values that a method showed.
struct ShownValues {
  float least = 1, largest = 0;
  bool finite = true;
  double error = 0;  // sum over frames of the mean |shown - reference|, where there is a reference
  int judged = 0;    // frames in `error`

  double MeanError() const { return judged > 0 ? error / judged : 0; }
};

class SoakedMethod {
 public:
  SoakedMethod(const MethodInfo& method, const Table& table, Executor& executor);

  // Makes the next frame of the golden scene, and the generated one before or after it.
  void Advance(ShownValues* shown);

 private:
  struct Display {
    ImageBuffer color, depth;
    MotionBuffer motion;
    DisplayedFrame frame;
  };
  void MakeDisplay(ShownValues* shown);

  const MethodInfo& method_;
  int number_ = 0;
  ClipFrame frame_;
  Display displays_[2];
  ImageBuffer generated_;
  std::optional<SuperResolution> super_resolution_;
  std::optional<FrameGeneration> generation_;
};

}  // namespace warplut
