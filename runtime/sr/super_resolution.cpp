#include "runtime/super_resolution.h"

#include <utility>
#include <vector>

#include "runtime/configuration/chosen.h"
#include "runtime/float_environment.h"
#include "runtime/motion_filter.h"
#include "runtime/peers/sr/sr_peer.h"
#include "runtime/prefilter.h"
#include "runtime/sr/frame_check.h"
#include "runtime/sr/passes.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {
namespace {

const SrPasses& OwnPassesOf(const SuperResolutionOptions& options) {
  if constexpr (kPipeline.reference) {
    if (options.reference) return ReferencePasses();
  }
  return FastPasses();
}

// Null passes without a peer.
SrPeerPasses PeerPassesOf(const SuperResolutionOptions& options) {
  if constexpr (kPipeline.peers) {
    const SrPeer* peer = options.peer;
    if (peer != nullptr) return IsReference(options) ? peer->reference() : peer->fast();
  }
  return {};
}

SrPasses PassesOf(const SuperResolutionOptions& options) {
  SrPasses passes = OwnPassesOf(options);
  const SrPeerPasses peer = PeerPassesOf(options);
  if (peer.update != nullptr) passes.update = peer.update;
  return passes;
}

bool KeepsState(const SuperResolutionOptions& options) {
  return kPipeline.peers && options.peer != nullptr && options.peer->keeps_state;
}

// With the filter of the peer, if there is one.
SuperResolutionOptions EffectiveOptions(SuperResolutionOptions options) {
  if (kPipeline.peers && options.peer != nullptr) options.warp = {.filter = options.peer->filter};
  return options;
}

}  // namespace

SrScratch::SrScratch(const SuperResolutionOptions& options)
    : render_rows(options.render_width, kRenderRows),
      disoccluded(static_cast<std::size_t>(TileCount(options.output_width, kTileWidth))) {
  const int width = options.output_width;
  if (WarpsHistory(options)) motion = MotionBuffer(width, kBandRows);
  if (WarpsHistory(options) || ReadsReactive(options) || PassesOf(options).always_validity)
    validity = Plane(width, kBandRows);
  output_rows = Plane(width, kOutputRows);
}

std::size_t SrScratch::bytes() const {
  return motion.bytes() + validity.bytes() + render_rows.bytes() + output_rows.bytes() +
         disoccluded.size();
}

struct WARPLUT_HIDDEN SuperResolution::State {
  State(const SuperResolutionOptions& chosen, Executor& runner);

  SrJob Job() const;
  // Calls pass(begin, end, scratch) for bands of rows.
  template <class Pass>
  void ForBands(int rows, const Pass& pass) {
    ForEachBand(executor, rows, kBandRows, scratch,
                [&](const Band& band, SrScratch& worker) { pass(band.first, band.last, worker); });
  }

  MotionView Filtered(const RenderedFrame& frame);
  void SetRenderSize(int width, int height);
  void FitBuffers();  // to the render size of the options
  void PrefilterHistory();
  void Predict(const SrJob& job);
  void PredictPeer(const SrJob& job, const Band& rows, SrScratch& worker);
  void Process(const RenderedFrame& frame, const MutableImageView& out);

  SuperResolutionOptions options;
  Executor& executor;
  const SrPasses passes;
  const SrPeerPasses peer_passes;
  AxisMap x, y;
  RenderPlanes planes;
  Plane nearest_before, farthest_before;  // with a depth gate
  Plane reactive_before;                  // with a reactive mask
  Plane residual[3];                      // in the residual and the adaptive form
  AliasingMap aliasing;                   // in the adaptive form
  ImageBuffer history;                    // where it is warped
  std::unique_ptr<PrefilterPass> prefilter;
  ImageBuffer coefficients;  // of the history, with a prefilter
  ImageBuffer next;
  ImageBuffer state, next_state;  // of a peer that keeps one
  std::unique_ptr<MotionFilter> filter;
  MotionBuffer filtered;
  std::vector<SrScratch> scratch;
  ImageBuffer geometry_depth;
  MotionBuffer geometry_motion;
  AxisBefore x_before, y_before;
  const int most_width, most_height;  // of rendered frames
  bool has_history = false;           // the frame before is kept
  bool is_cut = true;                 // the last frame shared nothing with one before
  bool has_geometry = false;          // the geometry buffers are those of the last frame
};

