// Methods of the registry on clips with odd input: how they are run, and what must hold whatever
// the input is.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/method.h"
#include "tests/stability/cases/stability_case.h"
#include "train/replay/clip.h"

namespace warplut {

// What a frame that is shown as it is, or a blend of two, may be off by.
inline constexpr double kRounding = 1e-6;

struct MethodSetup {
  bool reference = false;  // the plain version of every pass
  int threads = 1;
  bool motion_filter = false;
  Parameters parameters = {};
  PixelFormat history_format = PixelFormat::kRgba16F;
};

// What the method shows: every frame of the clip rendered, generated frames at 1/2. RGBA32F.
struct ShownImage {
  ImageBuffer image;
  bool generated = false;
};
using ShownImages = std::vector<ShownImage>;

// Throws an Error if the method refuses the clip. The filter is HistoryWarp().
ShownImages RunMethod(const Clip& clip, const MethodInfo& method, const MethodSetup& setup = {});

// Whether two runs showed the same bits.
bool SameBits(const ShownImages& a, const ShownImages& b);

// The largest difference in a channel of two runs of one method.
double LargestDifference(const ShownImages& a, const ShownImages& b);

// Edits one stream of every frame, on both grids: edit(value, x, y, frame); motion is a pair of
// values.
void EditMotion(Clip& clip, const std::function<void(float* xy, int x, int y, int frame)>& edit);
void EditDepth(Clip& clip, const std::function<void(float& depth, int x, int y, int frame)>& edit);
void EditColor(Clip& clip, const std::function<void(float* rgba, int x, int y, int frame)>& edit);

// A textured ground that pans and a nearer square that moves the other way; colours in [0.3, 0.7].
Clip MovingScene(GridSize render, GridSize output, int frames);
// The ground alone.
Clip PanningGround(GridSize render, GridSize output, int frames);

// What is shown between two frames where no motion is known.
enum class Between {
  kMean,     // their mean; with a brightness gate the later one where they are alike
  kLater,    // the later one
  kFarther,  // the one with the farther depth; depths differ by more than the threshold
};

// The largest difference in a channel from what must be shown without history and without motion:
// rendered frames as a method without history (with super resolution) or the reference shows them,
// interpolated ones as `between` says, extrapolated ones as the rendered frame before. The
// baselines repeat and average are as they always are.
double DifferenceFromStill(const Clip& clip, const MethodInfo& method, const ShownImages& shown,
                           Between between);

// The method that makes of each frame what `method`, one of super resolution, makes of it without
// history.
const MethodInfo& WithoutHistory(const MethodInfo& method);

// The largest overshoot of one warp by the table, in units of the range of its texels:
// (sum of |w| - 1) / 2 of the worst node.
double Overshoot(const TableView& table);

// Runs every method on clips and checks what must hold for any input: every value finite and in [0,
// 1], generated frames of finite sources within the range of the sources and the overshoot of the
// filter, the same bits for 1, 2 and 5 threads, and fast passes as the plain ones, to half a code
// value.
class Examination {
 public:
  // Without and with motion filter, or without alone.
  void Examine(const Clip& clip, const std::string& name, bool motion_filter = true);
  // The result so far; `observed` names the first failure.
  StabilityResult Result() const;

 private:
  void ExamineMethod(const Clip& clip, const MethodInfo& method, bool motion_filter,
                     const std::string& name);
  void Fail(const std::string& what);

  int runs_ = 0;
  double least_ = 1, largest_ = 0;  // value that was shown
  double plain_difference_ = 0;     // the largest from the plain version
  std::string failure_;
};

// A mesh whose border stays at that of the frame is stretched over it. Where its inner vertices are
// a million pixels away each pixel shows the corner, but for a fraction of a tile: values within
// this of it.
inline constexpr double kStretchedRounding = 0.01;
bool IsAnchoredMesh(const MethodInfo& method);

}  // namespace warplut
