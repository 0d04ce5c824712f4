#include "train/head_batch.h"

#include "luts/head.h"

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

HeadBatch::HeadBatch() : input_(2, kPoints) {
  for (int p = 0; p < kPoints; ++p) {
    input_(0, p) = 2 * NodeOffset(p % kSide) - 1;
    input_(1, p) = 2 * NodeOffset(p / kSide) - 1;
  }
}

const CanonicalWeights<double>& HeadBatch::Forward(const double* parameters) {
  const Matrix* in = &input_;
  for (int l = 0; l < kMlpLayers; ++l) {
    const int n_in = kMlpWidths[l];
    const int n_out = kMlpWidths[l + 1];
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
    const double dx = NodeOffset(i);
    const double dy = NodeOffset(j);
    const Weights<double> mask = Separable(HeadMask(dx), HeadMask(dy));
    const Weights<double> base = KeysWeights(kCatmullRomA, dx, dy);
    const Weights<double> spread = BilinearWeights(dx, dy);
    Weights<double> residual{};
    for (int g = 0; g < kSymmetries; ++g) {
      const int p = ImagePoint(g, i, j);
      for (int k = 0; k < kWeights; ++k) residual[k] += raw(MapWeight(g, k), p);
    }
    double sum = 0;
    for (int k = 0; k < kWeights; ++k) {
      residual[k] *= mask[k] / kSymmetries;
      sum += residual[k];
    }
    for (int k = 0; k < kWeights; ++k) weights_[c][k] = base[k] + residual[k] - sum * spread[k];
  }
  return weights_;
}

void HeadBatch::Backward(const double* parameters, const CanonicalWeights<double>& weight_gradient,
                         double* parameter_gradient) {
  Matrix& last = delta_.back();
  last.setZero(kWeights, kPoints);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    const double dx = NodeOffset(i);
    const double dy = NodeOffset(j);
    const Weights<double> mask = Separable(HeadMask(dx), HeadMask(dy));
    const Weights<double> spread = BilinearWeights(dx, dy);
    const Weights<double>& gradient = weight_gradient[c];
    double along = 0;
    for (int k = 0; k < kWeights; ++k) along += gradient[k] * spread[k];
    for (int g = 0; g < kSymmetries; ++g) {
      const int p = ImagePoint(g, i, j);
      for (int k = 0; k < kWeights; ++k) {
        last(MapWeight(g, k), p) += (gradient[k] - along) * mask[k] / kSymmetries;
      }
    }
  }
  for (int l = kMlpLayers - 1; l >= 0; --l) {
    const int n_in = kMlpWidths[l];
    const int n_out = kMlpWidths[l + 1];
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
