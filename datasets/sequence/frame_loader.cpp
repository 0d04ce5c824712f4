// Frames from files: which file, of which size and channels, converted by datasets/encoding.h.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "datasets/encoding.h"
#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/camera_fill.h"
#include "datasets/sequence/forward_flow.h"
#include "datasets/sequence/frame_pattern.h"
#include "datasets/sequence/sequence.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<Streams, const char*> kStreamNames[] = {
    {Streams::kColor, "color"},
    {Streams::kDepth, "depth"},
    {Streams::kMotion, "motion"},
    {Streams::kReference, "reference"},
    {Streams::kReferenceDepth, "reference_depth"},
    {Streams::kReferenceMotion, "reference_motion"},
    {Streams::kReactive, "reactive"},
    {Streams::kHud, "hud"},
    {Streams::kAlpha, "alpha"},
    {Streams::kReferenceAlpha, "reference_alpha"},
};

// 8 bits of a colour outside [0, 1] are rounding; more is another colour space.
constexpr float kColorSlack = 1.0F / 512;

// The files of one frame.
class FrameReader {
 public:
  FrameReader(const Sequence& sequence, int number) : sequence_(sequence), number_(number) {}

  Image Color(const ColorStream& stream, GridSize grid) const {
    const fs::path path = PathOf(stream.path);
    Check(path, grid, stream.channels, 0, Encoding::kFloat);
    const bool linear = sequence_.color_space == ColorSpace::kLinear;
    Image color =
        ToRgb(ReadImage(path, stream.channels, linear ? Values::kNumbers : Values::kFinite));
    if (!linear) CheckRange(path, "colour value", ", or color_space \"linear\"", &color);
    return color;
  }

  // A MaskStream or an AlphaStream.
  template <class Stream>
  Image Mask(const Stream& stream, GridSize grid) const {
    const fs::path path = PathOf(stream.path);
    Check(path, grid, stream.channels, 1, Encoding::kFloat);
    Image mask = ReadImage(path, stream.channels);
    CheckRange(path, "mask value", "", &mask);
    return mask;
  }

  // Premultiplied, however it is stored.
  Image Layer(const LayerStream& stream, GridSize grid) const {
    const fs::path path = PathOf(stream.path);
    Check(path, grid, stream.channels, 4, Encoding::kFloat);
    Image layer = ReadImage(path, stream.channels);
    Image alpha = Channel(layer, 3);
    CheckRange(path, "alpha", "", &alpha);
    if (sequence_.color_space != ColorSpace::kLinear) {
      CheckRange(path, "value", ", or color_space \"linear\"", &layer);
    }
    const bool straight = stream.alpha == AlphaKind::kStraight;
    for (std::size_t i = 0; i < layer.pixels(); ++i) {
      for (std::size_t c = 0; straight && c < 3; ++c) layer.data[4 * i + c] *= alpha.data[i];
      layer.data[4 * i + 3] = alpha.data[i];
    }
    return layer;
  }

  Image Depth(const DepthStream& stream, GridSize grid) const {
    const fs::path path = PathOf(stream.path);
    Check(path, grid, stream.channels, 1, stream.encoding);
    return DecodeDepth(ReadImage(path, stream.channels, Values::kAll), stream, path.string());
  }