inline SuperResolution::State::State(const SuperResolutionOptions& chosen, Executor& runner)
    : options(EffectiveOptions(chosen)),
      executor(runner),
      passes(PassesOf(options)),
      peer_passes(PeerPassesOf(options)),
      x(options.render_width, options.output_width),
      y(options.render_height, options.output_height),
      planes(options.render_width, options.render_height, ReadsMotion(options),
             ReadsReactive(options)),
      next(options.output_width, options.output_height, HistoryFormatOf(options)),
      most_width(options.render_width),
      most_height(options.render_height) {
  const auto plane = [&] { return Plane(options.render_width, options.render_height); };
  if (DepthOf(options) != DepthMeasure::kNone) {
    nearest_before = plane();
    farthest_before = plane();
  }
  if (ReadsReactive(options)) reactive_before = plane();
  if (HasResidual(options)) {
    for (Plane& channel : residual) channel = plane();
  }
  if (SmoothsAliasing(options)) {
    aliasing = AliasingMap(options.render_width, options.render_height, x.scale() * y.scale(),
                           CodeContrast(EncodingOf(options)));
  }
  if (WarpsHistory(options)) {
    history = ImageBuffer(options.output_width, options.output_height, HistoryFormatOf(options));
  }
  if (PrefiltersHistory(options)) {
    prefilter = std::make_unique<PrefilterPass>(PrefilterOf(options.warp), options.output_width,
                                                options.output_height, executor.Threads());
    coefficients = ImageBuffer(options.output_width, options.output_height,
                               CoefficientFormat(HistoryFormatOf(options)));
  }
  if (KeepsState(options)) {
    for (ImageBuffer* image : {&state, &next_state}) {
      *image = ImageBuffer(options.output_width, options.output_height, PixelFormat::kRgba16F);
    }
  }
  if (FiltersMotion(options)) {
    filter = std::make_unique<MotionFilter>(options.render_width, options.render_height,
                                            MotionFilterOptions{});
    filtered = MotionBuffer(options.render_width, options.render_height);
  }
  for (int i = 0; i < executor.Threads(); ++i) scratch.emplace_back(options);
}

inline SrJob SuperResolution::State::Job() const {
  return {options,
          x,
          y,
          planes,
          nearest_before,
          farthest_before,
          reactive_before,
          x_before,
          y_before,
          has_history,
          history.view(),
          coefficients.view(),
          {},
          {},
          residual,
          &aliasing};
}

// The planes stay those of the last frame, for its geometry, until the next one fills them.
inline void SuperResolution::State::SetRenderSize(int width, int height) {
  if (width == options.render_width && height == options.render_height) return;
  options.render_width = width;
  options.render_height = height;
  if (filter) filter = std::make_unique<MotionFilter>(width, height, MotionFilterOptions{});
}

inline void SuperResolution::State::FitBuffers() {
  const int width = options.render_width, height = options.render_height;
  if (x.render() == width && y.render() == height) return;
  x.SetRender(width);
  y.SetRender(height);
  planes.SetSize(width, height);
  for (Plane& channel : residual) channel.SetSize(width, height);
  if (SmoothsAliasing(options)) aliasing.SetSize(width, height, x.scale() * y.scale());
  for (SrScratch& worker : scratch) worker.SetRenderWidth(width);
}

inline MotionView SuperResolution::State::Filtered(const RenderedFrame& frame) {
  if (!FiltersMotion(options)) return frame.motion;
  if (IsReference(options)) {
    MotionFilter::Reference(frame.depth, frame.motion, {}, filtered.view());
  } else {
    filter->Apply(frame.depth, frame.motion, executor, filtered.view());
  }
  return filtered.view();
}

inline void SuperResolution::State::PrefilterHistory() {
  if (!has_history || !PrefiltersHistory(options)) return;
  const ImageView samples = std::as_const(history).view();
  if (IsReference(options)) {
    PrefilterPass::Reference(PrefilterOf(options.warp), samples, coefficients.view());
  } else {
    prefilter->Apply(samples, executor, coefficients.view());
  }
}

inline void SuperResolution::State::Predict(const SrJob& job) {
  for (SrScratch& worker : scratch) worker.tiles = {};
  ForBands(options.output_height, [&](int begin, int end, SrScratch& worker) {
    std::fill(worker.disoccluded.begin(), worker.disoccluded.end(), std::uint8_t{0});
    passes.predict(job, begin, end, worker);
    if constexpr (kPipeline.peers) PredictPeer(job, {begin, end}, worker);
    for (const std::uint8_t tile : worker.disoccluded) worker.tiles.disoccluded += tile;
    if (job.HasHistory() && !WarpsHistory(options)) {
      worker.tiles.warped.tiles[static_cast<int>(MotionKind::kStatic)] +=
          static_cast<std::int64_t>(worker.disoccluded.size());
    }
  });
}

// What a peer does to a band that was predicted: its state moves with the history.
inline void SuperResolution::State::PredictPeer(const SrJob& job, const Band& rows,
                                                SrScratch& worker) {
  if (!job.HasHistory()) return;
  if (KeepsState(options)) {
    const ImageView before = std::as_const(state).view();
    const MotionView motion = rows.Motion(worker.motion);
    const WarpOptions bilinear = {.filter = Filter::kBilinear};
    if (IsReference(options)) {
      WarpReferencePixels(WarpJob(before, motion, bilinear, job.next_state),
                          {0, rows.first, options.output_width, rows.last});
    } else {
      WarpRows(before, motion, bilinear, rows.first, rows.last, job.next_state);
    }
  }
  if (peer_passes.limit != nullptr) peer_passes.limit(job, rows.first, rows.last, worker);
}

