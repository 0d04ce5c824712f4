// Streams over the map row by row. With v = y - 1/2 and the error e = x - y, row r needs the
// vertical sums of e, e^2 and e v over image rows r to r + 10, then the horizontal ones. In the
// error
//   A1 = 2 mx my + C1              B1 = A1 + me^2           me, mx, my: means of e, x, y
//   A2 = 2 (var y + cov(e, y)) + C2    B2 = A2 + var e
//   1 - S = (me^2 B2 + A1 var e) / (B1 B2)
// so that nothing cancels where x is close to y, flat places too, and 1 - S is never negative. The
// gradient is the transposed filter of three maps:
//   dS/dE[e^2] = -S / B2
//   dS/dE[e v] = 2 A1 var e / (B1 B2^2)
//   dS/dE[e]   = 2 A2 me (me my - A1) / (B1^2 B2) - mv dS/dE[e v] - 2 me dS/dE[e^2]
// Rings of 11 rows keep both passes in cache.
#include "train/metrics/ssim.h"

#include "runtime/core/instruction_sets.h"
#include "train/metrics/ssim_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "train/metrics/ssim.cpp"
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

constexpr int kWindow = kSsimWindow;

// out[i] = sum over j of taps[j] * rows[j][i], i < n
void Vertical(const float* taps, const float* const* rows, int n, float* HWY_RESTRICT out) {
  const D d;
  for (int i = 0; i < n; i += static_cast<int>(hn::Lanes(d))) {
    V sum = hn::Mul(hn::Set(d, taps[0]), hn::LoadU(d, rows[0] + i));
    for (int j = 1; j < kWindow; ++j) {
      sum = hn::MulAdd(hn::Set(d, taps[j]), hn::LoadU(d, rows[j] + i), sum);
    }
    hn::StoreU(sum, d, out + i);
  }
}

// sum over j of taps[j] * row[j], one vector of outputs
HWY_INLINE V Horizontal(const float* taps, const float* row) {
  const D d;
  V sum = hn::Mul(hn::Set(d, taps[0]), hn::LoadU(d, row));
  for (int j = 1; j < kWindow; ++j) {
    sum = hn::MulAdd(hn::Set(d, taps[j]), hn::LoadU(d, row + j), sum);
  }
  return sum;
}

// Window means and variances of y itself.
void PrepareSsim(const SsimRows& s, float* mean_y, float* var_y) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int map_width = s.width - kWindow + 1;
  float* plain_rows = s.scratch;  // rings of 11 rows: v, v^2
  float* squares = plain_rows + kWindow * s.stride;
  float* sums = squares + kWindow * s.stride;  // 2 rows
  const V half = hn::Set(d, 0.5f);
  for (int row = 0; row < s.height; ++row) {
    float* square = squares + (row % kWindow) * s.stride;
    float* plain_row = plain_rows + (row % kWindow) * s.stride;
    for (int i = 0; i < s.width; i += lanes) {
      const V v = hn::Sub(hn::LoadU(d, s.y + row * s.stride + i), half);
      hn::StoreU(v, d, plain_row + i);
      hn::StoreU(hn::Mul(v, v), d, square + i);
    }
    const int r = row - kWindow + 1;
    if (r < 0) continue;
    const float* plain[kWindow];
    const float* squared[kWindow];
    for (int j = 0; j < kWindow; ++j) {
      plain[j] = plain_rows + ((r + j) % kWindow) * s.stride;
      squared[j] = squares + ((r + j) % kWindow) * s.stride;
    }
    Vertical(s.taps, plain, s.width, sums);
    Vertical(s.taps, squared, s.width, sums + s.stride);
    for (int i = 0; i < map_width; i += lanes) {
      const V mean = Horizontal(s.taps, sums + i);
      const V square_mean = Horizontal(s.taps, sums + s.stride + i);
      hn::StoreU(mean, d, mean_y + r * s.stride + i);
      hn::StoreU(hn::NegMulAdd(mean, mean, square_mean), d, var_y + r * s.stride + i);
    }
  }
}

