#include "train/fit/rollout/plane_prefilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "runtime/core/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "train/fit/rollout/plane_prefilter.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#ifndef WARPLUT_TRAIN_PLANE_PREFILTER_ONCE
#define WARPLUT_TRAIN_PLANE_PREFILTER_ONCE
namespace warplut {

// Rows that are filtered together, on their side.
inline constexpr int kRowBlock = 32;

// Lines of `width` floats, one after the other at `stride`.
struct Lines {
  float* data = nullptr;
  std::ptrdiff_t stride = 0;
  int count = 0;
  int width = 0;
};

}  // namespace warplut
#endif  // WARPLUT_TRAIN_PLANE_PREFILTER_ONCE

// clang-format off
HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {
// clang-format on

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;

// The recursions from line to line, of kVectors vectors side by side: what a line hands on stays in
// registers.
template <int kVectors>
void RecurseVectors(const PrefilterRecursion& r, const Lines& lines, int x0) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const V z = hn::Set(d, r.pole);
  const V scale = hn::Set(d, r.scale);
  const V last = hn::Set(d, r.last);
  const auto line = [&](int i) { return lines.data + i * lines.stride + x0; };
  V c[kVectors];
  for (V& vector : c) vector = hn::Zero(d);
  for (std::size_t i = 0; i < r.start.size(); ++i) {
    const V factor = hn::Set(d, r.start[i]);
    const float* at = line(static_cast<int>(i));
    for (int v = 0; v < kVectors; ++v) {
      c[v] = hn::MulAdd(factor, hn::LoadU(d, at + v * lanes), c[v]);
    }
  }
  for (int v = 0; v < kVectors; ++v) hn::StoreU(c[v], d, line(0) + v * lanes);
  for (int i = 1; i < lines.count; ++i) {
    float* at = line(i);
    for (int v = 0; v < kVectors; ++v) {
      c[v] = hn::MulAdd(z, c[v], hn::LoadU(d, at + v * lanes));
      hn::StoreU(c[v], d, at + v * lanes);
    }
  }
  float* at = line(lines.count - 1);
  for (int v = 0; v < kVectors; ++v) {
    c[v] = hn::Mul(last, c[v]);
    hn::StoreU(c[v], d, at + v * lanes);
  }
  for (int i = lines.count - 2; i >= 0; --i) {
    at = line(i);
    for (int v = 0; v < kVectors; ++v) {
      c[v] = hn::MulAdd(z, c[v], hn::Mul(scale, hn::LoadU(d, at + v * lanes)));
      hn::StoreU(c[v], d, at + v * lanes);
    }
  }
}

// Whole vectors may run past the lines.
void Recurse(const PrefilterRecursion& r, const Lines& lines) {
  constexpr int kVectors = 4;
  const int lanes = static_cast<int>(hn::Lanes(D()));
  int x = 0;
  for (; x + kVectors * lanes <= lines.width; x += kVectors * lanes) {
    RecurseVectors<kVectors>(r, lines, x);
  }
  for (; x < lines.width; x += lanes) RecurseVectors<1>(r, lines, x);
}

// Writes the 4 x 4 values at `from`, transposed, to `to`.
HWY_INLINE void TransposeBlock(const float* const from[4], float* const to[4]) {
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) to[i][j] = from[j][i];
  }
#else
  const hn::FixedTag<float, 4> d;
  const auto a = hn::LoadU(d, from[0]), b = hn::LoadU(d, from[1]);
  const auto c = hn::LoadU(d, from[2]), e = hn::LoadU(d, from[3]);
  const auto ac_low = hn::InterleaveLower(d, a, c), ac_high = hn::InterleaveUpper(d, a, c);
  const auto be_low = hn::InterleaveLower(d, b, e), be_high = hn::InterleaveUpper(d, b, e);
  hn::StoreU(hn::InterleaveLower(d, ac_low, be_low), d, to[0]);
  hn::StoreU(hn::InterleaveUpper(d, ac_low, be_low), d, to[1]);
  hn::StoreU(hn::InterleaveLower(d, ac_high, be_high), d, to[2]);
  hn::StoreU(hn::InterleaveUpper(d, ac_high, be_high), d, to[3]);
