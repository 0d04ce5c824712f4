#include "train/replay/clip.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "datasets/error.h"
#include "datasets/images/image_io.h"
#include "runtime/motion_filter.h"
#include "train/replay/image_views.h"
#include "train/replay/motion_composition.h"
#include "train/replay/motion_step.h"

namespace warplut {
namespace {

// The streams of one grid, with what composing its motion needs.
struct GridStreams {
  Streams motion, depth;
  Image Frame::*motion_image;
  Image Frame::*depth_image;
  bool jittered;
  float motion_filter_limit;
};

constexpr GridStreams kRenderGrid = {
    Streams::kMotion, Streams::kDepth, &Frame::motion, &Frame::depth, true, kMotionFilterLimit};
constexpr GridStreams kOutputGrid = {Streams::kReferenceMotion,
                                     Streams::kReferenceDepth,
                                     &Frame::reference_motion,
                                     &Frame::reference_depth,
                                     false,
                                     kGenerationMotionFilterLimit};

// The streams that composing the motion among `which` reads.
Streams ComposedStreams(const Sequence& sequence, Streams which) {
  Streams streams = Streams::kNone;
  for (const GridStreams& grid : {kRenderGrid, kOutputGrid}) {
    if (!Contains(which, grid.motion)) continue;
    streams = streams | grid.motion | (grid.depth & AvailableStreams(sequence));
  }
  return streams;
}

PixelFormat ColorFormat(const Sequence& sequence, int first, int count, Streams stream) {
  if (sequence.color_space == ColorSpace::kLinear) return PixelFormat::kRgba32F;
  for (int index = first; index < first + count; ++index) {
    for (const auto& file : FrameFiles(sequence, index, stream)) {
      const ImageInfo info = ReadImageInfo(file);
      if (!info.integer || info.bits != 8) return PixelFormat::kRgba32F;
    }
  }
  return PixelFormat::kRgba8;
}

// One channel as three.
Image Grey(const Image& one) {
  Image grey(one.width, one.height, 3);
  for (std::size_t i = 0; i < grey.data.size(); ++i) grey.data[i] = one.data[i / 3];
  return grey;
}

// Limits what lies beyond kLargestHdr and counts it.
std::int64_t LimitColor(Image& linear) {
  std::int64_t limited = 0;
  for (float& value : linear.data) {
    if (std::abs(value) <= kLargestHdr) continue;
    value = LimitHdr(value);
    ++limited;
  }
  return limited;
}

// The distance of depth 1, in units of the cameras: depth is divided by the far plane, or by the
// near one where the far one is infinitely far.
double DepthUnit(const DepthStream& depth) {
  return std::isfinite(depth.far) ? depth.far : depth.near;
}

std::optional<CameraMatrices> CameraOf(const Frame& frame) {
  if (!frame.camera) return std::nullopt;
  const CameraMatrices camera{frame.camera->view, frame.camera->projection};
  return camera.IsValid() ? std::optional(camera) : std::nullopt;
}

bool IsQuantised(MotionView motion) {
  constexpr int kRowStep = 4;  // one in so many is looked at
  motion.height /= kRowStep;
  motion.stride *= kRowStep;
  return MotionStep(motion) >= kQuantisedStep;
}

// Whether is_so(frame) of some frame; asked on all threads.
template <class T, class Predicate>
bool AnyOf(const std::vector<T>& frames, const Predicate& is_so) {
  std::atomic<bool> found = false;
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    if (!found && is_so(frames[i])) found = true;
  });
  return found;
}

// Filters the motion of one grid of all frames; of those without depth there is none to filter.
void FilterMotion(const GridStreams& grid, MotionFiltering filtering, std::vector<Frame>& frames) {
  const auto quantised = [&](const Frame& frame) {
    return IsQuantised(ToMotionBuffer(frame.*grid.motion_image).view());
  };
  if (filtering == MotionFiltering::kQuantised && !AnyOf(frames, quantised)) return;
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    Image& motion = frames[i].*grid.motion_image;
    const Image& depth = frames[i].*grid.depth_image;
    if (motion.empty() || depth.empty()) return;
    MotionBuffer filtered = ToMotionBuffer(motion);
    SerialExecutor executor;
    MotionFilter(motion.width, motion.height, {grid.motion_filter_limit})
        .Apply(ToBuffer(depth, PixelFormat::kR32F).view(), filtered.view(), executor,
               filtered.view());
    motion = ToImage(std::as_const(filtered).view());
  });
}

