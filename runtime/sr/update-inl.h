// Residuals, and how the new samples enter the history, per target.
#if defined(WARPLUT_RUNTIME_SR_UPDATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_SR_UPDATE_INL_H_
#undef WARPLUT_RUNTIME_SR_UPDATE_INL_H_
#else
#define WARPLUT_RUNTIME_SR_UPDATE_INL_H_
#endif

#include "runtime/sr/color-inl.h"
#include "runtime/warp/warp_general-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

// The variance of the residuals of columns [first, last) and rows [begin, end); `first` is a whole
// number of tiles.
HWY_INLINE float TileVariance(const Plane* residual, int first, int last, int begin, int end) {
  const FloatTag d;
  auto squares = hn::Zero(d);
  float sums[3];
  for (int c = 0; c < 3; ++c) {
    auto sum = hn::Zero(d);
    for (int i = first; i < last; i += kLanes) {
      const auto inside = hn::FirstN(d, static_cast<std::size_t>(std::min(last - i, kLanes)));
      for (int j = begin; j < end; ++j) {
        const auto r = hn::IfThenElseZero(inside, hn::LoadU(d, residual[c].Row(j) + i));
        sum = hn::Add(sum, r);
        squares = hn::MulAdd(r, r, squares);
      }
    }
    sums[c] = hn::GetLane(hn::SumOfLanes(d, sum));
  }
  const float sum_of_squares = hn::GetLane(hn::SumOfLanes(d, squares));
  return ResidualVariance(sum_of_squares, sums, (last - first) * (end - begin));
}

// The prediction at a sample is a 4 x 4 window of it: what the warp sums.
inline void Residual(const SrJob& job, int begin, int end, Plane* residual, AliasingMap& aliasing) {
  const FloatTag d;
  const TapPolynomials taps(Filter::kCatmullRom);
  const ImageView predicted = InFormat(kPipeline.sr.history_format, job.next);
  const float unit = 1.0f / ChannelScale(predicted.format);
  const auto slack = hn::Set(d, ResidualSlack(predicted.format));
  PixelRow r;
  for (int j = begin; j < end; ++j) {
    const int ty = job.y.texel()[j];
    const bool inside_y = ty > 0 && ty < job.y.output() - kTaps / 2;
    for (int x = 0; x < job.x.render(); x += kRowPixels) {
      r.count = std::min(kRowPixels, job.x.render() - x);
      r.padded = (r.count + kLanes - 1) / kLanes * kLanes;
      std::copy_n(job.x.texel() + x, r.padded, r.texel_x);
      std::copy_n(job.x.share() + x, r.padded, r.offset_x);
      std::fill_n(r.texel_y, r.padded, ty);
      std::fill_n(r.offset_y, r.padded, job.y.share()[j]);
      r.all_inside =
          inside_y && r.texel_x[0] > 0 && r.texel_x[r.padded - 1] < job.x.output() - kTaps / 2;
      ComputeWeights(taps, r);
      SumRow<Footprint::k16>(predicted, r.weights, r);
      for (int p = 0; p < r.padded; p += kLanes) {
        Floats red, green, blue, alpha;
        hn::LoadInterleaved4(d, r.sums + p * kRgba, red, green, blue, alpha);
        const Floats channels[3] = {red, green, blue};
        for (int c = 0; c < 3; ++c) {
          const auto sample = hn::LoadU(d, job.planes.color[c].Row(j) + x + p);
          const auto difference = hn::NegMulAdd(channels[c], hn::Set(d, unit), sample);
          const auto rounding = hn::Min(hn::Max(difference, hn::Neg(slack)), slack);
          hn::StoreU(hn::Sub(difference, rounding), d, residual[c].Row(j) + x + p);
        }
      }
    }
    for (int c = 0; c < 3; ++c) residual[c].ExtendRow(j);
  }
  if (!SmoothsAliasing(job.options)) return;
  float* variances = aliasing.Variances(begin / kAliasingTile);
  for (int first = 0; first < job.x.render(); first += kAliasingTile) {
    const int last = std::min(first + kAliasingTile, job.x.render());
    *variances++ = TileVariance(residual, first, last, begin, end);
  }
}

HWY_INLINE Floats DistanceOf(Floats dx, Floats dy) {
  return hn::Sqrt(hn::MulAdd(dx, dx, hn::Mul(dy, dy)));
}

HWY_INLINE Floats SampleWeights(float b, Floats distance) {
  const FloatTag d;
  return hn::Max(hn::NegMulAdd(hn::Set(d, b), distance, hn::Set(d, 1.0f)), hn::Zero(d));
}

