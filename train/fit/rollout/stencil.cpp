#include "train/fit/rollout/stencil.h"

#include <algorithm>

#include "runtime/core/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "train/fit/rollout/stencil.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

// clang-format off
HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {
// clang-format on

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;

// Taps of the largest footprint, two by two.
inline constexpr int kMostPairs = kWeights / 2;

// The texel of tap i of the footprint, from that of tap (0, 0).
template <Footprint kFootprint>
HWY_INLINE const float* TexelOf(int i, const float* in, std::ptrdiff_t stride) {
  const int k = TapsOf(kFootprint)[i];
  return in + TapY(k) * stride + TapX(k);
}

// Sum over the taps i of weights[i] times their texels, one vector of outputs; `in` is at tap
// (0, 0).
template <Footprint kFootprint>
HWY_INLINE V Gather(const V* weights, const float* in, std::ptrdiff_t stride) {
  constexpr int kCount = TapCount(kFootprint);
  const D d;
  const auto texels = [&](int i)
                          HWY_ATTR { return hn::LoadU(d, TexelOf<kFootprint>(i, in, stride)); };
  V even = hn::Mul(weights[0], texels(0));
  V odd = hn::Mul(weights[1], texels(1));
  HWY_UNROLL(kMostPairs)
  for (int i = 2; i < kCount; i += 2) {
    even = hn::MulAdd(weights[i], texels(i), even);
    odd = hn::MulAdd(weights[i + 1], texels(i + 1), odd);
  }
  return hn::Add(even, odd);
}

// Whole vectors may run past the right edge into the border, which FillBorder repairs.
template <Footprint kFootprint>
void FootprintRows(const Stencil& s, const BorderedPlane& in, BorderedPlane& out) {
  constexpr int kCount = TapCount(kFootprint);
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  V weights[kCount];
  for (int i = 0; i < kCount; ++i) weights[i] = hn::Set(d, s.weights[TapsOf(kFootprint)[i]]);
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0f);
  for (int y = 0; y < in.height(); ++y) {
    const float* from = in.row(y + s.cell_y) + s.cell_x;
    float* to = out.row(y);
    for (int x = 0; x < in.width(); x += lanes) {
      const V sum = Gather<kFootprint>(weights, from + x, in.stride());
      hn::StoreU(hn::Min(hn::Max(sum, zero), one), d, to + x);
    }
  }
}

// Zeroes the gradient of clamped pixels and adds the gradient of the weights, row by row.
template <Footprint kFootprint>
void FootprintWeightGradient(const Stencil& s, const BorderedPlane& in, const BorderedPlane& out,
                             BorderedPlane& out_gradient, double* gradient) {
  constexpr int kCount = TapCount(kFootprint);
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0f);
  for (int y = 0; y < in.height(); ++y) {
    const float* from = in.row(y + s.cell_y) + s.cell_x;
    const float* value = out.row(y);
    float* g = out_gradient.row(y);
    V sums[kCount];
    for (V& sum : sums) sum = zero;
    for (int x = 0; x < in.width(); x += lanes) {
      const V v = hn::LoadU(d, value + x);
      const auto open = hn::And(hn::Gt(v, zero), hn::Lt(v, one));
      const V masked = hn::IfThenElseZero(open, hn::LoadU(d, g + x));
      hn::StoreU(masked, d, g + x);
      HWY_UNROLL(kWeights)
      for (int i = 0; i < kCount; ++i) {
        const float* at = TexelOf<kFootprint>(i, from + x, in.stride());
        sums[i] = hn::MulAdd(masked, hn::LoadU(d, at), sums[i]);
      }
    }
    for (int i = 0; i < kCount; ++i) {
      gradient[TapsOf(kFootprint)[i]] += hn::GetLane(hn::SumOfLanes(d, sums[i]));
    }
  }
}

// in_gradient(q) = sum of weight k * out_gradient(q - offset of tap k), for q inside and in the
// border that a stencil reads. The taps (x, y) and (1 - x, 1 - y) are at places i and
// count - 1 - i.
template <Footprint kFootprint>
void FootprintInputGradient(const Stencil& s, const BorderedPlane& out_gradient,
                            BorderedPlane& in_gradient) {
  constexpr int kCount = TapCount(kFootprint);
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  V weights[kCount];
  for (int i = 0; i < kCount; ++i) {
    weights[i] = hn::Set(d, s.weights[TapsOf(kFootprint)[kCount - 1 - i]]);
  }
  for (int y = -kStencilReach; y < in_gradient.height() + kStencilReach; ++y) {
    const float* from = out_gradient.row(y - s.cell_y - 1) - s.cell_x - 1;
    float* to = in_gradient.row(y);
    for (int x = -kStencilReach; x < in_gradient.width() + kStencilReach; x += lanes) {
      hn::StoreU(Gather<kFootprint>(weights, from + x, out_gradient.stride()), d, to + x);
    }
  }
}