// The sum of 1 - SSIM over the map; with a gradient, adds scale times the derivative of the sum of
// SSIM to it.
template <bool kGradient>
double SsimPass(const SsimRows& s, const float* x, std::ptrdiff_t x_stride, float scale,
                float* gradient, std::ptrdiff_t gradient_stride) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int map_width = s.width - kWindow + 1;
  const int map_height = s.height - kWindow + 1;
  const std::ptrdiff_t st = s.stride;
  float* ring_e = s.scratch;  // three rings of 11 rows: e, e^2, e v
  float* ring_ee = ring_e + kWindow * st;
  float* ring_ev = ring_ee + kWindow * st;
  float* sums = ring_ev + kWindow * st;  // three rows
  float* maps = sums + 3 * st;           // three rows of derivatives, 10 zeros before and after
  float* ring_d = maps + 3 * st;         // three rings of 11 rows: transposed horizontal sums
  const V half = hn::Set(d, 0.5f);
  const V one = hn::Set(d, 1.0f);
  const V two = hn::Set(d, 2.0f);
  const V c1 = hn::Set(d, static_cast<float>(kSsimC1));
  const V c2 = hn::Set(d, static_cast<float>(kSsimC2));
  double total = 0;

  const auto add_gradient_row = [&](int q) {
    // Gradient row q takes map rows q - 10 .. q, those that exist.
    const int first = q - kWindow + 1 < 0 ? 0 : q - kWindow + 1;
    const int last = q < map_height ? q : map_height - 1;
    const float* xr = x + q * x_stride;
    const float* yr = s.y + q * st;
    float* g = gradient + q * gradient_stride;
    const auto sum_at = [&](int i, V& mean, V& square, V& product) {
      mean = square = product = hn::Zero(d);
      for (int r = first; r <= last; ++r) {
        const V tap = hn::Set(d, s.taps[q - r]);
        const float* at = ring_d + (r % kWindow) * st + i;
        mean = hn::MulAdd(tap, hn::LoadU(d, at), mean);
        square = hn::MulAdd(tap, hn::LoadU(d, at + kWindow * st), square);
        product = hn::MulAdd(tap, hn::LoadU(d, at + 2 * kWindow * st), product);
      }
    };
    const V factor = hn::Set(d, scale);
    int i = 0;
    for (; i + lanes <= s.width; i += lanes) {
      V mean, square, product;
      sum_at(i, mean, square, product);
      const V y = hn::LoadU(d, yr + i);
      const V e = hn::Sub(hn::LoadU(d, xr + i), y);
      const V sum = hn::MulAdd(hn::Add(e, e), square, hn::MulAdd(hn::Sub(y, half), product, mean));
      hn::StoreU(hn::MulAdd(factor, sum, hn::LoadU(d, g + i)), d, g + i);
    }
    if (i < s.width) {
      V mean, square, product;
      sum_at(i, mean, square, product);
      HWY_ALIGN float m[16] = {}, sq[16] = {}, pr[16] = {};
      hn::Store(mean, d, m);
      hn::Store(square, d, sq);
      hn::Store(product, d, pr);
      for (int l = 0; i + l < s.width; ++l) {
        const float e = xr[i + l] - yr[i + l];
        g[i + l] += scale * (m[l] + 2 * e * sq[l] + (yr[i + l] - 0.5f) * pr[l]);
      }
    }
  };

  for (int row = 0; row < s.height; ++row) {
    const float* xr = x + row * x_stride;
    const float* yr = s.y + row * st;
    const std::ptrdiff_t slot = (row % kWindow) * st;
    int i = 0;
    for (; i + lanes <= s.width; i += lanes) {
      const V y = hn::LoadU(d, yr + i);
      const V e = hn::Sub(hn::LoadU(d, xr + i), y);
      hn::StoreU(e, d, ring_e + slot + i);
      hn::StoreU(hn::Mul(e, e), d, ring_ee + slot + i);
      hn::StoreU(hn::Mul(e, hn::Sub(y, half)), d, ring_ev + slot + i);
    }
    for (; i < s.width; ++i) {
      const float e = xr[i] - yr[i];
      ring_e[slot + i] = e;
      ring_ee[slot + i] = e * e;
      ring_ev[slot + i] = e * (yr[i] - 0.5f);
    }
    const int r = row - kWindow + 1;
    if (r < 0) continue;

    const float* rows[3][kWindow];
    for (int j = 0; j < kWindow; ++j) {
      const std::ptrdiff_t at = ((r + j) % kWindow) * st;
      rows[0][j] = ring_e + at;
      rows[1][j] = ring_ee + at;
      rows[2][j] = ring_ev + at;
    }
    for (int f = 0; f < 3; ++f) Vertical(s.taps, rows[f], s.width, sums + f * st);

    V row_sum = hn::Zero(d);
    for (int c = 0; c < map_width; c += lanes) {
      const V me = Horizontal(s.taps, sums + c);
      const V ee = Horizontal(s.taps, sums + st + c);
      const V ev = Horizontal(s.taps, sums + 2 * st + c);
      const V mv = hn::LoadU(d, s.mean_y + r * st + c);
      const V var_y = hn::LoadU(d, s.var_y + r * st + c);
      const V my = hn::Add(mv, half);
      const V mx = hn::Add(my, me);
      const V covariance = hn::NegMulAdd(me, mv, ev);
      const V var_e = hn::Max(hn::NegMulAdd(me, me, ee), hn::Zero(d));
      const V a1 = hn::MulAdd(hn::Mul(two, mx), my, c1);
      const V a2 = hn::MulAdd(two, hn::Add(var_y, covariance), c2);
      const V b1 = hn::MulAdd(me, me, a1);
      const V b2 = hn::Add(a2, var_e);
      const V inverse = hn::Div(one, hn::Mul(b1, b2));
      const V loss = hn::Mul(hn::MulAdd(hn::Mul(me, me), b2, hn::Mul(a1, var_e)), inverse);
      const auto inside = hn::FirstN(d, static_cast<size_t>(map_width - c));
      row_sum = hn::Add(row_sum, hn::IfThenElseZero(inside, loss));
      if constexpr (kGradient) {
        const V twice = hn::Mul(two, inverse);
        const V inverse1 = hn::Mul(b2, inverse);
        const V inverse2 = hn::Mul(b1, inverse);
        const V to_square = hn::Mul(hn::Sub(loss, one), inverse2);
        const V to_product = hn::Mul(hn::Mul(twice, inverse2), hn::Mul(a1, var_e));
        const V direct =
            hn::Mul(hn::Mul(twice, inverse1), hn::Mul(hn::Mul(a2, me), hn::MulSub(me, my, a1)));
        const V to_mean =
            hn::NegMulAdd(hn::Add(me, me), to_square, hn::NegMulAdd(mv, to_product, direct));
        float* at = maps + kWindow - 1 + c;
        hn::StoreU(hn::IfThenElseZero(inside, to_mean), d, at);
        hn::StoreU(hn::IfThenElseZero(inside, to_square), d, at + st);
        hn::StoreU(hn::IfThenElseZero(inside, to_product), d, at + 2 * st);
      }
    }
    total += hn::GetLane(hn::SumOfLanes(d, row_sum));
    if constexpr (kGradient) {
      for (int f = 0; f < 3; ++f) {
        float* out = ring_d + f * kWindow * st + (r % kWindow) * st;
        for (int c = 0; c < s.width; c += lanes) {
          hn::StoreU(Horizontal(s.taps, maps + f * st + c), d, out + c);
        }
      }
      add_gradient_row(r);
    }
  }
  if constexpr (kGradient) {
    for (int q = map_height; q < s.height; ++q) add_gradient_row(q);
  }
  return total;
}