HWY_INLINE Floats BlendShares(float a, Floats weight) {
  const FloatTag d;
  return hn::Min(hn::Mul(hn::Set(d, a), weight), hn::Set(d, 1.0f));
}

// Rows of the scratch, mixed for a row of the output but the smoothing.
enum UpdateRow {
  kResidualRow,
  kColorRow = 3,
  kSmoothingRow = 6,
  kLimitRow = 7,
  kCoherentRow = 10,
  kSquareRow = 13,
  kSumRow = 16
};

// The mean of a residual and of its square, as CoherentResidual, at fraction `t` of the way from
// row j to the next, for all columns.
HWY_INLINE void FillMeanRows(const Plane& residual, int j, float t, float* mean, float* square,
                             Plane& rows) {
  const FloatTag d;
  float* sums[2] = {rows.Row(kSumRow), rows.Row(kSumRow + 1)};
  float* means[2] = {mean, square};
  for (int i = 0; i < residual.width(); i += kLanes) {
    auto sum = hn::Zero(d), squares = hn::Zero(d);
    for (int k = -kCoherentReach; k <= kCoherentReach + 1; ++k) {
      const int row = std::clamp(j + k, 0, residual.height() - 1);
      const auto weight = hn::Set(d, (1 - t) * CoherentTap(k) + t * CoherentTap(k - 1));
      const auto r = hn::LoadU(d, residual.Row(row) + i);
      const auto weighted = hn::Mul(weight, r);
      sum = hn::Add(sum, weighted);
      squares = hn::MulAdd(weighted, r, squares);
    }
    hn::Store(sum, d, sums[0] + i);
    hn::Store(squares, d, sums[1] + i);
  }
  for (int s = 0; s < 2; ++s) {
    rows.ExtendRow(kSumRow + s);
    for (int i = 0; i < residual.width(); i += kLanes) {
      auto sum = hn::Zero(d);
      for (int k = -kCoherentReach; k <= kCoherentReach; ++k) {
        sum = hn::MulAdd(hn::Set(d, CoherentTap(k)), hn::LoadU(d, sums[s] + i + k), sum);
      }
      hn::Store(sum, d, means[s] + i);
    }
  }
}

// The coherent residual between rows j and j + 1, in the rows kCoherentRow.
HWY_INLINE void FillCoherentRows(const SrJob& job, int j, float t, Plane& rows) {
  const FloatTag d;
  for (int c = 0; c < 3; ++c) {
    FillMeanRows(job.residual[c], j, t, rows.Row(kCoherentRow + c), rows.Row(kSquareRow + c), rows);
  }
  for (int i = 0; i < job.x.render(); i += kLanes) {
    auto squared = hn::Zero(d), variance = hn::Zero(d);
    for (int c = 0; c < 3; ++c) {
      const auto mean = hn::Load(d, rows.Row(kCoherentRow + c) + i);
      const auto square = hn::Load(d, rows.Row(kSquareRow + c) + i);
      squared = hn::MulAdd(mean, mean, squared);
      variance = hn::Add(variance, hn::Max(hn::NegMulAdd(mean, mean, square), hn::Zero(d)));
    }
    const auto all = hn::MulAdd(hn::Set(d, kIncoherence), variance, squared);
    const auto part = hn::Div(squared, hn::Max(all, hn::Set(d, kLeastCoherence)));
    for (int c = 0; c < 3; ++c) {
      float* row = rows.Row(kCoherentRow + c) + i;
      hn::Store(hn::Mul(part, hn::Load(d, row)), d, row);
    }
  }
  for (int c = 0; c < 3; ++c) rows.ExtendRow(kCoherentRow + c);
}

// BrightestSamples of one channel, for all samples (i, j) of row j as the upper left one.
HWY_INLINE void FillLimitRow(const Plane& color, int j, float* limit) {
  const FloatTag d;
  const auto unlimited = hn::Set(d, HdrCode(kUnlimitedHdr));
  for (int i = 0; i < color.width(); i += kLanes) {
    auto brightest = unlimited;
    for (int y = j - 1; y <= j + 2; ++y) {
      for (int x = i - 1; x <= i + 2; ++x) {
        brightest = hn::Max(brightest, hn::LoadU(d, color.Row(y) + x));
      }
    }
    hn::Store(brightest, d, limit + i);
  }
}

