#include "runtime/peers/sr/fsr2.h"

#include "runtime/core/instruction_sets.h"
#include "runtime/peers/sr/sr_peer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/peers/sr/fsr2.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/peers/sr/fsr2-inl.h"
#endif

#ifndef WARPLUT_RUNTIME_PEERS_FSR2_ONCE
#define WARPLUT_RUNTIME_PEERS_FSR2_ONCE
namespace warplut::peers {
namespace {

// The share of the history that is kept although it left the box: what a lock holds, or what an
// unstable luma asks for. Updates the state of the pixel.
float KeptHistory(const SrJob& job, int x, int y, float validity, float shading, const Rgb& mean,
                  const Rgb& deviation) {
  const float u = job.x.offset()[x] * job.x.scale(), v = job.y.offset()[y] * job.y.scale();
  const bool holds_sample = std::abs(u) <= 0.5f && std::abs(v) <= 0.5f;
  const bool is_new = holds_sample && IsThinFeature(job, job.x.nearest()[x], job.y.nearest()[y],
                                                    job.options.parameters.fsr2_lock_ratio);
  const float luma =
      std::floor(LumaOf(mean.c[0], mean.c[1], mean.c[2]) / kLumaStep + 0.5f) * kLumaStep;
  const MutableImageView& states = job.next_state;
  const auto state = [&](int i) { return LoadChannel(states.format, states.At(x, y), i); };
  const auto store = [&](float lifetime, float lock_shading, float luma_before) {
    const float values[4] = {lifetime, lock_shading, luma, luma_before};
    for (int i = 0; i < 4; ++i) StoreChannel(states.format, values[i], states.At(x, y), i);
  };
  if (!(validity > 0)) {
    store(is_new ? 1.0f : 0.0f, shading, luma);
    return 0;
  }
  float lifetime = state(0);
  if (is_new) {
    lifetime = lifetime > 0 ? 2.0f : 1.0f;
  } else if (lifetime > 1 && LumaRatio(state(1), shading) < 1 - kLockBreak) {
    lifetime = 0;
  }
  lifetime *= validity;
  const float lock_shading = 0.5f * (state(1) + shading);
  const float lock =
      Saturate(kTrustedLock * Saturate(lifetime - 1)) * LumaRatio(lock_shading, shading);
  const float change = luma - state(2), change_before = luma - state(3);
  const bool alternates = change * change_before > 0 && std::abs(change) >= kLumaStep &&
                          std::abs(change_before) < std::abs(change);
  const float spread =
      Saturate(LumaOf(deviation.c[0], deviation.c[1], deviation.c[2]) / kUnstableDeviation);
  const float cube = spread * spread * spread;
  const float unstable = alternates ? cube * cube : 0.0f;
  store(std::max(lifetime - LockDecay(job), 0.0f), lock_shading, state(2));
  return std::max(lock, unstable);
}

Rgb BlendFsr2(const SrJob& job, int x, int y, float shading, const Predicted& predicted,
              const Neighbourhood& n) {
  const Parameters& parameters = job.options.parameters;
  const Rgb mean = n.Mean(), deviation = n.Deviation();
  const float held = KeptHistory(job, x, y, predicted.validity, shading, mean, deviation);
  if (!(predicted.validity > 0)) return predicted.color;
  const float length = MotionLength(job, x, y);
  const bool counts = n.weight > kLeastWeight;
  const float weight = counts ? n.weight * parameters.fsr2_weight : 0.0f;
  const float t = std::max(1 - predicted.validity, Saturate(length / kBoxMotion));
  const float half = parameters.fsr2_box + t * (1 - parameters.fsr2_box);
  Rgb low, high;
  bool leaves = false;
  for (int c = 0; c < 3; ++c) {
    low.c[c] = std::max(n.low.c[c], mean.c[c] - half * deviation.c[c]);
    high.c[c] = std::min(n.high.c[c], mean.c[c] + half * deviation.c[c]);
    leaves = leaves || low.c[c] - predicted.color.c[c] > kRangeSlack ||
             predicted.color.c[c] - high.c[c] > kRangeSlack;
  }
  const float kept = leaves ? held : 1.0f;
  const float base = HistoryWeight(predicted.validity, weight, length);
  const float limited = std::min(base, kLimitedWeight);
  const float history_weight = limited + kept * (base - limited);
  const float share = counts ? weight / (history_weight + weight) : 0.0f;
  Rgb q;
  for (int c = 0; c < 3; ++c) {
    const float inside = std::min(std::max(predicted.color.c[c], low.c[c]), high.c[c]);
    const float h = inside + kept * (predicted.color.c[c] - inside);
    const float s = counts ? std::clamp(n.color.c[c] / n.weight, n.low.c[c], n.high.c[c]) : h;
    q.c[c] = h + share * (s - h);
  }
  return q;
}

void UpdateFsr2Reference(const SrJob& job, int begin, int end, SrScratch& scratch,
                         const MutableImageView& out) {
  float* sums = scratch.render_rows.Row(0);
  float* shading = scratch.render_rows.Row(1);
  const float narrowing = KernelBias(job) * KernelBias(job);
  const auto weigh = [&](int x, int y) {
    const float curve = BoxCurve(MotionLength(job, x, y));
    return [=](int, int, float dx, float dy) {
      const float square = dx * dx + dy * dy;
      return SampleWeights{Fsr2Kernel(square * narrowing), std::exp(curve * square)};
    };
  };
  const auto blend = [&](int x, int y, const Predicted& predicted, const Neighbourhood& n) {
    if (x == 0) FillShadingRow(job, job.y.nearest()[y], sums, shading);
    return BlendFsr2(job, x, y, shading[job.x.nearest()[x]], predicted, n);
  };
  UpdateRowsReference(job, begin, end, out, weigh, blend);
}

void LimitFsr2Reference(const SrJob& job, int begin, int end, SrScratch& scratch) {
  const MotionView motion = Band{begin, end}.Motion(scratch.motion);
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < job.x.output(); ++x) {
      if (scratch.validity.Row(y - begin)[x] >= 1) LimitToTexels(job, motion, x, y);
    }
  }
}

const SrPeerPasses& ReferenceFsr2() {
  static constexpr SrPeerPasses kPasses = {UpdateFsr2Reference, LimitFsr2Reference};
  return kPasses;
}

}  // namespace
}  // namespace warplut::peers
#endif  // WARPLUT_RUNTIME_PEERS_FSR2_ONCE

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

const SrPeerPasses& Fsr2OfTarget() {
#if HWY_TARGET == HWY_SCALAR
  return ReferenceFsr2();  // without vectors the formulas are the kernels
#else
  static constexpr SrPeerPasses kPasses = {UpdateFsr2, LimitFsr2};
  return kPasses;
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {
namespace peers {

HWY_EXPORT(Fsr2OfTarget);

static const SrPeerPasses& FastFsr2() { return HWY_DYNAMIC_DISPATCH(Fsr2OfTarget)(); }

}  // namespace peers

const SrPeer kFsr2 = {Filter::kCatmullRom, true, peers::ReferenceFsr2, peers::FastFsr2};

}  // namespace warplut
#endif  // HWY_ONCE
