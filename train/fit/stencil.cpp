#include "train/fit/stencil.h"

#include <algorithm>

#include "runtime/core/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "train/fit/stencil.cpp"
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

// Sum over the taps of weights[4 (ky) + kx] * in[ky * stride + kx], one vector of outputs.
HWY_INLINE V Gather(const V* weights, const float* in, std::ptrdiff_t stride) {
  const D d;
  V even = hn::Mul(weights[0], hn::LoadU(d, in));
  V odd = hn::Mul(weights[1], hn::LoadU(d, in + 1));
  for (int k = 2; k < kWeights; k += 2) {
    const float* at = in + (k / kTaps) * stride + k % kTaps;
    even = hn::MulAdd(weights[k], hn::LoadU(d, at), even);
    odd = hn::MulAdd(weights[k + 1], hn::LoadU(d, at + 1), odd);
  }
  return hn::Add(even, odd);
}

// Whole vectors may run past the right edge into the border, which FillBorder repairs.
void StencilRows(const Stencil& s, const BorderedPlane& in, BorderedPlane& out) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  V weights[kWeights];
  for (int k = 0; k < kWeights; ++k) weights[k] = hn::Set(d, s.weights[k]);
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0f);
  for (int y = 0; y < in.height(); ++y) {
    const float* from = in.row(y + s.cell_y + kFirstTap) + s.cell_x + kFirstTap;
    float* to = out.row(y);
    for (int x = 0; x < in.width(); x += lanes) {
      const V sum = Gather(weights, from + x, in.stride());
      hn::StoreU(hn::Min(hn::Max(sum, zero), one), d, to + x);
    }
  }
}

// Zeroes the gradient of clamped pixels and adds the gradient of the weights, row by row.
void WeightGradient(const Stencil& s, const BorderedPlane& in, const BorderedPlane& out,
                    BorderedPlane& out_gradient, double* gradient) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0f);
  for (int y = 0; y < in.height(); ++y) {
    const float* from = in.row(y + s.cell_y + kFirstTap) + s.cell_x + kFirstTap;
    const float* value = out.row(y);
    float* g = out_gradient.row(y);
    V sums[kWeights];
    for (V& sum : sums) sum = zero;
    for (int x = 0; x < in.width(); x += lanes) {
      const V v = hn::LoadU(d, value + x);
      const auto open = hn::And(hn::Gt(v, zero), hn::Lt(v, one));
      const V masked = hn::IfThenElseZero(open, hn::LoadU(d, g + x));
      hn::StoreU(masked, d, g + x);
      for (int k = 0; k < kWeights; ++k) {
        const float* at = from + (k / kTaps) * in.stride() + k % kTaps + x;
        sums[k] = hn::MulAdd(masked, hn::LoadU(d, at), sums[k]);
      }
    }
    for (int k = 0; k < kWeights; ++k) gradient[k] += hn::GetLane(hn::SumOfLanes(d, sums[k]));
  }
}

// in_gradient(q) = sum of weight k * out_gradient(q - offset of tap k), for q inside and in the
// border that a stencil reads.
void InputGradient(const Stencil& s, const BorderedPlane& out_gradient,
                   BorderedPlane& in_gradient) {
  constexpr int kReach = 2;
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  V weights[kWeights];
  for (int k = 0; k < kWeights; ++k) weights[k] = hn::Set(d, s.weights[kWeights - 1 - k]);
  // q - cell - tap for the last tap is the upper-left of the 4 x 4 window.
  const int first = kTaps - 1 + kFirstTap;
  for (int y = -kReach; y < in_gradient.height() + kReach; ++y) {
    const float* from = out_gradient.row(y - s.cell_y - first) - s.cell_x - first;
    float* to = in_gradient.row(y);
    for (int x = -kReach; x < in_gradient.width() + kReach; x += lanes) {
      hn::StoreU(Gather(weights, from + x, out_gradient.stride()), d, to + x);
    }
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

// How far a stencil reads past the image: a whole part of -1 and tap -1, or tap 2.
constexpr int kReach = 2;

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
