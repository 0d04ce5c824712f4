#include "runtime/frame_generation.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/configuration/chosen.h"
#include "runtime/float_environment.h"
#include "runtime/generation/band_buffers.h"
#include "runtime/generation/color_repair.h"
#include "runtime/generation/drawn_anew.h"
#include "runtime/generation/frame_check.h"
#include "runtime/generation/frame_coefficients.h"
#include "runtime/generation/hdr_rows.h"
#include "runtime/generation/row_kernels.h"
#include "runtime/hud.h"
#include "runtime/motion_filter.h"
#include "runtime/peers/generation/generation_peer.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {

using namespace generation;

namespace {

constexpr int kSplatRows = 2 * kBandRows;  // of the generated frame that are splatted to together

RowKernels OwnKernelsOf(const FrameGenerationOptions& options) {
  if constexpr (kPipeline.reference) {
    if (options.reference) return ReferenceRowKernels();
  }
  return FastRowKernels();
}

RowKernels KernelsOf(const FrameGenerationOptions& options) {
  const RowKernels own = OwnKernelsOf(options);
  if constexpr (kPipeline.peers) {
    if (options.peer == nullptr) return own;
    return IsReference(options) ? options.peer->reference(own) : options.peer->fast(own);
  }
  return own;
}

}  // namespace

struct WARPLUT_HIDDEN FrameGeneration::State {
  using Source = FrameCoefficients::Source;

  State(const FrameGenerationOptions& frame_options, Executor& threads);

  // Calls work(band, buffers) for bands of `rows` rows, each once.
  template <class Work>
  void ForBands(int rows, const Work& work) {
    ForEachBand(executor, options.height, rows, bands, work);
  }

  void Generate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                bool interpolates, const MutableImageView& out);
  void Show(const ImageView& color, const MutableImageView& out);

  void FindStillSurface(GenerationJob& job, const ImageView& moving);
  void DrawOver(const ImageView& drawn, const MutableImageView& out);
  void FilterMotion(GenerationJob& job);
  void Splat(const GenerationJob& job);
  void WarpDisplay(const GenerationJob& job, const Source& frame0, const Source& frame1,
                   const MutableImageView& out);
  void WarpHdr(const GenerationJob& job, const ImageView& color0, const ImageView& color1,
               const MutableImageView& out);
  void EncodeRows(const ImageView& linear, const Band& band, const MutableImageView& to) const;
  void DecodeRows(const ImageView& from, const Band& band, const MutableImageView& out) const;
  void FindMotion(const GenerationJob& job, const Band& band, BandBuffers& buffers) const;
  void WarpBand(const PrefilteredImage& image, const MotionView& motion, const Band& band,
                BandBuffers& buffers, const MutableImageView& to) const;
  void BlendBand(const GenerationJob& job, const WarpedFrames& warped, const Band& band,
                 const MutableImageView& out) const;

  // Whether frames are turned into coefficients: for the compiler false where no filter of the
  // build has a prefilter.
  bool Prefilters() const { return kContainsPrefilter && static_cast<bool>(coefficients); }
  MutableMotionView Forward() const {
    return {reinterpret_cast<float*>(forward.data()), options.width, options.height,
            std::ptrdiff_t{options.width} * 2 * static_cast<std::ptrdiff_t>(sizeof(float))};
  }
  KeyView Keys() const { return {reinterpret_cast<SplatKey*>(keys.data()), options.width}; }

  FrameGenerationOptions options;
  Executor& executor;
  RowKernels kernels;
  // With splatting.
  RowBuffer forward;            // displacements, one row of pixels after the other
  RowBuffer keys;               // likewise
  std::vector<RowRange> reach;  // of each row of frame 1: the rows at which it arrives

  ImageBuffer codes;               // kLinearHdr: the frame that is being warped
  FrameCoefficients coefficients;  // with a prefilter
  ImageBuffer still_depth;         // with a peer that projects
  RowBuffer still_columns;         // likewise
  std::unique_ptr<MotionFilter> filter;
  MotionBuffer filtered0, filtered1;  // with a motion filter
  std::vector<BandBuffers> bands;     // one for each worker
  std::int64_t tiles = 0;             // of the last frame
};

