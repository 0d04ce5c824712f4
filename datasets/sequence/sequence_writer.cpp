#include "datasets/sequence/sequence_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "datasets/encoding.h"
#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/frame_pattern.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// Each pattern with the file types that its stream can be written in.
struct Target {
  std::string pattern;
  std::vector<std::string> channels;
  std::vector<std::string> extensions;
};

std::vector<Target> Targets(const Sequence& s) {
  std::vector<Target> targets;
  const auto color = [&](const ColorStream& c) {
    targets.push_back({c.path, c.channels, {".png", ".exr"}});
  };
  const auto values = [&](const std::string& pattern, const auto& stream) {
    const char* extension = stream.encoding == Encoding::kFloat ? ".exr" : ".png";
    if (!pattern.empty()) targets.push_back({pattern, stream.channels, {extension}});
  };
  const auto motion = [&](const MotionStream& m) {
    for (const auto* pattern : {&m.path, &m.path_x, &m.path_y}) values(*pattern, m);
  };
  color(s.color);
  if (s.depth) values(s.depth->path, *s.depth);
  if (s.motion) motion(*s.motion);
  if (s.reference) color(*s.reference);
  if (s.reference_depth) values(s.reference_depth->path, *s.reference_depth);
  if (s.reference_motion) motion(*s.reference_motion);
  if (s.reactive) targets.push_back({s.reactive->path, s.reactive->channels, {".png", ".exr"}});
  if (s.hud) targets.push_back({s.hud->path, s.hud->channels, {".png", ".exr"}});
  for (const auto& alpha : {s.alpha, s.reference_alpha}) {
    if (alpha) targets.push_back({alpha->path, alpha->channels, {".png", ".exr"}});
  }
  return targets;
}

void CheckTargets(const Sequence& s) {
  const auto fail = [&](const std::string& pattern, const std::string& sentence) {
    throw Error(
        fmt::format("the sequence '{}' cannot be written: '{}' {}", s.name, pattern, sentence));
  };
  for (const auto* color : {&s.color, s.reference ? &*s.reference : nullptr}) {
    if (color && color->channels.size() == 1)
      fail(color->path, "has one named channel; expected three");
  }
  for (const auto& alpha : {s.alpha, s.reference_alpha}) {
    if (alpha && alpha->color == AlphaKind::kStraight) {
      fail(alpha->path, "has straight colour; expected premultiplied colour, as frames hold it");
    }
  }
  for (const auto* motion :
       {s.motion ? &*s.motion : nullptr, s.reference_motion ? &*s.reference_motion : nullptr}) {
    if (motion && motion->invalid && !motion->invalid->channel.empty()) {
      fail(motion->path, "has a channel that tells what is invalid, which is not written");
    }
  }
  std::set<std::string> seen;
  for (const auto& [pattern, channels, extensions] : Targets(s)) {
    const std::string extension = fs::path(pattern).extension().string();
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) {
      fail(pattern, fmt::format("has the extension '{}'; expected {}", extension,
                                fmt::join(extensions, " or ")));
    }
    if (extension == ".png" && !channels.empty()) {
      fail(pattern, "has named channels; expected none, as a .png has fixed ones");
    }
    if (!seen.insert(FrameFileName(pattern, s.first)).second) {
      fail(pattern, "names the files of two streams; expected one");
    }
  }
}

// Fields for readers alone: the file of a frame would need the motion of another one.
void CheckMotionOfFrame(const Sequence& s) {
  for (const auto* motion : {&s.motion, &s.reference_motion}) {
    const bool own = !*motion || ((*motion)->direction != MotionDirection::kCurrentToNext &&
                                  (*motion)->frame_offset == 0 && !(*motion)->contains_jitter);
    if (own) continue;
    throw Error(fmt::format(
        "the sequence '{}' cannot be written: its motion is forward flow, of another frame or with "
        "jitter; expected that of its own frame without jitter",
        s.name));
  }
}

// The streams of one frame, to files.
class FrameWriter {
 public:
  FrameWriter(const Sequence& sequence, int number) : sequence_(sequence), number_(number) {}

  void Color(const ColorStream& stream, const Image& image, GridSize grid, const char* name) const {
    Check(image, grid, 3, name);
    const fs::path path = PathOf(stream.path);
    WriteImage(path, image, path.extension() == ".png" ? PixelType::kUint8 : PixelType::kHalf,
               stream.channels);
  }