double SsimLoss(const SsimRows& s, const float* x, std::ptrdiff_t x_stride) {
  return SsimPass<false>(s, x, x_stride, 0, nullptr, 0);
}

double SsimLossAndGradient(const SsimRows& s, const float* x, std::ptrdiff_t x_stride, float scale,
                           float* gradient, std::ptrdiff_t gradient_stride) {
  return SsimPass<true>(s, x, x_stride, scale, gradient, gradient_stride);
}

// clang-format off
}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();
// clang-format on

#if HWY_ONCE

namespace warplut {
HWY_EXPORT(PrepareSsim);
HWY_EXPORT(SsimLoss);
HWY_EXPORT(SsimLossAndGradient);

namespace {

// Room for a vector and the window past the end of a row.
constexpr std::ptrdiff_t kRowPad = 16 + kSsimWindow + 16;

// Zeroed rows for one pass; valid until the thread's next call.
float* Scratch(std::ptrdiff_t stride) {
  thread_local std::vector<float> scratch;
  scratch.assign(static_cast<std::size_t>(stride) * kSsimScratchRows, 0);
  return scratch.data();
}

}  // namespace

Ssim::Ssim(const PlaneView& y)
    : width_(y.width), height_(y.height), stride_((y.width + kRowPad + 15) / 16 * 16) {
  const std::array<double, kSsimWindow> taps = SsimTaps();
  for (int i = 0; i < kSsimWindow; ++i) taps_[i] = static_cast<float>(taps[i]);
  const std::size_t plane = static_cast<std::size_t>(stride_) * height_;
  y_.assign(plane, 0);
  for (int row = 0; row < height_; ++row) {
    for (int i = 0; i < width_; ++i) y_[row * stride_ + i] = y.data[row * y.stride + i];
  }
  mean_y_.assign(plane, 0);
  var_y_.assign(plane, 0);
  HWY_DYNAMIC_DISPATCH(PrepareSsim)(Rows(Scratch(stride_)), mean_y_.data(), var_y_.data());
}

SsimRows Ssim::Rows(float* scratch) const {
  return {width_,    height_,        stride_,       taps_.data(),
          y_.data(), mean_y_.data(), var_y_.data(), scratch};
}

double Ssim::Mean(const PlaneView& x) const {
  return 1 - HWY_DYNAMIC_DISPATCH(SsimLoss)(Rows(Scratch(stride_)), x.data, x.stride) / MapSize();
}

double Ssim::MeanAndGradient(const PlaneView& x, float scale, float* gradient,
                             std::ptrdiff_t gradient_stride) const {
  const auto map_scale = static_cast<float>(scale / MapSize());
  return 1 - HWY_DYNAMIC_DISPATCH(SsimLossAndGradient)(Rows(Scratch(stride_)), x.data, x.stride,
                                                       map_scale, gradient, gradient_stride) /
                 MapSize();
}

double Ssim::MapSize() const {
  return static_cast<double>(width_ - kSsimWindow + 1) * (height_ - kSsimWindow + 1);
}

}  // namespace warplut

#endif  // HWY_ONCE
