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

// The heaviest window of an image whose pixels weigh `weight(x, y)`.
template <class Weight>
PictureWindow Heaviest(const char* kind, int frame, int width, int height, const Weight& weight) {
  constexpr int kStep = kWindowSide / 2;
  const int columns = std::max(width / kStep, 1), rows = std::max(height / kStep, 1);
  std::vector<double> blocks(static_cast<std::size_t>(columns) * rows);
  const auto block = [&](int i, int j) -> double& {
    return blocks[static_cast<std::size_t>(std::min(j, rows - 1)) * columns +
                  std::min(i, columns - 1)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) block(x / kStep, y / kStep) += weight(x, y);
  }
  PictureWindow best{.kind = kind, .frame = frame};
  for (int j = 0; j < std::max(rows - 1, 1); ++j) {
    for (int i = 0; i < std::max(columns - 1, 1); ++i) {
      double sum = block(i, j);
      if (columns > 1) sum += block(i + 1, j);
      if (rows > 1) sum += block(i, j + 1);
      if (columns > 1 && rows > 1) sum += block(i + 1, j + 1);
      if (sum <= best.weight) continue;
      best.x = i * kStep;
      best.y = j * kStep;
      best.weight = sum;
    }
  }
  return best;
}

// The window of `image`, every pixel kWindowZoom times in each axis.
Image Enlarged(const Image& image, const PictureWindow& window) {
  const int width = std::min(kWindowSide, image.width - window.x);
  const int height = std::min(kWindowSide, image.height - window.y);
  Image panel(width * kWindowZoom, height * kWindowZoom, 3);
  for (int y = 0; y < panel.height; ++y) {
    for (int x = 0; x < panel.width; ++x) {
      const float* rgb =
          &image.data[image.Index(window.x + x / kWindowZoom, window.y + y / kWindowZoom)];
      std::copy_n(rgb, 3, &panel.data[panel.Index(x, y)]);
    }
  }
  return panel;
}

// Panels of one height in a row, on white.
Image SideBySide(const std::vector<Image>& panels) {
  int width = 0;
  for (const Image& panel : panels) width += panel.width + kPicturePanelGap;
  Image picture(width - kPicturePanelGap, panels.front().height, 3);
  std::fill(picture.data.begin(), picture.data.end(), 1.0f);
  int left = 0;
  for (const Image& panel : panels) {
    for (int y = 0; y < panel.height; ++y) {
      std::copy_n(&panel.data[panel.Index(0, y)], static_cast<std::size_t>(panel.width) * 3,
                  &picture.data[picture.Index(left, y)]);
    }
    left += panel.width + kPicturePanelGap;
  }
  return picture;
}

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
  errors_.push_back(Heaviest("error", shown.frame, image.width, image.height, [&](int x, int y) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
      const double e = static_cast<double>(image.at(x, y, c)) - reference.at(x, y, c);
      sum += e * e;
    }
    return sum;
  }));
  if (shown.frame == 0 || truth.cut || !known.HasGeometry()) return;
  const TrueFrame known_before =
      TrueFrameOf(truth_.frames[static_cast<std::size_t>(shown.frame - 1)], width_, height_);
  const FrameGeometry now = {known.depth, known.motion};
  const FrameGeometry before = {known_before.depth, known_before.motion};
  disocclusions_.push_back(
      Heaviest("disocclusion", shown.frame, image.width, image.height,
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
    Image panel = Enlarged(reference, window);
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
    picture.panels.push_back(Enlarged(image, picture.window));
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
