// Planes of a rendered frame, colour boxes, the current frame and the predicted colour, per target.
#if defined(WARPLUT_RUNTIME_SR_COLOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_SR_COLOR_INL_H_
#undef WARPLUT_RUNTIME_SR_COLOR_INL_H_
#else
#define WARPLUT_RUNTIME_SR_COLOR_INL_H_
#endif

#include "runtime/core/hdr_code-inl.h"
#include "runtime/sr/geometry-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

// Pixels that were loaded from an image of this format.
HWY_INLINE void EncodePixels(ColorEncoding encoding, PixelFormat format, Pixels& p) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0f);
  const auto largest =
      hn::Set(d, format == PixelFormat::kRgba16F ? kLargestHdr : std::numeric_limits<float>::max());
  for (Floats* channel : {&p.r, &p.g, &p.b}) {
    if (encoding == ColorEncoding::kLinearHdr) {
      *channel = HdrCodes(LimitHdrs(*channel));
    } else {
      const auto finite = hn::IfThenElseZero(hn::Le(hn::Abs(*channel), largest), *channel);
      *channel = hn::Min(hn::Max(finite, hn::Zero(d)), one);
    }
  }
}

HWY_INLINE void DecodePixels(ColorEncoding encoding, Pixels& p) {
  if (encoding == ColorEncoding::kDisplay) return;
  for (Floats* channel : {&p.r, &p.g, &p.b}) *channel = HdrValues(*channel);
}

// `count` floats, the others 0.
HWY_INLINE Floats LoadSome(const float* from, int count) {
  const FloatTag d;
  if (count >= kLanes) return hn::LoadU(d, from);
  alignas(64) float whole[kLanes] = {};
  std::memcpy(whole, from, static_cast<std::size_t>(count) * sizeof(float));
  return hn::Load(d, whole);
}

HWY_INLINE void LoadMotion(const float* from, int count, Floats& x, Floats& y) {
  const FloatTag d;
  if (count >= kLanes) {
    hn::LoadInterleaved2(d, from, x, y);
    return;
  }
  alignas(64) float whole[2 * kLanes] = {};
  std::memcpy(whole, from, 2 * static_cast<std::size_t>(count) * sizeof(float));
  hn::LoadInterleaved2(d, whole, x, y);
}

HWY_INLINE void FillColorRow(const SuperResolutionOptions& options, const ImageView& color, int y,
                             RenderPlanes& planes) {
  const FloatTag d;
  for (int x = 0; x < color.width; x += kLanes) {
    Pixels p = LoadPixels(color, x, y, color.width - x);
    EncodePixels(EncodingOf(options), color.format, p);
    hn::Store(p.r, d, planes.color[0].Row(y) + x);
    hn::Store(p.g, d, planes.color[1].Row(y) + x);
    hn::Store(p.b, d, planes.color[2].Row(y) + x);
  }
  for (Plane& plane : planes.color) plane.ExtendRow(y);
}

HWY_INLINE void FillMotionRow(const ImageView& depth, const MotionView& motion, int y,
                              RenderPlanes& planes) {
  const FloatTag d;
  const auto farthest = hn::Set(d, kFarthestDepth);
  const auto largest = hn::Set(d, std::numeric_limits<float>::max());
  const auto none = hn::Set(d, std::numeric_limits<float>::quiet_NaN());
  for (int x = 0; x < depth.width; x += kLanes) {
    const int left = depth.width - x;
    const auto z = LoadSome(depth.Row<float>(y) + x, left);
    const auto known = hn::And(hn::Ge(z, hn::Zero(d)), hn::Lt(z, farthest));
    hn::Store(hn::IfThenElse(known, z, farthest), d, planes.depth.Row(y) + x);
    Floats mx, my;
    LoadMotion(motion.Row(y) + 2 * x, left, mx, my);
    const auto finite = hn::And(hn::Le(hn::Abs(mx), largest), hn::Le(hn::Abs(my), largest));
    hn::Store(hn::IfThenElse(finite, mx, none), d, planes.motion_x.Row(y) + x);
    hn::Store(hn::IfThenElse(finite, my, none), d, planes.motion_y.Row(y) + x);
  }
  for (Plane* plane : {&planes.depth, &planes.motion_x, &planes.motion_y}) plane->ExtendRow(y);
}

