#include <algorithm>
#include <cmath>

#include "runtime/sr/reference.h"

namespace warplut {

bool IsSurfaceEdge(const RenderPlanes& planes, int i, int j) {
  float nearest = planes.depth.Row(j)[i];
  float farthest = nearest;
  bool finite = true;
  for (int y = j; y <= j + 1; ++y) {
    for (int x = i; x <= i + 1; ++x) {
      nearest = std::min(nearest, planes.depth.Row(y)[x]);
      farthest = std::max(farthest, planes.depth.Row(y)[x]);
      finite = finite && !std::isnan(planes.motion_x.Row(y)[x]);
    }
  }
  return !finite || DepthDifference(DepthMeasure::kRelative, farthest, nearest) > kSurfaceStep;
}

Surface NearestSurface(const RenderPlanes& planes, int i, int j) {
  Surface surface{planes.depth.Row(j)[i], planes.motion_x.Row(j)[i], planes.motion_y.Row(j)[i]};
  for (int y = j - 1; y <= j + 1; ++y) {
    for (int x = i - 1; x <= i + 1; ++x) {
      if (planes.depth.Row(y)[x] >= surface.depth) continue;
      surface = {planes.depth.Row(y)[x], planes.motion_x.Row(y)[x], planes.motion_y.Row(y)[x]};
    }
  }
  return surface;
}

float BilinearAt(const SrJob& job, const Plane& plane, int x, int y) {
  const int i = job.x.cell()[x];
  const int j = job.y.cell()[y];
  const float fy = job.y.fraction()[y];
  const float* upper = plane.Row(j) + i;
  const float* lower = plane.Row(j + 1) + i;
  const float left = upper[0] + fy * (lower[0] - upper[0]);
  const float right = upper[1] + fy * (lower[1] - upper[1]);
  return left + job.x.fraction()[x] * (right - left);
}

Surface SurfaceAt(const SrJob& job, int x, int y) {
  const RenderPlanes& planes = job.planes;
  const int i = job.x.nearest()[x];
  const int j = job.y.nearest()[y];
  switch (MotionOf(job.options)) {
    case MotionUpsampling::kNearest:
      return {planes.depth.Row(j)[i], planes.motion_x.Row(j)[i], planes.motion_y.Row(j)[i]};
    case MotionUpsampling::kDilated:
      return NearestSurface(planes, i, j);
    case MotionUpsampling::kStatic:
      return {kFarthestDepth, 0, 0};
    case MotionUpsampling::kEdgeAware:
      break;
  }
  if (IsSurfaceEdge(planes, job.x.cell()[x], job.y.cell()[y])) return NearestSurface(planes, i, j);
  return {BilinearAt(job, planes.depth, x, y), BilinearAt(job, planes.motion_x, x, y),
          BilinearAt(job, planes.motion_y, x, y)};
}

void GeometryReference(const SrJob& job, int begin, int end, SrScratch&,
                       const MutableImageView& depth, const MutableMotionView& motion) {
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < job.x.output(); ++x) {
      const Surface surface = SurfaceAt(job, x, y);
      depth.Row<float>(y)[x] = surface.depth;
      motion.Row(y)[2 * x] = surface.motion_x * job.x.scale();
      motion.Row(y)[2 * x + 1] = surface.motion_y * job.y.scale();
    }
  }
}

namespace {

// The sample of the frame before at or before output position p of one axis.
int CellBefore(float p, const AxisBefore& axis) {
  const float u = p * axis.inverse_scale - 0.5f - axis.jitter;
  return static_cast<int>(std::clamp(u, 0.0f, static_cast<float>(axis.render - 1)));
}

}  // namespace

float ValidityReference(const SrJob& job, int x, int y, float depth, float motion_x,
                        float motion_y) {
  const float px = static_cast<float>(x) + 0.5f - motion_x;
  const float py = static_cast<float>(y) + 0.5f - motion_y;
  const bool inside = px >= 0 && px <= static_cast<float>(job.x.output()) && py >= 0 &&
                      py <= static_cast<float>(job.y.output());
  if (!job.HasHistory() || !inside) return 0.0f;
  if (DepthOf(job.options) == DepthMeasure::kNone) return 1.0f;
  const int i = CellBefore(px, job.x_before);
  const int j = CellBefore(py, job.y_before);
  const float before =
      std::clamp(depth, job.nearest_before.Row(j)[i], job.farthest_before.Row(j)[i]);
  const float farther = DepthDifference(DepthOf(job.options), depth, before);
  return Gate(RejectsBothWays(DepthOf(job.options)) ? std::abs(farther) : farther,
              job.options.parameters.sr_depth_threshold, job.options.gate_width);
}

float ReactiveReference(const SrJob& job, int x, int y, float motion_x, float motion_y) {
  const float px = static_cast<float>(x) + 0.5f - motion_x;
  const float py = static_cast<float>(y) + 0.5f - motion_y;
  if (!IsFiniteMotion(px, py)) return 1.0f;
  float reactive =
      job.reactive_before.Row(CellBefore(py, job.y_before))[CellBefore(px, job.x_before)];
  const int i = job.x.cell()[x];
  const int j = job.y.cell()[y];
  for (int v = j; v <= j + 1; ++v) {
    for (int u = i; u <= i + 1; ++u) reactive = std::max(reactive, job.planes.reactive.Row(v)[u]);
  }
  return reactive;
}

void ReactiveReachReference(const Plane& reactive, int begin, int end, Plane& reach) {
  for (int j = begin; j < end; ++j) {
    for (int i = 0; i < reactive.width(); ++i) {
      float greatest = 0;
      for (int y = j - 1; y <= j + 2; ++y) {
        for (int x = i - 1; x <= i + 2; ++x) greatest = std::max(greatest, reactive.Row(y)[x]);
      }
      reach.Row(j)[i] = greatest;
    }
  }
}

void DepthRangeReference(const Plane& depth, int begin, int end, Plane& nearest, Plane& farthest) {
  for (int j = begin; j < end; ++j) {
    for (int i = 0; i < depth.width(); ++i) {
      float least = depth.Row(j)[i];
      float greatest = least;
      for (int y = j - 1; y <= j + 2; ++y) {
        for (int x = i - 1; x <= i + 2; ++x) {
          least = std::min(least, depth.Row(y)[x]);
          greatest = std::max(greatest, depth.Row(y)[x]);
        }
      }
      nearest.Row(j)[i] = least;
      farthest.Row(j)[i] = greatest;
    }
  }
}

}  // namespace warplut
