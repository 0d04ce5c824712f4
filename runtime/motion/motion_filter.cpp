#include "runtime/motion_filter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "runtime/core/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/motion/motion_filter.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/core/band.h"
#include "runtime/core/warp_simd-inl.h"
#include "runtime/float_environment.h"
#include "runtime/gates.h"
#include "runtime/motion/motion_filter_pass.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

// The vectors of pixels [x, x + Lanes); see camera_motion.h for the formula.
HWY_INLINE void FilterVector(const MotionFilterPass& pass, float v, int x, const float* depth,
                             const float* motion, float* out) {
  const FloatTag d;
  const auto& c = pass.c;
  const auto set = [&](float value) HWY_ATTR { return hn::Set(d, value); };
  const auto z = hn::LoadU(d, depth);
  Floats mx, my;
  hn::LoadInterleaved2(d, motion, mx, my);

  const auto known = hn::And(hn::Ge(z, hn::Zero(d)), hn::Lt(z, set(kFarthestDepth)));
  const auto g = hn::IfThenElseZero(known, hn::Div(set(1), hn::Max(z, set(kLeastDepth))));
  const auto u = hn::MulAdd(PixelNumbers(x), set(pass.unit), set(pass.first_u));
  const auto h = hn::MulAdd(set(c[8]), u, hn::MulAdd(set(c[10]), g, set(c[9] * v)));
  const auto scale = hn::Div(set(1 / pass.unit), hn::Add(h, set(1)));
  const auto camera = [&](int first, Floats position) HWY_ATTR {
    auto sum = hn::MulAdd(set(c[first + 3]), g, set(c[first + 1] * v + c[first + 2]));
    sum = hn::MulAdd(set(c[first]), u, sum);
    return hn::Mul(hn::MulAdd(position, h, sum), scale);
  };
  const auto cx = camera(0, u);
  const auto cy = camera(4, set(v));
  const auto still = hn::And(hn::Le(hn::Abs(hn::Sub(cx, mx)), set(pass.limit_x)),
                             hn::Le(hn::Abs(hn::Sub(cy, my)), set(pass.limit_y)));
  hn::StoreInterleaved2(hn::IfThenElse(still, cx, mx), hn::IfThenElse(still, cy, my), d, out);
}

void FilterRow(const MotionFilterPass& pass, int y) {
  const int width = pass.motion.width;
  const float v = (static_cast<float>(y) * pass.unit) + pass.first_v;
  const float* depth = pass.depth.Row<float>(y);
  const float* motion = pass.motion.Row(y);
  float* out = pass.out.Row(y);
  int x = 0;
  for (; x + kLanes <= width; x += kLanes) {
    FilterVector(pass, v, x, depth + x, motion + 2 * x, out + 2 * x);
  }
  if (x >= width) return;
  float tail_depth[kLanes] = {};
  float tail[2 * kLanes] = {};
  std::memcpy(tail_depth, depth + x, sizeof(float) * static_cast<std::size_t>(width - x));
  std::memcpy(tail, motion + 2 * x, 2 * sizeof(float) * static_cast<std::size_t>(width - x));
  FilterVector(pass, v, x, tail_depth, tail, tail);
  std::memcpy(out + 2 * x, tail, 2 * sizeof(float) * static_cast<std::size_t>(width - x));
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {

HWY_EXPORT(FilterRow);

namespace {

float Limit(const MotionFilterOptions& options, double noise) {
  return static_cast<float>(std::min<double>(options.limit, kNoiseToLimit * noise));
}

}  // namespace

bool MotionFilterOptions::IsValid(std::string* why) const {
  if (limit > 0 && limit <= 16) return true;
  if (why != nullptr) {
    char sentence[80];
    std::snprintf(sentence, sizeof(sentence), "limit is %g; expected more than 0, up to 16.",
                  static_cast<double>(limit));
    *why = sentence;
  }
  return false;
}

MotionFilter::MotionFilter(int width, int height, const MotionFilterOptions& options)
    : options_(options), fit_(width, height) {}

void MotionFilter::Apply(const ImageView& depth, const MotionView& motion, Executor& executor,
                         const MutableMotionView& out) {
  const FloatEnvironment environment;
  const CameraMotion camera = fit_.Fit(depth, motion);
  const int height = motion.height;
  MotionFilterPass pass = {.depth = depth, .motion = motion, .out = out};
  for (std::size_t i = 0; i < camera.c.size(); ++i) pass.c[i] = static_cast<float>(camera.c[i]);
  pass.unit = 2.0f / static_cast<float>(motion.width);
  pass.first_u = pass.unit / 2 - 1;
  pass.first_v = static_cast<float>((1.0 - height) / motion.width);
  pass.limit_x = Limit(options_, camera.noise_x);
  pass.limit_y = Limit(options_, camera.noise_y);
  executor.ForEach(TileCount(height, kBandRows), [&](int band) {
    const int end = std::min(height, (band + 1) * kBandRows);
    for (int y = band * kBandRows; y < end; ++y) HWY_DYNAMIC_DISPATCH(FilterRow)(pass, y);
  });
}

void MotionFilter::Reference(const ImageView& depth, const MotionView& motion,
                             const MotionFilterOptions& options, const MutableMotionView& out) {
  const FloatEnvironment environment;
  const CameraMotion camera = CameraFit(motion.width, motion.height).Fit(depth, motion);
  const float limit_x = Limit(options, camera.noise_x);
  const float limit_y = Limit(options, camera.noise_y);
  for (int y = 0; y < motion.height; ++y) {
    for (int x = 0; x < motion.width; ++x) {
      const float mx = motion.Row(y)[2 * x];
      const float my = motion.Row(y)[2 * x + 1];
      const float g = InverseDepth(depth.Row<float>(y)[x]);
      const auto [cx, cy] = camera.At(x, y, g, motion.width, motion.height);
      const bool still = std::abs(cx - mx) <= limit_x && std::abs(cy - my) <= limit_y;
      out.Row(y)[2 * x] = still ? static_cast<float>(cx) : mx;
      out.Row(y)[2 * x + 1] = still ? static_cast<float>(cy) : my;
    }
  }
}

}  // namespace warplut
#endif  // HWY_ONCE
