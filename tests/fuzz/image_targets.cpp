// Targets that read images, as the streams of a sequence of one frame.
#include <cmath>

#include "datasets/images/image_io.h"
#include "datasets/sequence/sequence.h"
#include "luts/bake/table_io.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace warplut {
namespace {

// The extension of the format whose files begin like that.
std::string ExtensionOf(std::string_view bytes) {
  if (bytes.starts_with("PIEH")) return ".flo";
  if (bytes.starts_with("\x76\x2f\x31\x01")) return ".exr";
  return ".png";
}

// A sequence of one frame of this size.
Sequence OneFrame(const ImageInfo& info) {
  Sequence sequence;
  sequence.folder = FuzzFolder();
  sequence.name = "fuzz";
  sequence.count = 1;
  sequence.render = sequence.output = {info.width, info.height};
  sequence.color.path = "%d.png";
  return sequence;
}

// Whether all values are finite, or +infinity where that is allowed.
void RequireValues(const Image& image, bool infinity) {
  for (const float v : image.data) {
    Require(std::isfinite(v) || (infinity && v > 0), "a value that no reader may let through");
  }
}

}  // namespace

bool FuzzTableExr(std::string_view bytes) {
  const auto path = FuzzFile("table.exr", bytes);
  return Accepts([&] { LoadTable(path); });
}

bool FuzzPackedPng(std::string_view bytes) {
  const auto path = FuzzFile("0.png", bytes);
  ImageInfo info;
  if (!Accepts([&] { info = ReadImageInfo(path); })) return false;
  Sequence sequence = OneFrame(info);
  sequence.depth.emplace();
  sequence.depth->path = "%d.png";
  sequence.depth->encoding = Encoding::kRgba8Base255;
  sequence.depth->near = 0.1;
  sequence.depth->far = 100;
  sequence.motion.emplace();
  sequence.motion->path_x = sequence.motion->path_y = "%d.png";
  sequence.motion->encoding = Encoding::kRgba8Base255;
  sequence.motion->scale = {2, 2};
  sequence.motion->bias = {-1, -1};
  sequence.motion->units = MotionUnits::kUv;
  bool accepted = true;
  for (const DepthKind kind : {DepthKind::kLinear, DepthKind::kForward, DepthKind::kReversed}) {
    sequence.depth->kind = kind;
    accepted &=
        Accepts([&] { RequireValues(LoadFrame(sequence, 0, Streams::kDepth).depth, true); });
  }
  accepted &=
      Accepts([&] { RequireValues(LoadFrame(sequence, 0, Streams::kMotion).motion, false); });
  return accepted;
}

bool FuzzMotion(std::string_view bytes) {
  const std::string extension = ExtensionOf(bytes);
  const auto path = FuzzFile("0" + extension, bytes);
  ImageInfo info;
  if (!Accepts([&] { info = ReadImageInfo(path); })) return false;
  Sequence sequence = OneFrame(info);
  sequence.motion.emplace();
  sequence.motion->path = "%d" + extension;
  const auto load = [&] {
    return Accepts([&] { RequireValues(LoadFrame(sequence, 0, Streams::kMotion).motion, false); });
  };
  const bool plain = load();
  // With a validity channel, as KITTI's.
  sequence.motion->channels = {"R", "G"};
  sequence.motion->scale = {1023.984375, 1023.984375};
  sequence.motion->bias = {-512, -512};
  sequence.motion->invalid = {.values = {0}, .channel = "B"};
  return load() || plain;
}

bool FuzzImage(std::string_view bytes) {
  const std::string extension = ExtensionOf(bytes);
  if (extension == ".flo") return false;
  const auto path = FuzzFile("0" + extension, bytes);
  ImageInfo info;
  if (!Accepts([&] { info = ReadImageInfo(path); })) return false;
  Sequence sequence = OneFrame(info);
  sequence.color.path = "%d" + extension;
  const bool display =
      Accepts([&] { RequireValues(LoadFrame(sequence, 0, Streams::kColor).color, false); });
  sequence.color_space = ColorSpace::kLinear;
  return Accepts([&] {
           for (const float v : LoadFrame(sequence, 0, Streams::kColor).color.data) {
             Require(!std::isnan(v), "NaN in linear colour");
           }
         }) ||
         display;
}

}  // namespace warplut
