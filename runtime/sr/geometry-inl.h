// Motion, depth and validity of output rows, per target.
#if defined(WARPLUT_RUNTIME_SR_GEOMETRY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_SR_GEOMETRY_INL_H_
#undef WARPLUT_RUNTIME_SR_GEOMETRY_INL_H_
#else
#define WARPLUT_RUNTIME_SR_GEOMETRY_INL_H_
#endif

#include "runtime/core/gates-inl.h"
#include "runtime/core/pixels-inl.h"
#include "runtime/sr/passes.h"
#include "runtime/sr/reference.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

// NearestSurface for a row of samples.
HWY_INLINE void NearestSurfaces(const RenderPlanes& planes, int j, float* HWY_RESTRICT depth,
                                float* HWY_RESTRICT motion_x, float* HWY_RESTRICT motion_y) {
  const FloatTag d;
  const int width = planes.depth.width();
  for (int i = 0; i < width; i += kLanes) {
    auto z = hn::Load(d, planes.depth.Row(j) + i);
    auto mx = hn::Load(d, planes.motion_x.Row(j) + i);
    auto my = hn::Load(d, planes.motion_y.Row(j) + i);
    for (int y = j - 1; y <= j + 1; ++y) {
      for (int x = i - 1; x <= i + 1; ++x) {
        const auto other = hn::LoadU(d, planes.depth.Row(y) + x);
        const auto nearer = hn::Lt(other, z);
        z = hn::IfThenElse(nearer, other, z);
        mx = hn::IfThenElse(nearer, hn::LoadU(d, planes.motion_x.Row(y) + x), mx);
        my = hn::IfThenElse(nearer, hn::LoadU(d, planes.motion_y.Row(y) + x), my);
      }
    }
    hn::Store(z, d, depth + i);
    hn::Store(mx, d, motion_x + i);
    hn::Store(my, d, motion_y + i);
  }
}

// IsSurfaceEdge for a row of cells, as 1 or 0.
HWY_INLINE void SurfaceEdges(const RenderPlanes& planes, int j, float* HWY_RESTRICT edge) {
  const FloatTag d;
  const int width = planes.depth.width();
  const auto one = hn::Set(d, 1.0f);
  for (int i = 0; i < width; i += kLanes) {
    auto nearest = hn::Load(d, planes.depth.Row(j) + i);
    auto farthest = nearest;
    auto motion = hn::Zero(d);  // all bits set where one is NaN
    for (int y = j; y <= j + 1; ++y) {
      for (int x = i; x <= i + 1; ++x) {
        const auto z = hn::LoadU(d, planes.depth.Row(y) + x);
        nearest = hn::Min(nearest, z);
        farthest = hn::Max(farthest, z);
        const auto m = hn::LoadU(d, planes.motion_x.Row(y) + x);
        motion = hn::Or(motion, hn::VecFromMask(d, hn::IsNaN(m)));
      }
    }
    const auto lesser = hn::Max(nearest, hn::Set(d, 1e-12f));
    const auto step = hn::Div(hn::Sub(farthest, nearest), lesser);
    const auto split = hn::Gt(step, hn::Set(d, kSurfaceStep));
    const auto any = hn::Or(hn::IfThenElseZero(split, one), hn::And(motion, one));
    hn::Store(any, d, edge + i);
  }
}

// The rows on the render grid that an output row is made of; rows that stay from one output row to
// the next are kept.
class GeometryRowMaker {
 public:
  HWY_INLINE GeometryRowMaker(const SrJob& job, Plane& rows) : job_(job), rows_(rows) {}

  // Motion (output pixels) and depth of output row y; both are written in whole vectors.
  HWY_INLINE void Make(int y, float* HWY_RESTRICT depth, float* HWY_RESTRICT motion_x,
                       float* HWY_RESTRICT motion_y) {
    const RenderPlanes& planes = job_.planes;
    const int j = job_.y.nearest()[y];
    switch (MotionOf(job_.options)) {
      case MotionUpsampling::kNearest:
        TakeNearest(planes.depth.Row(j), planes.motion_x.Row(j), planes.motion_y.Row(j), depth,
                    motion_x, motion_y);
        break;
      case MotionUpsampling::kDilated:
        FindNearest(j);
        TakeNearest(rows_.Row(0), rows_.Row(1), rows_.Row(2), depth, motion_x, motion_y);
        break;
      case MotionUpsampling::kEdgeAware:
        FindNearest(j);
        TakeEdgeAware(y, depth, motion_x, motion_y);
        break;
      case MotionUpsampling::kStatic:
        StandStill(depth, motion_x, motion_y);
        break;
    }
  }

  static constexpr int kRows = 7;  // on the render grid that Make uses

 private:
  HWY_INLINE void FindNearest(int j) {
    if (j == nearest_) return;
    nearest_ = j;
    NearestSurfaces(job_.planes, j, rows_.Row(0), rows_.Row(1), rows_.Row(2));
  }