// HistoryStep for kLanes pixels.
class HistorySteps {
 public:
  // In the residual forms ResidualSlack is off the distances already.
  HWY_INLINE HistorySteps(const SrJob& job, bool residual)
      : settled_(SettledDistance(HistoryFormatOf(job.options), EncodingOf(job.options)) -
                 (residual ? ResidualSlack(HistoryFormatOf(job.options)) : 0.0f)),
        least_(residual ? LeastResidualStep(HistoryFormatOf(job.options), EncodingOf(job.options),
                                            job.options.parameters.blend_a)
                        : LeastStep(HistoryFormatOf(job.options))) {}

  // from + step.
  HWY_INLINE Floats Add(Floats share, Floats distance, Floats from) const {
    const FloatTag d;
    const auto to = hn::MulAdd(share, distance, from);
    if (!(least_ > 0)) return to;
    const auto least = hn::Set(d, least_);
    const auto is_far =
        hn::And(hn::Gt(share, hn::Zero(d)), hn::Gt(hn::Abs(distance), hn::Set(d, settled_)));
    const auto lengthened = hn::And(is_far, hn::Lt(hn::Abs(hn::Mul(share, distance)), least));
    return hn::IfThenElse(lengthened, hn::Add(from, hn::CopySign(least, distance)), to);
  }

 private:
  float settled_, least_;
};

// UpdateFromResidual for kLanes pixels, whose alpha is the validity; `smooths` says whether there
// is a row of smoothing.
HWY_INLINE void AddResidual(const SrJob& job, const HistorySteps& steps, int x, int y,
                            const Plane& rows, bool smooths, Pixels& p) {
  const FloatTag d;
  const Parameters& parameters = job.options.parameters;
  const auto distance = DistanceOf(hn::LoadU(d, job.x.offset() + x), hn::Set(d, job.y.offset()[y]));
  auto share =
      hn::Mul(p.a, BlendShares(parameters.blend_a, SampleWeights(parameters.blend_b, distance)));
  const Columns cell(job.x.cell(), x);
  const auto t = hn::LoadU(d, job.x.fraction() + x);
  if (smooths) {
    const auto smoothing = cell.At(rows.Row(kSmoothingRow));
    if (!hn::AllTrue(d, hn::Le(smoothing, hn::Zero(d)))) {
      const auto current_share = hn::Mul(p.a, hn::Mul(smoothing, hn::Set(d, kSmoothShare)));
      share = hn::NegMulAdd(share, smoothing, share);
      p.r = Mix(p.r, cell.Mixed(rows.Row(kColorRow), t), current_share);
      p.g = Mix(p.g, cell.Mixed(rows.Row(kColorRow + 1), t), current_share);
      p.b = Mix(p.b, cell.Mixed(rows.Row(kColorRow + 2), t), current_share);
    }
  }
  if (job.options.coherent_share > 0) {
    auto coherent = hn::Mul(p.a, hn::Set(d, job.options.coherent_share));
    if (smooths) {
      coherent = hn::NegMulAdd(coherent, cell.At(rows.Row(kSmoothingRow)), coherent);
    }
    coherent = hn::Sub(coherent, share);
    p.r = hn::MulAdd(coherent, cell.Mixed(rows.Row(kCoherentRow), t), p.r);
    p.g = hn::MulAdd(coherent, cell.Mixed(rows.Row(kCoherentRow + 1), t), p.g);
    p.b = hn::MulAdd(coherent, cell.Mixed(rows.Row(kCoherentRow + 2), t), p.b);
  }
  if (hn::AllTrue(d, hn::Le(share, hn::Zero(d)))) return;
  p.r = steps.Add(share, cell.Mixed(rows.Row(kResidualRow), t), p.r);
  p.g = steps.Add(share, cell.Mixed(rows.Row(kResidualRow + 1), t), p.g);
  p.b = steps.Add(share, cell.Mixed(rows.Row(kResidualRow + 2), t), p.b);
}

