// Errors that the jitter makes: what repeats with its cycle in time, and what repeats with the
// render grid in space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "datasets/frame.h"
#include "datasets/image.h"

namespace warplut {

// The least P of at least 2 with offsets[i + P] = offsets[i] for all i, where the offsets are those
// of at least P + 1 frames in a row. None where they do not repeat, or never change.
std::optional<int> JitterPeriod(std::span<const Vec2> offsets);

// An energy: the mean of squares of an error's component. As a difference of estimates it can come
// out negative where there is little of the component.
struct ErrorEnergy {
  double sum = 0;
  std::int64_t values = 0;

  ErrorEnergy& operator+=(const ErrorEnergy& other);
  // sum / values; NaN without values.
  double Mean() const;
  // The root of the mean, in the units of the images; 0 where that is negative, NaN without values.
  double Rms() const;
};

// The energy of the error's component of period P frames, P the jitter's:
//     d_f(p) = e_f(p) - mean of e_g(p) over the P frames g from f - floor(P / 2) on
//     energy = mean over p and f of d_f(p) d_(f+P)(p)
// e is an error of one channel (shown - reference), the p lie at least `border` from each edge.
// The mean over a cycle takes away what is constant or changes slowly. A signal of period P and
// mean 0 has its mean square, a sine of amplitude A therefore A^2 / 2. Noise that is independent
// from frame to frame has 0 in the mean. The f are whole cycles: all frames in a row give frames -
// 2 P + 1 of them, rounded down to a multiple of P and taken from the last ones, so that three
// cycles less a frame are the least. A drift of D per frame leaves D^2 / 4 where P is even.
//
// Memory: (2 P + 1) floats for each pixel. Rows on all threads, added in order: the same bits for
// any number.
class JitterErrorSum {
 public:
  JitterErrorSum(int period, int border);  // period >= 2

  // How many frames in a row give an energy.
  static int LeastFrames(int period) { return 3 * period - 1; }

  // The error of the next frame, of the size of those before.
  void Add(const Image& error);
  // Ends a row of frames: at a cut, at a frame that is missing.
  void Restart();

  // Of all rows of frames so far.
  ErrorEnergy Energy() const;

 private:
  std::vector<float>& Slot(std::vector<std::vector<float>>& ring, std::int64_t frame) const {
    return ring[static_cast<std::size_t>(frame) % ring.size()];
  }

  int period_, border_;
  std::int64_t count_ = 0;                              // frames of the row
  std::vector<std::vector<float>> errors_, detrended_;  // the last P, and the last P + 1
  std::vector<double> window_;                          // sum of errors_, for each pixel
  std::vector<ErrorEnergy> products_;                   // of each f of the row
  ErrorEnergy finished_;                                // of rows that have ended
};

// The energy of an error of one channel at the frequencies of the render grid: (1 / s_x, 0), (0, 1
// / s_y) and (1 / s_x, +-1 / s_y) cycles per output pixel, s = output / render size. Windows of L,
// eight render pixels in each axis (Hann, overlapping by half) are weighed with each frequency. The
// mean of the four squared amplitudes beside it, 2 / L away along x or y, is taken off its own: a
// spectrum without a line has them too. A chequerboard of +-A at s = 2 has A^2, a smooth error and
// white noise have 0 in the mean. Axes with s = 1 have no lattice. Windows lie at least `border`
// from each edge; no values where none fits. The same bits for any number of threads. Where s is
// near 2 and not 2, lines lie beside each other: at 1.7 up to four tenths of the energy are missed.
ErrorEnergy LatticeEnergy(const Image& error, double scale_x, double scale_y, int border);

}  // namespace warplut