  HWY_INLINE void TakeNearest(const float* z, const float* mx, const float* my, float* depth,
                              float* motion_x, float* motion_y) {
    const FloatTag d;
    const auto scale_x = hn::Set(d, job_.x.scale());
    const auto scale_y = hn::Set(d, job_.y.scale());
    for (int x = 0; x < job_.x.output(); x += kLanes) {
      const Columns nearest(job_.x.nearest(), x);
      hn::Store(nearest.At(z), d, depth + x);
      hn::Store(hn::Mul(nearest.At(mx), scale_x), d, motion_x + x);
      hn::Store(hn::Mul(nearest.At(my), scale_y), d, motion_y + x);
    }
  }

  HWY_INLINE void StandStill(float* depth, float* motion_x, float* motion_y) {
    std::fill_n(depth, job_.x.output(), kFarthestDepth);
    std::fill_n(motion_x, job_.x.output(), 0.0f);
    std::fill_n(motion_y, job_.x.output(), 0.0f);
  }

  HWY_INLINE void TakeEdgeAware(int y, float* depth, float* motion_x, float* motion_y) {
    const FloatTag d;
    const RenderPlanes& planes = job_.planes;
    const int j = job_.y.cell()[y];
    if (j != cell_) {
      cell_ = j;
      SurfaceEdges(planes, j, rows_.Row(3));
    }
    const float share = job_.y.fraction()[y];
    const int width = planes.depth.width();
    MixRows(planes.depth.Row(j), planes.depth.Row(j + 1), share, width, rows_.Row(4));
    MixRows(planes.motion_x.Row(j), planes.motion_x.Row(j + 1), share, width, rows_.Row(5));
    MixRows(planes.motion_y.Row(j), planes.motion_y.Row(j + 1), share, width, rows_.Row(6));
    const auto scale_x = hn::Set(d, job_.x.scale());
    const auto scale_y = hn::Set(d, job_.y.scale());
    for (int x = 0; x < job_.x.output(); x += kLanes) {
      const Columns cell(job_.x.cell(), x);
      const auto t = hn::LoadU(d, job_.x.fraction() + x);
      auto z = cell.Mixed(rows_.Row(4), t);
      auto mx = cell.Mixed(rows_.Row(5), t);
      auto my = cell.Mixed(rows_.Row(6), t);
      const auto edge = hn::Gt(cell.At(rows_.Row(3)), hn::Zero(d));
      if (HWY_UNLIKELY(!hn::AllFalse(d, edge))) {
        const Columns nearest(job_.x.nearest(), x);
        z = hn::IfThenElse(edge, nearest.At(rows_.Row(0)), z);
        mx = hn::IfThenElse(edge, nearest.At(rows_.Row(1)), mx);
        my = hn::IfThenElse(edge, nearest.At(rows_.Row(2)), my);
      }
      hn::Store(z, d, depth + x);
      hn::Store(hn::Mul(mx, scale_x), d, motion_x + x);
      hn::Store(hn::Mul(my, scale_y), d, motion_y + x);
    }
  }

  const SrJob& job_;
  Plane& rows_;  // nearest surface: depth, motion x, y; edges; mixed depth, motion x, y
  int nearest_ = -1;
  int cell_ = -1;
};

HWY_INLINE Ints CellBefore(Floats p, const AxisBefore& axis) {
  const FloatTag d;
  const auto u = hn::Sub(hn::Sub(hn::Mul(p, hn::Set(d, axis.inverse_scale)), hn::Set(d, 0.5f)),
                         hn::Set(d, axis.jitter));
  const auto last = hn::Set(d, static_cast<float>(axis.render - 1));
  return hn::ConvertTo(IntTag(), hn::Min(hn::Max(u, hn::Zero(d)), last));
}