#endif
}

// The recursions along rows, from one plane to another or the same. `side` holds kRowBlock values
// for each column and four more.
void RecurseRows(const PrefilterRecursion& r, const BorderedPlane& in, BorderedPlane& out,
                 float* side) {
  const int width = in.width(), height = in.height();
  for (int y0 = 0; y0 < height; y0 += kRowBlock) {
    const int rows = std::min(kRowBlock, height - y0);
    // The last rows may be fewer than four: they read the last one again, and write to a spare.
    for (int y = 0; y < rows; y += 4) {
      const float* from[4];
      for (int i = 0; i < 4; ++i) from[i] = in.row(y0 + std::min(y + i, rows - 1));
      float* to = side + y;
      for (int x = 0; x < width; x += 4, to += 4 * kRowBlock) {
        float* const columns[4] = {to, to + kRowBlock, to + 2 * kRowBlock, to + 3 * kRowBlock};
        TransposeBlock(from, columns);
        for (const float*& row : from) row += 4;
      }
    }
    Recurse(r, {side, kRowBlock, width, rows});
    for (int y = 0; y < rows; y += 4) {
      const float* from = side + y;
      for (int x = 0; x < width; x += 4, from += 4 * kRowBlock) {
        const float* const columns[4] = {from, from + kRowBlock, from + 2 * kRowBlock,
                                         from + 3 * kRowBlock};
        float spare[4];
        float* to[4];
        for (int i = 0; i < 4; ++i) to[i] = y + i < rows ? out.row(y0 + y + i) + x : spare;
        TransposeBlock(columns, to);
      }
    }
  }
}

// to = taps[0] from(0) + sum of taps[j] (before[j] + after[j]); whole vectors may run past `width`.
// The reach is known to the compiler, so that sums stay in registers.
template <int kReach>
void SumTapsOf(const float* taps, const float* const* before, const float* const* after, int width,
               float* to) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < width; x += lanes) {
    V sum = hn::Mul(hn::Set(d, taps[0]), hn::LoadU(d, before[0] + x));
    for (int j = 1; j <= kReach; ++j) {
      const V pair = hn::Add(hn::LoadU(d, before[j] + x), hn::LoadU(d, after[j] + x));
      sum = hn::MulAdd(hn::Set(d, taps[j]), pair, sum);
    }
    hn::StoreU(sum, d, to + x);
  }
}

// Adds the sum over x of g (before[j] + after[j]) to sums[j], j = 0..kReach.
template <int kReach>
void AddPairSumsOf(const float* g, const float* const* before, const float* const* after, int width,
                   double* sums) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  V parts[kReach + 1];
  for (V& part : parts) part = hn::Zero(d);
  int x = 0;
  for (; x + lanes <= width; x += lanes) {
    const V along = hn::LoadU(d, g + x);
    for (int j = 0; j <= kReach; ++j) {
      const V pair = hn::Add(hn::LoadU(d, before[j] + x), hn::LoadU(d, after[j] + x));
      parts[j] = hn::MulAdd(along, pair, parts[j]);
    }
  }
  for (int j = 0; j <= kReach; ++j) {
    sums[j] += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, parts[j])));
    for (int i = x; i < width; ++i) {
      sums[j] += static_cast<double>(g[i]) * static_cast<double>(before[j][i] + after[j][i]);
    }
  }
}

// Calls visit with the reach, 1..kLargestFirReach, as a constant.
template <int kReach = 1, class Visit>
HWY_INLINE void WithReach(int reach, const Visit& visit) {
  if constexpr (kReach < kLargestFirReach) {
    if (reach != kReach) return WithReach<kReach + 1>(reach, visit);
  }
  visit(std::integral_constant<int, kReach>());
}

