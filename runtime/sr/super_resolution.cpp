#include "runtime/super_resolution.h"

#include <atomic>
#include <utility>
#include <vector>

#include "runtime/motion_filter.h"
#include "runtime/motion_tiles.h"
#include "runtime/sr/passes.h"

namespace warplut {
namespace {

bool Refuse(std::string reason, std::string* why) {
  if (why != nullptr) *why = std::move(reason);
  return false;
}

std::string Size(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

bool IsColor(PixelFormat format) { return format != PixelFormat::kR32F; }

// Whether an image has data, this size and whole channels in rows that hold it.
template <class Image>
bool CheckImage(const char* name, const Image& image, int width, int height, std::string* why) {
  if (image.data == nullptr) return Refuse(std::string("The ") + name + " has no data.", why);
  if (image.width != width || image.height != height) {
    return Refuse(std::string("The ") + name + " is " + Size(image.width, image.height) + "; " +
                      Size(width, height) + " was expected.",
                  why);
  }
  const std::ptrdiff_t pixel = BytesPerPixel(image.format);
  if (image.stride < width * pixel || image.stride % (pixel / Channels(image.format)) != 0) {
    return Refuse(std::string("The rows of the ") + name +
                      " are shorter than its width or not whole channels.",
                  why);
  }
  return true;
}

bool CheckMotion(const MotionView& motion, int width, int height, std::string* why) {
  const ImageView pairs{motion.xy, motion.width, motion.height, motion.stride, PixelFormat::kR32F};
  if (!CheckImage("motion", pairs, width, height, why)) return false;
  if (motion.stride < std::ptrdiff_t{width} * 2 * static_cast<std::ptrdiff_t>(sizeof(float))) {
    return Refuse("The rows of the motion are shorter than its width.", why);
  }
  return true;
}

}  // namespace

bool SuperResolutionOptions::IsValid(std::string* why) const {
  if (render_width < 1 || render_height < 1) {
    return Refuse("The render size is " + Size(render_width, render_height) +
                      "; at least 1 x 1 was expected.",
                  why);
  }
  const auto fits = [](int render, int output) {
    return output >= render && output / 4.0 <= render && output <= kLargestSize;
  };
  if (!fits(render_width, output_width) || !fits(render_height, output_height)) {
    return Refuse("The output size is " + Size(output_width, output_height) +
                      "; 1 to 4 times the render size " + Size(render_width, render_height) +
                      " was expected.",
                  why);
  }
  if (!IsColor(history_format)) {
    return Refuse("The history format is r32f; rgba8, rgba16f or rgba32f was expected.", why);
  }
  if (!(gate_width >= 0 && gate_width <= 1)) {
    return Refuse("The gate width is " + std::to_string(gate_width) + "; 0 to 1 was expected.",
                  why);
  }
  const char* reason = nullptr;
  if (!warp.IsValid(&reason)) return Refuse(std::string("The filter: ") + reason + ".", why);
  return parameters.IsValid(why);
}

SrScratch::SrScratch(const SuperResolutionOptions& options)
    : motion(options.output_width, kBandRows),
      validity(options.output_width, kBandRows),
      render_rows(options.render_width, kRenderRows),
      output_rows(options.output_width, kOutputRows) {}

std::size_t SrScratch::bytes() const {
  return motion.bytes() + validity.bytes() + render_rows.bytes() + output_rows.bytes();
}

struct SuperResolution::State {
  State(const SuperResolutionOptions& chosen, Executor& runner);

  SrJob Job() const;
  // Calls pass(begin, end, scratch) for bands of rows; every band has the same bits whoever takes it.
  template <class Pass>
  void ForBands(int rows, int band, const Pass& pass);

