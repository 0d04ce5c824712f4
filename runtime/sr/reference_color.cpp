#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/core/pixel.h"
#include "runtime/sr/reference.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {
namespace {

float Load(const ImageView& image, int x, int y, int c) {
  return LoadChannel(image.format, image.At(x, y), c) / ChannelScale(image.format);
}

void Store(const MutableImageView& image, int x, int y, int c, float value) {
  StoreChannel(image.format, value * ChannelScale(image.format), image.At(x, y), c);
}

std::array<float, 4> TapWeights(CurrentFrame current, float fraction) {
  return current == CurrentFrame::kBilinear ? BilinearTaps(fraction)
                                            : KeysTaps(static_cast<float>(kCatmullRomA), fraction);
}

void SetMotion(const MutableMotionView& motion, int x, int y, float mx, float my) {
  motion.Row(y)[2 * x] = mx;
  motion.Row(y)[2 * x + 1] = my;
}

float Limit(float value) { return std::clamp(value, 0.0f, 1.0f); }

float Distance(const SrJob& job, int x, int y, int di, int dj) {
  return std::hypot(job.x.offset()[x] - static_cast<float>(di),
                    job.y.offset()[y] - static_cast<float>(dj));
}

// Sums of the samples within one render pixel of the centre of output pixel (x, y).
struct SampleSums {
  int count = 0;
  float weight = 0;
  Rgb color{};
};

SampleSums SumSamples(const SrJob& job, int x, int y) {
  SampleSums sums;
  const int i = job.x.nearest()[x];
  const int j = job.y.nearest()[y];
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const bool in_frame =
          i + di >= 0 && i + di < job.x.render() && j + dj >= 0 && j + dj < job.y.render();
      const float distance = Distance(job, x, y, di, dj);
      if (!in_frame || !(distance <= 1)) continue;
      const float weight = SampleWeight(job.options.parameters.blend_b, distance);
      ++sums.count;
      sums.weight += weight;
      for (int c = 0; c < 3; ++c)
        sums.color.c[c] += weight * job.planes.color[c].Row(j + dj)[i + di];
    }
  }
  return sums;
}

// The printed form, kept from losing energy; `validity` 0 leaves the prediction, the current frame
// alone, as it is.
Rgb UpdateFromSamples(const SrJob& job, int x, int y, const Rgb& predicted, float validity) {
  const SampleSums sums = SumSamples(job, x, y);
  if (!(sums.weight > 0)) return predicted;
  const float share = validity * BlendShare(job.options.parameters.blend_a,
                                            sums.weight / static_cast<float>(sums.count));
  const float settled = SettledDistance(job.next.format, EncodingOf(job.options));
  const float least = LeastStep(job.next.format);
  Rgb q;
  for (int c = 0; c < 3; ++c) {
    const float distance = sums.color.c[c] / sums.weight - predicted.c[c];
    q.c[c] = predicted.c[c] + HistoryStep(share, distance, settled, least);
  }
  return q;
}

// The coherent residual of column i at fraction `t` of the way from row j to the next.
Rgb CoherentResidual(const SrJob& job, int i, int j, float t) {
  Rgb mean{}, square{};
  float squared = 0, variance = 0;
  for (int c = 0; c < 3; ++c) {
    for (int dj = -kCoherentReach; dj <= kCoherentReach + 1; ++dj) {
      const float* row = job.residual[c].Row(std::clamp(j + dj, 0, job.y.render() - 1));
      const float weight = (1 - t) * CoherentTap(dj) + t * CoherentTap(dj - 1);
      for (int di = -kCoherentReach; di <= kCoherentReach; ++di) {
        const float r = row[std::clamp(i + di, 0, job.x.render() - 1)];
        mean.c[c] += weight * CoherentTap(di) * r;
        square.c[c] += weight * CoherentTap(di) * r * r;
      }
    }
    squared += mean.c[c] * mean.c[c];
    variance += std::max(square.c[c] - mean.c[c] * mean.c[c], 0.0f);
  }
  const float part = CoherentPart(squared, variance);
  for (float& channel : mean.c) channel *= part;
  return mean;
}