inline FrameGeneration::State::State(const FrameGenerationOptions& frame_options, Executor& threads)
    : options(frame_options), executor(threads), kernels(KernelsOf(options)) {
  const int width = options.width, height = options.height;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (Splats(options)) {
    const std::size_t least = Projects(options) ? options.peer->buffer_bytes(width, height) : 0;
    forward = RowBuffer(std::max(pixels * 2 * sizeof(float), least), 1);
    keys = RowBuffer(pixels * sizeof(SplatKey), 1);
    reach.resize(static_cast<std::size_t>(height));
  }
  if (Projects(options)) {
    still_depth = ImageBuffer(width, height, PixelFormat::kR32F);
    still_columns = RowBuffer(pixels * sizeof(std::int32_t), 1);
  }
  if (EncodingOf(options) == ColorEncoding::kLinearHdr) {
    codes = ImageBuffer(width, height, PixelFormat::kRgba32F);
  }
  if (PrefiltersFrames(options)) {
    const Prefilter prefilter = PrefilterOf(options.warp);
    coefficients = FrameCoefficients(prefilter, options, executor.Threads());
  }
  if (FiltersMotion(options)) {
    filter = std::make_unique<MotionFilter>(width, height,
                                            MotionFilterOptions{options.motion_filter_limit});
    filtered0 = MotionBuffer(width, height);
    filtered1 = MotionBuffer(width, height);
  }
  for (int i = 0; i < executor.Threads(); ++i) bands.emplace_back(width);
}

// Frame 1 of the job becomes what stands still of it.
inline void FrameGeneration::State::FindStillSurface(GenerationJob& job, const ImageView& moving) {
  auto* columns = reinterpret_cast<std::int32_t*>(still_columns.data());
  ForBands(kBandRows, [&](const Band& band, BandBuffers&) {
    for (int y = band.first; y < band.last; ++y) {
      FindStillRow(job.depth1, moving, y, still_depth.view(),
                   columns + std::ptrdiff_t{y} * options.width);
    }
  });
  job.depth1 = std::as_const(still_depth).view();
  job.still_column = columns;
}

inline void FrameGeneration::State::DrawOver(const ImageView& drawn, const MutableImageView& out) {
  ForBands(kBandRows, [&](const Band& band, BandBuffers&) {
    const bool linear = EncodingOf(options) == ColorEncoding::kLinearHdr;
    for (int y = band.first; y < band.last; ++y) DrawOverRow(drawn, linear, y, out);
  });
}

inline void FrameGeneration::State::FilterMotion(GenerationJob& job) {
  if (!FiltersMotion(options)) return;
  const auto apply = [&](const ImageView& depth, MotionBuffer& filtered, MotionView& motion) {
    if (IsReference(options)) {
      MotionFilter::Reference(depth, motion, {options.motion_filter_limit}, filtered.view());
    } else {
      filter->Apply(depth, motion, executor, filtered.view());
    }
    motion = filtered.view();
  };
  apply(job.depth1, filtered1, job.motion1);
  if (job.CountsMotion0()) apply(job.depth0, filtered0, job.motion0);
}

inline void FrameGeneration::State::Splat(const GenerationJob& job) {
  ForBands(kBandRows, [&](const Band& band, BandBuffers&) {
    for (int y = band.first; y < band.last; ++y) reach[y] = kernels.forward(job, y, Forward());
  });
  ForBands(kSplatRows, [&](const Band& band, BandBuffers&) {
    std::fill(Keys().Row(band.first), Keys().Row(band.last), kNoSplat);
    for (int y = 0; y < options.height; ++y) {
      if (reach[y].first >= band.last || reach[y].last <= band.first) continue;
      kernels.splat(job, Forward(), y, {band.first, band.last}, Keys());
    }
  });
}

inline void FrameGeneration::State::FindMotion(const GenerationJob& job, const Band& band,
                                               BandBuffers& buffers) const {
  const MutableMotionView from0 = band.Motion(buffers.from0), from1 = band.Motion(buffers.from1);
  if (!Splats(options)) {
    for (int y = band.first; y < band.last; ++y) {
      kernels.forward(job, y, from1);
      kernels.own_motion(job, y, from0, from1);
    }
    return;
  }
  std::vector<std::uint8_t>& disoccluded = buffers.disoccluded;
  std::fill(disoccluded.begin(), disoccluded.end(), std::uint8_t{0});
  for (int y = band.first; y < band.last; ++y) {
    kernels.target_motion(job, {Forward(), Keys()}, y, from0, from1, disoccluded.data());
  }
  for (const std::uint8_t tile : disoccluded) buffers.tiles.disoccluded += tile;
}