void SumTaps(const float* taps, int reach, const float* const* before, const float* const* after,
             int width, float* to) {
  WithReach(reach, [&](auto r) { SumTapsOf<r.value>(taps, before, after, width, to); });
}

void AddPairSums(const float* g, const float* const* before, const float* const* after, int reach,
                 int width, double* sums) {
  WithReach(reach, [&](auto r) { AddPairSumsOf<r.value>(g, before, after, width, sums); });
}

// clang-format off
}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();
// clang-format on

#if HWY_ONCE

namespace warplut {
HWY_EXPORT(Recurse);
HWY_EXPORT(RecurseRows);
HWY_EXPORT(SumTaps);
HWY_EXPORT(AddPairSums);

namespace {

int Mirrored(int i, int size) { return ContinuedPixel(i, size, Border::kMirrored); }

PrefilterRecursion MakeRecursion(double side, int size) {
  constexpr double kNegligible = 0x1p-30;
  const double z = PoleOfSide(side);
  PrefilterRecursion r;
  r.pole = static_cast<float>(z);
  r.scale = static_cast<float>((1 - z) * (1 - z));
  r.last = static_cast<float>(1 - z);
  std::vector<double> start(static_cast<std::size_t>(size), 0.0);
  double power = 1;
  for (int i = 0; std::abs(power) > kNegligible; ++i, power *= z) {
    start[static_cast<std::size_t>(Mirrored(-i, size))] += power;
  }
  while (start.back() == 0) start.pop_back();
  r.start.assign(start.begin(), start.end());
  return r;
}

// The pixels of a row from to[kLargestFirReach] on, continued by `reach` on both sides.
void CopyContinued(const float* row, int width, int reach, float* to) {
  std::copy_n(row, width, to + kLargestFirReach);
  for (int i = 1; i <= reach; ++i) {
    to[kLargestFirReach - i] = row[Mirrored(-i, width)];
    to[kLargestFirReach + width - 1 + i] = row[Mirrored(width - 1 + i, width)];
  }
}

// Where the values j before and j after begin, for a row that CopyContinued wrote, or for row y.
struct Neighbours {
  std::array<const float*, kLargestFirReach + 1> before{}, after{};
};

Neighbours RowNeighbours(const float* continued, int reach) {
  Neighbours neighbours;
  for (int j = 0; j <= reach; ++j) {
    neighbours.before[j] = continued + kLargestFirReach - j;
    neighbours.after[j] = continued + kLargestFirReach + j;
  }
  return neighbours;
}

Neighbours ColumnNeighbours(const BorderedPlane& plane, int y, int reach) {
  Neighbours neighbours;
  for (int j = 0; j <= reach; ++j) {
    neighbours.before[j] = plane.row(Mirrored(y - j, plane.height()));
    neighbours.after[j] = plane.row(Mirrored(y + j, plane.height()));
  }
  return neighbours;
}

std::array<float, kLargestFirReach + 1> FloatTaps(const RealPrefilter& prefilter) {
  std::array<float, kLargestFirReach + 1> taps;
  for (int j = 0; j <= kLargestFirReach; ++j) taps[j] = static_cast<float>(prefilter.taps[j]);
  return taps;
}

void ClearBorder(BorderedPlane& plane) {
  constexpr int kBorder = BorderedPlane::kBorder;
  for (int y = -kBorder; y < plane.height() + kBorder; ++y) {
    const bool inside = y >= 0 && y < plane.height();
    float* row = plane.row(y);
    std::fill(row - kBorder, row + (inside ? 0 : plane.width()), 0.0f);
    std::fill(row + plane.width(), row - kBorder + plane.stride(), 0.0f);
  }
}

}  // namespace

PlanePrefilter::PlanePrefilter(int width, int height)
    : width_(width),
      height_(height),
      lines_(static_cast<std::size_t>(kRowBlock) * (width + 4) + 2 * kLargestFirReach + width),
      other_(width, height),
      along_y_(width, height) {}

void PlanePrefilter::Set(const RealPrefilter& prefilter) {
  prefilter_ = prefilter;
  if (prefilter.kind != PrefilterKind::kRecursive) return;
  row_ = MakeRecursion(prefilter.side, width_);
  column_ = MakeRecursion(prefilter.side, height_);
}

void PlanePrefilter::Rows(const BorderedPlane& in, BorderedPlane& out) {
  const int width = in.width();
  if (prefilter_.kind == PrefilterKind::kRecursive) {
    HWY_DYNAMIC_DISPATCH(RecurseRows)(row_, in, out, lines_.data());
    return;
  }
  const auto taps = FloatTaps(prefilter_);
  const Neighbours neighbours = RowNeighbours(lines_.data(), prefilter_.reach);
  for (int y = 0; y < in.height(); ++y) {
    CopyContinued(in.row(y), width, prefilter_.reach, lines_.data());
    HWY_DYNAMIC_DISPATCH(SumTaps)
    (taps.data(), prefilter_.reach, neighbours.before.data(), neighbours.after.data(), width,
     out.row(y));
  }
}

void PlanePrefilter::Columns(BorderedPlane& plane) {
  const int width = plane.width(), height = plane.height();
  if (prefilter_.kind == PrefilterKind::kRecursive) {
    HWY_DYNAMIC_DISPATCH(Recurse)(column_, {plane.row(0), plane.stride(), height, width});
    return;
  }
  const auto taps = FloatTaps(prefilter_);
  other_ = plane;
  for (int y = 0; y < height; ++y) {
    const Neighbours neighbours = ColumnNeighbours(other_, y, prefilter_.reach);
    HWY_DYNAMIC_DISPATCH(SumTaps)
    (taps.data(), prefilter_.reach, neighbours.before.data(), neighbours.after.data(), width,
     plane.row(y));
  }
}

void PlanePrefilter::Apply(const BorderedPlane& samples, BorderedPlane& coefficients) {
  Rows(samples, coefficients);
  Columns(coefficients);
  FillBorder(coefficients, Border::kMirrored);
}

void PlanePrefilter::Adjoint(const BorderedPlane& samples, const BorderedPlane& coefficients,
                             BorderedPlane& g, RealPrefilter& prefilter_gradient) {
  const int width = g.width(), height = g.height();
  const bool recursive = prefilter_.kind == PrefilterKind::kRecursive;
  const BorderedPlane& moved = recursive ? coefficients : samples;
  // The sums over both axes of <one of P_x g and P_y g, S_j moved>; of kRecursive D = S_1 - 2 S_0.
  std::array<double, kLargestFirReach + 1> sums{};
  const int reach = recursive ? 1 : prefilter_.reach;
  along_y_ = g;
  Rows(g, g);
  Columns(along_y_);
  const BorderedPlane& with_rows = recursive ? g : along_y_;
  const BorderedPlane& with_columns = recursive ? along_y_ : g;
  for (int y = 0; y < height; ++y) {
    CopyContinued(moved.row(y), width, reach, lines_.data());
    const Neighbours in_row = RowNeighbours(lines_.data(), reach);
    HWY_DYNAMIC_DISPATCH(AddPairSums)
    (with_rows.row(y), in_row.before.data(), in_row.after.data(), reach, width, sums.data());
    const Neighbours in_column = ColumnNeighbours(moved, y, reach);
    HWY_DYNAMIC_DISPATCH(AddPairSums)
    (with_columns.row(y), in_column.before.data(), in_column.after.data(), reach, width,
     sums.data());
  }
  sums[0] /= 2;
  if (recursive) {
    prefilter_gradient.side -= sums[1] - 2 * sums[0];
  } else {
    for (int j = 0; j <= reach; ++j) prefilter_gradient.taps[j] += sums[j];
  }
  Columns(g);
  ClearBorder(g);
}

}  // namespace warplut

#endif  // HWY_ONCE
