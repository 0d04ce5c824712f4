#include "train/replay/mode_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "runtime/core/pixel.h"
#include "train/replay/image_views.h"
#include "train/replay/optical_flow.h"
#include "train/replay/reprojection_source.h"

namespace warplut {
namespace {

// Times that differ by less are one.
constexpr double kTimeSlack = 1e-5;

bool WarpsFrames(const MethodInfo& method) {
  return Generates(method) && method.generator == Generator::kWarped;
}

std::string WhyClipIsUnfit(const Clip& clip, const ModeRunOptions& options) {
  const MethodInfo& method = *options.method;
  if (clip.frames.empty()) return fmt::format("the clip of '{}' has no frames", clip.name);
  const Streams needed =
      NeededStreams(method, GeneratesFromReferences(clip) ? Streams::kAll : Streams::kRenderGrid);
  for (const ClipFrame& frame : clip.frames) {
    if (const char* stream = MissingStream(frame, clip, needed)) {
      return fmt::format("frame {} of '{}' has no stream '{}', which the method {} needs",
                         frame.number, clip.name, stream, method.name);
    }
  }
  if (!clip.render_sizes.empty() && !method.super_resolution && !GeneratesFromReferences(clip)) {
    return fmt::format(
        "the render size of '{}' varies; the method {} takes rendered frames of one size",
        clip.name, method.name);
  }
  const int last = static_cast<int>(clip.frames.size()) - 1;
  if (Generates(method) && last < options.every) {
    return fmt::format(
        "the clip of '{}' has {} frames, of which one in {} is rendered; the method {} needs two "
        "that are",
        clip.name, last + 1, options.every, method.name);
  }
  return {};
}

// Whether the passes of the method run on its device, for options that are valid.
std::string WhyDeviceIsUnfit(const Clip& clip, const ModeRunOptions& options) {
  std::string reason;
  if (options.device == nullptr) return reason;
  if (options.method->super_resolution) {
    options.device->IsRunnable(EffectiveSuperResolution(clip, options), &reason);
  }
  if (reason.empty() && WarpsFrames(*options.method)) {
    options.device->IsRunnable(EffectiveGeneration(clip, options), &reason);
  }
  return reason;
}

// A rendered frame as it is displayed: the clip's own buffers, or what super resolution made.
struct Display {
  DisplayedFrame frame;
  double seconds = 0;
  FrameTiles tiles;
  ImageBuffer color, depth;  // what super resolution made; not used without it
  MotionBuffer motion;
};

class Stopwatch {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class ModeRun {
 public:
  ModeRun(const Clip& clip, const ModeRunOptions& options, Executor& executor,
          const ShownFrameSink& sink)
      : clip_(clip),
        options_(options),
        method_(*options.method),
        executor_(executor),
        processor_(executor),
        device_(options.device != nullptr ? *options.device : processor_),
        sink_(sink),
        alphas_(Alphas(options)) {
    if (method_.super_resolution) PrepareSuperResolution();
    if (Generates(method_)) PrepareGeneration();
  }

  void Run() {
    const int count = static_cast<int>(clip_.frames.size());
    for (int index = 0, turn = 0; index < count; index += options_.every, ++turn) {
      Display& now = displays_[turn % 2];
      const Display& before = displays_[(turn + 1) % 2];
      Render(index, now);
      if (turn > 0 && method_.generation == Generation::kInterpolation) {
        Generate(before, now, index - options_.every);
      }
      Show({.time = static_cast<double>(index),
            .image = now.frame.color,
            .seconds = now.seconds,
            .tiles = now.tiles});
      if (turn > 0 && method_.generation == Generation::kExtrapolation) {
        Generate(before, now, index);
      }
    }
  }

 private:
  void PrepareSuperResolution() {
    super_resolution_ =
        device_.MakeSuperResolution(EffectiveSuperResolution(clip_, options_), Generates(method_));
    const bool linear = clip_.encoding == ColorEncoding::kLinearHdr;
    const PixelFormat format = linear && options_.shown_format == PixelFormat::kRgba8
                                   ? PixelFormat::kRgba16F
                                   : options_.shown_format;
    const auto [width, height] = clip_.output;
    for (Display& display : displays_) {
      display.color = ImageBuffer(width, height, format);
      if (!Generates(method_)) continue;
      display.depth = ImageBuffer(width, height, PixelFormat::kR32F);
      display.motion = MotionBuffer(width, height);
    }
    if (!HasHistory(method_)) {
      no_depth_ = ImageBuffer(clip_.render.width, clip_.render.height, PixelFormat::kR32F);
      no_motion_ = MotionBuffer(clip_.render.width, clip_.render.height);
    }
  }

