#include "tests/stability/cases/passes/runtime_methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "datasets/error.h"
#include "luts/quantize/baked_table.h"
#include "runtime/executor.h"
#include "tests/stability/cases/stability_clip.h"
#include "train/replay/image_views.h"
#include "train/replay/mode_run.h"

namespace warplut {
namespace {

// The pairs of buffers of a stream: on the render grid and of the references.
template <class Buffer, class Edit>
void EditBuffers(Clip& clip, Buffer ClipFrame::*first, Buffer ClipFrame::*second,
                 const Edit& edit) {
  for (std::size_t i = 0; i < clip.frames.size(); ++i) {
    for (Buffer ClipFrame::*stream : {first, second}) {
      const auto view = (clip.frames[i].*stream).view();
      for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) edit(view, x, y, static_cast<int>(i));
      }
    }
  }
}

void GroundTexture(double x, double y, int frame, ClipTexel* texel) {
  constexpr double kMotionX = 0.37, kMotionY = -0.21;
  Texture(x - kMotionX * frame, y - kMotionY * frame, 23.0, texel->color);
  for (float& channel : texel->color) channel = 0.5f + 0.5f * (channel - 0.5f);
  texel->depth = 0.8f;
  texel->motion_x = kMotionX;
  texel->motion_y = kMotionY;
}

bool HasBrightnessGate(const MethodInfo& method) {
  if (method.configure_generation == nullptr) return false;
  FrameGenerationOptions options;
  method.configure_generation(options);
  return options.brightness_gate;
}

// |value - what may be shown between a and b|.
double DifferenceBetween(Between between, bool gate, double value, double a, double b,
                         bool a_is_farther) {
  switch (between) {
    case Between::kLater:
      return std::abs(value - b);
    case Between::kFarther:
      return std::abs(value - (a_is_farther ? a : b));
    case Between::kMean:
      break;
  }
  const double mean = std::abs(value - (a + b) / 2);
  return gate ? std::min(mean, std::abs(value - b)) : mean;
}

struct Neighbours {
  ImageView before, after;
  bool before_is_farther;
};

double DifferenceFromNeighbours(const ImageView& image, const Neighbours& neighbours,
                                const MethodInfo& method, Between between) {
  const bool gate = HasBrightnessGate(method);
  double most = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int i = 0; i < 4 * image.width; ++i) {
      const auto at = [&](const ImageView& view) {
        return static_cast<double>(view.Row<float>(y)[i]);
      };
      most = std::max(most, DifferenceBetween(between, gate, at(image), at(neighbours.before),
                                              at(neighbours.after), neighbours.before_is_farther));
    }
  }
  return most;
}

// Of what a method may show: generated frames of finite sources keep to the sources' range and the
// filter's overshoot.
ValueRange AllowedRange(const Clip& clip, const MethodInfo& method) {
  constexpr double kSumRounding = 1e-5;  // of weights and their sum
  if (method.super_resolution) return {0, 1};
  ValueRange sources{1, 0};
  for (const ClipFrame& frame : clip.frames) {
    const ValueRange range = RangeOf(frame.reference.view());
    if (!range.IsWithin(0, 1)) return {0, 1};
    sources = {std::min(sources.least, range.least), std::max(sources.largest, range.largest)};
  }
  const double slack =
      Overshoot(StoredHistoryTable()) * (sources.largest - sources.least) + kSumRounding;
  return {std::max(0.0, sources.least - slack), std::min(1.0, sources.largest + slack)};
}

std::string SizeName(GridSize grid) { return fmt::format("{} x {}", grid.width, grid.height); }

}  // namespace