HWY_INLINE void FillReactiveRow(const ImageView& mask, int y, Plane& reactive) {
  const FloatTag d;
  float* row = reactive.Row(y);
  if (mask.data == nullptr) {
    std::fill_n(row, reactive.width(), 0.0f);
  } else {
    for (int x = 0; x < mask.width; x += kLanes) {
      const auto value = LoadSome(mask.Row<float>(y) + x, mask.width - x);
      const auto number = hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), value);
      hn::Store(hn::Min(number, hn::Set(d, 1.0f)), d, row + x);
    }
  }
  reactive.ExtendRow(y);
}

inline void FillPlanes(const SuperResolutionOptions& options, const RenderedFrame& frame,
                       const MotionView& motion, int begin, int end, RenderPlanes& planes) {
  const ImageView color = InFormat(kPipeline.sr.color_format, frame.color);
  for (int y = begin; y < end; ++y) {
    FillColorRow(options, color, y, planes);
    if (ReadsReactive(options)) FillReactiveRow(frame.reactive, y, planes.reactive);
    if (ReadsMotion(options)) FillMotionRow(frame.depth, motion, y, planes);
  }
}

// The colour boxes along an output row, interpolated between those of the samples.
class ColorBoxes {
 public:
  // Sets of rows R, G, B of the least, then of the greatest: those of an even and of an odd row of
  // samples, and the mixed ones.
  static constexpr int kSet = 6;
  static constexpr int kRows = 3 * kSet;

  HWY_INLINE ColorBoxes(const SrJob& job, Plane& rows, int first)
      : job_(job), rows_(rows), first_(first) {}

  HWY_INLINE void MoveTo(int y) {
    const int j = job_.y.cell()[y];
    Find(j);
    Find(j + 1);
    for (int r = 0; r < kSet; ++r) {
      MixRows(Row(j % 2, r), Row((j + 1) % 2, r), job_.y.fraction()[y], job_.x.render(),
              Row(kMixed, r));
    }
  }

  // v limited to the boxes at fractions t of the way from `cell` to the next.
  HWY_INLINE Floats Clamp(const Columns& cell, Floats t, int c, Floats v) {
    const auto low = cell.Mixed(Row(kMixed, c), t);
    const auto high = cell.Mixed(Row(kMixed, 3 + c), t);
    return hn::Min(hn::Max(v, low), high);
  }

 private:
  static constexpr int kMixed = 2;

  HWY_INLINE float* Row(int set, int r) { return rows_.Row(first_ + set * kSet + r); }

  HWY_INLINE void Find(int j) {
    const int set = j % 2;
    if (found_[set] == j) return;
    found_[set] = j;
    for (int c = 0; c < 3; ++c) {
      if (ClampOf(job_.options) == ColorClamp::kBox) {
        Extremes(job_.planes.color[c], j, Row(set, c), Row(set, 3 + c));
      } else {
        Spread(job_.planes.color[c], j, Row(set, c), Row(set, 3 + c));
      }
    }
    for (int r = 0; r < kSet; ++r) rows_.ExtendRow(first_ + set * kSet + r);
  }

  static HWY_INLINE void Extremes(const Plane& color, int j, float* low, float* high) {
    const FloatTag d;
    for (int i = 0; i < color.width(); i += kLanes) {
      auto least = hn::Load(d, color.Row(j) + i);
      auto greatest = least;
      for (int y = j - 1; y <= j + 1; ++y) {
        for (int x = i - 1; x <= i + 1; ++x) {
          const auto s = hn::LoadU(d, color.Row(y) + x);
          least = hn::Min(least, s);
          greatest = hn::Max(greatest, s);
        }
      }
      hn::Store(least, d, low + i);
      hn::Store(greatest, d, high + i);
    }
  }

  HWY_INLINE void Spread(const Plane& color, int j, float* low, float* high) const {
    const FloatTag d;
    const auto middle = hn::Set(d, kBoxMiddle);
    const auto side = hn::Set(d, kBoxSide);
    const auto gamma = hn::Set(d, job_.options.parameters.clamp_gamma);
    const auto add = [&](Floats weight, Floats s, Floats& sum, Floats& squares) HWY_ATTR {
      const auto weighted = hn::Mul(weight, s);
      sum = hn::Add(sum, weighted);
      squares = hn::MulAdd(weighted, s, squares);
    };
    for (int i = 0; i < color.width(); i += kLanes) {
      auto mean = hn::Zero(d);
      auto square = hn::Zero(d);
      for (int y = j - 1; y <= j + 1; ++y) {
        auto sum = hn::Zero(d);
        auto squares = hn::Zero(d);
        add(side, hn::LoadU(d, color.Row(y) + i - 1), sum, squares);
        add(middle, hn::LoadU(d, color.Row(y) + i), sum, squares);
        add(side, hn::LoadU(d, color.Row(y) + i + 1), sum, squares);
        const auto weight = y == j ? middle : side;
        mean = hn::MulAdd(weight, sum, mean);
        square = hn::MulAdd(weight, squares, square);
      }
      const auto variance = hn::NegMulAdd(mean, mean, square);
      const auto half = hn::Mul(gamma, hn::Sqrt(hn::Max(variance, hn::Zero(d))));
      hn::Store(Limit(hn::Sub(mean, half)), d, low + i);
      hn::Store(Limit(hn::Add(mean, half)), d, high + i);
    }
  }