  SuperResolutionOptions options;
  Executor& executor;
  const SrPasses& passes;
  AxisMap x, y;
  RenderPlanes planes;
  Plane nearest_before, farthest_before;
  Plane residual[3];
  ImageBuffer history, next;
  std::unique_ptr<MotionFilter> filter;
  MotionBuffer filtered;
  std::vector<SrScratch> scratch;
  ImageBuffer geometry_depth;
  MotionBuffer geometry_motion;
  float jitter_x_before = 0, jitter_y_before = 0;
  bool has_history = false;   // `history` holds the frame before
  bool has_geometry = false;  // the geometry buffers are those of the last frame
};

SuperResolution::State::State(const SuperResolutionOptions& chosen, Executor& runner)
    : options(chosen),
      executor(runner),
      passes(chosen.reference ? ReferencePasses() : FastPasses()),
      x(options.render_width, options.output_width),
      y(options.render_height, options.output_height),
      planes(options.render_width, options.render_height),
      nearest_before(options.render_width, options.render_height),
      farthest_before(options.render_width, options.render_height),
      history(options.output_width, options.output_height, options.history_format),
      next(options.output_width, options.output_height, options.history_format) {
  if (options.form == HistoryForm::kResidual) {
    for (Plane& plane : residual) plane = Plane(options.render_width, options.render_height);
  }
  if (options.motion_filter) {
    filter = std::make_unique<MotionFilter>(options.render_width, options.render_height,
                                            MotionFilterOptions{});
    filtered = MotionBuffer(options.render_width, options.render_height);
  }
  for (int i = 0; i < executor.Threads(); ++i) scratch.emplace_back(options);
}

SrJob SuperResolution::State::Job() const {
  return {options,
          x,
          y,
          planes,
          nearest_before,
          farthest_before,
          jitter_x_before,
          jitter_y_before,
          has_history,
          history.view(),
          {},
          residual};
}

template <class Pass>
void SuperResolution::State::ForBands(int rows, int band, const Pass& pass) {
  const int bands = TileCount(rows, band);
  std::atomic<int> next_band = 0;
  executor.ForEach(static_cast<int>(scratch.size()), [&](int worker) {
    for (int i = next_band++; i < bands; i = next_band++) {
      pass(i * band, std::min((i + 1) * band, rows), scratch[static_cast<std::size_t>(worker)]);
    }
  });
}

SuperResolution::SuperResolution(const SuperResolutionOptions& options, Executor& executor)
    : state_(std::make_unique<State>(options, executor)) {}

SuperResolution::~SuperResolution() = default;

bool SuperResolution::IsProcessable(const RenderedFrame& frame, const MutableImageView& out,
                                    std::string* why) const {
  const SuperResolutionOptions& options = state_->options;
  const int width = options.render_width;
  const int height = options.render_height;
  if (!CheckImage("colour", frame.color, width, height, why) ||
      !CheckImage("depth", frame.depth, width, height, why) ||
      !CheckMotion(frame.motion, width, height, why) ||
      !CheckImage("output", out, options.output_width, options.output_height, why)) {
    return false;
  }
  if (!IsColor(frame.color.format) || !IsColor(out.format)) {
    return Refuse("Colour or output is r32f; rgba8, rgba16f or rgba32f was expected.", why);
  }
  if (frame.depth.format != PixelFormat::kR32F) {
    return Refuse(std::string("The depth is ") + Name(frame.depth.format) + "; r32f was expected.",
                  why);
  }
  if (!(std::abs(frame.jitter_x) <= 1 && std::abs(frame.jitter_y) <= 1)) {
    return Refuse("The jitter is (" + std::to_string(frame.jitter_x) + ", " +
                      std::to_string(frame.jitter_y) + "); -1 to 1 was expected.",
                  why);
  }
  return true;
}

void SuperResolution::Process(const RenderedFrame& frame, const MutableImageView& out) {
  State& s = *state_;
  const int render_rows = s.options.render_height;
  const int output_rows = s.options.output_height;
  s.x.SetJitter(frame.jitter_x);
  s.y.SetJitter(frame.jitter_y);
  s.has_history = s.has_history && s.options.history && !frame.cut;
  s.has_geometry = false;

  MotionView motion = frame.motion;
  if (s.filter) {
    s.filter->Apply(frame.depth, frame.motion, s.executor, s.filtered.view());
    motion = s.filtered.view();
  }
  s.ForBands(render_rows, kRenderBandRows, [&](int begin, int end, SrScratch&) {
    s.passes.fill_planes(frame, motion, s.options.encoding, begin, end, s.planes);
  });

  SrJob job = s.Job();
  job.next = s.next.view();
  s.ForBands(output_rows, kBandRows, [&](int begin, int end, SrScratch& scratch) {
    s.passes.predict(job, begin, end, scratch);
  });
  if (s.options.history && s.options.form == HistoryForm::kResidual) {
    s.ForBands(render_rows, kRenderBandRows, [&](int begin, int end, SrScratch&) {
      s.passes.residual(job, begin, end, s.residual);
    });
  }
  s.ForBands(output_rows, kBandRows, [&](int begin, int end, SrScratch& scratch) {
    s.passes.update(job, begin, end, scratch, out);
  });
  s.ForBands(render_rows, kRenderBandRows, [&](int begin, int end, SrScratch&) {
    s.passes.depth_range(s.planes.depth, begin, end, s.nearest_before, s.farthest_before);
  });
  std::swap(s.history, s.next);
  s.jitter_x_before = frame.jitter_x;
  s.jitter_y_before = frame.jitter_y;
  s.has_history = true;
}

OutputGeometry SuperResolution::Geometry() {
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
    s.ForBands(s.options.output_height, kBandRows, [&](int begin, int end, SrScratch& scratch) {
      s.passes.geometry(job, begin, end, scratch, depth, motion);
    });
    s.has_geometry = true;
  }
  return {std::as_const(s.geometry_depth).view(), std::as_const(s.geometry_motion).view()};
}

void SuperResolution::Reset() { state_->has_history = false; }

void SuperResolution::SetParameters(const Parameters& parameters, float gate_width) {
  state_->options.parameters = parameters;
  state_->options.gate_width = gate_width;
}

std::size_t SuperResolution::MemoryBytes() const {
  const State& s = *state_;
  std::size_t bytes = s.x.bytes() + s.y.bytes() + s.planes.bytes() + s.nearest_before.bytes() +
                      s.farthest_before.bytes() + 3 * s.residual[0].bytes() + s.history.bytes() +
                      s.next.bytes() + s.filtered.bytes() + s.geometry_depth.bytes() +
                      s.geometry_motion.bytes();
  if (s.filter) bytes += s.filter->MemoryBytes();
  for (const SrScratch& scratch : s.scratch) bytes += scratch.bytes();
  return bytes;
}

}  // namespace warplut
