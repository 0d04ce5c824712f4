// The prefilter of a resampler: turns the samples of an image into the coefficients that its table
// reads.
//
// A table without prefilter weighs samples. A table with one weighs coefficients c = P x, with P a
// separable filter that runs once per image (generalized interpolation: Thevenaz, Blu, Unser, IEEE
// TMI 2000). At whole offsets the weights of each axis are (s, 1 - 2 s, s), s the `side`: their
// transfer function is
//
//   A(f) = 1 - 2 s + 2 s cos f          f in radians per pixel
//
// and that of the prefilter, for each axis,
//
//   kRecursive  1 / A(f): prefilter, then whole offset, is the identity. One pole z,
//               -1 < z < 0, s = -z / (1 - z)^2:
//                 c+(i) = x(i) + z c+(i - 1)        forward
//                 c(i)  = z (c(i + 1) - c+(i))      backward, then divided by s
//   kFir        t_0 + 2 sum over j = 1..reach of t_j cos(j f), about 1 / A(f)
//
// Both have 1 at f = 0: a constant stays as it is. Images are continued beyond their border by
// mirroring at the edge of the outermost pixels: x(-1 - i) = x(i). Then c is mirrored alike, and P
// is a symmetric matrix.
// Ranges: 0 < s < 1/4 keeps the pole inside the unit circle; kLargestSide keeps |z| below .6.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

enum class PrefilterKind : std::uint8_t { kNone, kRecursive, kFir };

constexpr const char* Name(PrefilterKind kind) {
  switch (kind) {
    case PrefilterKind::kNone:
      return "none";
    case PrefilterKind::kRecursive:
      return "recursive";
    case PrefilterKind::kFir:
      return "fir";
  }
  return "";
}

inline constexpr int kLargestFirReach = 7;  // 15 taps
inline constexpr float kLeastSide = 0.01f;
inline constexpr float kLargestSide = 0.23f;

// T is float where a prefilter is stored or runs, double where one is trained.
template <class T>
struct BasicPrefilter {
  PrefilterKind kind = PrefilterKind::kNone;
  T side = 0;                                     // s; 0 without prefilter
  int reach = 0;                                  // kFir: the filter has 2 reach + 1 taps
  std::array<T, kLargestFirReach + 1> taps = {};  // kFir: t_0 ... t_reach, then 0

  friend constexpr bool operator==(const BasicPrefilter&, const BasicPrefilter&) = default;
};

using Prefilter = BasicPrefilter<float>;
using RealPrefilter = BasicPrefilter<double>;

template <class T>
constexpr bool HasPrefilter(const BasicPrefilter<T>& p) {
  return p.kind != PrefilterKind::kNone;
}

// The pole z of side s in (0, 1/4): s + (1 - 2 s) z + s z^2 = 0, the root inside the unit circle.
inline double PoleOfSide(double s) {
  const double m = 1 - 2 * s;
  return (-m + std::sqrt(m * m - 4 * s * s)) / (2 * s);
}

// s of the pole z in (-1, 0).
constexpr double SideOfPole(double z) { return -z / ((1 - z) * (1 - z)); }

// A(f).
template <class T>
double WholeOffsetResponse(const BasicPrefilter<T>& p, double f) {
  return 1 - 2 * static_cast<double>(p.side) * (1 - std::cos(f));
}

// The prefilter's transfer function along one axis, real; 1 without prefilter.
template <class T>
double PrefilterResponse(const BasicPrefilter<T>& p, double f) {
  switch (p.kind) {
    case PrefilterKind::kNone:
      return 1;
    case PrefilterKind::kRecursive:
      return 1 / WholeOffsetResponse(p, f);
    case PrefilterKind::kFir: {
      double sum = static_cast<double>(p.taps[0]);
      for (int j = 1; j <= p.reach; ++j)
        sum += 2 * static_cast<double>(p.taps[j]) * std::cos(j * f);
      return sum;
    }
  }
  return 1;
}

// How far PrefilterResponse * WholeOffsetResponse of a kFir prefilter may be from 1 at any
// frequency.
inline constexpr double kFirIdentityTolerance = 0.05;
// How far the sum of the taps may be from 1.
inline constexpr double kFirSumTolerance = 1e-5;

// Whether the prefilter is one of the above; otherwise *why (if not null) says in a sentence why
// not.
inline bool IsValid(const Prefilter& p, const char** why = nullptr) {
  const auto refuse = [why](const char* reason) {
    if (why != nullptr) *why = reason;
    return false;
  };
  if (p.kind == PrefilterKind::kNone) {
    return p == Prefilter{} || refuse("has values, expected none of a prefilter of kind none");
  }
  if (p.kind != PrefilterKind::kRecursive && p.kind != PrefilterKind::kFir) {
    return refuse("has an unknown kind, expected none, recursive or fir");
  }
  if (!(p.side >= kLeastSide && p.side <= kLargestSide)) {
    return refuse("has a side outside [0.01, 0.23], where its pole is well inside the unit circle");
  }
  if (p.kind == PrefilterKind::kRecursive) {
    return (p.reach == 0 && p.taps == decltype(p.taps){}) ||
           refuse("is recursive and has taps, expected none");
  }
  if (p.reach < 1 || p.reach > kLargestFirReach) {
    return refuse("has a number of taps other than 3, 5, ... 15");
  }
  double sum = static_cast<double>(p.taps[0]);
  for (int j = 1; j <= kLargestFirReach; ++j) {
    if (j > p.reach && p.taps[j] != 0) return refuse("has taps beyond its reach, expected 0");
    sum += 2 * static_cast<double>(p.taps[j]);
  }
  if (!(std::abs(sum - 1) <= kFirSumTolerance)) return refuse("has taps that do not sum to 1");
  constexpr int kFrequencies = 64;
  for (int i = 0; i <= kFrequencies; ++i) {
    const double f = 3.14159265358979323846 * i / kFrequencies;
    if (!(std::abs(PrefilterResponse(p, f) * WholeOffsetResponse(p, f) - 1) <=
          kFirIdentityTolerance)) {
      return refuse("does not invert its side: prefilter, then whole offset, is no identity");
    }
  }
  return true;
}

}  // namespace warplut