  void PrepareGeneration() {
    const GridSize grid = ShownGrid(clip_, method_);
    const ClipFrame& first = clip_.frames.front();
    const PixelFormat format = method_.super_resolution         ? displays_[0].color.view().format
                               : GeneratesFromReferences(clip_) ? first.reference.view().format
                                                                : first.color.view().format;
    if (method_.optical_flow) {
      flow_.emplace(grid.width, grid.height, clip_.encoding);
      flow_motion_ = MotionBuffer(grid.width, grid.height);
      flat_depth_ = ImageBuffer(grid.width, grid.height, PixelFormat::kR32F);
    }
    generated_ = ImageBuffer(grid.width, grid.height, format);
    if (!WarpsFrames(method_)) return;
    if (method_.cameras != CameraSchedule::kNone && HasCameras(clip_)) {
      known_.emplace(clip_, method_.cameras, options_.every, GeneratesFromReferences(clip_));
    }
    generation_ = device_.MakeFrameGeneration(EffectiveGeneration(clip_, options_), format);
  }

  void Render(int index, Display& display) {
    const ClipFrame& frame = clip_.frames[static_cast<std::size_t>(index)];
    const auto id = static_cast<std::uint64_t>(index) + 1;
    if (!super_resolution_) {
      const RenderedFrame rendered = frame.Rendered();
      display.frame =
          GeneratesFromReferences(clip_)
              ? frame.Displayed()
              : DisplayedFrame{rendered.color, rendered.depth, rendered.motion, rendered.cut};
      display.frame.id = id;
      return;
    }
    RenderedFrame rendered = frame.Rendered();
    if (!HasHistory(method_)) {
      rendered.depth = no_depth_.view();
      rendered.motion = no_motion_.view();
      rendered.depth.width = rendered.motion.width = rendered.color.width;
      rendered.depth.height = rendered.motion.height = rendered.color.height;
    }
    if (!clip_.render_sizes.empty()) {
      super_resolution_->SetRenderSize(rendered.color.width, rendered.color.height);
    }
    const Stopwatch watch;
    super_resolution_->Process(rendered, display.color.view());
    display.tiles = super_resolution_->Tiles();
    display.frame = {
        .color = display.color.view(), .depth = {}, .motion = {}, .cut = frame.cut, .id = id};
    if (!Generates(method_)) {
      display.seconds = watch.Seconds();
      return;
    }
    const OutputGeometry geometry = super_resolution_->Geometry();
    display.seconds = watch.Seconds();
    CopyPixels(geometry.depth, display.depth.view());
    CopyMotion(geometry.motion, display.motion.view());
    display.frame.depth = display.depth.view();
    display.frame.motion = display.motion.view();
    display.frame.cut = geometry.cut;
  }

  // Shows the frames between two displayed ones or after the later, from time `begin` on.
  void Generate(const Display& before, const Display& now, int begin) {
    DisplayedFrame frame0 = before.frame, frame1 = now.frame;
    double seconds = FindFlow(frame0, frame1);
    for (const float alpha : alphas_) {
      const double time = TimeOf(begin + static_cast<double>(alpha) * options_.every);
      if (known_) frame1.reprojection = &known_->At(begin, time);
      const Stopwatch watch;
      const ImageView image = GenerateAt(frame0, frame1, alpha);
      seconds += watch.Seconds();
      Show({.time = time,
            .generated = true,
            .image = image,
            .seconds = seconds,
            .tiles = generation_ ? generation_->Tiles() : FrameTiles{}});
      seconds = 0;
    }
  }

  // Gives both frames the motion of their colours, where the method takes that; returns the time.
  double FindFlow(DisplayedFrame& frame0, DisplayedFrame& frame1) {
    if (!flow_) return 0;
    const Stopwatch watch;
    flow_->Find(frame0.color, frame1.color, flow_motion_.view());
    for (DisplayedFrame* frame : {&frame0, &frame1}) {
      frame->depth = flat_depth_.view();
      frame->motion = flow_motion_.view();
    }
    return watch.Seconds();
  }

  ImageView GenerateAt(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha) {
    switch (method_.generator) {
      case Generator::kRepeat:
        return method_.generation == Generation::kExtrapolation ? frame1.color : frame0.color;
      case Generator::kAverage:
        Blend(frame0.color, frame1.color, alpha);
        break;
      case Generator::kWarped:
        if (method_.generation == Generation::kInterpolation) {
          generation_->Interpolate(frame0, frame1, alpha, generated_.view());
        } else {
          generation_->Extrapolate(frame0, frame1, alpha, generated_.view());
        }
        break;
    }
    return generated_.view();
  }

