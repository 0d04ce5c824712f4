#include "tools/view/picture_label.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace warplut {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontScale = 0.45;
constexpr int kBaseline = 15, kLeft = 4;

cv::Mat MatOf(const Image& image) {
  return {image.height, image.width, CV_32FC3, const_cast<float*>(image.data.data())};
}

}  // namespace

Image Labelled(const Image& picture, const std::string& text) {
  Image labelled(picture.width, picture.height + kLabelHeight, 3);
  std::fill_n(labelled.data.begin(), labelled.Index(0, kLabelHeight), 1.0f);
  std::copy(picture.data.begin(), picture.data.end(),
            labelled.data.begin() + static_cast<std::ptrdiff_t>(labelled.Index(0, kLabelHeight)));
  std::string shown = text;
  const auto fits = [&] {
    return cv::getTextSize(shown, kFont, kFontScale, 1, nullptr).width + kLeft < picture.width;
  };
  while (!shown.empty() && !fits()) shown.pop_back();
  cv::Mat mat = MatOf(labelled);
  cv::putText(mat, shown, {kLeft, kBaseline}, kFont, kFontScale, {0, 0, 0}, 1, cv::LINE_AA);
  return labelled;
}

Image AtMostWide(const Image& picture, int width) {
  if (picture.width <= width) return picture;
  const int height = std::max(1, picture.height * width / picture.width);
  Image smaller(width, height, 3);
  cv::Mat mat = MatOf(smaller);
  cv::resize(MatOf(picture), mat, mat.size(), 0, 0, cv::INTER_AREA);
  return smaller;
}

}  // namespace warplut