// Frames of a sequence from index `begin` on, as loaded.
class LoadedFrames {
 public:
  LoadedFrames(int begin, std::vector<Frame> frames) : begin_(begin), frames_(std::move(frames)) {}

  Frame& at(int index) { return frames_[static_cast<std::size_t>(index - begin_)]; }

  // Whether motion reaches from the frame at `index` to the one `every` before it.
  bool Composable(int index, int every) {
    if (index - every + 1 < begin_) return false;
    for (int i = index; i > index - every; --i) {
      if (at(i).cut) return false;
    }
    return true;
  }

  Image Compose(const GridStreams& grid, int index, int every) {
    std::vector<MotionField> fields;
    for (int i = index; i > index - every; --i) {
      const Frame& frame = at(i);
      const Image& depth = frame.*grid.depth_image;
      fields.push_back({.motion = &(frame.*grid.motion_image),
                        .depth = depth.empty() ? nullptr : &depth,
                        .offset = grid.jittered ? frame.jitter : Vec2{}});
    }
    return ComposeMotion(fields);
  }

 private:
  int begin_;
  std::vector<Frame> frames_;
};

void CheckRange(const Sequence& sequence, int first, int count, int every) {
  if (first < 0 || count < 1 || first > sequence.count - count) {
    throw Error(fmt::format("the sequence '{}' has {} frames; expected frames {} to {} among them",
                            sequence.name, sequence.count, first, first + count - 1));
  }
  if (every < 1) throw Error(fmt::format("every is {}; expected at least 1", every));
}

}  // namespace

RenderedFrame ClipFrame::Rendered() const {
  return {.color = color.view(),
          .depth = depth.view(),
          .motion = motion.view(),
          .jitter_x = static_cast<float>(jitter.x),
          .jitter_y = static_cast<float>(jitter.y),
          .cut = cut,
          .reactive = reactive.view()};
}

DisplayedFrame ClipFrame::Displayed() const {
  return {.color = reference.view(),
          .depth = reference_depth.view(),
          .motion = reference_motion.view(),
          .cut = cut};
}

bool HasCameras(const Clip& clip) {
  return std::all_of(clip.frames.begin(), clip.frames.end(),
                     [](const ClipFrame& frame) { return frame.camera.has_value(); });
}

bool HasQuantisedMotion(const Clip& clip) {
  return AnyOf(clip.frames, [](const ClipFrame& frame) {
    const MotionView motion = frame.motion.view();
    return IsQuantised(motion.width > 0 ? motion : frame.reference_motion.view());
  });
}