  void Blend(const ImageView& a, const ImageView& b, float share) {
    const MutableImageView out = generated_.view();
    executor_.ForEach(out.height, [&](int y) {
      for (int x = 0; x < out.width; ++x) {
        const void* pa = a.At(x, y);
        const void* pb = b.At(x, y);
        void* po = out.At(x, y);
        for (int c = 0; c < 4; ++c) {
          const float va = LoadChannel(a.format, pa, c), vb = LoadChannel(b.format, pb, c);
          StoreChannel(out.format, va + share * (vb - va), po, c);
        }
      }
    });
  }

  // A time that is nearly whole is.
  static double TimeOf(double time) {
    const double whole = std::round(time);
    return std::abs(time - whole) < kTimeSlack ? whole : time;
  }

  void Show(ShownFrame shown) {
    if (shown.time == std::round(shown.time) &&
        shown.time < static_cast<double>(clip_.frames.size())) {
      shown.frame = static_cast<int>(shown.time);
    }
    sink_(shown);
  }

  const Clip& clip_;
  const ModeRunOptions& options_;
  const MethodInfo& method_;
  Executor& executor_;
  ProcessorDevice processor_;
  ModeDevice& device_;
  const ShownFrameSink& sink_;
  const std::vector<float> alphas_;
  std::unique_ptr<SuperResolutionPasses> super_resolution_;
  std::unique_ptr<FrameGenerationPasses> generation_;
  std::optional<OpticalFlow> flow_;
  std::optional<ReprojectionSource> known_;
  MotionBuffer flow_motion_;
  ImageBuffer flat_depth_;  // with optical flow
  std::array<Display, 2> displays_;
  ImageBuffer generated_;
  ImageBuffer no_depth_;  // for methods that look at neither
  MotionBuffer no_motion_;
};

}  // namespace

SuperResolutionOptions EffectiveSuperResolution(const Clip& clip, const ModeRunOptions& options) {
  SuperResolutionOptions effective = options.super_resolution;
  effective.render_width = clip.render.width;
  effective.render_height = clip.render.height;
  effective.output_width = clip.output.width;
  effective.output_height = clip.output.height;
  effective.encoding = clip.encoding;
  effective.reactive =
      std::any_of(clip.frames.begin(), clip.frames.end(),
                  [](const ClipFrame& frame) { return frame.reactive.bytes() > 0; });
  if (options.filter_quantised_motion && clip.quantised_motion) effective.motion_filter = true;
  options.method->configure_super_resolution(effective);
  if (options.method->paper) effective.parameters = kPaperParameters;
  return effective;
}

FrameGenerationOptions EffectiveGeneration(const Clip& clip, const ModeRunOptions& options) {
  FrameGenerationOptions effective = options.generation;
  const GridSize grid = ShownGrid(clip, *options.method);
  effective.width = grid.width;
  effective.height = grid.height;
  effective.encoding = clip.encoding;
  // Super resolution hands over motion that is filtered already.
  if (options.method->super_resolution) {
    effective.motion_filter = false;
  } else if (options.filter_quantised_motion && clip.quantised_motion) {
    effective.motion_filter = true;
  }
  // The motion of colours has no depth to be filtered by.
  if (options.method->optical_flow) effective.motion_filter = false;
  options.method->configure_generation(effective);
  if (options.method->paper) effective.parameters = kPaperParameters;
  return effective;
}

bool ModeRunOptions::IsValid(const Clip& clip, std::string* why) const {
  std::string reason;
  if (method == nullptr) {
    reason = "no method is given";
  } else {
    if (every < 1) reason = fmt::format("every is {}; expected at least 1", every);
    if (reason.empty()) AreTimesValid(*this, &reason);
    if (reason.empty()) reason = WhyClipIsUnfit(clip, *this);
    if (reason.empty() && shown_format == PixelFormat::kR32F) {
      reason = "the format of shown frames is r32f; expected rgba8, rgba16f or rgba32f";
    }
    if (reason.empty() && method->configure_super_resolution != nullptr) {
      EffectiveSuperResolution(clip, *this).IsValid(&reason);
    }
    if (reason.empty() && method->configure_generation != nullptr) {
      EffectiveGeneration(clip, *this).IsValid(&reason);
    }
    if (reason.empty()) reason = WhyDeviceIsUnfit(clip, *this);
  }
  if (why != nullptr) *why = reason;
  return reason.empty();
}

void RunMode(const Clip& clip, const ModeRunOptions& options, Executor& executor,
             const ShownFrameSink& sink) {
  ModeRun(clip, options, executor, sink).Run();
}

}  // namespace warplut
