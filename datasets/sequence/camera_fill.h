// The motion that the cameras of two frames give to what stands still.
#pragma once

#include <optional>

#include "datasets/frame.h"

namespace warplut {

// Carries points of one frame to the frame before, by the matrices of both.
class CameraStep {
 public:
  // `width`, `height` of the grid, `jitter` of the current frame on it. Nothing (Valid() false)
  // where a matrix has no inverse or the projection is neither perspective nor orthographic.
  CameraStep(const Camera& previous, const Camera& current, int width, int height, Vec2 jitter);

  bool Valid() const { return valid_; }
  // Whether the two cameras are the same: nothing that stands still moves.
  bool AtRest() const { return at_rest_; }

  // The motion, in pixels, of what stands still at pixel (x, y), at a view depth > 0 in units of
  // the matrices; +infinity: background, which a camera moves by its rotation alone. Nothing where
  // it was behind the camera before.
  std::optional<Vec2> MotionAt(int x, int y, double view_depth) const;

 private:
  bool valid_ = false, at_rest_ = false;
  std::array<double, 16> projection_{}, previous_projection_{};
  std::array<double, 16> to_previous_{};  // view space of this frame to that of the frame before
  double width_, height_;
  Vec2 jitter_;
};

// Writes the camera's motion where `motion` (2 channels, pixels) has none: where a component is
// NaN, and where it is exactly (0, 0) at the background. Exporters write that for a sky that they
// do not know to move. `depth` is 1 channel in the convention of datasets/frame.h, of the same
// size; `unit` turns it into units of the matrices; depth of at least `background` is background.
// Returns the number of pixels written.
std::size_t FillMissingMotion(const CameraStep& step, const Image& depth, double unit,
                              double background, Image* motion);

// Whether there is something that FillMissingMotion could fill: a pixel with NaN or (0, 0).
bool MayMissMotion(const Image& motion);

}  // namespace warplut