  // A MaskStream or an AlphaStream.
  template <class Stream>
  void Mask(const Stream& stream, const Image& image, GridSize grid, const char* name) const {
    Check(image, grid, 1, name);
    WriteMask(PathOf(stream.path), image, stream.channels);
  }

  // `image` is premultiplied; the colours of transparent pixels are lost where that is undone.
  void Layer(const LayerStream& stream, const Image& image, GridSize grid, const char* name) const {
    Check(image, grid, 4, name);
    Image layer = image;
    for (std::size_t i = 0; stream.alpha == AlphaKind::kStraight && i < layer.pixels(); ++i) {
      const float alpha = layer.data[4 * i + 3];
      for (std::size_t c = 0; c < 3 && alpha > 0; ++c) layer.data[4 * i + c] /= alpha;
    }
    WriteMask(PathOf(stream.path), layer, stream.channels);
  }

  void Depth(const DepthStream& stream, const Image& image, GridSize grid, const char* name) const {
    Check(image, grid, 1, name);
    const fs::path path = PathOf(stream.path);
    WriteValues(path, EncodeDepth(image, stream, path.string()), stream.encoding,
                Names(stream.channels, {"Z"}));
  }

  void Motion(const MotionStream& stream, const Image& image, GridSize grid,
              const char* name) const {
    Check(image, grid, 2, name);
    const std::vector<std::string> names = Names(stream.channels, {"X", "Y"});
    if (!stream.path.empty()) {
      const fs::path path = PathOf(stream.path);
      Image both(grid.width, grid.height, 2);
      for (std::size_t c = 0; c < 2; ++c) {
        const Image one = EncodeMotion(image, stream, static_cast<int>(c), path.string());
        for (std::size_t i = 0; i < one.data.size(); ++i) both.data[2 * i + c] = one.data[i];
      }
      WriteValues(path, both, stream.encoding, names);
      return;
    }
    for (std::size_t c = 0; c < 2; ++c) {
      const fs::path path = PathOf(c == 0 ? stream.path_x : stream.path_y);
      WriteValues(path, EncodeMotion(image, stream, static_cast<int>(c), path.string()),
                  stream.encoding, {names[c]});
    }
  }

 private:
  fs::path PathOf(const std::string& pattern) const {
    return sequence_.folder / FrameFileName(pattern, number_);
  }

  static void WriteMask(const fs::path& path, const Image& image,
                        const std::vector<std::string>& names) {
    WriteImage(path, image, path.extension() == ".png" ? PixelType::kUint8 : PixelType::kHalf,
               names);
  }

  void Check(const Image& image, GridSize grid, int channels, const char* name) const {
    if (image.width != grid.width || image.height != grid.height || image.channels != channels) {
      throw Error(fmt::format(
          "frame {} of the sequence '{}': stream '{}' is {} x {} with {} channels; expected "
          "{} x {} with {}",
          number_, sequence_.name, name, image.width, image.height, image.channels, grid.width,
          grid.height, channels));
    }
  }

  static std::vector<std::string> Names(const std::vector<std::string>& channels,
                                        std::vector<std::string> otherwise) {
    return channels.empty() ? std::move(otherwise) : channels;
  }

  static void WriteValues(const fs::path& path, const Image& stored, Encoding encoding,
                          const std::vector<std::string>& names) {
    if (encoding == Encoding::kFloat) {
      WriteImage(path, stored, PixelType::kFloat, names);
    } else {
      WriteImage(path, stored, PixelType::kUint8);
    }
  }

  const Sequence& sequence_;
  int number_;
};

}  // namespace

