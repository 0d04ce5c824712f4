// The vector kernel of the last pass.
#if defined(WARPLUT_RUNTIME_GENERATION_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_BLEND_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_BLEND_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_BLEND_INL_H_
#endif

#include "runtime/generation/motion/geometry-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

// Colours of kPixels pixels in planes, in [0, 1].
struct alignas(64) ColorPlanes {
  alignas(64) float c[3][kPixels];
};

template <class T>
HWY_INLINE void LoadPlanesOf(const T* from, float scale, ColorPlanes& to) {
  const FloatTag d;
  alignas(64) float channels[4 * kPixels];
  for (int i = 0; i < 4 * kPixels; i += kLanes) {
    const auto value = hn::Mul(LoadChannels(from + i), hn::Set(d, scale));
    const auto limited = hn::Min(value, hn::Set(d, 1.0f));
    hn::Store(hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), limited), d, channels + i);
  }
  for (int i = 0; i < kPixels; i += kLanes) {
    Floats r, g, b, a;
    hn::LoadInterleaved4(d, channels + 4 * i, r, g, b, a);
    hn::Store(r, d, to.c[0] + i);
    hn::Store(g, d, to.c[1] + i);
    hn::Store(b, d, to.c[2] + i);
  }
}

// LoadRgb of `count` pixels; what follows them is zero.
HWY_INLINE void LoadPlanes(const ImageView& image, int x, int y, int count, ColorPlanes& to) {
  alignas(64) std::byte padded[16 * kPixels];
  const void* from = image.At(x, y);
  if (count < kPixels) {
    std::memset(padded, 0, sizeof(padded));
    std::memcpy(padded, from, static_cast<std::size_t>(count) * BytesPerPixel(image.format));
    from = padded;
  }
  const float scale = 1.0f / ChannelScale(image.format);
  switch (image.format) {
    case PixelFormat::kRgba8:
      LoadPlanesOf(static_cast<const std::uint8_t*>(from), scale, to);
      break;
    case PixelFormat::kRgba16F:
      LoadPlanesOf(static_cast<const hwy::float16_t*>(from), scale, to);
      break;
    default:
      LoadPlanesOf(static_cast<const float*>(from), scale, to);
      break;
  }
}

// StoreRgb of `count` pixels.
HWY_INLINE void StorePlanes(const ColorPlanes& from, int count, int x, int y,
                            const MutableImageView& out) {
  const FloatTag d;
  alignas(64) float channels[4 * kPixels];
  const auto scale = hn::Set(d, ChannelScale(out.format));
  for (int i = 0; i < kPixels; i += kLanes) {
    hn::StoreInterleaved4(hn::Mul(hn::Load(d, from.c[0] + i), scale),
                          hn::Mul(hn::Load(d, from.c[1] + i), scale),
                          hn::Mul(hn::Load(d, from.c[2] + i), scale), scale, d, channels + 4 * i);
  }
  StoreChannels(out.format, channels, 4 * count, out.At(x, y));
}

// DepthBits of the 3 x 3 pixels around kLanes pixels that follow each other from (x, y) on, the
// least of each; columns x - 1 to x + kLanes lie in the image.
HWY_INLINE auto LeastDepthBits(const ImageView& depth, int x, int y) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  auto least = hn::BitCast(du, hn::Set(d, kFarthestDepth));
  for (int j = -1; j <= 1; ++j) {
    const float* row = depth.Row<float>(std::clamp(y + j, 0, depth.height - 1)) + x;
    for (int i = -1; i <= 1; ++i) {
      least = hn::Min(least, hn::BitCast(du, hn::Add(hn::LoadU(d, row + i), hn::Zero(d))));
    }
  }
  return least;
}

// LeastDepthAround of kLanes pixels, given that they lie in the image.
HWY_INLINE void FindLeastDepths(const ImageView& depth, Ints x, Ints y, float* HWY_RESTRICT to) {
  const FloatTag d;
  const IntTag di;
  const TwoRuns runs(x, y, depth.width);
  const auto apart = [&](int first) { return first > 0 && first + kLanes < depth.width; };
  if (runs.found && apart(runs.x0) && apart(runs.x1)) {
    auto least = hn::BitCast(d, LeastDepthBits(depth, runs.x0, runs.y0));
    if (!hn::AllTrue(d, runs.first)) {
      least = hn::IfThenElse(runs.first, least,
                             hn::BitCast(d, LeastDepthBits(depth, runs.x1, runs.y1)));
    }
    hn::Store(least, d, to);
    return;
  }
  alignas(64) std::int32_t px[kLanes], py[kLanes];
  hn::Store(x, di, px);
  hn::Store(y, di, py);
  for (int i = 0; i < kLanes; ++i) to[i] = LeastDepthAround(depth, px[i], py[i]);
}

// Where the pixels of a row lie in one frame, and the least depth around.
struct alignas(64) SourcePixels {
  alignas(64) float inside[kPixels];  // 1 or 0
  alignas(64) float depth[kPixels];
};