void StencilRows(const Stencil& s, const BorderedPlane& in, BorderedPlane& out) {
  switch (s.footprint) {
    case Footprint::k16:
      return FootprintRows<Footprint::k16>(s, in, out);
    case Footprint::k24:
      return FootprintRows<Footprint::k24>(s, in, out);
    case Footprint::k36:
      return FootprintRows<Footprint::k36>(s, in, out);
  }
}

void WeightGradient(const Stencil& s, const BorderedPlane& in, const BorderedPlane& out,
                    BorderedPlane& out_gradient, double* gradient) {
  switch (s.footprint) {
    case Footprint::k16:
      return FootprintWeightGradient<Footprint::k16>(s, in, out, out_gradient, gradient);
    case Footprint::k24:
      return FootprintWeightGradient<Footprint::k24>(s, in, out, out_gradient, gradient);
    case Footprint::k36:
      return FootprintWeightGradient<Footprint::k36>(s, in, out, out_gradient, gradient);
  }
}

void InputGradient(const Stencil& s, const BorderedPlane& out_gradient,
                   BorderedPlane& in_gradient) {
  switch (s.footprint) {
    case Footprint::k16:
      return FootprintInputGradient<Footprint::k16>(s, out_gradient, in_gradient);
    case Footprint::k24:
      return FootprintInputGradient<Footprint::k24>(s, out_gradient, in_gradient);
    case Footprint::k36:
      return FootprintInputGradient<Footprint::k36>(s, out_gradient, in_gradient);
  }
}

// clang-format off
}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();
// clang-format on

#if HWY_ONCE

namespace warplut {
HWY_EXPORT(StencilRows);
HWY_EXPORT(WeightGradient);
HWY_EXPORT(InputGradient);

namespace {

constexpr int kReach = kStencilReach;

}  // namespace

int ContinuedPixel(int i, int size, Border border) {
  if (border == Border::kRepeated) return std::clamp(i, 0, size - 1);
  if (i >= 0 && i < size) return i;
  const int period = 2 * size;
  if (i >= -size && i < period) return i < 0 ? -1 - i : period - 1 - i;
  const int place = (i % period + period) % period;
  return std::min(place, period - 1 - place);
}

void FillBorder(BorderedPlane& plane, Border border) {
  const int width = plane.width();
  const int height = plane.height();
  for (int i = 1; i <= kReach; ++i) {
    const int left = ContinuedPixel(-i, width, border);
    const int right = ContinuedPixel(width - 1 + i, width, border);
    for (int y = 0; y < height; ++y) {
      float* row = plane.row(y);
      row[-i] = row[left];
      row[width - 1 + i] = row[right];
    }
  }
  const auto fill_row = [&](int y) {
    std::copy_n(plane.row(ContinuedPixel(y, height, border)) - kReach, width + 2 * kReach,
                plane.row(y) - kReach);
  };
  for (int i = 1; i <= kReach; ++i) {
    fill_row(-i);
    fill_row(height - 1 + i);
  }
}

void ApplyStencil(const Stencil& stencil, const BorderedPlane& in, BorderedPlane& out) {
  HWY_DYNAMIC_DISPATCH(StencilRows)(stencil, in, out);
  FillBorder(out);
}

void AdjointStencil(const Stencil& stencil, const BorderedPlane& in, const BorderedPlane& out,
                    BorderedPlane& out_gradient, BorderedPlane& in_gradient,
                    Weights<double>& weight_gradient, Border border) {
  const int width = in.width();
  const int height = in.height();
  HWY_DYNAMIC_DISPATCH(WeightGradient)(stencil, in, out, out_gradient, weight_gradient.data());
  HWY_DYNAMIC_DISPATCH(InputGradient)(stencil, out_gradient, in_gradient);
  // The adjoint of FillBorder.
  const auto fold_row = [&](int y) {
    float* source = in_gradient.row(y) - kReach;
    float* target = in_gradient.row(ContinuedPixel(y, height, border)) - kReach;
    for (int x = 0; x < width + 2 * kReach; ++x) target[x] += source[x];
  };
  for (int i = 1; i <= kReach; ++i) {
    fold_row(-i);
    fold_row(height - 1 + i);
  }
  constexpr int kBorder = BorderedPlane::kBorder;
  for (int y = 0; y < height; ++y) {
    float* row = in_gradient.row(y);
    for (int i = 1; i <= kReach; ++i) {
      row[ContinuedPixel(-i, width, border)] += row[-i];
      row[ContinuedPixel(width - 1 + i, width, border)] += row[width - 1 + i];
    }
    std::fill(row - kBorder, row, 0.0f);
    std::fill(row + width, in_gradient.row(y + 1) - kBorder, 0.0f);
  }
  for (int i = 1; i <= kBorder; ++i) {
    std::fill_n(in_gradient.row(-i) - kBorder, in_gradient.stride(), 0.0f);
    std::fill_n(in_gradient.row(height - 1 + i) - kBorder, in_gradient.stride(), 0.0f);
  }
}

}  // namespace warplut

#endif  // HWY_ONCE
