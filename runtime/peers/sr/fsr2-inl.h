// The update of fsr2, per target.
#if defined(WARPLUT_RUNTIME_PEERS_FSR2_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PEERS_FSR2_INL_H_
#undef WARPLUT_RUNTIME_PEERS_FSR2_INL_H_
#else
#define WARPLUT_RUNTIME_PEERS_FSR2_INL_H_
#endif

#include "runtime/peers/sr/lanczos_samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

using FloatMask = hn::Mask<FloatTag>;

// Fsr2Kernel of d^2.
struct Fsr2Kernels {
  float narrowing;  // bias^2

  HWY_INLINE Floats operator()(Floats square) const {
    const FloatTag d;
    const auto t = hn::Min(hn::Mul(square, hn::Set(d, narrowing)), hn::Set(d, 4.0f));
    const auto one = hn::Set(d, 1.0f);
    const auto a = hn::MulSub(hn::Set(d, 0.4f), t, one);
    const auto b = hn::MulSub(hn::Set(d, 0.25f), t, one);
    const auto first = hn::MulSub(hn::Set(d, 25.0f / 16), hn::Mul(a, a), hn::Set(d, 9.0f / 16));
    return hn::Mul(first, hn::Mul(b, b));
  }
};

// LumaOf, to the bit.
HWY_INLINE Floats LumasOf(Floats r, Floats g, Floats b) {
  const FloatTag d;
  const auto rg = hn::Add(hn::Mul(hn::Set(d, static_cast<float>(kLumaWeights[0])), r),
                          hn::Mul(hn::Set(d, static_cast<float>(kLumaWeights[1])), g));
  return hn::Add(rg, hn::Mul(hn::Set(d, static_cast<float>(kLumaWeights[2])), b));
}

HWY_INLINE Floats LumaRatios(Floats a, Floats b) {
  const FloatTag d;
  const auto greater = hn::Max(a, b);
  const auto some = hn::Gt(greater, hn::Zero(d));
  const auto one = hn::Set(d, 1.0f);
  return hn::IfThenElse(some, hn::Div(hn::Min(a, b), hn::IfThenElse(some, greater, one)), one);
}

// IsThinFeature for row j of the samples, as 1 or 0.
HWY_INLINE void FillThinRow(const SrJob& job, int j, float* thin) {
  const FloatTag d;
  const auto ratio = hn::Set(d, job.options.parameters.fsr2_lock_ratio);
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  for (int i = 0; i < job.x.render(); i += kLanes) {
    const auto luma = [&](int di, int dj) HWY_ATTR {
      const auto channel = [&](int c) HWY_ATTR {
        return hn::LoadU(d, job.planes.color[c].Row(j + dj) + i + di);
      };
      return LumasOf(channel(0), channel(1), channel(2));
    };
    const auto center = luma(0, 0);
    auto least = hn::Set(d, 2.0f), greatest = hn::Set(d, -1.0f);
    Floats alike[3][3];
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        if (di == 0 && dj == 0) {
          alike[1][1] = one;
          continue;
        }
        const auto other = luma(di, dj);
        const auto is_alike =
            hn::Lt(hn::Max(other, center), hn::Mul(ratio, hn::Min(other, center)));
        alike[dj + 1][di + 1] = hn::IfThenElseZero(is_alike, one);
        least = hn::IfThenElse(is_alike, least, hn::Min(least, other));
        greatest = hn::IfThenElse(is_alike, greatest, hn::Max(greatest, other));
      }
    }
    auto is_thin = hn::Or(hn::Gt(center, greatest), hn::Lt(center, least));
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 2; ++x) {
        const auto all = hn::Mul(hn::Mul(alike[y][x], alike[y][x + 1]),
                                 hn::Mul(alike[y + 1][x], alike[y + 1][x + 1]));
        is_thin = hn::And(is_thin, hn::Eq(all, zero));
      }
    }
    hn::Store(hn::IfThenElseZero(is_thin, one), d, thin + i);
  }
}

