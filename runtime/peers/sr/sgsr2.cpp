#include "runtime/peers/sr/sgsr2.h"

#include "runtime/core/instruction_sets.h"
#include "runtime/peers/sr/lanczos_samples.h"
#include "runtime/peers/sr/sr_peer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/peers/sr/sgsr2.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/peers/sr/lanczos_samples-inl.h"
#endif

#ifndef WARPLUT_RUNTIME_PEERS_SGSR2_ONCE
#define WARPLUT_RUNTIME_PEERS_SGSR2_ONCE
namespace warplut::peers {
namespace {

// (bias / 2)^2.
float Sgsr2Narrowing(const SrJob& job) { return 0.25f * KernelBias(job) * KernelBias(job); }

Rgb BlendSgsr2(const SrJob& job, int x, int y, const Predicted& predicted, const Neighbourhood& n) {
  const Parameters& parameters = job.options.parameters;
  const float length = MotionLength(job, x, y);
  const bool counts = n.weight > kLeastWeight;
  const float weight = counts ? n.weight * parameters.sgsr2_weight : 0.0f;
  const float t = std::max(1 - predicted.validity, Saturate(length / kBoxMotion));
  const float half = parameters.sgsr2_box + t * (1 - parameters.sgsr2_box);
  bool leaves = false;
  for (int c = 0; c < 3; ++c) {
    leaves = leaves || n.low.c[c] - predicted.color.c[c] > kRangeSlack ||
             predicted.color.c[c] - n.high.c[c] > kRangeSlack;
  }
  const float kept = !leaves ? 1.0f : length > kSgsr2StillMotion ? 0.0f : kSgsr2StillKept;
  const float base = HistoryWeight(predicted.validity, weight, length);
  const float limited = std::min(base, kLimitedWeight);
  const float history_weight = limited + kept * (base - limited);
  const float share = counts ? weight / (history_weight + weight) : 0.0f;
  const Rgb mean = n.Mean(), deviation = n.Deviation();
  Rgb q;
  for (int c = 0; c < 3; ++c) {
    const float low = std::max(n.low.c[c], mean.c[c] - half * deviation.c[c]);
    const float high = std::min(n.high.c[c], mean.c[c] + half * deviation.c[c]);
    const float inside = std::min(std::max(predicted.color.c[c], low), high);
    const float h = inside + kept * (predicted.color.c[c] - inside);
    const float s = counts ? std::clamp(n.color.c[c] / n.weight, n.low.c[c] - kSgsr2Slack,
                                        n.high.c[c] + kSgsr2Slack)
                           : h;
    q.c[c] = h + share * (s - h);
  }
  return q;
}

void UpdateSgsr2Reference(const SrJob& job, int begin, int end, SrScratch& /*scratch*/,
                          const MutableImageView& out) {
  const float narrowing = Sgsr2Narrowing(job);
  const auto weigh = [&](int x, int y) {
    const float curve = BoxCurve(MotionLength(job, x, y));
    return [=](int, int, float dx, float dy) {
      const float square = dx * dx + dy * dy;
      return SampleWeights{Sgsr2Kernel(square * narrowing), std::exp(curve * square)};
    };
  };
  const auto blend = [&](int x, int y, const Predicted& predicted, const Neighbourhood& n) {
    return BlendSgsr2(job, x, y, predicted, n);
  };
  UpdateRowsReference(job, begin, end, out, weigh, blend);
}

const SrPeerPasses& ReferenceSgsr2() {
  static constexpr SrPeerPasses kPasses = {UpdateSgsr2Reference, nullptr};
  return kPasses;
}

}  // namespace
}  // namespace warplut::peers
#endif  // WARPLUT_RUNTIME_PEERS_SGSR2_ONCE

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
// Sgsr2Kernel of d^2.
struct Sgsr2Kernels {
  float narrowing;

  HWY_INLINE Floats operator()(Floats square) const {
    const FloatTag d;
    const auto one = hn::Set(d, 1.0f);
    const auto t = hn::Min(hn::Mul(square, hn::Set(d, narrowing)), one);
    const auto u = hn::Sub(t, one);
    const auto squared = hn::Mul(u, u);
    return hn::Mul(hn::MulAdd(hn::Set(d, 0.75f), u, squared), squared);
  }
};

void UpdateSgsr2(const SrJob& job, int begin, int end, SrScratch& /*scratch*/,
                 const MutableImageView& out) {
  const FloatTag d;
  const Parameters& parameters = job.options.parameters;
  const Sgsr2Kernels kernel{Sgsr2Narrowing(job)};
  using Weights = LanczosWeights<Sgsr2Kernels>;
  const auto weigh = [&](int x, int y) HWY_ATTR { return Weights(job, kernel, x, y); };
  const auto blend = [&](const Weights& weights, const Pixels& predicted,
                         const Neighbourhoods& n) HWY_ATTR {
    const auto one = hn::Set(d, 1.0f);
    const Floats history[3] = {predicted.r, predicted.g, predicted.b};
    const Floats length = weights.length();
    Colors sample, mean, deviation, q;
    const auto weight = UpsampledColor(n, kSgsr2Slack, parameters.sgsr2_weight, sample);
    const auto t = hn::Max(hn::Sub(one, predicted.a), ShareOf(length, kBoxMotion));
    const auto half =
        hn::MulAdd(t, hn::Set(d, 1 - parameters.sgsr2_box), hn::Set(d, parameters.sgsr2_box));
    const auto moves = hn::Gt(length, hn::Set(d, kSgsr2StillMotion));
    const auto out_of_range = hn::IfThenElse(moves, hn::Zero(d), hn::Set(d, kSgsr2StillKept));
    const auto kept = hn::IfThenElse(LeavesRange(history, n.low, n.high), out_of_range, one);
    const auto base = HistoryWeights(predicted.a, weight, length);
    const auto limited = hn::Min(base, hn::Set(d, kLimitedWeight));
    const auto sum = hn::Add(Mix(limited, base, kept), weight);
    const auto counts = hn::Gt(weight, hn::Zero(d));
    const auto share = hn::IfThenElseZero(counts, hn::Div(weight, sum));
    n.Box(mean, deviation);
    for (int c = 0; c < 3; ++c) {
      const auto low = hn::Max(n.low.c[c], hn::NegMulAdd(half, deviation.c[c], mean.c[c]));
      const auto high = hn::Min(n.high.c[c], hn::MulAdd(half, deviation.c[c], mean.c[c]));
      const auto h = Mix(Clamp(history[c], low, high), history[c], kept);
      q.c[c] = Mix(h, sample.c[c], share);
    }
    return q;
  };
  UpdateRows(job, begin, end, out, weigh, blend);
}
#endif

const SrPeerPasses& Sgsr2OfTarget() {
#if HWY_TARGET == HWY_SCALAR
  return ReferenceSgsr2();  // without vectors the formulas are the kernels
#else
  static constexpr SrPeerPasses kPasses = {UpdateSgsr2, nullptr};
  return kPasses;
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {
namespace peers {

HWY_EXPORT(Sgsr2OfTarget);

static const SrPeerPasses& FastSgsr2() { return HWY_DYNAMIC_DISPATCH(Sgsr2OfTarget)(); }

}  // namespace peers

const SrPeer kSgsr2 = {Filter::kBilinear, false, peers::ReferenceSgsr2, peers::FastSgsr2};

}  // namespace warplut
#endif  // HWY_ONCE
