#include "luts/certificate/gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "luts/quantize/baked_table.h"

namespace warplut {
namespace {

using Complex = std::complex<double>;

constexpr int kGrid = 64;         // frequencies per axis and period
constexpr int kHalf = kGrid / 2;  // fx runs over 0..kHalf
constexpr double kGridStep = 2 * std::numbers::pi / kGrid;
constexpr double kSearchEnd = 1e-7;          // last step of the compass search
constexpr double kLeastImprovement = 1e-14;  // relative; below it is rounding

// One number for each tap of an axis.
using AxisSums = std::array<Complex, kWindowTaps>;

// exp(-i f t) for the taps t of one axis, from z = exp(-i f).
AxisSums Phasors(Complex z) {
  const Complex square = z * z;
  return {std::conj(square), std::conj(z), 1.0, z, square, square * z};
}

const std::array<AxisSums, kGrid>& GridPhasors() {
  static const auto phasors = [] {
    std::array<AxisSums, kGrid> p;
    for (int i = 0; i < kGrid; ++i) p[i] = Phasors(std::polar(1.0, -kGridStep * i));
    return p;
  }();
  return phasors;
}

// The taps of an axis, as kx or ky: those of the 4 x 4 square where no weight lies outside.
struct AxisRange {
  int first = 0;
  int last = kWindowTaps;

  explicit AxisRange(const Weights<double>& w) {
    for (int k = 0; k < kWeights; ++k) {
      if (w[k] != 0 && !HasTap(Footprint::k16, TapX(k), TapY(k))) return;
    }
    first = kFirstTap - kFirstWindowTap;
    last = first + kTaps;
  }
};

class Transfer {
 public:
  explicit Transfer(const Weights<double>& w) : w_(w), range_(w) {}

  bool is_wide() const { return range_.first == 0; }

  // Sums over x: one complex number per row of taps.
  AxisSums RowSums(const AxisSums& x) const {
    AxisSums sums{};
    for (int ky = range_.first; ky < range_.last; ++ky) {
      for (int kx = range_.first; kx < range_.last; ++kx)
        sums[ky] += w_[WeightIndex(kx, ky)] * x[kx];
    }
    return sums;
  }

  double SquaredSum(const AxisSums& sums, const AxisSums& y) const {
    // Written out: std::complex multiplication handles infinities that cannot occur here.
    double re = 0;
    double im = 0;
    for (int k = range_.first; k < range_.last; ++k) {
      re += sums[k].real() * y[k].real() - sums[k].imag() * y[k].imag();
      im += sums[k].real() * y[k].imag() + sums[k].imag() * y[k].real();
    }
    return re * re + im * im;
  }

 private:
  const Weights<double>& w_;
  AxisRange range_;
};

double SquaredGainAt(const Transfer& transfer, const Prefilter& prefilter, double fx, double fy) {
  const double squared = transfer.SquaredSum(transfer.RowSums(Phasors(std::polar(1.0, -fx))),
                                             Phasors(std::polar(1.0, -fy)));
  if (!HasPrefilter(prefilter)) return squared;
  const double response = PrefilterResponse(prefilter, fx) * PrefilterResponse(prefilter, fy);
  return squared * response * response;
}

// |H|^2 at the grid frequencies (a, b), a = 0..kHalf, b = 0..kGrid - 1.
class FrequencyGrid {
 public:
  FrequencyGrid(const Transfer& transfer, const Prefilter& prefilter)
      : values_((kHalf + 1) * kGrid) {
    std::array<double, kGrid> squared;  // response
    for (int a = 0; a < kGrid; ++a) {
      const double response = PrefilterResponse(prefilter, a * kGridStep);
      squared[a] = response * response;
    }
    for (int a = 0; a <= kHalf; ++a) {
      const AxisSums sums = transfer.RowSums(GridPhasors()[a]);
      for (int b = 0; b < kGrid; ++b) {
        values_[a * kGrid + b] =
            transfer.SquaredSum(sums, GridPhasors()[b]) * squared[a] * squared[b];
        best_ = std::max(best_, values_[a * kGrid + b]);
      }
    }
  }

  double best() const { return best_; }

  // Any integers: periodic, and |H(-f)| = |H(f)|.
  double At(int a, int b) const {
    if (a < 0 || a > kHalf) {
      a = (kGrid - a) % kGrid;
      b = -b;
    }
    return values_[a * kGrid + (b + kGrid) % kGrid];
  }

  bool IsLocalMaximum(int a, int b) const {
    for (int db = -1; db <= 1; ++db) {
      for (int da = -1; da <= 1; ++da) {
        if (At(a + da, b + db) > At(a, b)) return false;
      }
    }
    return true;
  }

 private:
  std::vector<double> values_;
  double best_ = 0;
};

// Walks uphill among the 8 neighbours at a distance that is halved where none is higher; `gain`
// holds |H|^2.
Gain Climb(const Transfer& transfer, const Prefilter& prefilter, Gain from) {
  for (double step = kGridStep / 2; step > kSearchEnd;) {
    Gain best = from;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        const double fx = from.fx + dx * step;
        const double fy = from.fy + dy * step;
        const double value = SquaredGainAt(transfer, prefilter, fx, fy);
        if (value > best.gain * (1 + kLeastImprovement)) best = {value, fx, fy};
      }
    }
    if (best.gain > from.gain) {
      from = best;
    } else {
      step /= 2;
    }
  }
  return from;
}

// The same frequency with fx in [0, pi], fy in (-pi, pi].
Gain Normalized(Gain g) {
  constexpr double kPeriod = 2 * std::numbers::pi;
  g.fx = std::remainder(g.fx, kPeriod);
  g.fy = std::remainder(g.fy, kPeriod);
  if (g.fx < 0) {
    g.fx = -g.fx;
    g.fy = -g.fy;
  }
  if (g.fy <= -std::numbers::pi) g.fy += kPeriod;
  return g;
}

}  // namespace

double GainAt(const Weights<double>& w, double fx, double fy, const Prefilter& prefilter) {
  return std::sqrt(SquaredGainAt(Transfer(w), prefilter, fx, fy));
}

Gain MaxGain(const Weights<double>& w, const Prefilter& prefilter) {
  const Transfer transfer(w);
  const FrequencyGrid grid(transfer, prefilter);
  const double loss = HasPrefilter(prefilter) ? kPrefilteredGridLoss
                      : transfer.is_wide()    ? kWideGridLoss
                                              : kGridLoss;
  Gain best;
  for (int a = 0; a <= kHalf; ++a) {
    for (int b = 0; b < kGrid; ++b) {
      const double value = grid.At(a, b);
      if (value < (1 - loss) * grid.best() || !grid.IsLocalMaximum(a, b)) continue;
      const Gain top = Climb(transfer, prefilter, {value, a * kGridStep, b * kGridStep});
      if (top.gain > best.gain * (1 + kLeastImprovement)) best = top;
    }
  }
  best.gain = std::sqrt(best.gain);
  return Normalized(best);
}

GainMap MapGains(const TableView& table) {
  GainMap map;
  for (const IntegerRow& row : TableIntegers(table, "table")) {
    map.nodes.push_back(MaxGain(RealRow(row, table.format), table.prefilter));
    if (map.nodes.back().gain > map.nodes[map.worst].gain * (1 + kLeastImprovement)) {
      map.worst = static_cast<int>(map.nodes.size()) - 1;
    }
  }
  return map;
}

}  // namespace warplut