inline void SuperResolution::State::Process(const RenderedFrame& frame,
                                            const MutableImageView& out) {
  const int render_rows = options.render_height;
  FitBuffers();
  x.SetJitter(frame.jitter_x);
  y.SetJitter(frame.jitter_y);
  is_cut = !has_history || frame.cut;
  has_history = !is_cut && KeepsHistory(options);
  has_geometry = false;

  const MotionView motion = Filtered(frame);
  ForBands(render_rows, [&](int begin, int end, SrScratch&) {
    passes.fill_planes(options, frame, motion, begin, end, planes);
  });
  SrJob job = Job();
  job.next = next.view();
  job.next_state = next_state.view();
  PrefilterHistory();
  Predict(job);
  if (HasResidual(options)) {
    ForBands(render_rows, [&](int begin, int end, SrScratch&) {
      passes.residual(job, begin, end, residual, aliasing);
    });
  }
  if (SmoothsAliasing(options)) aliasing.Finish();
  ForBands(options.output_height, [&](int begin, int end, SrScratch& worker) {
    passes.update(job, begin, end, worker, out);
  });
  if (DepthOf(options) != DepthMeasure::kNone) {
    ForBands(render_rows, [&](int begin, int end, SrScratch&) {
      passes.depth_range(planes.depth, begin, end, nearest_before, farthest_before);
    });
  }
  if (ReadsReactive(options)) {
    ForBands(render_rows, [&](int begin, int end, SrScratch&) {
      passes.reactive_reach(planes.reactive, begin, end, reactive_before);
    });
  }
  if (WarpsHistory(options)) std::swap(history, next);
  std::swap(state, next_state);
  x_before = x.AsBefore();
  y_before = y.AsBefore();
  has_history = true;
}

SuperResolution::SuperResolution(const SuperResolutionOptions& options, Executor& executor) {
  const FloatEnvironment environment;
  if constexpr (kPipeline.super_resolution) state_ = std::make_unique<State>(options, executor);
}

SuperResolution::~SuperResolution() = default;

bool SuperResolution::IsProcessable(const RenderedFrame& frame, const MutableImageView& out,
                                    std::string* why) const {
  return IsFrameProcessable(state_->options, frame, out, why);
}

void SuperResolution::Process(const RenderedFrame& frame, const MutableImageView& out) {
  const FloatEnvironment environment;
  if constexpr (kPipeline.super_resolution) state_->Process(frame, out);
}

OutputGeometry SuperResolution::Geometry() {
  const FloatEnvironment environment;
  State& s = *state_;
  if (s.geometry_motion.bytes() == 0) {
    s.geometry_depth =
        ImageBuffer(s.options.output_width, s.options.output_height, PixelFormat::kR32F);
    s.geometry_motion = MotionBuffer(s.options.output_width, s.options.output_height);
  }
  if (!s.has_geometry) {
    const SrJob job = s.Job();
    const MutableImageView depth = s.geometry_depth.view();
    const MutableMotionView motion = s.geometry_motion.view();
    s.ForBands(s.options.output_height, [&](int begin, int end, SrScratch& scratch) {
      s.passes.geometry(job, begin, end, scratch, depth, motion);
    });
    s.has_geometry = true;
  }
  return {.depth = std::as_const(s.geometry_depth).view(),
          .motion = std::as_const(s.geometry_motion).view(),
          .cut = s.is_cut};
}

void SuperResolution::SetRenderSize(int width, int height) {
  if constexpr (kPipeline.super_resolution) state_->SetRenderSize(width, height);
}

bool SuperResolution::IsRenderSize(int width, int height, std::string* why) const {
  const State& s = *state_;
  return IsRenderSizeOf(s.options, width, height, s.most_width, s.most_height, why);
}

void SuperResolution::Reset() { state_->has_history = false; }

void SuperResolution::SetParameters(const Parameters& parameters, float gate_width) {
  state_->options.parameters = parameters;
  state_->options.gate_width = gate_width;
}

FrameTiles SuperResolution::Tiles() const {
  const SuperResolutionOptions& options = state_->options;
  FrameTiles tiles;
  tiles.total = std::int64_t{TileCount(options.output_width, kTileWidth)} *
                TileCount(options.output_height, kTileHeight);
  for (const SrScratch& scratch : state_->scratch) tiles += scratch.tiles;
  return tiles;
}

std::size_t SuperResolution::MemoryBytes() const {
  const State& s = *state_;
  std::size_t bytes = s.x.bytes() + s.y.bytes() + s.planes.bytes() + s.nearest_before.bytes() +
                      s.farthest_before.bytes() + s.reactive_before.bytes() +
                      3 * s.residual[0].bytes() + s.aliasing.bytes() + s.history.bytes() +
                      s.coefficients.bytes() + s.next.bytes() + s.state.bytes() +
                      s.next_state.bytes() + s.filtered.bytes() + s.geometry_depth.bytes() +
                      s.geometry_motion.bytes();
  if (s.filter) bytes += s.filter->MemoryBytes();
  if (s.prefilter) bytes += s.prefilter->bytes();
  for (const SrScratch& scratch : s.scratch) bytes += scratch.bytes();
  return bytes;
}

}  // namespace warplut