// The same at the centre of output pixel (x, y).
Rgb CoherentResidualAt(const SrJob& job, int x, int y) {
  const int j = job.y.cell()[y];
  const int i = std::clamp(job.x.cell()[x], 0, job.x.render() - 1);
  const int next = std::clamp(job.x.cell()[x] + 1, 0, job.x.render() - 1);
  const Rgb left = CoherentResidual(job, i, j, job.y.fraction()[y]);
  Rgb q = CoherentResidual(job, next, j, job.y.fraction()[y]);
  for (int c = 0; c < 3; ++c) q.c[c] = left.c[c] + job.x.fraction()[x] * (q.c[c] - left.c[c]);
  return q;
}

Rgb UpdateFromResidual(const SrJob& job, int x, int y, const Rgb& predicted, float validity,
                       float smoothing) {
  const Parameters& parameters = job.options.parameters;
  const float share =
      validity * (1 - smoothing) *
      BlendShare(parameters.blend_a, SampleWeight(parameters.blend_b, Distance(job, x, y, 0, 0)));
  const float current_share = validity * smoothing * kSmoothShare;
  const float settled =
      SettledDistance(job.next.format, EncodingOf(job.options)) - ResidualSlack(job.next.format);
  const float least =
      LeastResidualStep(job.next.format, EncodingOf(job.options), parameters.blend_a);
  const float coherent_share = job.options.coherent_share;
  const Rgb coherent = coherent_share > 0 ? CoherentResidualAt(job, x, y) : Rgb{};
  const float more = validity * (1 - smoothing) * coherent_share - share;
  Rgb q;
  for (int c = 0; c < 3; ++c) {
    const float current = BilinearAt(job, job.planes.color[c], x, y);
    const float residual = BilinearAt(job, job.residual[c], x, y);
    q.c[c] = predicted.c[c] + HistoryStep(share, residual, settled, least) +
             current_share * (current - predicted.c[c]) + more * coherent.c[c];
  }
  return q;
}

// The variance of the residuals of columns [first, last) and rows [begin, end).
float TileVariance(const Plane* residual, int first, int last, int begin, int end) {
  float squares = 0;
  float sums[3] = {};
  for (int c = 0; c < 3; ++c) {
    for (int j = begin; j < end; ++j) {
      for (int i = first; i < last; ++i) {
        const float r = residual[c].Row(j)[i];
        sums[c] += r;
        squares += r * r;
      }
    }
  }
  return ResidualVariance(squares, sums, (last - first) * (end - begin));
}

// The greatest of each channel of the samples (i - 1, j - 1) to (i + 2, j + 2), at least the code
// of kUnlimitedHdr: what a linear HDR pixel between samples i and i + 1, j and j + 1 is limited to.
Rgb BrightestSamples(const SrJob& job, int i, int j) {
  const float unlimited = HdrCode(kUnlimitedHdr);
  Rgb brightest = {{unlimited, unlimited, unlimited}};
  for (int c = 0; c < 3; ++c) {
    for (int y = j - 1; y <= j + 2; ++y) {
      const float* row = job.planes.color[c].Row(y);
      brightest.c[c] = std::max(brightest.c[c], *std::max_element(row + i - 1, row + i + 3));
    }
  }
  return brightest;
}

}  // namespace

void FillPlanesReference(const SuperResolutionOptions& options, const RenderedFrame& frame,
                         const MotionView& motion, int begin, int end, RenderPlanes& planes) {
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < frame.color.width; ++x) {
      float rgb[3] = {Load(frame.color, x, y, 0), Load(frame.color, x, y, 1),
                      Load(frame.color, x, y, 2)};
      EncodeColor(EncodingOf(options), rgb);
      for (int c = 0; c < 3; ++c) planes.color[c].Row(y)[x] = rgb[c];
    }
    for (Plane& plane : planes.color) plane.ExtendRow(y);
    if (ReadsReactive(options)) {
      for (int x = 0; x < frame.color.width; ++x) {
        const bool given = frame.reactive.data != nullptr;
        planes.reactive.Row(y)[x] =
            given ? SanitizeReactive(frame.reactive.Row<float>(y)[x]) : 0.0f;
      }
      planes.reactive.ExtendRow(y);
    }
    if (!ReadsMotion(options)) continue;
    for (int x = 0; x < frame.color.width; ++x) {
      planes.depth.Row(y)[x] = SanitizeDepth(frame.depth.Row<float>(y)[x]);
      const float* m = motion.Row(y) + 2 * x;
      const bool finite = IsFiniteMotion(m[0], m[1]);
      constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
      planes.motion_x.Row(y)[x] = finite ? m[0] : kNone;
      planes.motion_y.Row(y)[x] = finite ? m[1] : kNone;
    }
    for (Plane* plane : {&planes.depth, &planes.motion_x, &planes.motion_y}) plane->ExtendRow(y);
  }
}