// Without prefilter `image` has no coefficients.
inline void FrameGeneration::State::WarpBand(const PrefilteredImage& image,
                                             const MotionView& motion, const Band& band,
                                             BandBuffers& buffers,
                                             const MutableImageView& to) const {
  const ImageView& color = image.samples;
  const WarpOptions& warp = options.warp;
  if (IsReference(options)) {
    const TileRect rows = {0, band.first, to.width, band.last};
    WarpReferencePixels(
        Prefilters() ? WarpJob(image, motion, warp, to) : WarpJob(color, motion, warp, to), rows);
  } else if (Prefilters()) {
    buffers.tiles.warped += WarpRows(image, motion, warp, band.first, band.last, to);
  } else {
    buffers.tiles.warped += WarpRows(color, motion, warp, band.first, band.last, to);
  }
  if (EncodingOf(options) == ColorEncoding::kLinearHdr) {
    for (int y = band.first; y < band.last; ++y) LimitHdrRow(color, motion, y, to);
    return;
  }
  if (Choose(kWarpedFrameFormat, to.format) == PixelFormat::kRgba8) return;
  for (int y = band.first; y < band.last; ++y) RepairRow(color, motion, options.warp, y, to);
}

inline void FrameGeneration::State::BlendBand(const GenerationJob& job, const WarpedFrames& warped,
                                              const Band& band, const MutableImageView& out) const {
  for (int y = band.first; y < band.last; ++y) kernels.blend(job, warped, y, out);
}

inline void FrameGeneration::State::WarpDisplay(const GenerationJob& job, const Source& frame0,
                                                const Source& frame1, const MutableImageView& out) {
  PrefilteredImage color0{frame0.samples, {}}, color1{frame1.samples, {}};
  if (Prefilters() && job.Interpolates()) {
    const auto both = coefficients.OfBoth(frame0, frame1, executor);
    color0 = both[0];
    color1 = both[1];
  } else if (Prefilters()) {
    color1 = coefficients.Of(frame1, executor);
  }
  ForBands(kBandRows, [&](const Band& band, BandBuffers& buffers) {
    FindMotion(job, band, buffers);
    const MutableMotionView from0 = band.Motion(buffers.from0), from1 = band.Motion(buffers.from1);
    const MutableImageView warped0 =
        band.Image(buffers.color0, color0.samples.format, options.width);
    const MutableImageView warped1 =
        band.Image(buffers.color1, color1.samples.format, options.width);
    if (job.Interpolates()) WarpBand(color0, from0, band, buffers, warped0);
    WarpBand(color1, from1, band, buffers, warped1);
    BlendBand(job, {warped0, warped1, from0, from1}, band, out);
  });
}

inline void FrameGeneration::State::EncodeRows(const ImageView& linear, const Band& band,
                                               const MutableImageView& to) const {
  for (int y = band.first; y < band.last; ++y) kernels.encode_hdr(linear, y, to);
}

inline void FrameGeneration::State::DecodeRows(const ImageView& from, const Band& band,
                                               const MutableImageView& out) const {
  for (int y = band.first; y < band.last; ++y) kernels.decode_hdr(from, y, out);
}

// One frame after the other is encoded and warped; the output keeps what came of frame 1 in
// between.
inline void FrameGeneration::State::WarpHdr(const GenerationJob& job, const ImageView& color0,
                                            const ImageView& color1, const MutableImageView& out) {
  constexpr PixelFormat kFormat = PixelFormat::kRgba32F;
  const auto encode = [&](const ImageView& color) {
    ForBands(kBandRows,
             [&](const Band& band, BandBuffers&) { EncodeRows(color, band, codes.view()); });
    const ImageView samples = std::as_const(codes).view();
    return Prefilters() ? coefficients.Of({samples}, executor) : PrefilteredImage{samples, {}};
  };
  const PrefilteredImage codes1 = encode(color1);
  ForBands(kBandRows, [&](const Band& band, BandBuffers& buffers) {
    FindMotion(job, band, buffers);
    const MutableImageView warped1 = band.Image(buffers.color1, kFormat, options.width);
    WarpBand(codes1, band.Motion(buffers.from1), band, buffers, warped1);
    DecodeRows(warped1, band, out);
  });
  if (!job.Interpolates()) return;
  const PrefilteredImage codes0 = encode(color0);
  for (BandBuffers& worker : bands) worker.tiles.disoccluded = 0;  // they are found again
  ForBands(kBandRows, [&](const Band& band, BandBuffers& buffers) {
    FindMotion(job, band, buffers);
    const MutableMotionView from0 = band.Motion(buffers.from0), from1 = band.Motion(buffers.from1);
    const MutableImageView warped0 = band.Image(buffers.color0, kFormat, options.width);
    const MutableImageView warped1 = band.Image(buffers.color1, kFormat, options.width);
    WarpBand(codes0, from0, band, buffers, warped0);
    EncodeRows(out, band, warped1);
    BlendBand(job, {warped0, warped1, from0, from1}, band, warped1);
    DecodeRows(warped1, band, out);
  });
}