ShownImages RunMethod(const Clip& clip, const MethodInfo& method, const MethodSetup& setup) {
  ModeRunOptions options;
  options.method = &method;
  options.shown_format = PixelFormat::kRgba32F;
  options.super_resolution.warp = options.generation.warp = HistoryWarp();
  options.super_resolution.motion_filter = options.generation.motion_filter = setup.motion_filter;
  options.super_resolution.parameters = options.generation.parameters = setup.parameters;
  options.super_resolution.reference = options.generation.reference = setup.reference;
  options.super_resolution.history_format = setup.history_format;
  std::string why;
  if (!options.IsValid(clip, &why)) throw Error(why);
  std::unique_ptr<Executor> executor;
  if (setup.threads == 1) {
    executor = std::make_unique<SerialExecutor>();
  } else {
    executor = std::make_unique<ThreadPool>(setup.threads);
  }
  ShownImages shown;
  RunMode(clip, options, *executor, [&](const ShownFrame& frame) {
    ShownImage& image = shown.emplace_back();
    image.image = ImageBuffer(frame.image.width, frame.image.height, frame.image.format);
    image.generated = frame.generated;
    CopyPixels(frame.image, image.image.view());
  });
  return shown;
}

bool SameBits(const ShownImages& a, const ShownImages& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ShownImage& one, const ShownImage& other) {
                      return SameBits(one.image.view(), other.image.view());
                    });
}

double LargestDifference(const ShownImages& a, const ShownImages& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, LargestDifference(a[i].image.view(), b[i].image.view()));
  }
  return most;
}

void EditMotion(Clip& clip, const std::function<void(float* xy, int x, int y, int frame)>& edit) {
  EditBuffers(clip, &ClipFrame::motion, &ClipFrame::reference_motion,
              [&](const MutableMotionView& view, int x, int y, int frame) {
                edit(view.Row(y) + 2 * x, x, y, frame);
              });
}

void EditDepth(Clip& clip, const std::function<void(float& depth, int x, int y, int frame)>& edit) {
  EditBuffers(clip, &ClipFrame::depth, &ClipFrame::reference_depth,
              [&](const MutableImageView& view, int x, int y, int frame) {
                edit(view.Row<float>(y)[x], x, y, frame);
              });
}

void EditColor(Clip& clip, const std::function<void(float* rgba, int x, int y, int frame)>& edit) {
  EditBuffers(clip, &ClipFrame::color, &ClipFrame::reference,
              [&](const MutableImageView& view, int x, int y, int frame) {
                edit(view.Row<float>(y) + 4 * x, x, y, frame);
              });
}

Clip PanningGround(GridSize render, GridSize output, int frames) {
  return MakeClip(render, output, frames, [](double x, double y, int frame) {
    ClipTexel texel;
    GroundTexture(x, y, frame, &texel);
    return texel;
  });
}

Clip MovingScene(GridSize render, GridSize output, int frames) {
  return MakeClip(render, output, frames, [render](double x, double y, int frame) {
    constexpr double kMotionX = -1.3, kMotionY = 0.6;
    ClipTexel texel;
    const double u = x - kMotionX * frame - 0.5 * render.width;
    const double v = y - kMotionY * frame - 0.4 * render.height;
    if (std::abs(u) > 0.2 * render.width || std::abs(v) > 0.25 * render.height) {
      GroundTexture(x, y, frame, &texel);
      return texel;
    }
    Texture(u, v, 11.0, texel.color);
    for (float& channel : texel.color) channel = 0.5f + 0.5f * (channel - 0.5f);
    texel.depth = 0.3f;
    texel.motion_x = kMotionX;
    texel.motion_y = kMotionY;
    return texel;
  });
}

double DifferenceFromStill(const Clip& clip, const MethodInfo& method, const ShownImages& shown,
                           Between between) {
  // Other systems promise none of this.
  if (method.peer || method.optical_flow) return 0;
  ShownImages alone;
  if (method.super_resolution) alone = RunMethod(clip, WithoutHistory(method));
  const auto rendered = [&](std::size_t i) {
    return method.super_resolution ? std::as_const(alone[i].image).view()
                                   : std::as_const(clip.frames[i].reference).view();
  };
  const Between rule = method.generator == Generator::kAverage ? Between::kMean : between;
  double most = 0;
  std::size_t count = 0;  // rendered frames so far
  for (const ShownImage& image : shown) {
    const ImageView view = image.image.view();
    if (!image.generated) {
      most = std::max(most, LargestDifference(view, rendered(count++)));
    } else if (method.generator == Generator::kRepeat ||
               method.generation == Generation::kExtrapolation) {
      most = std::max(most, LargestDifference(view, rendered(count - 1)));
    } else {
      const auto depth = [&](std::size_t i) {
        return *clip.frames[i].reference_depth.view().Row<float>(0);
      };
      const Neighbours neighbours{rendered(count - 1), rendered(count),
                                  depth(count - 1) > depth(count)};
      most = std::max(most, DifferenceFromNeighbours(view, neighbours, method, rule));
    }
  }
  return most;
}

