#include "train/fit/objective/head_batch.h"

namespace warplut {
namespace {

constexpr int kSide = kNodes + 1;
constexpr int kPoints = kSide * kSide;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The point that symmetry g maps node (i, j) to.
int ImagePoint(int g, int i, int j) {
  const auto [x, y] = MapOffset(g, i, j, kNodes);
  return y * kSide + x;
}

}  // namespace

HeadBatch::HeadBatch(Footprint footprint, double kaiser_b)
    : footprint_(footprint), input_(2, kPoints) {
  const FootprintTaps& taps = TapsOf(footprint);
  for (int i = 0; i < taps.count; ++i) place_[taps[i]] = i;
  for (int p = 0; p < kPoints; ++p) {
    input_(0, p) = 2 * NodeOffset(p % kSide) - 1;
    input_(1, p) = 2 * NodeOffset(p / kSide) - 1;
  }
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    const double dx = NodeOffset(i), dy = NodeOffset(j);
    if (footprint == Footprint::k16) {
      heads_.emplace_back(dx, dy);
    } else {
      heads_.emplace_back(footprint, WideWeights(footprint, kaiser_b, dx, dy), dx, dy);
    }
  }
}

void HeadBatch::SetSide(double side) {
  if (side == side_) return;
  side_ = side;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    heads_[c] = HeadAt<double>(NodeOffset(i), NodeOffset(j), side);
  }
}

double HeadBatch::SideGradient(const CanonicalWeights<double>& weight_gradient) const {
  double sum = 0;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    for (int k = 0; k < kWeights; ++k) sum += weight_gradient[c][k] * heads_[c].base_slope()[k];
  }
  return sum;
}

const CanonicalWeights<double>& HeadBatch::Forward(const double* parameters) {
  const Matrix* in = &input_;
  for (int l = 0; l < kMlpLayers; ++l) {
    const int n_in = MlpWidth(l, footprint_);
    const int n_out = MlpWidth(l + 1, footprint_);
    const double* at = parameters + MlpLayerOffset(l);
    const Eigen::Map<const RowMajor> weight(at, n_out, n_in);
    const Eigen::Map<const Eigen::VectorXd> bias(at + n_in * n_out, n_out);
    activation_[l].noalias() = weight * *in;
    activation_[l].colwise() += bias;
    if (l + 1 < kMlpLayers) activation_[l] = activation_[l].array().tanh().matrix();
    in = &activation_[l];
  }
  const Matrix& raw = activation_.back();
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    Weights<double> mean{};
    for (int g = 0; g < kSymmetries; ++g) {
      const int p = ImagePoint(g, i, j);
      for (const int k : TapsOf(footprint_)) {
        mean[k] += raw(place_[MapWeight(g, k)], p) / kSymmetries;
      }
    }
    weights_[c] = heads_[c].Forward(mean);
  }
  return weights_;
}

void HeadBatch::Backward(const double* parameters, const CanonicalWeights<double>& weight_gradient,
                         double* parameter_gradient) {
  Matrix& last = delta_.back();
  last.setZero(TapCount(footprint_), kPoints);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    const Weights<double> mean = heads_[c].Backward(weight_gradient[c]);
    for (int g = 0; g < kSymmetries; ++g) {
      const int p = ImagePoint(g, i, j);
      for (const int k : TapsOf(footprint_)) {
        last(place_[MapWeight(g, k)], p) += mean[k] / kSymmetries;
      }
    }
  }
  for (int l = kMlpLayers - 1; l >= 0; --l) {
    const int n_in = MlpWidth(l, footprint_);
    const int n_out = MlpWidth(l + 1, footprint_);
    const double* at = parameters + MlpLayerOffset(l);
    double* out = parameter_gradient + MlpLayerOffset(l);
    const Matrix& in = l > 0 ? activation_[l - 1] : input_;
    Eigen::Map<RowMajor> weight_out(out, n_out, n_in);
    Eigen::Map<Eigen::VectorXd> bias_out(out + n_in * n_out, n_out);
    weight_out.noalias() = delta_[l] * in.transpose();
    bias_out = delta_[l].rowwise().sum();
    if (l > 0) {
      const Eigen::Map<const RowMajor> weight(at, n_out, n_in);
      delta_[l - 1].noalias() = weight.transpose() * delta_[l];
      delta_[l - 1].array() *= 1.0 - in.array().square();
    }
  }
}

}  // namespace warplut
