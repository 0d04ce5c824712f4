#include "tools/bench/ssim_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "datasets/error.h"
#include "tools/bench/timing.h"
#include "train/fit/random.h"
#include "train/metrics/ssim.h"

namespace warplut {
namespace {

// Mean SSIM over the valid region.
double OpenCvSsim(const cv::Mat& x, const cv::Mat& y) {
  const auto blur = [](const cv::Mat& image) {
    cv::Mat out;
    cv::GaussianBlur(image, out, cv::Size(kSsimWindow, kSsimWindow), kSsimSigma);
    return out;
  };
  const cv::Mat mx = blur(x), my = blur(y);
  const cv::Mat mxx = mx.mul(mx), myy = my.mul(my), mxy = mx.mul(my);
  const cv::Mat vx = blur(x.mul(x)) - mxx, vy = blur(y.mul(y)) - myy, cxy = blur(x.mul(y)) - mxy;
  const cv::Mat above = (2 * mxy + kSsimC1).mul(2 * cxy + kSsimC2);
  const cv::Mat below = (mxx + myy + kSsimC1).mul(vx + vy + kSsimC2);
  cv::Mat map;
  cv::divide(above, below, map);
  const int edge = kSsimWindow / 2;
  return cv::mean(map(cv::Rect(edge, edge, x.cols - 2 * edge, x.rows - 2 * edge)))[0];
}

}  // namespace

SsimBenchmark RunSsimBenchmark(int width, int height, int repeats) {
  cv::setNumThreads(1);
  cv::Mat y(height, width, CV_32F), x(height, width, CV_32F), gradient(height, width, CV_32F);
  Random random(1);
  for (int row = 0; row < height; ++row) {
    for (int i = 0; i < width; ++i) {
      const double wave = 0.5 + 0.3 * std::sin(0.21 * i + 0.13 * row);
      y.at<float>(row, i) = static_cast<float>(wave + 0.1 * random.Uniform());
      x.at<float>(row, i) = static_cast<float>(wave + 0.1 * random.Uniform());
    }
  }
  const auto view = [](const cv::Mat& m, int rows) {
    return PlaneView{m.ptr<float>(), m.cols, rows, static_cast<std::ptrdiff_t>(m.step1())};
  };
  const PlaneView vx = view(x, height), vy = view(y, height);
  SsimBenchmark benchmark;
  const int checked = std::min(height, 64);  // the reference is slow
  benchmark.error = std::abs(Ssim(view(y, checked)).Mean(view(x, checked)) -
                             SsimReference(view(x, checked), view(y, checked)));
  const double difference = std::abs(OpenCvSsim(x, y) - Ssim(vy).Mean(vx));
  if (benchmark.error > kSsimAccuracy || difference > 1e-4) {
    throw Error(
        fmt::format("SSIM is off by {} from its reference and by {} from OpenCV's; expected at "
                    "most {} and 1e-4.",
                    benchmark.error, difference, kSsimAccuracy));
  }
  const Ssim ssim(vy);
  const auto stride = static_cast<std::ptrdiff_t>(gradient.step1());
  std::vector<double> ours, prepared, ratios;
  for (int i = 0; i <= repeats; ++i) {  // the first is a warm-up
    gradient.setTo(0);
    const double own =
        Milliseconds([&] { ssim.MeanAndGradient(vx, 1, gradient.ptr<float>(), stride); });
    const double whole = Milliseconds([&] {
      const Ssim fresh(vy);
      fresh.MeanAndGradient(vx, 1, gradient.ptr<float>(), stride);
    });
    const double other = Milliseconds([&] { OpenCvSsim(x, y); });
    if (i == 0) continue;
    ours.push_back(own);
    prepared.push_back(whole);
    ratios.push_back(other / own);
  }
  const double kilopixels = 1e-3 * width * height;  // per millisecond: megapixels per second
  benchmark.mpixels = kilopixels / Summarise(ours).median;
  benchmark.prepared_mpixels = kilopixels / Summarise(prepared).median;
  benchmark.opencv_ratio = Summarise(ratios).median;
  return benchmark;
}

}  // namespace warplut