// KeptHistory for kLanes pixels of row y from x on, of which `left` are in the image; `thin` marks
// the nearest samples, `shading` is that of theirs.
HWY_INLINE Floats KeptHistories(const SrJob& job, int x, int y, int left, Floats validity,
                                Floats thin, Floats shading, const Colors& mean,
                                const Colors& deviation) {
  const FloatTag d;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  const auto u = hn::Mul(hn::LoadU(d, job.x.offset() + x), hn::Set(d, job.x.scale()));
  const auto v = hn::Set(d, job.y.offset()[y] * job.y.scale());
  const auto holds_sample = hn::And(hn::Le(hn::Abs(u), half), hn::Le(hn::Abs(v), half));
  const auto is_new = hn::And(holds_sample, hn::Gt(thin, zero));
  const auto luma =
      hn::Mul(hn::Floor(hn::Add(
                  hn::Div(LumasOf(mean.c[0], mean.c[1], mean.c[2]), hn::Set(d, kLumaStep)), half)),
              hn::Set(d, kLumaStep));
  const Pixels state = LoadPixels(job.next_state, x, y, left);
  auto lifetime = state.r;
  const auto ends = hn::And(hn::Gt(lifetime, one),
                            hn::Lt(LumaRatios(state.g, shading), hn::Set(d, 1 - kLockBreak)));
  const auto begun = hn::IfThenElse(hn::Gt(lifetime, zero), hn::Set(d, 2.0f), one);
  lifetime = hn::IfThenElse(is_new, begun, hn::IfThenElse(ends, zero, lifetime));
  lifetime = hn::Mul(lifetime, validity);
  const auto lock_shading = hn::Mul(half, hn::Add(state.g, shading));
  const auto lock = hn::Mul(Limit(hn::Mul(hn::Set(d, kTrustedLock), Limit(hn::Sub(lifetime, one)))),
                            LumaRatios(lock_shading, shading));
  const auto change = hn::Sub(luma, state.b), change_before = hn::Sub(luma, state.a);
  const auto alternates = hn::And(hn::And(hn::Gt(hn::Mul(change, change_before), zero),
                                          hn::Ge(hn::Abs(change), hn::Set(d, kLumaStep))),
                                  hn::Lt(hn::Abs(change_before), hn::Abs(change)));
  const auto spread = Limit(hn::Mul(LumasOf(deviation.c[0], deviation.c[1], deviation.c[2]),
                                    hn::Set(d, 1.0f / kUnstableDeviation)));
  const auto cube = hn::Mul(spread, hn::Mul(spread, spread));
  const auto unstable = hn::IfThenElseZero(alternates, hn::Mul(cube, cube));

  const auto valid = hn::Gt(validity, zero);
  const auto decayed = hn::Max(hn::Sub(lifetime, hn::Set(d, LockDecay(job))), zero);
  const Pixels next{hn::IfThenElse(valid, decayed, hn::IfThenElseZero(is_new, one)),
                    hn::IfThenElse(valid, lock_shading, shading), luma,
                    hn::IfThenElse(valid, state.b, luma)};
  StorePixels(next, job.next_state, x, y, left);
  return hn::Max(lock, unstable);
}

inline void UpdateFsr2(const SrJob& job, int begin, int end, SrScratch& scratch,
                       const MutableImageView& out) {
  const FloatTag d;
  const Parameters& parameters = job.options.parameters;
  const Fsr2Kernels kernel{KernelBias(job) * KernelBias(job)};
  float* thin = scratch.render_rows.Row(0);
  float* sums = scratch.render_rows.Row(1);
  float* shading = scratch.render_rows.Row(2);
  int thin_row = -1, shading_row = -1;  // of samples, of tiles

  struct Place : LanczosWeights<Fsr2Kernels> {
    HWY_INLINE Place(const SrJob& job, const Fsr2Kernels& kernel, int column, int row)
        : LanczosWeights<Fsr2Kernels>(job, kernel, column, row), x(column), y(row) {}
    int x, y;
  };
  const auto weigh = [&](int x, int y) HWY_ATTR {
    if (job.y.nearest()[y] != thin_row) {
      thin_row = job.y.nearest()[y];
      FillThinRow(job, thin_row, thin);
      if (thin_row / kShadingTile != shading_row) FillShadingRow(job, thin_row, sums, shading);
      shading_row = thin_row / kShadingTile;
    }
    return Place(job, kernel, x, y);
  };
  const auto blend = [&](const Place& place, const Pixels& predicted,
                         const Neighbourhoods& n) HWY_ATTR {
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const Floats history[3] = {predicted.r, predicted.g, predicted.b};
    Colors sample, mean, deviation, low, high, q;
    n.Box(mean, deviation);
    const Columns nearest(job.x.nearest(), place.x);
    const auto held = KeptHistories(job, place.x, place.y, job.x.output() - place.x, predicted.a,
                                    nearest.At(thin), nearest.At(shading), mean, deviation);
    const auto length = place.length();
    const auto weight = UpsampledColor(n, 0.0f, parameters.fsr2_weight, sample);
    const auto t = hn::Max(hn::Sub(one, predicted.a), ShareOf(length, kBoxMotion));
    const auto half =
        hn::MulAdd(t, hn::Set(d, 1 - parameters.fsr2_box), hn::Set(d, parameters.fsr2_box));
    for (int c = 0; c < 3; ++c) {
      low.c[c] = hn::Max(n.low.c[c], hn::NegMulAdd(half, deviation.c[c], mean.c[c]));
      high.c[c] = hn::Min(n.high.c[c], hn::MulAdd(half, deviation.c[c], mean.c[c]));
    }
    const auto kept = hn::IfThenElse(LeavesRange(history, low, high), held, one);
    const auto base = HistoryWeights(predicted.a, weight, length);
    const auto limited = hn::Min(base, hn::Set(d, kLimitedWeight));
    const auto sum = hn::Add(Mix(limited, base, kept), weight);
    const auto share = hn::IfThenElseZero(hn::Gt(weight, zero), hn::Div(weight, sum));
    for (int c = 0; c < 3; ++c) {
      const auto h = Mix(Clamp(history[c], low.c[c], high.c[c]), history[c], kept);
      q.c[c] = Mix(h, sample.c[c], share);
    }
    return q;
  };
  UpdateRows(job, begin, end, out, weigh, blend);
}

