#include "runtime/peers/sr/taau.h"

#include "runtime/core/instruction_sets.h"
#include "runtime/peers/sr/neighbourhood.h"
#include "runtime/peers/sr/sr_peer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/peers/sr/taau.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/peers/sr/neighbourhood-inl.h"
#endif

#ifndef WARPLUT_RUNTIME_PEERS_TAAU_ONCE
#define WARPLUT_RUNTIME_PEERS_TAAU_ONCE
namespace warplut::peers {
namespace {

float SampleGauss(const SrJob& job, float dx, float dy) {
  const float u = dx * job.x.scale(), v = dy * job.y.scale();
  return std::exp(-kSampleFalloff * (u * u + v * v));
}

void UpdateTaauReference(const SrJob& job, int begin, int end, SrScratch& /*scratch*/,
                         const MutableImageView& out) {
  const Parameters& parameters = job.options.parameters;
  const auto weigh = [&](int, int) {
    return [&](int, int, float dx, float dy) {
      return SampleWeights{SampleGauss(job, dx, dy), 1.0f};
    };
  };
  const auto blend = [&](int x, int y, const Predicted& predicted, const Neighbourhood& n) {
    const Rgb sample = n.Color(), mean = n.Mean(), deviation = n.Deviation();
    const float share = predicted.validity * parameters.taau_blend *
                        SampleGauss(job, job.x.offset()[x], job.y.offset()[y]);
    Rgb q;
    for (int c = 0; c < 3; ++c) {
      const float half = parameters.taau_gamma * deviation.c[c];
      const float h = std::clamp(predicted.color.c[c], mean.c[c] - half, mean.c[c] + half);
      q.c[c] = h + share * (sample.c[c] - h);
    }
    return q;
  };
  UpdateRowsReference(job, begin, end, out, weigh, blend);
}

const SrPeerPasses& ReferenceTaau() {
  static constexpr SrPeerPasses kPasses = {UpdateTaauReference, nullptr};
  return kPasses;
}

}  // namespace
}  // namespace warplut::peers
#endif  // WARPLUT_RUNTIME_PEERS_TAAU_ONCE

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
// SampleGauss, a product of one factor for each axis, of the samples around kLanes pixels.
class GaussWeights {
 public:
  HWY_INLINE GaussWeights(const SrJob& job, int x, int y) {
    const FloatTag d;
    const auto offset = hn::LoadU(d, job.x.offset() + x);
    const auto scale = hn::Set(d, job.x.scale());
    for (int i = -1; i <= 1; ++i) {
      const auto u = hn::Mul(hn::Sub(offset, hn::Set(d, static_cast<float>(i))), scale);
      columns_[i + 1] = hn::Exp(d, hn::Mul(hn::Set(d, -kSampleFalloff), hn::Mul(u, u)));
      const float v = (job.y.offset()[y] - static_cast<float>(i)) * job.y.scale();
      rows_[i + 1] = std::exp(-kSampleFalloff * v * v);
    }
  }
  HWY_INLINE Floats At(int di, int dj) const {
    return hn::Mul(columns_[di + 1], hn::Set(FloatTag(), rows_[dj + 1]));
  }
  HWY_INLINE SampleWeightVectors operator()(int di, int dj, Floats /*dx*/, Floats /*dy*/) const {
    return {At(di, dj), hn::Set(FloatTag(), 1.0f)};
  }

 private:
  Floats columns_[3];
  float rows_[3];
};

void UpdateTaau(const SrJob& job, int begin, int end, SrScratch& /*scratch*/,
                const MutableImageView& out) {
  const FloatTag d;
  const Parameters& parameters = job.options.parameters;
  const auto gamma = hn::Set(d, parameters.taau_gamma);
  const auto alpha = hn::Set(d, parameters.taau_blend);
  const auto weigh = [&](int x, int y) HWY_ATTR { return GaussWeights(job, x, y); };
  const auto blend = [&](const GaussWeights& weights, const Pixels& predicted,
                         const Neighbourhoods& n) HWY_ATTR {
    const Floats history[3] = {predicted.r, predicted.g, predicted.b};
    const Colors sample = n.Color();
    Colors mean, deviation, q;
    n.Box(mean, deviation);
    const auto share = hn::Mul(hn::Mul(predicted.a, alpha), weights.At(0, 0));
    for (int c = 0; c < 3; ++c) {
      const auto half = hn::Mul(gamma, deviation.c[c]);
      const auto h = Clamp(history[c], hn::Sub(mean.c[c], half), hn::Add(mean.c[c], half));
      q.c[c] = Mix(h, sample.c[c], share);
    }
    return q;
  };
  UpdateRows(job, begin, end, out, weigh, blend);
}
#endif

const SrPeerPasses& TaauOfTarget() {
#if HWY_TARGET == HWY_SCALAR
  return ReferenceTaau();  // without vectors the formulas are the kernels
#else
  static constexpr SrPeerPasses kPasses = {UpdateTaau, nullptr};
  return kPasses;
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {
namespace peers {

HWY_EXPORT(TaauOfTarget);

static const SrPeerPasses& FastTaau() { return HWY_DYNAMIC_DISPATCH(TaauOfTarget)(); }

}  // namespace peers

const SrPeer kTaau = {Filter::kCatmullRom, false, peers::ReferenceTaau, peers::FastTaau};

}  // namespace warplut
#endif  // HWY_ONCE
