#include "tests/stability/cases/gradients/gradient_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "datasets/tone_map.h"
#include "tests/stability/cases/gradients/gradient_reference.h"
#include "tests/stability/cases/training/training_images.h"
#include "train/calibration/gate_model.h"
#include "train/calibration/soft_fit.h"
#include "train/fit/objective/gain_penalty.h"
#include "train/fit/objective/mlp_objective.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rollout/noise_image.h"
#include "train/metrics/ssim_reference.h"

namespace warplut {
namespace {

constexpr int kSide = 20;  // of images whose SSIM is derived pixel by pixel

PlaneView View(const Image& image) {
  return {image.data.data(), image.width, image.height, image.width};
}

Image Disturbed(Image image, double amount) {
  Random random(9);
  for (float& value : image.data) {
    value = std::clamp(value + static_cast<float>(amount * (random.Uniform() - 0.5)), 0.0f, 1.0f);
  }
  return image;
}

// Against the complex step of every pixel.
double SsimError(const Image& x, const Image& y) {
  std::vector<float> gradient(x.data.size(), 0.0f);
  Ssim(View(y)).MeanAndGradient(View(x), 1, gradient.data(), x.width);
  std::vector<Complex> seeded(x.data.begin(), x.data.end());
  std::vector<double> exact;
  for (Complex& pixel : seeded) {
    pixel = Seeded(pixel.real(), 1);
    exact.push_back(Derivative(SsimReferenceAs<Complex>(seeded.data(), x.width, View(y))));
    pixel = pixel.real();
  }
  return RelativeError(gradient, exact);
}

// The error of g . v by HeadBatch against the complex step of the slow head, relative to the size
// of g.
StabilityResult HeadErrorAt(double scale, int directions, double bound) {
  std::vector<double> parameters = RandomParameters(3);
  for (double& p : parameters) p *= scale;
  const CanonicalWeights<double> factors = RandomSigns(1);
  HeadBatch batch;
  batch.Forward(parameters.data());
  std::vector<double> gradient(kMlpParameters);
  batch.Backward(parameters.data(), factors, gradient.data());
  const double size = LengthOf(gradient);

  Random random(2);
  double worst = 0;
  for (int i = 0; i < directions; ++i) {
    const auto [seeded, analytic] = RandomDirection(parameters, gradient, random);
    double exact = 0;
    for (int c = 0; c < kCanonicalNodes; ++c) {
      const auto [x, y] = CanonicalPosition(c);
      const auto weights = HeadWeights<Complex>(seeded.data(), NodeOffset(x), NodeOffset(y));
      for (int k = 0; k < kWeights; ++k) exact += factors[c][k] * Derivative(weights[k]);
    }
    worst = std::max(worst, std::abs(analytic - exact) / size);
  }
  return {worst <= bound, fmt::format("relative error {:.1e}", worst)};
}

int PartDirections(StabilityEffort effort) { return effort == StabilityEffort::kFull ? 16 : 2; }

}  // namespace

StabilityResult SsimGradient(StabilityEffort) {
  const Image noise = NoiseImage(kSide, kSide, 8);
  Image hdr = HdrImage(kSide, 3), dark = noise;
  for (float& value : hdr.data) value *= ToneMapFactor(value);
  for (float& value : dark.data) value *= 1e-4f;
  struct {
    const char* name;
    Image x, y;
  } const pairs[] = {
      {"noise", Disturbed(noise, 0.2), noise},
      {"all but equal", Disturbed(noise, 1e-3), noise},
      {"constant", ConstantImage(kSide, 0.3f), noise},
      {"constants", ConstantImage(kSide, 0.3f), ConstantImage(kSide, 0.7f)},
      {"white for black", ConstantImage(kSide, 1), ConstantImage(kSide, 0)},
      {"checkerboard", Disturbed(CheckerboardImage(kSide), 0.1), CheckerboardImage(kSide)},
      {"tone-mapped HDR", Disturbed(hdr, 0.1), hdr},
      {"1e-4 of the range", Disturbed(dark, 2e-5), dark},
  };
  double worst = 0;
  std::string observed;
  for (const auto& [name, x, y] : pairs) {
    const double error = SsimError(x, y);
    worst = std::max(worst, error);
    observed += fmt::format("{} {:.0e}, ", name, error);
  }
  std::vector<float> gradient(noise.data.size(), 0.0f);
  Ssim(View(noise)).MeanAndGradient(View(noise), 1, gradient.data(), noise.width);
  const bool zero = std::all_of(gradient.begin(), gradient.end(), [](float g) { return g == 0; });
  return {worst <= 1e-3 && zero,
          fmt::format("{}equal images {}", observed, zero ? "exactly 0" : "not 0")};
}

StabilityResult HeadGradient(StabilityEffort effort) {
  return HeadErrorAt(1, PartDirections(effort), 1e-13);
}
StabilityResult HeadGradientSaturated(StabilityEffort effort) {
  return HeadErrorAt(1e3, PartDirections(effort), 1e-13);
}
StabilityResult HeadGradientTiny(StabilityEffort effort) {
  return HeadErrorAt(1e-6, PartDirections(effort), 1e-13);
}

StabilityResult HeadGradientAtExtremeOffsets(StabilityEffort) {
  constexpr double kEpsilon = 0x1p-53;
  const Weights<double> factors = RandomSigns(4)[0];
  double worst = 0;
  for (const double dx : {0.0, 0.5, 1 - kEpsilon}) {
    for (const double dy : {0.0, 0.5, 1 - kEpsilon}) {
      const Weights<double> gradient = HeadAt<double>(dx, dy).Backward(factors);
      Weights<double> exact{};
      for (int j = 0; j < kWeights; ++j) {
        Weights<Complex> mean{};
        for (int k = 0; k < kWeights; ++k) mean[k] = Seeded(0.1 * (k % 5 - 2), k == j ? 1 : 0);
        const Weights<Complex> weights = HeadAt<Complex>(dx, dy).Forward(mean);
        for (int k = 0; k < kWeights; ++k) exact[j] += factors[k] * Derivative(weights[k]);
      }
      for (int j = 0; j < kWeights; ++j) {
        worst = std::max(worst, std::abs(gradient[j] - exact[j]));
      }
    }
  }
  return {worst <= 1e-14, fmt::format("absolute error {:.1e}", worst)};
}

// P is a polynomial of degree 4 but for what is cut off at 0, whose square is smooth to first
// order.
StabilityResult GainPenaltyGradient(StabilityEffort effort) {
  const GainPenalty penalty(1.005);
  std::vector<double> saturated = RandomParameters(1);
  for (double& p : saturated) p *= 1e3;
  HeadBatch head;
  struct {
    const char* name;
    CanonicalWeights<double> weights;
    double step;  // of the differences
  } const points[] = {
      {"Keys -0.75", KeysCanonicalWeights(-0.75), 1e-6},
      {"Keys -0.5", KeysCanonicalWeights(-0.5), 1e-6},
      {"saturated", head.Forward(saturated.data()), 1e-2},
  };
  double worst = 0;
  std::string observed;
  for (const auto& [name, weights, step] : points) {
    Resampler of_resampler, unused;
    penalty.AddGradient(weights, 1, of_resampler);
    const CanonicalWeights<double>& gradient = of_resampler.weights;
    const double size = std::sqrt(Dot(gradient, gradient));
    double error = 0;
    for (int i = 0; i < PartDirections(effort); ++i) {
      const CanonicalWeights<double> direction = RandomSigns(20 + i);
      const auto along = [&](double t) {
        CanonicalWeights<double> moved = weights;
        for (int c = 0; c < kCanonicalNodes; ++c) {
          for (int k = 0; k < kWeights; ++k) moved[c][k] += t * direction[c][k];
        }
        return penalty.AddGradient(moved, 0, unused);
      };
      const double difference = FourthOrderDifference(along, 0, step);
      error =
          std::max(error, std::abs(Dot(gradient, direction) - difference) / (size > 0 ? size : 1));
    }
    worst = std::max(worst, error);
    observed += fmt::format("{}{} {:.0e}", observed.empty() ? "" : ", ", name, error);
  }
  return {worst <= 1e-6, observed};
}

// The calibration has no analytic derivative: its steps of kDifference are compared with
// fourth-order differences a hundredth as long.
StabilityResult CalibrationDifferences(StabilityEffort) {
  const SearchSpace space({0, 3, 4}, {});
  GateModel model({});
  std::string observed;
  double least = 1;
  for (const float width : {0.8f, 0.4f, 0.2f, 0.1f}) {
    const Point point = {0.6, 0.5, 0.3};
    const auto loss = [&](std::size_t i, double x) {
      Point moved = point;
      moved[i] = x;
      std::vector<double> residuals(model.Size());
      model.Evaluate(space.ToParameters(moved), width, residuals);
      return LossOf(residuals);
    };
    double product = 0, square_a = 0, square_b = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const auto along = [&](double x) { return loss(i, x); };
      const double exact = FourthOrderDifference(along, point[i], kDifference / 10);
      const double used = (along(point[i] + kDifference) - along(point[i])) / kDifference;
      product += exact * used;
      square_a += exact * exact;
      square_b += used * used;
    }
    const double cosine = product / std::sqrt(square_a * square_b);
    least = std::min(least, cosine);
    observed += fmt::format("{}width {}: {:.4f}", observed.empty() ? "" : ", ", width, cosine);
  }
  return {least >= 0.95, "cosine at " + observed};
}

}  // namespace warplut