Clip LoadClip(const Sequence& sequence, int first, int count, Streams which, int every,
              MotionFiltering filtering) {
  CheckRange(sequence, first, count, every);
  Clip clip;
  clip.name = sequence.name;
  clip.render = sequence.render;
  clip.output = sequence.output;
  if (!sequence.render_sizes.empty()) {
    const auto begin_size = sequence.render_sizes.begin() + first;
    clip.render_sizes.assign(begin_size, begin_size + count);
  }
  clip.encoding = sequence.color_space == ColorSpace::kLinear ? ColorEncoding::kLinearHdr
                                                              : ColorEncoding::kDisplay;
  // Of a colour and its alpha.
  const auto formats = [&](Streams color, Streams alpha) {
    const auto of = [&](Streams one) {
      return Contains(which, one) ? ColorFormat(sequence, first, count, one) : PixelFormat::kRgba8;
    };
    const bool premultiplied = Contains(which, color | alpha);
    return std::pair(premultiplied ? PixelFormat::kRgba32F : of(color), of(alpha));
  };
  const auto [color_format, alpha_format] = formats(Streams::kColor, Streams::kAlpha);
  const auto [reference_format, reference_alpha_format] =
      formats(Streams::kReference, Streams::kReferenceAlpha);

  // Frames before the first are there for their motion. Colour goes to its buffer at once; motion
  // and depth, which other frames need to compose theirs, when all frames are loaded.
  const Streams composed = every > 1 ? ComposedStreams(sequence, which) : Streams::kNone;
  const int begin = std::max(0, first - every + 1);
  clip.frames.resize(static_cast<std::size_t>(count));
  std::vector<Frame> loaded(static_cast<std::size_t>(first + count - begin));
  std::atomic<std::int64_t> limited_color = 0, limited_reference = 0;
  tbb::parallel_for(begin, first + count, [&](int index) {
    Frame& frame = loaded[static_cast<std::size_t>(index - begin)];
    frame = LoadFrame(sequence, index, index < first ? composed : which | composed);
    frame.cut = frame.cut || index == 0;
    if (index < first) return;
    ClipFrame& out = clip.frames[static_cast<std::size_t>(index - first)];
    out.number = frame.number;
    out.jitter = frame.jitter;
    out.camera = CameraOf(frame);
    if (clip.encoding == ColorEncoding::kLinearHdr) {
      limited_color += LimitColor(frame.color);
      limited_reference += LimitColor(frame.reference);
    }
    if (Contains(which, Streams::kColor)) out.color = ToBuffer(frame.color, color_format);
    if (Contains(which, Streams::kReference)) {
      out.reference = ToBuffer(frame.reference, reference_format);
    }
    if (Contains(which, Streams::kReactive)) {
      out.reactive = ToBuffer(frame.reactive, PixelFormat::kR32F);
    }
    if (Contains(which, Streams::kAlpha)) out.alpha = ToBuffer(Grey(frame.alpha), alpha_format);
    if (Contains(which, Streams::kReferenceAlpha)) {
      out.reference_alpha = ToBuffer(Grey(frame.reference_alpha), reference_alpha_format);
    }
    for (Image* image : {&frame.color, &frame.reference, &frame.reactive, &frame.hud, &frame.alpha,
                         &frame.reference_alpha}) {
      *image = Image();
    }
  });
  if (sequence.depth) clip.depth_unit = DepthUnit(*sequence.depth);
  if (sequence.reference_depth) clip.reference_depth_unit = DepthUnit(*sequence.reference_depth);
  clip.limited_color = limited_color;
  clip.limited_reference = limited_reference;

  if (every > 1 && filtering != MotionFiltering::kOff) {
    for (const GridStreams& grid : {kRenderGrid, kOutputGrid}) {
      if (Contains(which, grid.motion)) FilterMotion(grid, filtering, loaded);
    }
  }

  LoadedFrames frames(begin, std::move(loaded));
  tbb::parallel_for(first, first + count, [&](int index) {
    ClipFrame& out = clip.frames[static_cast<std::size_t>(index - first)];
    const Frame& frame = frames.at(index);
    const bool composable = frames.Composable(index, every);
    out.cut = every > 1 ? !composable : frame.cut;
    const auto motion = [&](const GridStreams& grid) {
      return composable && every > 1 ? ToMotionBuffer(frames.Compose(grid, index, every))
                                     : ToMotionBuffer(frame.*grid.motion_image);
    };
    if (Contains(which, Streams::kMotion)) out.motion = motion(kRenderGrid);
    if (Contains(which, Streams::kReferenceMotion)) out.reference_motion = motion(kOutputGrid);
    if (Contains(which, Streams::kDepth)) out.depth = ToBuffer(frame.depth, PixelFormat::kR32F);
    if (Contains(which, Streams::kReferenceDepth)) {
      out.reference_depth = ToBuffer(frame.reference_depth, PixelFormat::kR32F);
    }
  });
  if (filtering == MotionFiltering::kQuantised) clip.quantised_motion = HasQuantisedMotion(clip);
  return clip;
}

}  // namespace warplut