const MethodInfo& WithoutHistory(const MethodInfo& method) {
  SuperResolutionOptions options;
  method.configure_super_resolution(options);
  return options.history ? *FindMethod("bilinear") : method;
}

double Overshoot(const TableView& table) {
  double worst = 1;
  for (const IntegerRow& row : TableIntegers(table, "table")) {
    double sum = 0;
    for (const double weight : RealRow(row, table.format)) sum += std::abs(weight);
    worst = std::max(worst, sum);
  }
  return (worst - 1) / 2;
}

void Examination::Fail(const std::string& what) {
  if (failure_.empty()) failure_ = what;
}

void Examination::Examine(const Clip& clip, const std::string& name, bool motion_filter) {
  for (const MethodInfo& method : Methods()) {
    ExamineMethod(clip, method, false, name);
    if (motion_filter) ExamineMethod(clip, method, true, name);
  }
}

void Examination::ExamineMethod(const Clip& clip, const MethodInfo& method, bool motion_filter,
                                const std::string& name) {
  const std::string which =
      fmt::format("{}{} on {}, {} from {}", method.name, motion_filter ? " with motion filter" : "",
                  name, SizeName(clip.output), SizeName(clip.render));
  const ShownImages fast = RunMethod(clip, method, {.motion_filter = motion_filter});
  for (const int threads : {2, 5}) {
    const MethodSetup setup{.threads = threads, .motion_filter = motion_filter};
    if (!SameBits(fast, RunMethod(clip, method, setup))) {
      Fail(fmt::format("{}: other bits on {} threads", which, threads));
    }
  }
  ++runs_;
  if (method.generator != Generator::kWarped) return;
  const ShownImages plain =
      RunMethod(clip, method, {.reference = true, .motion_filter = motion_filter});
  const ValueRange allowed = AllowedRange(clip, method);
  for (std::size_t i = 0; i < fast.size(); ++i) {
    if (!method.super_resolution && !fast[i].generated) continue;  // a source as it is
    const ImageView image = fast[i].image.view();
    const ValueRange range = RangeOf(image);
    least_ = std::min(least_, range.least);
    largest_ = std::max(largest_, range.largest);
    if (!range.IsWithin(allowed.least, allowed.largest)) {
      Fail(fmt::format("{}: {:.4f} to {:.4f}, allowed {:.4f} to {:.4f}", which, range.least,
                       range.largest, allowed.least, allowed.largest));
    }
    const ImageView expected = plain[i].image.view();
    const double difference = LargestDifference(image, expected);
    plain_difference_ = std::max(plain_difference_, difference);
    if (!(difference <= kHalfCode)) {
      Fail(
          fmt::format("{}: {:.2g} of the pixels differ from the plain version by more than half a "
                      "code value, at most by {:.3g} code values",
                      which, DifferingShare(image, expected, kHalfCode), 255 * difference));
    }
  }
}

StabilityResult Examination::Result() const {
  std::string observed =
      failure_.empty()
          ? fmt::format(
                "{} runs: values {:.3f} to {:.3f}, {:.2g} of a code value from the plain "
                "version, the same bits on every number of threads",
                runs_, least_, largest_, 255 * plain_difference_)
          : failure_;
  return {failure_.empty(), observed};
}

bool IsAnchoredMesh(const MethodInfo& method) {
  FrameGenerationOptions options;
  if (method.configure_generation != nullptr) method.configure_generation(options);
  return options.peer == &kMeshProjection;
}

}  // namespace warplut
