#include "tools/view/error_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace warplut {

Image ErrorMap(const Image& image, const Image& truth, double amplify) {
  cv::Mat codes(image.height, image.width, CV_8UC1), colors;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      float largest = 0;
      for (int c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(image.at(x, y, c) - truth.at(x, y, c)));
      }
      const double shown = std::min(1.0, amplify * largest);
      codes.at<unsigned char>(y, x) = static_cast<unsigned char>(std::lround(255 * shown));
    }
  }
  cv::applyColorMap(codes, colors, cv::COLORMAP_INFERNO);
  Image map(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto& bgr = colors.at<cv::Vec3b>(y, x);
      for (int c = 0; c < 3; ++c) map.at(x, y, c) = static_cast<float>(bgr[2 - c]) / 255;
    }
  }
  return map;
}

std::string ErrorFactor(double amplify) { return fmt::format("x {:.4g}", amplify); }

std::string ErrorLegend(double amplify) {
  return fmt::format("{}: black is 0, pale yellow is {:.2g} or more", ErrorFactor(amplify),
                     1 / amplify);
}

}  // namespace warplut
