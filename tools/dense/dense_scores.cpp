#include "tools/dense/dense_scores.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/warp.h"
#include "tools/dense/dense_world.h"
#include "train/metrics/luma.h"
#include "train/metrics/temporal_error.h"
#include "train/replay/image_views.h"
#include "train/replay/motion_composition.h"

namespace warplut {
namespace {

constexpr int kBorder = 5;

Image Difference(const Image& a, const Image& b) {
  Image difference = a;
  for (std::size_t i = 0; i < a.data.size(); ++i) difference.data[i] -= b.data[i];
  return difference;
}

Image Mean(const std::vector<Image>& images) {
  Image mean = images.front();
  for (std::size_t i = 0; i < mean.data.size(); ++i) {
    double sum = 0;
    for (const Image& image : images) sum += image.data[i];
    mean.data[i] = static_cast<float>(sum / static_cast<double>(images.size()));
  }
  return mean;
}

Image Warped(const Image& image, const Image& motion) {
  const ImageBuffer from = ToBuffer(image, PixelFormat::kRgba32F);
  ImageBuffer to(image.width, image.height, PixelFormat::kRgba32F);
  WarpOptions options;
  options.filter = Filter::kCatmullRom;
  Warp(from, ToMotionBuffer(motion).view(), options, to);
  return ToImage(std::as_const(to).view());
}

// Pixels that stand still in all frames, where the luma of their mean has an edge.
std::vector<std::size_t> StaticEdges(const std::vector<Frame>& frames,
                                     const std::vector<Image>& ideal) {
  const Image luma = Luma(Mean(ideal));
  std::vector<std::size_t> edges;
  for (int y = kBorder; y < luma.height - kBorder; ++y) {
    for (int x = kBorder; x < luma.width - kBorder; ++x) {
      const bool still = std::all_of(frames.begin(), frames.end(), [&](const Frame& frame) {
        return frame.reference_motion.at(x, y, 0) == 0 && frame.reference_motion.at(x, y, 1) == 0;
      });
      const double gradient =
          std::hypot(luma.at(x + 1, y) - luma.at(x - 1, y), luma.at(x, y + 1) - luma.at(x, y - 1)) /
          2;
      if (still && gradient >= kStaticEdge) edges.push_back(luma.Index(x, y));
    }
  }
  return edges;
}

}  // namespace

DenseJudge::DenseJudge(std::vector<Frame> references) : references_(std::move(references)) {
  for (std::size_t i = 0; i < references_.size(); ++i) {
    ideal_.push_back(references_[i].reference);
    std::vector<MotionField> fields;
    for (std::size_t j = i / kSlowStep * kSlowStep + kSlowStep - 1; j > i; --j) {
      fields.push_back({&references_[j].reference_motion, &references_[j].reference_depth, {}});
    }
    motion_.push_back(fields.empty() ? Image(ideal_[i].width, ideal_[i].height, 2)
                                     : ComposeMotion(fields));
  }
  static_edges_ = StaticEdges(references_, ideal_);
}

int DenseJudge::Integrals() const { return static_cast<int>(ideal_.size()) / kSlowStep; }

Image DenseJudge::Fixed(const std::vector<Image>& shown, int k) const {
  const auto first = shown.begin() + std::ptrdiff_t{k} * kSlowStep;
  return Mean({first, first + kSlowStep});
}

Image DenseJudge::Tracking(const std::vector<Image>& shown, int k) const {
  std::vector<Image> followed;
  for (int i = k * kSlowStep; i < (k + 1) * kSlowStep; ++i) {
    followed.push_back(
        Warped(shown[static_cast<std::size_t>(i)], motion_[static_cast<std::size_t>(i)]));
  }
  return Mean(followed);
}

double DenseJudge::TemporalErrorOf(const std::vector<Image>& shown) const {
  TemporalErrorSum sum;
  for (std::size_t i = 1; i < shown.size(); ++i) {
    const auto depth = ToBuffer(references_[i].reference_depth, PixelFormat::kR32F);
    const auto depth_before = ToBuffer(references_[i - 1].reference_depth, PixelFormat::kR32F);
    const MotionBuffer motion = ToMotionBuffer(references_[i].reference_motion);
    const MotionBuffer motion_before = ToMotionBuffer(references_[i - 1].reference_motion);
    sum += TemporalError(Difference(shown[i], ideal_[i]), {depth, motion.view()},
                         Difference(shown[i - 1], ideal_[i - 1]),
                         {depth_before, motion_before.view()}, kBorder);
  }
  return sum.Rms();
}

double DenseJudge::StaticFlickerOf(const std::vector<Image>& shown) const {
  if (static_edges_.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sums(static_edges_.size()), squares(static_edges_.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Image error = Luma(Difference(shown[i], ideal_[i]));
    for (std::size_t e = 0; e < static_edges_.size(); ++e) {
      const double value = error.data[static_edges_[e]];
      sums[e] += value;
      squares[e] += value * value;
    }
  }
  const auto count = static_cast<double>(shown.size());
  double variance = 0;
  for (std::size_t e = 0; e < static_edges_.size(); ++e) {
    variance += std::max(0.0, squares[e] / count - sums[e] / count * sums[e] / count);
  }
  return std::sqrt(variance / static_cast<double>(static_edges_.size()));
}

DenseScores DenseJudge::Judge(const std::vector<Image>& shown) const {
  std::vector<FrameScore> fixed, tracking;
  for (int k = 0; k < Integrals(); ++k) {
    const std::string name = std::to_string(k);
    fixed.push_back(CompareImages(name, Fixed(shown, k), Fixed(ideal_, k), kBorder));
    tracking.push_back(CompareImages(name, Tracking(shown, k), Tracking(ideal_, k), kBorder));
  }
  DenseScores scores;
  scores.fixed = MeanScore(fixed);
  scores.tracking = MeanScore(tracking);
  scores.temporal_error = TemporalErrorOf(shown);
  scores.static_flicker = StaticFlickerOf(shown);
  return scores;
}

}  // namespace warplut