  // NaN where the motion is invalid.
  Image MotionOrNan(MotionStream stream, GridSize grid) const {
    Image motion;  // made once there is a file of that size
    if (!stream.path.empty()) {
      const fs::path path = PathOf(stream.path);
      if (HasExtension(path, ".flo") && !stream.invalid) stream.invalid.emplace();
      std::vector<std::string> channels = stream.channels;
      const bool has_validity = stream.invalid && !stream.invalid->channel.empty();
      if (has_validity) channels.push_back(stream.invalid->channel);
      Check(path, grid, channels, 2, stream.encoding);
      const Image read = ReadImage(path, channels, Values::kAll);
      motion = Image(grid.width, grid.height, 2);
      for (int c = 0; c < 2; ++c) DecodeMotion(Channel(read, c), stream, c, path.string(), &motion);
      for (std::size_t i = 0; has_validity && i < motion.pixels(); ++i) {
        const float valid = read.data[3 * i + 2];
        if (valid == 0 || std::isnan(valid)) motion.data[2 * i] = std::nanf("");
      }
      return motion;
    }
    for (int c = 0; c < 2; ++c) {
      const fs::path path = PathOf(c == 0 ? stream.path_x : stream.path_y);
      std::vector<std::string> channels = stream.channels;
      if (stream.encoding == Encoding::kFloat && !channels.empty()) {
        channels = {channels[static_cast<std::size_t>(c)]};
      }
      Check(path, grid, channels, 1, stream.encoding);
      const Image read = ReadImage(path, channels, Values::kAll);
      if (motion.empty()) motion = Image(grid.width, grid.height, 2);
      DecodeMotion(read, stream, c, path.string(), &motion);
    }
    return motion;
  }

 private:
  fs::path PathOf(const std::string& pattern) const {
    return sequence_.folder / FrameFileName(pattern, number_);
  }

  // Size and channels, before any pixel is read. `components`: numbers that a pixel holds, 0 where
  // any.
  static void Check(const fs::path& path, GridSize grid, const std::vector<std::string>& channels,
                    std::size_t components, Encoding encoding) {
    const ImageInfo info = ReadImageInfo(path, channels);
    if (info.width != grid.width || info.height != grid.height) {
      throw Error(fmt::format("'{}' is {} x {}; expected {} x {} as the sequence says",
                              path.string(), info.width, info.height, grid.width, grid.height));
    }
    const bool packed = encoding == Encoding::kRgba8Base255;
    if (packed && !(info.integer && info.bits == 8)) {
      throw Error(fmt::format("'{}' has {}-bit {} values; expected 8-bit integers, as it is packed",
                              path.string(), info.bits, info.integer ? "integer" : "float"));
    }
    const std::size_t expected = packed ? 4 : components;
    if (channels.empty() && expected != 0 && info.channels.size() != expected) {
      throw Error(fmt::format("'{}' has {} channels ({}); expected {}, or the field 'channels'",
                              path.string(), info.channels.size(), fmt::join(info.channels, ", "),
                              expected));
    }
  }

  static Image Channel(const Image& image, int c) {
    Image one(image.width, image.height, 1);
    for (std::size_t i = 0; i < one.data.size(); ++i) {
      one.data[i] =
          image.data[i * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c)];
    }
    return one;
  }

  static Image ToRgb(Image image) {
    if (image.channels == 3) return image;
    const bool grey = image.channels <= 2;
    Image rgb(image.width, image.height, 3);
    const std::size_t pixels = image.pixels(), step = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < pixels; ++i) {
      for (std::size_t c = 0; c < 3; ++c)
        rgb.data[3 * i + c] = image.data[i * step + (grey ? 0 : c)];
    }
    return rgb;
  }

  static void CheckRange(const fs::path& path, const char* what, const char* otherwise,
                         Image* image) {
    for (std::size_t i = 0; i < image->data.size(); ++i) {
      float& v = image->data[i];
      if (!(v >= -kColorSlack && v <= 1 + kColorSlack)) {
        const std::size_t pixel = i / static_cast<std::size_t>(image->channels);
        const auto width = static_cast<std::size_t>(image->width);
        throw Error(fmt::format("'{}': pixel ({}, {}) has the {} {}; expected 0 to 1{}",
                                path.string(), pixel % width, pixel / width, what, v, otherwise));
      }
      v = std::clamp(v, 0.0F, 1.0F);
    }
  }

  const Sequence& sequence_;
  int number_;
};

// Straight colour becomes premultiplied.
void Premultiply(const AlphaStream& stream, const Image& alpha, Image* color) {
  if (stream.color == AlphaKind::kPremultiplied || color->empty()) return;
  for (std::size_t i = 0; i < alpha.data.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) color->data[3 * i + c] *= alpha.data[i];
  }
}

void DivideOut(double exposure, Image* image) {
  if (exposure == 1) return;
  const auto factor = static_cast<float>(1 / exposure);
  for (float& value : image->data) value *= factor;
}

