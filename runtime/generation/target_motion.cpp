#include "runtime/generation/target_motion.h"

namespace warplut::generation {
namespace {

// How far the search for background goes, in pixels along each of the 8 directions.
constexpr int kBackgroundReach = 64;

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

  // The motion of the farthest of the first arrivals in 8 directions; zero if there are none.
  TargetMotion Background(int x, int y) const {
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
    return farthest == kNoSplat ? TargetMotion{} : Arrived(farthest);
  }

  TargetMotion Disocclusion(int x, int y) const {
    if (job.Interpolates() || FillOf(job.options) == DisocclusionFill::kBackground) {
      return Background(x, y);
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