  const SrJob& job_;
  Plane& rows_;
  int first_;
  int found_[2] = {-1, -1};  // the row of samples in each set
};

// Weights of the taps 0 and 1, or -1 to 2, at kLanes fractions.
struct TapVectors {
  Floats w[kTaps];
};

HWY_INLINE TapVectors TapsOf(CurrentFrame current, Floats t) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0f);
  const auto e = hn::Sub(one, t);
  if (current == CurrentFrame::kBilinear) return {{hn::Zero(d), e, t, hn::Zero(d)}};
  constexpr float kA = static_cast<float>(kCatmullRomA);  // as KeysTaps
  const auto a = hn::Set(d, kA);
  const auto outer0 = hn::Mul(hn::Mul(a, t), hn::Mul(e, e));
  const auto outer3 = hn::Mul(hn::Mul(a, e), hn::Mul(t, t));
  const auto slope = hn::MulAdd(hn::Set(d, kA + 2), t, hn::Set(d, -(kA + 3)));
  const auto inner1 = hn::MulAdd(slope, hn::Mul(t, t), one);
  return {{outer0, inner1, hn::Sub(hn::Sub(hn::Sub(one, inner1), outer0), outer3), outer3}};
}

// CurrentFrameAt for kLanes pixels.
HWY_NOINLINE inline Pixels CurrentPixels(const SrJob& job, int x, int y) {
  const FloatTag d;
  const CurrentFrame current = CurrentOf(job.options);
  const TapVectors wx = TapsOf(current, hn::LoadU(d, job.x.fraction() + x));
  const TapVectors wy = TapsOf(current, hn::Set(d, job.y.fraction()[y]));
  const int j = job.y.cell()[y];
  const Columns cell(job.x.cell(), x);
  Floats color[3];
  for (int c = 0; c < 3; ++c) {
    color[c] = hn::Zero(d);
    for (int k = current == CurrentFrame::kBilinear ? 1 : 0;
         k < (current == CurrentFrame::kBilinear ? 3 : kTaps); ++k) {
      const float* row = job.planes.color[c].Row(j + kFirstTap + k);
      auto sum = hn::Mul(wx.w[1], cell.At(row));
      sum = hn::MulAdd(wx.w[2], cell.Next(row), sum);
      if (current == CurrentFrame::kBicubic) {
        sum = hn::MulAdd(wx.w[0], cell.At(row - 1), sum);
        sum = hn::MulAdd(wx.w[3], cell.Next(row + 1), sum);
      }
      color[c] = hn::MulAdd(wy.w[k], sum, color[c]);
    }
  }
  return {Limit(color[0]), Limit(color[1]), Limit(color[2]), hn::Zero(d)};
}