void CheckIndex(const Sequence& s, int index) {
  if (index < 0 || index >= s.count) {
    throw Error(fmt::format("the sequence '{}' has no frame at index {}; expected 0 to {}", s.name,
                            index, s.count - 1));
  }
}

// The motion of one grid of a frame, whichever files it is in.
class MotionLoader {
 public:
  MotionLoader(const Sequence& sequence, bool output)
      : sequence_(sequence),
        stream_(output ? *sequence.reference_motion : *sequence.motion),
        depth_(output ? sequence.reference_depth : sequence.depth),
        jittered_(!output) {}

  // (0, 0) where there is none and the camera does not tell.
  Image Load(int index, bool cut) const {
    Image motion = Stored(index);
    if (!cut && index > 0) FillFromCamera(index, &motion);
    ClearInvalid(&motion);
    return motion;
  }

 private:
  GridSize GridOf(int index) const {
    return jittered_ ? sequence_.RenderSize(index) : sequence_.output;
  }

  // NaN where there is none.
  Image Stored(int index) const {
    const GridSize grid = GridOf(index);
    const bool forward = stream_.direction == MotionDirection::kCurrentToNext;
    const int at = forward ? index - 1 : index;  // the frame whose pixels the file has
    const int file = at + stream_.frame_offset;
    if (at < 0 || file < 0 || file >= sequence_.count) {
      Image none(grid.width, grid.height, 2);
      std::fill(none.data.begin(), none.data.end(), std::nanf(""));
      return none;
    }
    Image motion = FrameReader(sequence_, sequence_.Number(file)).MotionOrNan(stream_, grid);
    if (stream_.contains_jitter && index > 0) {
      const Vec2 now = JitterOf(index), before = JitterOf(index - 1);
      for (std::size_t i = 0; i < motion.data.size(); i += 2) {
        motion.data[i] += static_cast<float>(now.x - before.x);
        motion.data[i + 1] += static_cast<float>(now.y - before.y);
      }
    }
    return forward ? MotionOfForwardFlow(motion, depth_ ? DepthOf(at) : Image()) : motion;
  }

  // Depth that cannot be read is a fault of its own stream, found where that is loaded.
  void FillFromCamera(int index, Image* motion) const {
    if (sequence_.camera.empty() || !depth_ || !MayMissMotion(*motion)) return;
    const auto i = static_cast<std::size_t>(index);
    const GridSize grid = GridOf(index);
    const CameraStep step(sequence_.camera[i - 1], sequence_.camera[i], grid.width, grid.height,
                          jittered_ ? JitterOf(index) : Vec2{});
    if (!step.Valid() || step.AtRest()) return;
    const bool finite = std::isfinite(depth_->far);
    try {
      FillMissingMotion(step, DepthOf(index), finite ? depth_->far : depth_->near,
                        finite ? 1 : std::numeric_limits<double>::infinity(), motion);
    } catch (const Error&) {
      return;
    }
  }

  Image DepthOf(int index) const {
    return FrameReader(sequence_, sequence_.Number(index)).Depth(*depth_, GridOf(index));
  }

  Vec2 JitterOf(int index) const {
    const auto& jitter = sequence_.jitter;
    return jitter.empty() ? Vec2{} : jitter[static_cast<std::size_t>(index) % jitter.size()];
  }

  const Sequence& sequence_;
  const MotionStream& stream_;
  const std::optional<DepthStream>& depth_;
  bool jittered_;
};

}  // namespace

Streams AvailableStreams(const Sequence& s) {
  Streams set = Streams::kColor;
  if (s.depth) set = set | Streams::kDepth;
  if (s.motion) set = set | Streams::kMotion;
  if (s.reference) set = set | Streams::kReference;
  if (s.reference_depth) set = set | Streams::kReferenceDepth;
  if (s.reference_motion) set = set | Streams::kReferenceMotion;
  if (s.reactive) set = set | Streams::kReactive;
  if (s.hud) set = set | Streams::kHud;
  if (s.alpha) set = set | Streams::kAlpha;
  if (s.reference_alpha) set = set | Streams::kReferenceAlpha;
  return set;
}

