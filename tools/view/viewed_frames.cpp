#include "tools/view/viewed_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "datasets/error.h"
#include "tools/judge/images/image_set.h"

namespace warplut {
namespace {

// The last part of a path that has a name.
std::string LastName(const std::string& path) {
  std::filesystem::path lexical = std::filesystem::path(path).lexically_normal();
  if (!lexical.has_filename()) lexical = lexical.parent_path();
  const std::string name = lexical.filename().string();
  return name.empty() ? path : name;
}

// Three channels in [0, 1].
Image LoadShown(const ListedImage& listed, JudgedDomain domain) {
  Image image = DisplayedImage(LoadCompared(listed, domain), ColorEncoding::kDisplay);
  for (float& value : image.data) value = std::clamp(value, 0.0f, 1.0f);
  return image;
}

void RequireSize(const ViewedFrame& frame, const Image& image, const std::string& source) {
  if (image.width == frame.a.width && image.height == frame.a.height) return;
  throw Error(fmt::format("frame {} has {} x {} pixels in '{}'; expected {} x {}, as in the first",
                          frame.name, image.width, image.height, source, frame.a.width,
                          frame.a.height));
}

}  // namespace

ViewedFrame ViewedFrames::Load(std::size_t index) const {
  const Files& of = files[index];
  ViewedFrame frame{
      .name = of.name, .a = LoadShown(of.a, domain), .b = LoadShown(of.b, domain), .reference = {}};
  RequireSize(frame, frame.b, b);
  if (of.reference) {
    frame.reference = LoadShown(*of.reference, domain);
    RequireSize(frame, frame.reference, "the reference");
  }
  return frame;
}

ViewedFrames FramesOfFolders(const std::string& a, const std::string& b,
                             const std::string& reference, bool linear) {
  const std::vector<FramePair> pairs = PairFrames(a, b);
  ViewedFrames frames{.a = LastName(a), .b = LastName(b), .files = {}};
  if (frames.a == frames.b) {
    frames.a = a;
    frames.b = b;
  }
  if (frames.a == frames.b) frames.b += " (again)";
  frames.domain = DomainOf(pairs, linear);
  for (const FramePair& pair : pairs) {
    const std::string name = std::filesystem::path(pair.name).stem().string();
    frames.files.push_back({.name = name, .a = pair.a, .b = pair.b, .reference = {}});
  }
  if (reference.empty()) return frames;
  std::vector<FramePair> with_reference = PairFrames(a, reference);
  for (std::size_t i = 0; i < with_reference.size(); ++i) {
    frames.files[i].reference = std::move(with_reference[i].b);
  }
  return frames;
}

}  // namespace warplut
