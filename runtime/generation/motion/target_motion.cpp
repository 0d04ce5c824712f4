#include "runtime/generation/motion/target_motion.h"

#include "runtime/generation/motion/motion_model.h"
#include "runtime/generation/motion/surface_before.h"

namespace warplut::generation {
namespace {

// Steps of `direction` from p that stay in [0, size).
int Reach(int p, int direction, int size) {
  return direction < 0 ? p : direction > 0 ? size - 1 - p : kBackgroundReach;
}

struct Finder {
  const GenerationJob& job;
  const Arrivals& arrivals;
  DepthTolerance tolerance;

  TargetMotion Arrived(SplatKey key) const {
    const auto width = static_cast<std::uint32_t>(job.width());
    const int x = static_cast<int>(SplatSource(key) % width);
    const int y = static_cast<int>(SplatSource(key) / width);
    const Vector from1 = MotionAt(arrivals.forward, x, y);
    return {from1 + MotionAt(job.motion1, x, y), from1};
  }

  // The mean motion of the foreground around a gap; false if (x, y) is none.
  bool Gap(int x, int y, TargetMotion* motion) const {
    SplatKey keys[3][3];
    float depth[3][3];
    bool alike[3][3];
    const float center = SplatDepth(arrivals.keys.Row(y)[x]);
    float nearest = center;
    for (int j = 0; j < 3; ++j) {
      const SplatKey* row = arrivals.keys.Row(std::clamp(y + j - 1, 0, job.height() - 1));
      for (int i = 0; i < 3; ++i) {
        keys[j][i] = row[std::clamp(x + i - 1, 0, job.width() - 1)];
        depth[j][i] = SplatDepth(keys[j][i]);
        alike[j][i] = tolerance.Alike(center, depth[j][i]);
        nearest = std::min(nearest, depth[j][i]);
      }
    }
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        if (alike[j][i] && alike[j][i + 1] && alike[j + 1][i] && alike[j + 1][i + 1]) return false;
      }
    }
    if (tolerance.Alike(center, nearest)) return false;
    TargetMotion sum;
    float count = 0;
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        if (keys[j][i] == kNoSplat || !job.Contains(x + i - 1, y + j - 1) ||
            !tolerance.Alike(depth[j][i], nearest)) {
          continue;
        }
        const TargetMotion neighbour = Arrived(keys[j][i]);
        sum = {sum.from0 + neighbour.from0, sum.from1 + neighbour.from1};
        count += 1;
      }
    }
    const float share = 1.0f / count;
    *motion = {share * sum.from0, share * sum.from1};
    return true;
  }

  // The farthest of the first arrivals in 8 directions; kNoSplat if there are none.
  SplatKey Background(int x, int y) const {
    constexpr int kDirections[8][2] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                       {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
    const SplatKey* const center = arrivals.keys.Row(y) + x;
    SplatKey farthest = kNoSplat;
    for (const auto& [dx, dy] : kDirections) {
      const std::ptrdiff_t stride = std::ptrdiff_t{dy} * job.width() + dx;
      const int reach =
          std::min({kBackgroundReach, Reach(x, dx, job.width()), Reach(y, dy, job.height())});
      for (int step = 1; step <= reach; ++step) {
        const SplatKey key = center[step * stride];
        if (key == kNoSplat) continue;
        if (farthest == kNoSplat || SplatDepth(key) > SplatDepth(farthest)) farthest = key;
        break;
      }
    }
    return farthest;
  }

  // A pixel of frame 0 that goes on as it moved: steadily in homogeneous coordinates, `loss` being
  // the depth that it loses from frame to frame. From frame 0 to the generated frame, and to frame
  // 1.
  struct Steady {
    Vector to_generated, to_frame1;
  };
  Steady GoOn(Vector m0, float z0, float loss) const {
    const float before = z0 + loss;
    return {job.alpha * (before / (z0 - job.alpha * loss)) * m0, (before / (z0 - loss)) * m0};
  }

  // What frame 0 shows of the disocclusion at (x, y), by the motion of frame 0 itself: p0 with
  // p0 + GoOn(p0) = (x, y), by fixed-point steps from the motion of the background that arrived.
  // Loss of depth and acceleration are those of the background.
  bool FoundInFrame0(int x, int y, SplatKey background, TargetMotion* motion) const {
    const auto width = static_cast<std::uint32_t>(job.width());
    const int bx = static_cast<int>(SplatSource(background) % width);
    const int by = static_cast<int>(SplatSource(background) / width);
    const Vector m1 = MotionAt(job.motion1, bx, by);
    const SurfaceBefore before = FindSurfaceBefore(job, bx, by, m1);
    if (!(before.gate > 0.0f)) return false;
    const float depth1 = NotZero(DepthAt(job.depth1, bx, by));
    const float loss = depth1 * (before.ratio - 1.0f);
    // All depths that are divided by are more than half of the depth of frame 0.
    if (!(depth1 * before.ratio > 2.0f * std::abs(loss))) return false;
    const TargetMotion arrived = Arrived(background);
    const Steady steady = GoOn(before.motion, depth1 * before.ratio, loss);
    const Vector bend0 = arrived.from0 - steady.to_generated;
    const Vector bend1 = m1 - steady.to_frame1;
    Vector from0 = arrived.from0, whole = m1;
    float off = 0;
    for (int step = 0; step < kSearchSteps; ++step) {
      const PixelIndex p0 = NearestPixel(job, x, y, {-from0.x, -from0.y});
      if (p0.x < 0) return false;
      const Vector m0 = MotionAt(job.motion0, p0.x, p0.y);
      const float z0 = NotZero(DepthAt(job.depth0, p0.x, p0.y));
      if (!IsFinite(m0) || !(z0 > 2.0f * std::abs(loss))) return false;
      const Steady here = GoOn(m0, z0, loss);
      const Vector next = here.to_generated + bend0;
      off = std::max(std::abs(next.x - from0.x), std::abs(next.y - from0.y));
      from0 = next;
      whole = here.to_frame1 + bend1;
    }
    if (!(off <= kSearchClosure)) return false;
    *motion = {from0, from0 - whole};
    return true;
  }

  TargetMotion Disocclusion(int x, int y) const {
    if (job.Interpolates() || FillOf(job.options) == DisocclusionFill::kBackground) {
      const SplatKey background = Background(x, y);
      if (background == kNoSplat) return {};
      TargetMotion motion;
      const bool found = job.Interpolates() && job.FollowsPerspective() &&
                         FoundInFrame0(x, y, background, &motion);
      return found ? motion : Arrived(background);
    }
    const Vector own = MotionAt(arrivals.forward, x, y);
    const bool moves = FillOf(job.options) == DisocclusionFill::kOwnMotion && IsFinite(own);
    return {{}, moves ? own : Vector{}};
  }
};

}  // namespace

TargetMotion TargetMotionAt(const GenerationJob& job, const Arrivals& arrivals, int x, int y) {
  const Finder finder{job, arrivals, DepthTolerance(job)};
  TargetMotion motion;
  if (Refines(job.options) && finder.Gap(x, y, &motion)) return motion;
  const SplatKey key = arrivals.keys.Row(y)[x];
  if (key != kNoSplat) return finder.Arrived(key);
  motion = finder.Disocclusion(x, y);
  motion.filled = true;
  return motion;
}

}  // namespace warplut::generation