inline void FrameGeneration::State::Generate(const DisplayedFrame& frame0,
                                             const DisplayedFrame& frame1, float alpha,
                                             bool interpolates, const MutableImageView& out) {
  const bool motion0_counts = ModelOf(options) != MotionModel::kLinear && !frame0.cut;
  GenerationJob job{options,      interpolates, alpha,         motion0_counts,
                    frame0.depth, frame1.depth, frame0.motion, frame1.motion};
  const Reprojection* known = Projects(options) ? frame1.reprojection : nullptr;
  std::optional<PointCarrier> carrier;
  if (known != nullptr) carrier = PointCarrier::Of(*known, options.width, options.height);
  if (carrier) job.carrier = &*carrier;
  for (BandBuffers& worker : bands) worker.tiles = {};
  tiles =
      std::int64_t{TileCount(options.width, kTileWidth)} * TileCount(options.height, kTileHeight);
  FilterMotion(job);
  if (known != nullptr && known->moving.data != nullptr) FindStillSurface(job, known->moving);
  if (Splats(options)) Splat(job);
  if (EncodingOf(options) == ColorEncoding::kLinearHdr) {
    WarpHdr(job, frame0.color, frame1.color, out);
  } else {
    WarpDisplay(job, {frame0.color, frame0.id}, {frame1.color, frame1.id}, out);
  }
  if (known != nullptr && known->drawn.data != nullptr) DrawOver(known->drawn, out);
}

// `color` as it is, in the format of `out`.
inline void FrameGeneration::State::Show(const ImageView& color, const MutableImageView& out) {
  for (BandBuffers& worker : bands) worker.tiles = {};
  tiles = 0;
  ForBands(kBandRows, [&](const Band& band, BandBuffers&) {
    for (int y = band.first; y < band.last; ++y) {
      for (int x = 0; x < options.width; ++x) {
        const void* pixel = color.At(x, y);
        StoreRgb(EncodingOf(options) == ColorEncoding::kLinearHdr ? LoadHdr(color.format, pixel)
                                                                  : LoadRgb(color.format, pixel),
                 out.format, out.At(x, y));
      }
    }
  });
}

FrameGeneration::FrameGeneration(const FrameGenerationOptions& options, Executor& executor) {
  const FloatEnvironment environment;
  if constexpr (kContainsGeneration) state_ = std::make_unique<State>(options, executor);
}

FrameGeneration::~FrameGeneration() = default;

void FrameGeneration::Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1,
                                  float alpha, const MutableImageView& out) {
  const FloatEnvironment environment;
  if constexpr (kPipeline.interpolation) {
    if (frame1.cut) {
      state_->Show(alpha < 0.5f ? frame0.color : frame1.color, out);
    } else {
      state_->Generate(frame0, frame1, alpha, true, out);
    }
    DrawHud(alpha < 0.5f ? frame0.hud : frame1.hud, EncodingOf(state_->options), state_->executor,
            out);
  }
}

void FrameGeneration::Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1,
                                  float alpha, const MutableImageView& out) {
  const FloatEnvironment environment;
  if constexpr (kPipeline.extrapolation) {
    if (frame1.cut) {
      state_->Show(frame1.color, out);
    } else {
      state_->Generate(frame0, frame1, alpha, false, out);
    }
    DrawHud(frame1.hud, EncodingOf(state_->options), state_->executor, out);
  }
}

bool FrameGeneration::IsGenerable(const DisplayedFrame& frame0, const DisplayedFrame& frame1,
                                  float alpha, const MutableImageView& out,
                                  std::string* why) const {
  return AreGenerable(state_->options, frame0, frame1, alpha, out, why);
}

void FrameGeneration::SetParameters(const Parameters& parameters, float gate_width) {
  state_->options.parameters = parameters;
  state_->options.gate_width = gate_width;
}

FrameTiles FrameGeneration::Tiles() const {
  FrameTiles tiles;
  tiles.total = state_->tiles;
  for (const BandBuffers& band : state_->bands) tiles += band.tiles;
  return tiles;
}

std::size_t FrameGeneration::MemoryBytes() const {
  std::size_t bytes =
      state_->forward.size() + state_->keys.size() + state_->reach.size() * sizeof(RowRange) +
      state_->codes.bytes() + state_->filtered0.bytes() + state_->filtered1.bytes() +
      state_->coefficients.bytes() + state_->still_depth.bytes() + state_->still_columns.size();
  if (state_->filter != nullptr) bytes += state_->filter->MemoryBytes();
  for (const BandBuffers& band : state_->bands) bytes += band.bytes();
  return bytes;
}

}  // namespace warplut