HWY_INLINE void FindSources(const GenerationJob& job, const MotionView& motion,
                            const ImageView& depth, int x0, int y, int count, SourcePixels& to) {
  const FloatTag d;
  alignas(64) float padded[2 * kPixels];
  const float* from = Padded(motion.Row(y) + 2 * x0, 2 * count, 2 * kPixels, padded);
  for (int i = 0; i < kPixels; i += kLanes) {
    Floats mx, my;
    hn::LoadInterleaved2(d, from + 2 * i, mx, my);
    const auto p =
        FindNearest(job, PixelNumbers(x0 + i), static_cast<float>(y), hn::Neg(mx), hn::Neg(my));
    if (DepthOf(job.options) != DepthMeasure::kNone) {
      FindLeastDepths(depth, p.x, p.y, to.depth + i);
    }
    hn::Store(hn::IfThenElseZero(p.inside, hn::Set(d, 1.0f)), d, to.inside + i);
  }
}

HWY_INLINE Floats Brightnesses(const ColorPlanes& color, int i) {
  const FloatTag d;
  const auto rg = hn::Add(hn::Mul(hn::Set(d, kBrightnessWeights[0]), hn::Load(d, color.c[0] + i)),
                          hn::Mul(hn::Set(d, kBrightnessWeights[1]), hn::Load(d, color.c[1] + i)));
  return hn::Add(rg, hn::Mul(hn::Set(d, kBrightnessWeights[2]), hn::Load(d, color.c[2] + i)));
}

// InterpolationShare.
HWY_INLINE Floats InterpolationShares(const GenerationJob& job, Floats depth, Floats brightness) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0f);
  const float width = job.options.gate_width;
  const auto frame0 = hn::Sub(one, Gates(depth, job.depth_threshold(), width));
  const auto frame1 = hn::Sub(one, Gates(hn::Neg(depth), job.depth_threshold(), width));
  const auto alike = Gates(hn::Abs(brightness), job.brightness_threshold(), width);
  const auto nearer = hn::Set(d, job.alpha >= 0.5f ? 1.0f : 0.0f);
  const auto blended =
      hn::Add(hn::Mul(alike, nearer), hn::Mul(hn::Sub(one, alike), hn::Set(d, job.alpha)));
  return hn::Add(frame1, hn::Mul(hn::Sub(hn::Sub(one, frame0), frame1), blended));
}

// FrameShare of kLanes pixels.
HWY_INLINE Floats FrameShares(const GenerationJob& job, const SourcePixels& source0,
                              const SourcePixels& source1, Floats brightness, int i) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0f);
  const DepthMeasure measure = DepthOf(job.options);
  const auto depth = measure == DepthMeasure::kNone
                         ? zero
                         : DepthDifferences(measure, hn::Load(d, source0.depth + i),
                                            hn::Load(d, source1.depth + i));
  const auto inside0 = hn::Gt(hn::Load(d, source0.inside + i), zero);
  const auto inside1 = hn::Gt(hn::Load(d, source1.inside + i), zero);
  const auto share = InterpolationShares(job, depth, brightness);
  const auto without1 =
      hn::IfThenElseZero(hn::Not(inside0), hn::Set(d, job.alpha >= 0.5f ? 1.0f : 0.0f));
  return hn::IfThenElse(inside1, hn::IfThenElse(inside0, share, one), without1);
}

inline void BlendRow(const GenerationJob& job, const WarpedFrames& warped, int y,
                     const MutableImageView& out) {
  const FloatTag d;
  const ImageView warped0 = InFormat(kWarpedFrameFormat, warped.color0);
  const ImageView warped1 = InFormat(kWarpedFrameFormat, warped.color1);
  const MutableImageView blended = InFormat(kBlendedFrameFormat, out);
  ColorPlanes color, color0;
  SourcePixels source0, source1;
  for (int x0 = 0; x0 < job.width(); x0 += kPixels) {
    const int count = std::min(kPixels, job.width() - x0);
    LoadPlanes(warped1, x0, y, count, color);
    if (job.Interpolates()) {
      LoadPlanes(warped0, x0, y, count, color0);
      FindSources(job, warped.from0, job.depth0, x0, y, count, source0);
      FindSources(job, warped.from1, job.depth1, x0, y, count, source1);
      for (int i = 0; i < kPixels; i += kLanes) {
        const auto brightness = GatesBrightness(job.options)
                                    ? hn::Sub(Brightnesses(color0, i), Brightnesses(color, i))
                                    : hn::Set(d, kUnlike);
        const auto share = FrameShares(job, source0, source1, brightness, i);
        for (int c = 0; c < 3; ++c) {
          const auto c0 = hn::Load(d, color0.c[c] + i);
          const auto difference = hn::Sub(hn::Load(d, color.c[c] + i), c0);
          hn::Store(hn::Add(c0, hn::Mul(share, difference)), d, color.c[c] + i);
        }
      }
    }
    StorePlanes(color, count, x0, y, blended);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