std::vector<std::string> StreamNames(Streams streams) {
  std::vector<std::string> names;
  for (const auto& [stream, name] : kStreamNames) {
    if (Contains(streams, stream)) names.emplace_back(name);
  }
  return names;
}

std::vector<fs::path> FrameFiles(const Sequence& s, int index, Streams which) {
  CheckIndex(s, index);
  std::vector<fs::path> files;
  const auto add = [&](const std::string& pattern) {
    if (!pattern.empty()) files.push_back(s.folder / FrameFileName(pattern, s.Number(index)));
  };
  const auto add_stream = [&](Streams stream, const auto& described) {
    if (Contains(which, stream) && described) add(described->path);
  };
  const auto add_motion = [&](Streams stream, const std::optional<MotionStream>& described) {
    add_stream(stream, described);
    if (!Contains(which, stream) || !described) return;
    add(described->path_x);
    add(described->path_y);
  };
  if (Contains(which, Streams::kColor)) add(s.color.path);
  add_stream(Streams::kDepth, s.depth);
  add_motion(Streams::kMotion, s.motion);
  add_stream(Streams::kReference, s.reference);
  add_stream(Streams::kReferenceDepth, s.reference_depth);
  add_motion(Streams::kReferenceMotion, s.reference_motion);
  add_stream(Streams::kReactive, s.reactive);
  add_stream(Streams::kHud, s.hud);
  add_stream(Streams::kAlpha, s.alpha);
  add_stream(Streams::kReferenceAlpha, s.reference_alpha);
  return files;
}

Frame LoadFrame(const Sequence& s, int index, Streams which) {
  CheckIndex(s, index);
  const Streams available = AvailableStreams(s);
  for (const auto& [stream, name] : kStreamNames) {
    if (Contains(which, stream) && !Contains(available, stream)) {
      throw Error(
          fmt::format("the sequence '{}' has no stream '{}', which is needed here; it has: {}",
                      s.name, name, fmt::join(StreamNames(available), ", ")));
    }
  }
  Frame frame;
  frame.number = s.Number(index);
  frame.cut = std::binary_search(s.cuts.begin(), s.cuts.end(), frame.number);
  const auto i = static_cast<std::size_t>(index);
  if (!s.jitter.empty()) frame.jitter = s.jitter[i % s.jitter.size()];
  if (!s.camera.empty()) frame.camera = s.camera[i];

  const FrameReader reader(s, frame.number);
  const auto wants = [&](Streams stream) { return Contains(which, stream); };
  const GridSize render = s.RenderSize(index);
  if (wants(Streams::kColor)) frame.color = reader.Color(s.color, render);
  if (wants(Streams::kDepth)) frame.depth = reader.Depth(*s.depth, render);
  if (wants(Streams::kMotion)) frame.motion = MotionLoader(s, false).Load(index, frame.cut);
  if (wants(Streams::kReference)) frame.reference = reader.Color(*s.reference, s.output);
  if (wants(Streams::kReferenceDepth))
    frame.reference_depth = reader.Depth(*s.reference_depth, s.output);
  if (wants(Streams::kReferenceMotion)) {
    frame.reference_motion = MotionLoader(s, true).Load(index, frame.cut);
  }
  if (wants(Streams::kReactive)) frame.reactive = reader.Mask(*s.reactive, render);
  if (wants(Streams::kHud)) frame.hud = reader.Layer(*s.hud, s.output);
  if (wants(Streams::kAlpha)) {
    frame.alpha = reader.Mask(*s.alpha, render);
    Premultiply(*s.alpha, frame.alpha, &frame.color);
  }
  if (wants(Streams::kReferenceAlpha)) {
    frame.reference_alpha = reader.Mask(*s.reference_alpha, s.output);
    Premultiply(*s.reference_alpha, frame.reference_alpha, &frame.reference);
  }
  for (Image* image : {&frame.color, &frame.reference}) DivideOut(s.Exposure(index), image);
  return frame;
}

}  // namespace warplut