// `validity` is that of the row, or null where all of the history is valid; marks the tiles where
// some is not.
inline void PredictRow(const SrJob& job, int y, const float* validity, ColorBoxes& boxes,
                       std::uint8_t* disoccluded) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0f);
  const auto zero = hn::Zero(d);
  const MutableImageView next = InFormat(kPipeline.sr.history_format, job.next);
  const bool clamped = ClampOf(job.options) != ColorClamp::kNone;
  if (clamped && job.HasHistory()) boxes.MoveTo(y);
  for (int x = 0; x < job.x.output(); x += kLanes) {
    const int left = job.x.output() - x;
    const auto valid = !job.HasHistory()     ? zero
                       : validity == nullptr ? one
                                             : hn::Load(d, validity + x);
    const bool some = !hn::AllTrue(d, hn::Le(valid, zero));
    const auto beyond = hn::Not(hn::FirstN(d, static_cast<std::size_t>(std::min(left, kLanes))));
    const bool all = hn::AllTrue(d, hn::Or(hn::Ge(valid, one), beyond));
    Pixels p{zero, zero, zero, valid};
    if (some) {
      p = LoadPixels(next, x, y, left);
      if (clamped) {
        const Columns cell(job.x.cell(), x);
        const auto t = hn::LoadU(d, job.x.fraction() + x);
        p.r = boxes.Clamp(cell, t, 0, p.r);
        p.g = boxes.Clamp(cell, t, 1, p.g);
        p.b = boxes.Clamp(cell, t, 2, p.b);
      } else {
        p = {Limit(p.r), Limit(p.g), Limit(p.b), p.a};
      }
      p.a = valid;
    }
    if (!all) {
      disoccluded[x / kTileWidth] = 1;
      const Pixels current = CurrentPixels(job, x, y);
      const auto full = hn::Ge(valid, one);
      p.r = hn::IfThenElse(full, p.r, Mix(current.r, p.r, valid));
      p.g = hn::IfThenElse(full, p.g, Mix(current.g, p.g, valid));
      p.b = hn::IfThenElse(full, p.b, Mix(current.b, p.b, valid));
    }
    StorePixels(p, next, x, y, left);
  }
}

// Motion and validity of a band, and its history warped.
HWY_INLINE void WarpBand(const SrJob& job, const Band& band, SrScratch& scratch) {
  GeometryRowMaker geometry(job, scratch.render_rows);
  float* depth = scratch.output_rows.Row(0);
  float* motion_x = scratch.output_rows.Row(1);
  float* motion_y = scratch.output_rows.Row(2);
  const MutableMotionView motion = band.Motion(scratch.motion);
  for (int y = band.first; y < band.last; ++y) {
    geometry.Make(y, depth, motion_x, motion_y);
    float* validity = scratch.validity.Row(y - band.first);
    ValidityRow(job, y, depth, motion_x, motion_y, validity);
    if (ReadsReactive(job.options)) ApplyReactive(job, y, motion_x, motion_y, validity);
    StoreMotion(motion_x, motion_y, job.x.output(), motion.Row(y));
  }
  const WarpOptions& warp = job.options.warp;
  scratch.tiles.warped +=
      PrefiltersHistory(job.options)
          ? WarpRows(PrefilteredImage{job.history, job.coefficients}, motion, warp, band.first,
                     band.last, job.next)
          : WarpRows(job.history, motion, warp, band.first, band.last, job.next);
}

// Validity of a band of a history that lies where it was, where there is a mask.
HWY_INLINE void StillValidity(const SrJob& job, int begin, int end, SrScratch& scratch) {
  float* motion = scratch.output_rows.Row(0);
  std::fill_n(motion, job.x.output(), 0.0f);
  for (int y = begin; y < end; ++y) {
    float* validity = scratch.validity.Row(y - begin);
    std::fill_n(validity, job.x.output(), 1.0f);
    ApplyReactive(job, y, motion, motion, validity);
  }
}

inline void Predict(const SrJob& job, int begin, int end, SrScratch& scratch) {
  const bool warps = WarpsHistory(job.options);
  const bool masks = job.HasHistory() && ReadsReactive(job.options);
  // What `next` holds of the frame before is the prediction already: values in [0, 1], alpha 1.
  if (job.HasHistory() && !warps && !masks && ClampOf(job.options) == ColorClamp::kNone) return;
  if (job.HasHistory() && warps) WarpBand(job, {begin, end}, scratch);
  if (masks && !warps) StillValidity(job, begin, end, scratch);
  ColorBoxes boxes(job, scratch.render_rows, GeometryRowMaker::kRows);
  for (int y = begin; y < end; ++y) {
    PredictRow(job, y, warps || masks ? scratch.validity.Row(y - begin) : nullptr, boxes,
               scratch.disoccluded.data());
  }
}

inline void Geometry(const SrJob& job, int begin, int end, SrScratch& scratch,
                     const MutableImageView& depth, const MutableMotionView& motion) {
  GeometryRowMaker maker(job, scratch.render_rows);
  float* motion_x = scratch.output_rows.Row(1);
  float* motion_y = scratch.output_rows.Row(2);
  for (int y = begin; y < end; ++y) {
    maker.Make(y, scratch.output_rows.Row(0), motion_x, motion_y);
    std::copy_n(scratch.output_rows.Row(0), job.x.output(), depth.Row<float>(y));
    StoreMotion(motion_x, motion_y, job.x.output(), motion.Row(y));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
