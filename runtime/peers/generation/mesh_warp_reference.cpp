#include <algorithm>
#include <limits>

#include "runtime/peers/generation/mesh_warp.h"

namespace warplut::peers {
namespace {

// The motion of a stretched triangle's pixel, whose farthest corner has the displacement `farthest`
// and lay at the pixel minus `away`. Frame 0 shows the ground there, or frame 1 the ground mirrored
// at the corner.
TargetMotion StretchedMotion(const GenerationJob& job, int x, int y, Vector farthest, Vector away) {
  const Vector from0 = BackwardShare(job.alpha) * farthest;
  if (job.Interpolates() && NearestPixel(job, x, y, {-from0.x, -from0.y}).x >= 0) {
    return {from0, {kOutside, kOutside}, true};
  }
  return {{kOutside, kOutside}, 2.0f * away - farthest, true};
}

}  // namespace

RowRange MeshForwardRow(const GenerationJob& job, int y, const MutableMotionView& forward) {
  const float share = job.Interpolates() ? job.alpha - 1 : job.alpha;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  float first = static_cast<float>(job.height()), last = -1;
  const auto reach = [&](float row, float displacement) {
    first = std::min(first, row + displacement);
    last = std::max(last, row + displacement);
  };
  const int below = std::min(y + 1, job.height() - 1);
  for (int x = 0; x < job.width(); ++x) {
    const Vector m = MotionAt(job.motion1, x, y);
    const bool moves = IsFinite(m);
    SetMotion(forward, x, y, moves ? share * m : Vector{kNan, kNan});
    const Vector next = MotionAt(job.motion1, x, below);
    if (moves) reach(static_cast<float>(y), share * m.y);
    if (IsFinite(next)) reach(static_cast<float>(below), share * next.y);
  }
  const auto limited = [&](float row) {
    return static_cast<int>(std::clamp(row, 0.0f, static_cast<float>(job.height())));
  };
  return {limited(std::floor(first)), limited(std::ceil(last) + 1)};
}

void DrawQuad(const GenerationJob& job, const MotionView& forward, const DepthTolerance& tolerance,
              int x, int y, RowRange target, const KeyView& keys) {
  Vector at[2][2];
  float depth[2][2];
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const Vector place{static_cast<float>(x + i), static_cast<float>(y + j)};
      at[j][i] = place + MotionAt(forward, x + i, y + j);
      depth[j][i] = DepthAt(job.depth1, x + i, y + j);
      if (!IsFinite(at[j][i])) return;
    }
  }
  const auto [left, right] = std::minmax({at[0][0].x, at[0][1].x, at[1][0].x, at[1][1].x});
  const auto [top, bottom] = std::minmax({at[0][0].y, at[0][1].y, at[1][0].y, at[1][1].y});
  const auto [near, far] = std::minmax({depth[0][0], depth[0][1], depth[1][0], depth[1][1]});
  if (right - left > kLongestSheet || bottom - top > kLongestSheet) return;
  const bool is_wide = std::max(right - left, bottom - top) > kLeastStretch;
  const SplatKey stretched = is_wide && !tolerance.Alike(near, far) ? kStretched : 0;
  const auto limited = [](float v, int low, int high) {
    return static_cast<int>(std::clamp(v, static_cast<float>(low), static_cast<float>(high)));
  };
  const int last_y = limited(std::floor(bottom), target.first - 1, target.last - 1);
  const int last_x = limited(std::floor(right), -1, job.width() - 1);
  for (int qy = limited(std::ceil(top), target.first, target.last); qy <= last_y; ++qy) {
    for (int qx = limited(std::ceil(left), 0, job.width()); qx <= last_x; ++qx) {
      const Vector q{static_cast<float>(qx), static_cast<float>(qy)};
      for (const bool lower : {false, true}) {
        const auto [a, b, c] = CornersOf(lower);
        const Triangle triangle{at[a.y][a.x] - q, at[b.y][b.x] - q, at[c.y][c.x] - q};
        const Triangle::Weights w = triangle.At();
        if (!w.inside) continue;
        const float sum = w.a * depth[a.y][a.x] + w.b * depth[b.y][b.x] + w.c * depth[c.y][c.x];
        const float z = std::clamp(sum / w.area, near, far);
        const auto quad = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(job.width()) +
                          static_cast<std::uint32_t>(x);
        SplatKey& kept = keys.Row(qy)[qx];
        kept = std::min(kept, MakeSplatKey(z + 0.0f, 2 * quad + (lower ? 1 : 0)) | stretched);
      }
    }
  }
}

TargetMotion MeshMotionAt(const GenerationJob& job, const Arrivals& arrivals, int x, int y) {
  const SplatKey key = arrivals.keys.Row(y)[x];
  if (key == kNoSplat) {
    const Vector own = MotionAt(arrivals.forward, x, y);
    if (!IsFinite(own)) return {{}, {}, true};
    return {BackwardShare(job.alpha) * own, own, true};
  }
  const auto width = static_cast<std::uint32_t>(job.width());
  const std::uint32_t quad = SplatSource(key) / 2;
  const int left = static_cast<int>(quad % width), top = static_cast<int>(quad / width);
  const TriangleCorners corners = CornersOf(SplatSource(key) % 2 == 1);
  const PixelIndex a = corners.a, b = corners.b, c = corners.c;
  const auto displacement = [&](PixelIndex corner) {
    return MotionAt(arrivals.forward, left + corner.x, top + corner.y);
  };
  const auto around = [&](PixelIndex corner) {
    const Vector place{static_cast<float>(left + corner.x - x),
                       static_cast<float>(top + corner.y - y)};
    return place + displacement(corner);
  };
  const Triangle::Weights w = Triangle{around(a), around(b), around(c)}.At();
  const auto mean = [&](float Vector::*axis) {
    return (w.a * (displacement(a).*axis) + w.b * (displacement(b).*axis) +
            w.c * (displacement(c).*axis)) /
           w.area;
  };
  const Vector from1{mean(&Vector::x), mean(&Vector::y)};
  if (key >= kStretched) {
    const auto depth = [&](PixelIndex corner) {
      return DepthAt(job.depth1, left + corner.x, top + corner.y);
    };
    PixelIndex farthest = a;
    for (const PixelIndex corner : {b, c}) {
      if (depth(corner) > depth(farthest)) farthest = corner;
    }
    if (FillOf(job.options) != DisocclusionFill::kBackground) {
      return {{kOutside, kOutside}, from1, true};
    }
    const Vector away{static_cast<float>(x - left - farthest.x),
                      static_cast<float>(y - top - farthest.y)};
    return StretchedMotion(job, x, y, displacement(farthest), away);
  }
  const bool shown = NearestPixel(job, x, y, {-from1.x, -from1.y}).x >= 0;
  const Vector from0 = BackwardShare(job.alpha) * from1;
  return {shown ? Vector{kOutside, kOutside} : from0, from1};
}

}  // namespace warplut::peers
