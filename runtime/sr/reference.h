// The plain version of every pass: one pixel after the other, from the formulas.
#pragma once

#include <algorithm>
#include <cmath>

#include "runtime/sr/passes.h"

namespace warplut {

// What is seen at a point; motion in render pixels.
struct Surface {
  float depth;
  float motion_x, motion_y;
};

// Depths of neighbouring samples that differ by more, relative to the lesser, belong to different
// surfaces.
inline constexpr float kSurfaceStep = 0.03f;

// Whether history that lay farther is rejected like history that lay nearer. What is seen now was
// seen a frame ago, or something nearer hid it: where all samples lay farther none hit it, as
// happens to thin objects, and the history knows it better than they did. The absolute measure is
// the paper's and compares both ways, as the paper does.
constexpr bool RejectsBothWays(DepthMeasure measure) { return measure == DepthMeasure::kAbsolute; }

// Weights of a sample and of each of its two neighbours, along one axis, in the mean and variance
// of a colour box.
inline constexpr float kBoxMiddle = 0.6f;
inline constexpr float kBoxSide = 0.2f;

// What is taken off a residual, towards 0: the rounding of the history makes differences of this
// size, which would keep a still image moving. A unit in the last place of [1/2, 1]; codes settle
// by themselves.
constexpr float ResidualSlack(PixelFormat history) {
  switch (history) {
    case PixelFormat::kRgba16F:
      return 0x1p-11f;
    case PixelFormat::kRgba32F:
      return 0x1p-20f;
    case PixelFormat::kRgba8:
      return 0x1p-9f;
    case PixelFormat::kR32F:
      break;
  }
  return 0.0f;
}

// A step of the history that its rounding would undo never ends. Where the history is farther than
// SettledDistance from where it should go and has a share in going there, it goes by LeastStep at
// least: three quarters of a unit, which rounds to one, so that it ends within that distance and
// then rests. The distance is that of one displayed code, but no less than a unit of the history.
constexpr float LeastStep(PixelFormat history) {
  switch (history) {
    case PixelFormat::kRgba8:
      return 0.75f / 255;
    case PixelFormat::kRgba16F:
      return 0.75f * 0x1p-11f;
    case PixelFormat::kRgba32F:
    case PixelFormat::kR32F:
      break;
  }
  return 0.0f;  // the least share of a distance of one code is more than a unit
}
constexpr float SettledDistance(PixelFormat history, ColorEncoding encoding) {
  return (history == PixelFormat::kRgba8 ? 1.0f : CodeContrast(encoding)) / 255;
}

// LeastStep of the residual forms. It is 0 unless the nearest sample's share is so small that
// rounding would undo a step towards a sample one unit beyond SettledDistance: a larger share needs
// no help, and under a jitter cycle a history that is helped moves by a unit from cycle to cycle.
inline float LeastResidualStep(PixelFormat history, ColorEncoding encoding, float blend_a) {
  const float least = LeastStep(history), unit = least / 0.75f;
  const float distance = SettledDistance(history, encoding) + unit - ResidualSlack(history);
  return BlendShare(blend_a, 1.0f) * distance < 0.5f * unit ? least : 0.0f;
}

// Residuals are coherent where their mean over the 5 x 5 samples around, with binomial weights, is
// large against their deviation: of the mean m and the variance V over the same samples, summed
// over channels, g = m^2 / (m^2 + kIncoherence V) m is coherent.
inline constexpr int kCoherentReach = 2;
inline constexpr float kIncoherence = 4.0f;
inline constexpr float kLeastCoherence = 1e-20f;  // of the denominator

// The weight of the sample k samples away, along one axis; 0 beyond kCoherentReach.
constexpr float CoherentTap(int k) {
  constexpr float kBinomial[kCoherentReach + 1] = {6.0f / 16, 4.0f / 16, 1.0f / 16};
  const int distance = k < 0 ? -k : k;
  return distance > kCoherentReach ? 0.0f : kBinomial[distance];
}

// The part g / m of the means that is coherent, of the sum of their squares and of the variances.
inline float CoherentPart(float squared_mean, float variance) {
  return squared_mean / std::max(squared_mean + kIncoherence * variance, kLeastCoherence);
}

// `share` of `distance`, lengthened to `least` where the distance is more than `settled`.
inline float HistoryStep(float share, float distance, float settled, float least) {
  const float step = share * distance;
  const bool is_lengthened = share > 0 && std::abs(distance) > settled && std::abs(step) < least;
  return is_lengthened ? std::copysign(least, distance) : step;
}

// Whether the samples (i, j) to (i + 1, j + 1) belong to different surfaces, or one has no motion.
bool IsSurfaceEdge(const RenderPlanes& planes, int i, int j);

// The nearest to the camera of the 3 x 3 samples around (i, j); of equal ones the middle one, then
// the first in reading order.
Surface NearestSurface(const RenderPlanes& planes, int i, int j);

// Bilinear among the samples of the plane around the centre of output pixel (x, y), which may be
// beyond the outermost ones.
float BilinearAt(const SrJob& job, const Plane& plane, int x, int y);

// What is seen at the centre of output pixel (x, y).
Surface SurfaceAt(const SrJob& job, int x, int y);

// How much of the history counts where (depth, motion in output pixels) is seen: 0 outside of the
// image and without motion, else the gate of how far `depth` lies behind the depths around the
// position one frame ago, with the absolute measure also before them.
float ValidityReference(const SrJob& job, int x, int y, float depth, float motion_x,
                        float motion_y);

// How reactive output pixel (x, y) with that motion is, in [0, 1]: the greatest of the four samples
// of the mask around it, and of the 4 x 4 samples of the mask of the frame before around the
// position that its history comes from. 1 without motion.
float ReactiveReference(const SrJob& job, int x, int y, float motion_x, float motion_y);

struct Rgb {
  float c[3];
};

struct ColorBox {
  Rgb low, high;
};

// The colour box of the 3 x 3 samples around (i, j), in [0, 1].
ColorBox SampleColorBox(const SrJob& job, int i, int j);

// The colour box at the centre of output pixel (x, y): bilinear among those of the four samples
// around it.
ColorBox ColorBoxAt(const SrJob& job, int x, int y);

// The current frame alone at the centre of output pixel (x, y), in [0, 1].
Rgb CurrentFrameAt(const SrJob& job, int x, int y);

void FillPlanesReference(const SuperResolutionOptions& options, const RenderedFrame& frame,
                         const MotionView& motion, int begin, int end, RenderPlanes& planes);
void GeometryReference(const SrJob& job, int begin, int end, SrScratch& scratch,
                       const MutableImageView& depth, const MutableMotionView& motion);
void PredictReference(const SrJob& job, int begin, int end, SrScratch& scratch);
void ResidualReference(const SrJob& job, int begin, int end, Plane* residual,
                       AliasingMap& aliasing);
void UpdateReference(const SrJob& job, int begin, int end, SrScratch& scratch,
                     const MutableImageView& out);
void DepthRangeReference(const Plane& depth, int begin, int end, Plane& nearest, Plane& farthest);
void ReactiveReachReference(const Plane& reactive, int begin, int end, Plane& reach);

}  // namespace warplut
