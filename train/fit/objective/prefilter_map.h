// The prefilter of a training, as a function of free numbers.
//
//   none       no number
//   fixed      recursive, of a given side: no number
//   recursive  u: s = a + (b - a) / (1 + exp(-u)), a = kLeastSide, b the largest side asked for:
//              the pole stays inside the unit circle whatever u is
//   fir        u as above, then t_1 ... t_reach; t_0 = 1 - 2 (t_1 + ... + t_reach)
//
// More than one pole per axis is impossible: the 16 taps at whole offsets are (s, 1 - 2 s, s) in
// each axis, and the inverse of these has one pair of poles, z and 1 / z.
#pragma once

#include <vector>

#include "luts/prefilter.h"

namespace warplut {

class PrefilterMap {
 public:
  PrefilterMap() = default;  // none
  static PrefilterMap Fixed(double side);
  static PrefilterMap Recursive(double largest_side);
  static PrefilterMap Fir(int reach, double largest_side);

  PrefilterKind kind() const { return kind_; }
  // How many numbers.
  int size() const { return (free_ ? 1 : 0) + reach_; }

  RealPrefilter At(const double* numbers) const;

  // Writes d(loss)/d(numbers), given d(loss)/d(side) and d(loss)/d(t_j), t_0 among them.
  void Backward(const double* numbers, const RealPrefilter& gradient, double* out) const;

  // The numbers of a prefilter of this kind; a side at or beyond the ends is moved inside.
  std::vector<double> NumbersOf(const RealPrefilter& prefilter) const;

 private:
  PrefilterMap(PrefilterKind kind, int reach, bool free, double side)
      : kind_(kind), reach_(reach), free_(free), side_(side) {}

  PrefilterKind kind_ = PrefilterKind::kNone;
  int reach_ = 0;
  bool free_ = false;
  double side_ = 0;  // the largest where the side is free
};

// As a fit stores it, and back.
Prefilter Rounded(const RealPrefilter& prefilter);
RealPrefilter ToReal(const Prefilter& prefilter);

}  // namespace warplut