// ValidityReference for a row.
HWY_INLINE void ValidityRow(const SrJob& job, int y, const float* HWY_RESTRICT depth,
                            const float* HWY_RESTRICT motion_x, const float* HWY_RESTRICT motion_y,
                            float* HWY_RESTRICT validity) {
  const FloatTag d;
  const IntTag di;
  const auto width = hn::Set(d, static_cast<float>(job.x.output()));
  const auto height = hn::Set(d, static_cast<float>(job.y.output()));
  const auto zero = hn::Zero(d);
  const auto row = hn::Set(d, static_cast<float>(y) + 0.5f);
  const auto stride = hn::Set(di, job.nearest_before.stride());
  const SuperResolutionOptions& options = job.options;
  const DepthMeasure measure = DepthOf(options);
  for (int x = 0; x < job.x.output(); x += kLanes) {
    const auto column = hn::Add(PixelNumbers(x), hn::Set(d, 0.5f));
    const auto px = hn::Sub(column, hn::Load(d, motion_x + x));
    const auto py = hn::Sub(row, hn::Load(d, motion_y + x));
    const auto inside = hn::And(hn::And(hn::Ge(px, zero), hn::Le(px, width)),
                                hn::And(hn::Ge(py, zero), hn::Le(py, height)));
    auto valid = hn::Set(d, 1.0f);
    if (measure != DepthMeasure::kNone) {
      const auto i = CellBefore(hn::IfThenElseZero(inside, px), job.x_before);
      const auto j = CellBefore(hn::IfThenElseZero(inside, py), job.y_before);
      const auto index = hn::Add(hn::Mul(j, stride), i);
      const auto nearest = hn::GatherIndex(d, job.nearest_before.Row(0), index);
      const auto farthest = hn::GatherIndex(d, job.farthest_before.Row(0), index);
      const auto z = hn::Load(d, depth + x);
      const auto before = hn::Min(hn::Max(z, nearest), farthest);
      const auto farther = DepthDifferences(measure, z, before);
      valid = Gates(RejectsBothWays(measure) ? hn::Abs(farther) : farther,
                    options.parameters.sr_depth_threshold, options.gate_width);
    }
    hn::Store(hn::IfThenElseZero(inside, valid), d, validity + x);
  }
}

// Multiplies the validity of a row by 1 - ReactiveReference.
HWY_INLINE void ApplyReactive(const SrJob& job, int y, const float* HWY_RESTRICT motion_x,
                              const float* HWY_RESTRICT motion_y, float* HWY_RESTRICT validity) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const auto row = hn::Set(d, static_cast<float>(y) + 0.5f);
  const auto stride = hn::Set(IntTag(), job.reactive_before.stride());
  const float* upper = job.planes.reactive.Row(job.y.cell()[y]);
  const float* lower = job.planes.reactive.Row(job.y.cell()[y] + 1);
  for (int x = 0; x < job.x.output(); x += kLanes) {
    const auto valid = hn::Load(d, validity + x);
    const auto column = hn::Add(PixelNumbers(x), hn::Set(d, 0.5f));
    const auto some = hn::Gt(valid, zero);  // elsewhere the motion may be no number
    const auto px = hn::IfThenElseZero(some, hn::Sub(column, hn::Load(d, motion_x + x)));
    const auto py = hn::IfThenElseZero(some, hn::Sub(row, hn::Load(d, motion_y + x)));
    const auto index =
        hn::Add(hn::Mul(CellBefore(py, job.y_before), stride), CellBefore(px, job.x_before));
    const auto before = hn::GatherIndex(d, job.reactive_before.Row(0), index);
    const Columns cell(job.x.cell(), x);
    const auto above = hn::Max(cell.At(upper), cell.Next(upper));
    const auto below = hn::Max(cell.At(lower), cell.Next(lower));
    const auto reactive = hn::Max(hn::Max(above, below), before);
    hn::Store(hn::NegMulAdd(valid, reactive, valid), d, validity + x);
  }
}

inline void ReactiveReach(const Plane& reactive, int begin, int end, Plane& reach) {
  const FloatTag d;
  for (int j = begin; j < end; ++j) {
    for (int i = 0; i < reactive.width(); i += kLanes) {
      auto greatest = hn::Zero(d);
      for (int y = j - 1; y <= j + 2; ++y) {
        for (int x = i - 1; x <= i + 2; ++x) {
          greatest = hn::Max(greatest, hn::LoadU(d, reactive.Row(y) + x));
        }
      }
      hn::Store(greatest, d, reach.Row(j) + i);
    }
  }
}

// (x, y) of `count` pixels, interleaved.
HWY_INLINE void StoreMotion(const float* HWY_RESTRICT motion_x, const float* HWY_RESTRICT motion_y,
                            int count, float* HWY_RESTRICT to) {
  const FloatTag d;
  int x = 0;
  for (; x + kLanes <= count; x += kLanes) {
    hn::StoreInterleaved2(hn::Load(d, motion_x + x), hn::Load(d, motion_y + x), d, to + 2 * x);
  }
  for (; x < count; ++x) {
    to[2 * x] = motion_x[x];
    to[2 * x + 1] = motion_y[x];
  }
}

inline void DepthRange(const Plane& depth, int begin, int end, Plane& nearest, Plane& farthest) {
  const FloatTag d;
  for (int j = begin; j < end; ++j) {
    float* low = nearest.Row(j);
    float* high = farthest.Row(j);
    for (int i = 0; i < depth.width(); i += kLanes) {
      auto least = hn::Load(d, depth.Row(j) + i);
      auto greatest = least;
      for (int y = j - 1; y <= j + 2; ++y) {
        for (int x = i - 1; x <= i + 2; ++x) {
          const auto z = hn::LoadU(d, depth.Row(y) + x);
          least = hn::Min(least, z);
          greatest = hn::Max(greatest, z);
        }
      }
      hn::Store(least, d, low + i);
      hn::Store(greatest, d, high + i);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
