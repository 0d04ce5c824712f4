// Flicker: how much the error of a shown sequence changes from frame to frame, followed along the
// motion.
#pragma once

#include <cstdint>

#include "datasets/image.h"
#include "runtime/image_view.h"

namespace warplut {

// What is known of one frame; all views on one grid.
struct FrameGeometry {
  ImageView depth;    // kR32F, as in RenderedFrame
  MotionView motion;  // from the frame before, pixels
};

// The sum over pixels and channels of (e_f(p) - e_(f-1)(p - m_f(p)))^2 and how many values are in
// it.
struct TemporalErrorSum {
  double squares = 0;
  std::int64_t values = 0;

  TemporalErrorSum& operator+=(const TemporalErrorSum& other);
  // sqrt(squares / values), in the units of the images; NaN without values.
  double Rms() const;
};

// With e_f = shown frame - reference (`error`, of any channels) and e_(f-1)
// (`previous_error`, same size) read bilinearly at p - m, m and depth those of the reference. A p
// counts if it lies at least `border` from each edge, p - m lies inside the image, and the texel
// nearest to p - m had a depth before that differs from that of p now by at most kSameSurface
// (train/replay/motion_composition.h), relative to the lesser: what was just revealed has no error
// to compare with. A method whose error moves with its surfaces, a constant blur for example, has
// none; one that flickers or lags behind has.
//
// Rows on all threads, added in order: the same bits for any number.
TemporalErrorSum TemporalError(const Image& error, const FrameGeometry& geometry,
                               const Image& previous_error, const FrameGeometry& previous_geometry,
                               int border);

// Whether what pixel (x, y) shows was visible in the frame before: the rule above.
bool WasVisible(const FrameGeometry& geometry, const FrameGeometry& previous_geometry, int x,
                int y);

}  // namespace warplut
