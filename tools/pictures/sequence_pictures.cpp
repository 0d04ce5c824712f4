#include "tools/pictures/sequence_pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "tools/judge/sequence_scores.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

std::vector<PictureWindow> HeaviestOf(std::vector<PictureWindow> windows) {
  std::stable_sort(windows.begin(), windows.end(),
                   [](const auto& a, const auto& b) { return a.weight > b.weight; });
  std::erase_if(windows, [](const PictureWindow& window) { return window.weight <= 0; });
  if (windows.size() > kWindowsOfAKind) windows.resize(kWindowsOfAKind);
  return windows;
}

}  // namespace

void WindowChooser::Add(const ShownFrame& shown) {
  if (shown.frame < 0) return;
  const ClipFrame& truth = truth_.frames[static_cast<std::size_t>(shown.frame)];
  const TrueFrame known = TrueFrameOf(truth, shown.image.width, shown.image.height);
  const Image image = JudgedImage(shown.image, truth_.encoding);
  const Image reference = JudgedImage(known.image, truth_.encoding);
  width_ = image.width;
  height_ = image.height;
  errors_.push_back(
      HeaviestWindow("error", shown.frame, image.width, image.height,
                     [&](int x, int y) { return SquaredDifference(image, reference, x, y); }));
  if (shown.frame == 0 || truth.cut || !known.HasGeometry()) return;
  const TrueFrame known_before =
      TrueFrameOf(truth_.frames[static_cast<std::size_t>(shown.frame - 1)], width_, height_);
  const FrameGeometry now = {known.depth, known.motion};
  const FrameGeometry before = {known_before.depth, known_before.motion};
  disocclusions_.push_back(
      HeaviestWindow("disocclusion", shown.frame, image.width, image.height,
                     [&](int x, int y) { return WasVisible(now, before, x, y) ? 0.0 : 1.0; }));
}

std::vector<PictureWindow> WindowChooser::Windows() const {
  std::vector<PictureWindow> windows = HeaviestOf(errors_);
  for (const PictureWindow& window : HeaviestOf(disocclusions_)) windows.push_back(window);
  for (PictureWindow& window : windows) {
    window.image_width = width_;
    window.image_height = height_;
  }
  return windows;
}

SequencePictures::SequencePictures(const Clip& truth, std::vector<PictureWindow> windows)
    : truth_(truth) {
  for (PictureWindow& window : windows) {
    const ClipFrame& frame = truth.frames[static_cast<std::size_t>(window.frame)];
    const Image reference = JudgedImage(
        TrueFrameOf(frame, window.image_width, window.image_height).image, truth.encoding);
    Image panel = EnlargedWindow(reference, window);
    pictures_.push_back(
        {.window = std::move(window), .names = {"reference"}, .panels = {std::move(panel)}});
  }
}

void SequencePictures::Add(const std::string& method, const ShownFrame& shown) {
  const auto wanted = [&](const Picture& picture) {
    return picture.window.frame == shown.frame && picture.window.image_width == shown.image.width &&
           picture.window.image_height == shown.image.height;
  };
  if (std::none_of(pictures_.begin(), pictures_.end(), wanted)) return;
  const Image image = JudgedImage(shown.image, truth_.encoding);
  for (Picture& picture : pictures_) {
    if (!wanted(picture)) continue;
    picture.names.push_back(method);
    picture.panels.push_back(EnlargedWindow(image, picture.window));
  }
}

std::vector<std::string> SequencePictures::Write(const std::filesystem::path& folder) const {
  CreateFolder(folder);
  std::vector<std::string> lines;
  for (const Picture& picture : pictures_) {
    const int number = truth_.frames[static_cast<std::size_t>(picture.window.frame)].number;
    const std::filesystem::path path =
        folder / fmt::format("{}-{:04}-{}.png", truth_.name, number, picture.window.kind);
    WriteImage(path, SideBySide(picture.panels), PixelType::kUint8);
    lines.push_back(fmt::format("{}: {}", path.string(), fmt::join(picture.names, " | ")));
  }
  return lines;
}

}  // namespace warplut
