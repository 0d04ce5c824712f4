#include "train/replay/optical_flow.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/video/tracking.hpp>

#include "luts/luma_weights.h"
#include "runtime/core/pixel.h"
#include "train/metrics/displayed_color.h"

namespace warplut {

struct OpticalFlow::State {
  ColorEncoding encoding;
  cv::Ptr<cv::DISOpticalFlow> search;
  cv::Mat before, now, flow;
};

namespace {

void FillLuma(ColorEncoding encoding, const ImageView& image, cv::Mat& luma) {
  for (int y = 0; y < image.height; ++y) {
    auto* row = luma.ptr<std::uint8_t>(y);
    for (int x = 0; x < image.width; ++x) {
      float rgb[3];
      for (int c = 0; c < 3; ++c) {
        const float v = LoadChannel(image.format, image.At(x, y), c) / ChannelScale(image.format);
        rgb[c] = std::isfinite(v) ? v : 0.0f;
      }
      ToDisplay(encoding, rgb);
      double sum = 0;
      for (int c = 0; c < 3; ++c) sum += kLumaWeights[c] * std::clamp(rgb[c], 0.0f, 1.0f);
      row[x] = RoundToCode(static_cast<float>(255 * sum));
    }
  }
}

}  // namespace

OpticalFlow::OpticalFlow(int width, int height, ColorEncoding encoding)
    : state_(std::make_unique<State>()) {
  cv::setNumThreads(1);
  state_->encoding = encoding;
  state_->search = cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_MEDIUM);
  state_->before.create(height, width, CV_8UC1);
  state_->now.create(height, width, CV_8UC1);
}

OpticalFlow::~OpticalFlow() = default;

void OpticalFlow::Find(const ImageView& before, const ImageView& now,
                       const MutableMotionView& motion) {
  const bool searches = std::min(now.width, now.height) >= kLeastFlowSize;
  if (searches) {
    FillLuma(state_->encoding, before, state_->before);
    FillLuma(state_->encoding, now, state_->now);
    state_->search->calc(state_->now, state_->before, state_->flow);
  }
  for (int y = 0; y < now.height; ++y) {
    float* row = motion.Row(y);
    for (int x = 0; x < now.width; ++x) {
      // The flow leads from now to before, the motion the other way.
      const cv::Point2f flow = searches ? state_->flow.at<cv::Point2f>(y, x) : cv::Point2f();
      row[2 * x] = std::isfinite(flow.x) ? -flow.x : 0.0f;
      row[2 * x + 1] = std::isfinite(flow.y) ? -flow.y : 0.0f;
    }
  }
}

}  // namespace warplut