// UpdateFromSamples for kLanes pixels, whose alpha is the validity.
HWY_INLINE void BlendSamples(const SrJob& job, const HistorySteps& steps, int x, int y, Pixels& p) {
  const FloatTag d;
  const IntTag di;
  const Parameters& parameters = job.options.parameters;
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0f);
  const Columns nearest(job.x.nearest(), x);
  const auto i = hn::LoadU(di, job.x.nearest() + x);
  const auto dx = hn::LoadU(d, job.x.offset() + x);
  Pixels sum{zero, zero, zero, zero};
  auto count = zero;
  for (int dj = -1; dj <= 1; ++dj) {
    const int j = job.y.nearest()[y] + dj;
    if (j < 0 || j >= job.y.render()) continue;
    const auto dy = hn::Set(d, job.y.offset()[y] - static_cast<float>(dj));
    for (int step = -1; step <= 1; ++step) {
      const auto column = hn::Add(i, hn::Set(di, step));
      const auto in_frame =
          hn::And(hn::Gt(column, hn::Set(di, -1)), hn::Lt(column, hn::Set(di, job.x.render())));
      const auto distance = DistanceOf(hn::Sub(dx, hn::Set(d, static_cast<float>(step))), dy);
      const auto near = hn::And(hn::RebindMask(d, in_frame), hn::Le(distance, one));
      if (hn::AllFalse(d, near)) continue;
      const auto weight = hn::IfThenElseZero(near, SampleWeights(parameters.blend_b, distance));
      count = hn::Add(count, hn::IfThenElseZero(near, one));
      sum.a = hn::Add(sum.a, weight);
      sum.r = hn::MulAdd(weight, nearest.At(job.planes.color[0].Row(j) + step), sum.r);
      sum.g = hn::MulAdd(weight, nearest.At(job.planes.color[1].Row(j) + step), sum.g);
      sum.b = hn::MulAdd(weight, nearest.At(job.planes.color[2].Row(j) + step), sum.b);
    }
  }
  const auto seen = hn::Gt(sum.a, zero);
  const auto mean = hn::IfThenElseZero(seen, hn::Div(sum.a, hn::Max(count, one)));
  const auto share = hn::Mul(p.a, BlendShares(parameters.blend_a, mean));
  const auto inverse = hn::Div(one, hn::IfThenElse(seen, sum.a, one));
  p.r = steps.Add(share, hn::Sub(hn::Mul(sum.r, inverse), p.r), p.r);
  p.g = steps.Add(share, hn::Sub(hn::Mul(sum.g, inverse), p.g), p.g);
  p.b = steps.Add(share, hn::Sub(hn::Mul(sum.b, inverse), p.b), p.b);
}

inline void Update(const SrJob& job, int begin, int end, SrScratch& scratch,
                   const MutableImageView& out) {
  const FloatTag d;
  const SuperResolutionOptions& options = job.options;
  const MutableImageView next = InFormat(kPipeline.sr.history_format, job.next);
  const MutableImageView shown = InFormat(kPipeline.sr.output_format, out);
  const bool residual = HasResidual(options);
  const bool samples = KeepsHistory(options) && !residual;
  Plane& rows = scratch.render_rows;
  const bool limits = EncodingOf(options) == ColorEncoding::kLinearHdr && KeepsHistory(options);
  const HistorySteps steps(job, residual);
  int smoothing_row = -1, limit_row = -1;  // of samples
  bool smooths = false;
  for (int y = begin; y < end; ++y) {
    const int j = job.y.cell()[y];
    const auto mix = [&](const Plane* planes, int first) HWY_ATTR {
      for (int c = 0; c < 3; ++c) {
        MixRows(planes[c].Row(j), planes[c].Row(j + 1), job.y.fraction()[y], job.x.render(),
                rows.Row(first + c));
      }
    };
    if (residual) mix(job.residual, kResidualRow);
    if (residual && options.coherent_share > 0) {
      FillCoherentRows(job, j, job.y.fraction()[y], rows);
    }
    if (SmoothsAliasing(options) && j != smoothing_row) {
      smoothing_row = j;
      smooths = job.aliasing->FillRow(j, rows.Row(kSmoothingRow));
    }
    if (smooths) mix(job.planes.color, kColorRow);
    if (limits && j != limit_row) {
      limit_row = j;
      for (int c = 0; c < 3; ++c) FillLimitRow(job.planes.color[c], j, rows.Row(kLimitRow + c));
    }
    for (int x = 0; x < job.x.output(); x += kLanes) {
      const int left = job.x.output() - x;
      Pixels p = LoadPixels(next, x, y, left);
      if (residual) AddResidual(job, steps, x, y, rows, smooths, p);
      if (samples) BlendSamples(job, steps, x, y, p);
      if (limits) {
        const Columns cell(job.x.cell(), x);
        p.r = hn::Min(p.r, cell.At(rows.Row(kLimitRow)));
        p.g = hn::Min(p.g, cell.At(rows.Row(kLimitRow + 1)));
        p.b = hn::Min(p.b, cell.At(rows.Row(kLimitRow + 2)));
      }
      p = {Limit(p.r), Limit(p.g), Limit(p.b), hn::Set(d, 1.0f)};
      StorePixels(p, next, x, y, left);
      DecodePixels(EncodingOf(options), p);
      StorePixels(p, shown, x, y, left);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