ColorBox SampleColorBox(const SrJob& job, int i, int j) {
  ColorBox box;
  for (int c = 0; c < 3; ++c) {
    float low = 1, high = 0, mean = 0, square = 0;
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const float s = job.planes.color[c].Row(j + dj)[i + di];
        const float weight = (dj == 0 ? kBoxMiddle : kBoxSide) * (di == 0 ? kBoxMiddle : kBoxSide);
        low = std::min(low, s);
        high = std::max(high, s);
        mean += weight * s;
        square += weight * s * s;
      }
    }
    if (ClampOf(job.options) == ColorClamp::kVariance) {
      const float half =
          job.options.parameters.clamp_gamma * std::sqrt(std::max(square - mean * mean, 0.0f));
      low = mean - half;
      high = mean + half;
    }
    const bool none = ClampOf(job.options) == ColorClamp::kNone;
    box.low.c[c] = none ? 0.0f : Limit(low);
    box.high.c[c] = none ? 1.0f : Limit(high);
  }
  return box;
}

ColorBox ColorBoxAt(const SrJob& job, int x, int y) {
  const int i = job.x.cell()[x];
  const int j = job.y.cell()[y];
  const ColorBox corners[4] = {SampleColorBox(job, i, j), SampleColorBox(job, i + 1, j),
                               SampleColorBox(job, i, j + 1), SampleColorBox(job, i + 1, j + 1)};
  const auto mixed = [&](Rgb ColorBox::*bound, int c) {
    const auto value = [&](int corner) { return (corners[corner].*bound).c[c]; };
    const float fy = job.y.fraction()[y];
    const float left = value(0) + fy * (value(2) - value(0));
    const float right = value(1) + fy * (value(3) - value(1));
    return left + job.x.fraction()[x] * (right - left);
  };
  ColorBox box;
  for (int c = 0; c < 3; ++c) {
    box.low.c[c] = mixed(&ColorBox::low, c);
    box.high.c[c] = mixed(&ColorBox::high, c);
  }
  return box;
}

Rgb CurrentFrameAt(const SrJob& job, int x, int y) {
  const auto wx = TapWeights(CurrentOf(job.options), job.x.fraction()[x]);
  const auto wy = TapWeights(CurrentOf(job.options), job.y.fraction()[y]);
  const int i = job.x.cell()[x];
  const int j = job.y.cell()[y];
  Rgb color{};
  for (int c = 0; c < 3; ++c) {
    for (int ky = 0; ky < kTaps; ++ky) {
      const float* row = job.planes.color[c].Row(j + kFirstTap + ky) + i + kFirstTap;
      color.c[c] += wy[ky] * (wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3]);
    }
    color.c[c] = Limit(color.c[c]);
  }
  return color;
}

