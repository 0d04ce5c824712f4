#include "tools/pictures/picture_window.h"

#include <algorithm>

namespace warplut {

PictureWindow HeaviestWindow(const char* kind, int frame, int width, int height,
                             const std::function<double(int x, int y)>& weight) {
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

double SquaredDifference(const Image& a, const Image& b, int x, int y) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const double e = static_cast<double>(a.at(x, y, c)) - b.at(x, y, c);
    sum += e * e;
  }
  return sum;
}

Image EnlargedWindow(const Image& image, const PictureWindow& window) {
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

}  // namespace warplut