// The least and the greatest of the 2 x 2 texels of kLanes pixels that follow each other from
// (x, y) on; columns x to x + kLanes and rows y and y + 1 lie in the image.
HWY_INLINE void TexelRange(const ImageView& image, int x, int y, Colors& low, Colors& high) {
  for (int k = 0; k < 4; ++k) {
    const Pixels texel = LoadPixels(image, x + k % 2, y + k / 2, kLanes);
    const Floats channels[3] = {texel.r, texel.g, texel.b};
    for (int c = 0; c < 3; ++c) {
      low.c[c] = k == 0 ? channels[c] : hn::Min(low.c[c], channels[c]);
      high.c[c] = k == 0 ? channels[c] : hn::Max(high.c[c], channels[c]);
    }
  }
}

// LimitToTexels of those of kLanes pixels whose sources follow the first one's or precede the last
// one's, as nearly all do where motion changes little. The others are limited one by one.
HWY_INLINE void LimitPixels(const SrJob& job, const MotionView& motion, const float* validity,
                            int x, int y) {
  const FloatTag d;
  const IntTag di;
  const ImageView history = InFormat(kPipeline.sr.history_format, job.history);
  const MutableImageView next = InFormat(kPipeline.sr.history_format, job.next);
  Floats mx, my;
  hn::LoadInterleaved2(d, motion.Row(y) + 2 * x, mx, my);
  const auto column =
      hn::Sub(hn::Floor(hn::Sub(PixelNumbers(x), mx)), hn::ConvertTo(d, hn::Iota(di, 0)));
  const auto row = hn::Floor(hn::Sub(hn::Set(d, static_cast<float>(y)), my));
  auto valid = hn::Ge(hn::LoadU(d, validity + x), hn::Set(d, 1.0f));
  if (hn::AllFalse(d, valid)) return;
  Pixels p = LoadPixels(next, x, y, kLanes);
  const auto limit = [&](int lane) HWY_ATTR {
    const float left = hn::ExtractLane(column, static_cast<std::size_t>(lane));
    const float top = hn::ExtractLane(row, static_cast<std::size_t>(lane));
    const bool inside = left >= 0 && left + kLanes < static_cast<float>(history.width) &&
                        top >= 0 && top + 1 < static_cast<float>(history.height);
    if (!inside) return;
    const auto run =
        hn::And(valid, hn::And(hn::Eq(column, hn::Set(d, left)), hn::Eq(row, hn::Set(d, top))));
    if (hn::AllFalse(d, run)) return;
    Colors low, high;
    TexelRange(history, static_cast<int>(left), static_cast<int>(top), low, high);
    p.r = hn::IfThenElse(run, Clamp(p.r, low.c[0], high.c[0]), p.r);
    p.g = hn::IfThenElse(run, Clamp(p.g, low.c[1], high.c[1]), p.g);
    p.b = hn::IfThenElse(run, Clamp(p.b, low.c[2], high.c[2]), p.b);
    valid = hn::AndNot(run, valid);
  };
  limit(0);
  if (!hn::AllFalse(d, valid)) limit(kLanes - 1);
  StorePixels(p, next, x, y, kLanes);
  if (hn::AllFalse(d, valid)) return;
  alignas(64) float left[kLanes];
  hn::Store(hn::IfThenElseZero(valid, hn::Set(d, 1.0f)), d, left);
  for (int i = 0; i < kLanes; ++i) {
    if (left[i] > 0) LimitToTexels(job, motion, x + i, y);
  }
}

inline void LimitFsr2(const SrJob& job, int begin, int end, SrScratch& scratch) {
  const MotionView motion = Band{begin, end}.Motion(scratch.motion);
  for (int y = begin; y < end; ++y) {
    const float* validity = scratch.validity.Row(y - begin);
    for (int x = 0; x < job.x.output(); x += kLanes) {
      if (x + kLanes <= job.x.output()) {
        LimitPixels(job, motion, validity, x, y);
        continue;
      }
      for (int i = x; i < job.x.output(); ++i) {
        if (validity[i] >= 1) LimitToTexels(job, motion, i, y);
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