Sequence StandardSequence(const std::string& name, int first, int count, GridSize render,
                          GridSize output, ColorSpace color_space, Streams streams, double near,
                          double far) {
  Sequence s;
  s.name = name;
  s.first = first;
  s.count = count;
  s.render = render;
  s.output = output;
  s.color_space = color_space;
  const char* color_type = color_space == ColorSpace::kLinear ? ".exr" : ".png";
  const auto color = [&](const char* grid) {
    return ColorStream{fmt::format("{}/color/%04d{}", grid, color_type), {}};
  };
  const auto depth = [&](const char* grid) {
    DepthStream stream;
    stream.path = fmt::format("{}/depth/%04d.exr", grid);
    stream.channels = {"Z"};
    stream.near = near;
    stream.far = far;
    return stream;
  };
  const auto motion = [&](const char* grid) {
    MotionStream stream;
    stream.path = fmt::format("{}/motion/%04d.exr", grid);
    stream.channels = {"X", "Y"};
    return stream;
  };
  s.color = color("lr");
  if (Contains(streams, Streams::kDepth)) s.depth = depth("lr");
  if (Contains(streams, Streams::kMotion)) s.motion = motion("lr");
  if (Contains(streams, Streams::kReference)) s.reference = color("hr");
  if (Contains(streams, Streams::kReferenceDepth)) s.reference_depth = depth("hr");
  if (Contains(streams, Streams::kReferenceMotion)) s.reference_motion = motion("hr");
  if (Contains(streams, Streams::kReactive)) s.reactive = MaskStream{"lr/reactive/%04d.png", {}};
  if (Contains(streams, Streams::kHud)) {
    s.hud = LayerStream{fmt::format("hr/hud/%04d{}", color_type), {}, AlphaKind::kPremultiplied};
  }
  const auto alpha = [](const char* grid) {
    return AlphaStream{fmt::format("{}/alpha/%04d.png", grid), {}, AlphaKind::kPremultiplied};
  };
  if (Contains(streams, Streams::kAlpha)) s.alpha = alpha("lr");
  if (Contains(streams, Streams::kReferenceAlpha)) s.reference_alpha = alpha("hr");
  return s;
}

SequenceWriter::SequenceWriter(const fs::path& folder, Sequence sequence)
    : sequence_(std::move(sequence)) {
  sequence_.folder = folder;
  json_ = SequenceJson(sequence_);
  CheckTargets(sequence_);
  CheckMotionOfFrame(sequence_);
  CreateFolder(folder);
  for (const fs::path& text : {manifest(), partial()}) {
    if (fs::exists(text) && ReadFile(text) != json_) {
      throw Error(fmt::format(
          "'{}' describes another sequence than '{}', which is to be written; expected an empty "
          "folder or one where that sequence was begun",
          text.string(), sequence_.name));
    }
  }
  for (const Target& target : Targets(sequence_)) {
    CreateFolder((folder / FrameFileName(target.pattern, sequence_.first)).parent_path());
  }
  if (!fs::exists(manifest())) WriteFile(partial(), json_);
}

fs::path SequenceWriter::partial() const {
  return sequence_.folder / fmt::format("{}.partial", Sequence::kManifest);
}

bool SequenceWriter::Has(int index) const {
  try {
    LoadFrame(sequence_, index, AvailableStreams(sequence_));
    return true;
  } catch (const Error&) {
    return false;
  }
}

void SequenceWriter::Write(int index, const Frame& frame) const {
  const Sequence& s = sequence_;
  FrameFiles(s, index, Streams::kNone);  // checks the index
  if (fs::exists(manifest())) {
    WriteFile(partial(), json_);
    std::error_code error;
    fs::remove(manifest(), error);
    if (error)
      throw Error(fmt::format("cannot remove '{}': {}", manifest().string(), error.message()));
  }
  const FrameWriter writer(s, s.Number(index));
  const GridSize render = s.RenderSize(index);
  writer.Color(s.color, frame.color, render, "color");
  if (s.depth) writer.Depth(*s.depth, frame.depth, render, "depth");
  if (s.motion) writer.Motion(*s.motion, frame.motion, render, "motion");
  if (s.reference) writer.Color(*s.reference, frame.reference, s.output, "reference");
  if (s.reference_depth)
    writer.Depth(*s.reference_depth, frame.reference_depth, s.output, "reference_depth");
  if (s.reference_motion)
    writer.Motion(*s.reference_motion, frame.reference_motion, s.output, "reference_motion");
  if (s.reactive) writer.Mask(*s.reactive, frame.reactive, render, "reactive");
  if (s.hud) writer.Layer(*s.hud, frame.hud, s.output, "hud");
  if (s.alpha) writer.Mask(*s.alpha, frame.alpha, render, "alpha");
  if (s.reference_alpha) {
    writer.Mask(*s.reference_alpha, frame.reference_alpha, s.output, "reference_alpha");
  }
}

void SequenceWriter::Finish() const {
  for (int index = 0; index < sequence_.count; ++index) {
    for (const fs::path& file : FrameFiles(sequence_, index, AvailableStreams(sequence_))) {
      if (!fs::exists(file)) {
        throw Error(fmt::format(
            "the sequence '{}' cannot be finished: '{}' is missing; expected every frame to be "
            "written",
            sequence_.name, file.string()));
      }
    }
  }
  WriteFile(manifest(), json_);
  std::error_code ignored;  // beside a manifest with the same text it does no harm
  fs::remove(partial(), ignored);
}

}  // namespace warplut
