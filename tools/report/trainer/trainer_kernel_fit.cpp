#include "tools/report/trainer/trainer_kernel_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "train/fit/objective/head_batch.h"

namespace warplut {
namespace {

constexpr int kConjugateSteps = 40;           // at most, in one step of the fit
constexpr double kConjugateTolerance = 0.05;  // of the residual of the linear system
constexpr double kFirstDamping = 1e-3;
constexpr double kLargestDamping = 1e8;
constexpr double kDifference = 1e-4;  // in parameter space, of the longest component
constexpr Eigen::Index kResiduals = Eigen::Index{kCanonicalNodes} * kWeights;

using Vector = Eigen::VectorXd;

class KernelFit {
 public:
  explicit KernelFit(const CanonicalWeights<double>& kernel) : kernel_(kernel) {}

  // r at the parameters, so that the loss is 1/2 |r|^2; J is taken there from now on.
  Vector Residuals(const Vector& parameters) {
    point_ = parameters;
    return ToVector(head_.Forward(point_.data()), &kernel_);
  }

  Vector TimesJacobian(const Vector& v) {
    const double reach = v.cwiseAbs().maxCoeff();
    if (reach == 0) return Vector::Zero(kResiduals);
    const double h = kDifference / reach;
    const Vector above = point_ + h * v, below = point_ - h * v;
    const Vector ahead = ToVector(probe_.Forward(above.data()), nullptr);
    return (ahead - ToVector(probe_.Forward(below.data()), nullptr)) / (2 * h);
  }

  Vector TimesTranspose(const Vector& u) {
    CanonicalWeights<double> weights{};
    for (Eigen::Index i = 0; i < kResiduals; ++i) {
      weights[static_cast<std::size_t>(i) / kWeights][static_cast<std::size_t>(i) % kWeights] =
          kScale * u[i];
    }
    Vector product(kMlpParameters);
    head_.Backward(point_.data(), weights, product.data());
    return product;
  }

 private:
  static inline const double kScale = 1 / std::sqrt(static_cast<double>(kCanonicalNodes));

  static Vector ToVector(const CanonicalWeights<double>& weights,
                         const CanonicalWeights<double>* minus) {
    Vector vector(kResiduals);
    for (Eigen::Index i = 0; i < kResiduals; ++i) {
      const auto c = static_cast<std::size_t>(i) / kWeights;
      const auto k = static_cast<std::size_t>(i) % kWeights;
      vector[i] = kScale * (weights[c][k] - (minus != nullptr ? (*minus)[c][k] : 0.0));
    }
    return vector;
  }

  const CanonicalWeights<double>& kernel_;
  HeadBatch head_, probe_;
  Vector point_;
};

// s with (J^T J + damping I) s = -gradient, roughly; *products counts pairs.
Vector Step(KernelFit& fit, const Vector& gradient, double damping, int* products) {
  Vector step = Vector::Zero(gradient.size());
  Vector residual = -gradient, direction = residual;
  double square = residual.squaredNorm();
  const double enough = kConjugateTolerance * kConjugateTolerance * square;
  for (int i = 0; i < kConjugateSteps && square > enough; ++i) {
    const Vector along = fit.TimesTranspose(fit.TimesJacobian(direction)) + damping * direction;
    ++*products;
    const double length = square / direction.dot(along);
    step += length * direction;
    residual -= length * along;
    const double next = residual.squaredNorm();
    direction = residual + next / square * direction;
    square = next;
  }
  return step;
}

}  // namespace

void FitKernelByLevenbergMarquardt(const CanonicalWeights<double>& kernel,
                                   const KernelFitCallback& callback,
                                   std::vector<double>& parameters) {
  KernelFit fit(kernel);
  Vector point = Eigen::Map<const Vector>(parameters.data(), kMlpParameters);
  Vector residuals = fit.Residuals(point);
  double loss = residuals.squaredNorm() / 2;
  double damping = kFirstDamping, growth = 2;
  int evaluations = 1;
  while (callback(evaluations, loss) && damping < kLargestDamping) {
    evaluations = 1;
    const Vector gradient = fit.TimesTranspose(residuals);
    if (!(gradient.squaredNorm() > 0)) break;
    const Vector step = Step(fit, gradient, damping, &evaluations);
    const double predicted = step.dot(damping * step - gradient) / 2;
    const Vector candidate = point + step;
    const Vector there = fit.Residuals(candidate);
    const double gained = loss - there.squaredNorm() / 2;
    if (gained > 0 && predicted > 0) {
      const double agreement = 2 * gained / predicted - 1;
      point = candidate;
      residuals = there;
      loss -= gained;
      damping *= std::max(1.0 / 3, 1 - agreement * agreement * agreement);
      growth = 2;
    } else {
      residuals = fit.Residuals(point);
      damping *= growth;
      growth *= 2;
    }
  }
  std::memcpy(parameters.data(), point.data(), kMlpParameters * sizeof(double));
}

}  // namespace warplut
