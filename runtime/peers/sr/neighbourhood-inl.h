// Neighbourhoods and rows of the peers, per target.
#if defined(WARPLUT_RUNTIME_PEERS_NEIGHBOURHOOD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PEERS_NEIGHBOURHOOD_INL_H_
#undef WARPLUT_RUNTIME_PEERS_NEIGHBOURHOOD_INL_H_
#else
#define WARPLUT_RUNTIME_PEERS_NEIGHBOURHOOD_INL_H_
#endif

#include <hwy/contrib/math/math-inl.h>

#include "runtime/sr/color-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

using namespace warplut::HWY_NAMESPACE;

struct Colors {
  Floats c[3];
};

HWY_INLINE Floats Clamp(Floats v, Floats low, Floats high) {
  return hn::Min(hn::Max(v, low), high);
}

// peers::SampleWeights of kLanes pixels.
struct SampleWeightVectors {
  Floats color;
  Floats box;
};

// peers::Neighbourhood of kLanes pixels.
struct Neighbourhoods {
  Floats weight, box_weight;
  Colors color, box, box_square, low, high;

  HWY_INLINE Colors Color() const {
    const FloatTag d;
    const auto share = hn::Div(hn::Set(d, 1.0f), weight);
    return {{hn::Mul(color.c[0], share), hn::Mul(color.c[1], share), hn::Mul(color.c[2], share)}};
  }
  HWY_INLINE void Box(Colors& mean, Colors& deviation) const {
    const FloatTag d;
    const auto share = hn::Div(hn::Set(d, 1.0f), box_weight);
    for (int c = 0; c < 3; ++c) {
      mean.c[c] = hn::Mul(box.c[c], share);
      const auto square = hn::Mul(box_square.c[c], share);
      const auto variance = hn::NegMulAdd(mean.c[c], mean.c[c], square);
      deviation.c[c] = hn::Sqrt(hn::Max(variance, hn::Zero(d)));
    }
  }
};

// NeighbourhoodAt for pixels x to x + kLanes of row y.
template <class Weigh>
HWY_INLINE Neighbourhoods NeighbourhoodsAt(const SrJob& job, int x, int y, const Weigh& weigh) {
  const FloatTag d;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  Neighbourhoods n{zero,
                   zero,
                   {{zero, zero, zero}},
                   {{zero, zero, zero}},
                   {{zero, zero, zero}},
                   {{one, one, one}},
                   {{zero, zero, zero}}};
  const Columns nearest(job.x.nearest(), x);
  const int j = job.y.nearest()[y];
  const auto offset = hn::LoadU(d, job.x.offset() + x);
  for (int dj = -1; dj <= 1; ++dj) {
    const auto dy = hn::Set(d, job.y.offset()[y] - static_cast<float>(dj));
    for (int di = -1; di <= 1; ++di) {
      const SampleWeightVectors w =
          weigh(di, dj, hn::Sub(offset, hn::Set(d, static_cast<float>(di))), dy);
      n.weight = hn::Add(n.weight, w.color);
      n.box_weight = hn::Add(n.box_weight, w.box);
      for (int c = 0; c < 3; ++c) {
        const auto s = nearest.At(job.planes.color[c].Row(j + dj) + di);
        const auto boxed = hn::Mul(w.box, s);
        n.color.c[c] = hn::MulAdd(w.color, s, n.color.c[c]);
        n.box.c[c] = hn::Add(n.box.c[c], boxed);
        n.box_square.c[c] = hn::MulAdd(boxed, s, n.box_square.c[c]);
        n.low.c[c] = hn::Min(n.low.c[c], s);
        n.high.c[c] = hn::Max(n.high.c[c], s);
      }
    }
  }
  return n;
}

// UpdateRowsReference on vectors: blend(weigh(x, y), predicted, n) gives kLanes colours; those of
// pixels without a valid history are not used.
template <class WeighAt, class Blend>
HWY_INLINE void UpdateRows(const SrJob& job, int begin, int end, const MutableImageView& out,
                           const WeighAt& weigh, const Blend& blend) {
  const FloatTag d;
  const MutableImageView next = InFormat(kPipeline.sr.history_format, job.next);
  const MutableImageView shown = InFormat(kPipeline.sr.output_format, out);
  const bool hdr = EncodingOf(job.options) == ColorEncoding::kLinearHdr;
  const auto unlimited = hn::Set(d, hdr ? HdrCode(kUnlimitedHdr) : 1.0f);
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < job.x.output(); x += kLanes) {
      const int left = job.x.output() - x;
      Pixels p = LoadPixels(next, x, y, left);
      const auto weights = weigh(x, y);
      const auto n = NeighbourhoodsAt(job, x, y, weights);
      const auto valid = hn::Gt(p.a, hn::Zero(d));
      const Colors q = blend(weights, p, n);
      p.r = hn::IfThenElse(valid, q.c[0], p.r);
      p.g = hn::IfThenElse(valid, q.c[1], p.g);
      p.b = hn::IfThenElse(valid, q.c[2], p.b);
      p.r = hn::Min(p.r, hn::Max(n.high.c[0], unlimited));
      p.g = hn::Min(p.g, hn::Max(n.high.c[1], unlimited));
      p.b = hn::Min(p.b, hn::Max(n.high.c[2], unlimited));
      p = {Limit(p.r), Limit(p.g), Limit(p.b), hn::Set(d, 1.0f)};
      StorePixels(p, next, x, y, left);
      DecodePixels(EncodingOf(job.options), p);
      StorePixels(p, shown, x, y, left);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
