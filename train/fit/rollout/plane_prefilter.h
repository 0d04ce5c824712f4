// The prefilter of luts/prefilter.h on the planes of the training, with its gradient.
//
//   c = P x,   P = P_y P_x: along rows, then along columns; the image is mirrored at its edges
//
// Each of P_x and P_y is a symmetric matrix and they commute, so that P is its own adjoint. With g
// the gradient of c, and <a, b> the sum over the pixels of a b,
//
//   kRecursive  d<g, P x>/ds = -<P_y g, D_y c> - <P_x g, D_x c>, since P_x = (1 + s D_x)^-1
//   kFir        d<g, P x>/dt_j = <P_y g, S_jx x> + <P_x g, S_jy x>
//
// D = x(i - 1) - 2 x(i) + x(i + 1), S_0 = 1, S_j = x(i - j) + x(i + j). Taps are taken to be
// independent: what ties them (the sum of 1) is the caller's.
#pragma once

#include <vector>

#include "luts/prefilter.h"
#include "train/fit/rollout/stencil.h"

namespace warplut {

// The recursions of luts/prefilter.h along lines of one length, with the division by s in the
// second:
//   c+(i) = x(i) + z c+(i - 1)      c(i) = z c(i + 1) + (1 - z)^2 c+(i)
struct PrefilterRecursion {
  float pole = 0;            // z
  float scale = 0;           // (1 - z)^2
  float last = 0;            // c over c+ at the last pixel: 1 - z, by the mirror
  std::vector<float> start;  // c+(0) = sum of start[i] x(i)
};

// One object serves one thread at a time; any image size from 1 x 1.
class PlanePrefilter {
 public:
  PlanePrefilter(int width, int height);

  // `prefilter` has a prefilter; a side in (0, 1/4) is all that is asked of it.
  void Set(const RealPrefilter& prefilter);

  // coefficients = P samples, border mirrored. The planes are of this size and different.
  // Recursions start exactly as the mirrored image has it and run over the whole plane. Accuracy:
  // 2e-6 times the largest |coefficient|. The same bits on every machine with the same instruction
  // set.
  void Apply(const BorderedPlane& samples, BorderedPlane& coefficients);

  // After coefficients = Apply(samples): replaces g by P g, border cleared, and adds
  // d<g, P samples>/d(side) or d/d(t_j) to `prefilter_gradient`.
  void Adjoint(const BorderedPlane& samples, const BorderedPlane& coefficients, BorderedPlane& g,
               RealPrefilter& prefilter_gradient);

  // The slow, obvious version of Apply, in double: solves with the tridiagonal matrix of
  // kRecursive, sums the taps of kFir. Row-major, width * height values.
  static std::vector<double> Reference(const RealPrefilter& prefilter, int width, int height,
                                       std::vector<double> samples);

 private:
  // From one plane to another or the same.
  void Rows(const BorderedPlane& in, BorderedPlane& out);
  void Columns(BorderedPlane& plane);

  int width_;
  int height_;
  RealPrefilter prefilter_;
  PrefilterRecursion row_, column_;  // kRecursive
  std::vector<float> lines_;         // rows on their side, or one row with its continuation
  BorderedPlane other_, along_y_;
};

}  // namespace warplut