void PredictReference(const SrJob& job, int begin, int end, SrScratch& scratch) {
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < job.x.output(); ++x) {
      const Surface surface = SurfaceAt(job, x, y);
      const float mx = surface.motion_x * job.x.scale();
      const float my = surface.motion_y * job.y.scale();
      float validity = ValidityReference(job, x, y, surface.depth, mx, my);
      if (ReadsReactive(job.options)) validity *= 1 - ReactiveReference(job, x, y, mx, my);
      scratch.validity.Row(y - begin)[x] = validity;
      if (WarpsHistory(job.options))
        SetMotion(Band{begin, end}.Motion(scratch.motion), x, y, mx, my);
    }
  }
  if (job.HasHistory() && WarpsHistory(job.options)) {
    const MotionView motion = Band{begin, end}.Motion(scratch.motion);
    const WarpOptions& warp = job.options.warp;
    WarpReferencePixels(
        PrefiltersHistory(job.options)
            ? WarpJob(PrefilteredImage{job.history, job.coefficients}, motion, warp, job.next)
            : WarpJob(job.history, motion, warp, job.next),
        {0, begin, job.x.output(), end});
  }
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < job.x.output(); ++x) {
      const float validity = scratch.validity.Row(y - begin)[x];
      if (validity < 1) scratch.disoccluded[static_cast<std::size_t>(x / kTileWidth)] = 1;
      const Rgb current = CurrentFrameAt(job, x, y);
      const ColorBox box = ColorBoxAt(job, x, y);
      for (int c = 0; c < 3; ++c) {
        float color = current.c[c];
        if (validity > 0) {
          const float warped = std::clamp(Load(job.next, x, y, c), box.low.c[c], box.high.c[c]);
          color = validity < 1 ? color + validity * (warped - color) : warped;
        }
        Store(job.next, x, y, c, color);
      }
      Store(job.next, x, y, 3, validity);
    }
  }
}

void ResidualReference(const SrJob& job, int begin, int end, Plane* residual,
                       AliasingMap& aliasing) {
  const int last_x = job.x.output() - 1;
  const int last_y = job.y.output() - 1;
  const float slack = ResidualSlack(job.next.format);
  for (int j = begin; j < end; ++j) {
    const auto wy = KeysTaps(static_cast<float>(kCatmullRomA), job.y.share()[j]);
    for (int i = 0; i < job.x.render(); ++i) {
      const auto wx = KeysTaps(static_cast<float>(kCatmullRomA), job.x.share()[i]);
      for (int c = 0; c < 3; ++c) {
        float predicted = 0;
        for (int ky = 0; ky < kTaps; ++ky) {
          const int y = std::clamp(job.y.texel()[j] + kFirstTap + ky, 0, last_y);
          float sum = 0;
          for (int kx = 0; kx < kTaps; ++kx) {
            const int x = std::clamp(job.x.texel()[i] + kFirstTap + kx, 0, last_x);
            sum += wx[kx] * Load(job.next, x, y, c);
          }
          predicted += wy[ky] * sum;
        }
        const float difference = job.planes.color[c].Row(j)[i] - predicted;
        residual[c].Row(j)[i] = difference - std::clamp(difference, -slack, slack);
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

void UpdateReference(const SrJob& job, int begin, int end, SrScratch& scratch,
                     const MutableImageView& out) {
  float* smoothing = scratch.render_rows.Row(0);
  for (int y = begin; y < end; ++y) {
    const bool smooth =
        SmoothsAliasing(job.options) && job.aliasing->FillRow(job.y.cell()[y], smoothing);
    for (int x = 0; x < job.x.output(); ++x) {
      Rgb q = {{Load(job.next, x, y, 0), Load(job.next, x, y, 1), Load(job.next, x, y, 2)}};
      if (KeepsHistory(job.options)) {
        const float validity = Load(job.next, x, y, 3);
        q = FormOf(job.options) == HistoryForm::kSample
                ? UpdateFromSamples(job, x, y, q, validity)
                : UpdateFromResidual(job, x, y, q, validity,
                                     smooth ? smoothing[job.x.cell()[x]] : 0.0f);
      }
      if (EncodingOf(job.options) == ColorEncoding::kLinearHdr && KeepsHistory(job.options)) {
        const Rgb limit = BrightestSamples(job, job.x.cell()[x], job.y.cell()[y]);
        for (int c = 0; c < 3; ++c) q.c[c] = std::min(q.c[c], limit.c[c]);
      }
      for (float& channel : q.c) channel = Limit(channel);
      for (int c = 0; c < 3; ++c) Store(job.next, x, y, c, q.c[c]);
      DecodeColor(EncodingOf(job.options), q.c);
      for (int c = 0; c < 3; ++c) Store(out, x, y, c, q.c[c]);
      Store(out, x, y, 3, 1.0f);
    }
  }
}

const SrPasses& ReferencePasses() {
  static constexpr SrPasses kPasses = {
      FillPlanesReference, GeometryReference,   PredictReference,       ResidualReference,
      UpdateReference,     DepthRangeReference, ReactiveReachReference, true};
  return kPasses;
}

}  // namespace warplut
