#include "luts/quantize/real_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "luts/fit/head.h"

namespace warplut {
namespace {

constexpr int kStencil = 4;

struct Stencil {
  int first = 0;
  std::array<double, kStencil> weights{};
};

// The cubic Lagrange weights of the nodes first..first + 3 at position t, in intervals.
Stencil LagrangeStencil(double t, int intervals) {
  Stencil s;
  s.first = std::clamp(static_cast<int>(std::floor(t)) - 1, 0, intervals - kStencil + 1);
  for (int a = 0; a < kStencil; ++a) {
    s.weights[a] = 1;
    for (int b = 0; b < kStencil; ++b) {
      if (b != a) s.weights[a] *= (t - (s.first + b)) / (a - b);
    }
  }
  return s;
}

}  // namespace

RealTable SampleWeights(const std::string& name, int intervals, const WeightFunction& weights) {
  RealTable table{.name = name, .intervals = intervals, .rows = {}};
  table.rows.reserve(static_cast<std::size_t>(intervals + 1) * (intervals + 1));
  for (int jy = 0; jy <= intervals; ++jy) {
    for (int ix = 0; ix <= intervals; ++ix) {
      table.rows.push_back(
          weights(static_cast<double>(ix) / intervals, static_cast<double>(jy) / intervals));
    }
  }
  return table;
}

Weights<double> FitWeights(const Fit& fit, double dx, double dy) {
  const double* parameters = fit.parameters.data();
  if (fit.footprint != Footprint::k16) {
    return HeadWeights(fit.footprint, fit.kaiser_b, parameters, dx, dy);
  }
  if (!HasPrefilter(fit.prefilter)) return HeadWeights(parameters, dx, dy);
  return HeadWeights(parameters, dx, dy, static_cast<double>(fit.prefilter.side));
}

RealTable SampleFit(const Fit& fit, int intervals) {
  RealTable table = SampleWeights(fit.name, intervals,
                                  [&fit](double dx, double dy) { return FitWeights(fit, dx, dy); });
  table.prefilter = fit.prefilter;
  table.footprint = fit.footprint;
  return table;
}

RealTable Resample(const RealTable& table, int intervals) {
  RealTable resampled = SampleWeights(table.name, intervals, [&table](double dx, double dy) {
    const Stencil x = LagrangeStencil(dx * table.intervals, table.intervals);
    const Stencil y = LagrangeStencil(dy * table.intervals, table.intervals);
    Weights<double> w{};
    for (int b = 0; b < kStencil; ++b) {
      for (int a = 0; a < kStencil; ++a) {
        const Weights<double>& node = table.Row(x.first + a, y.first + b);
        for (int k = 0; k < kWeights; ++k) w[k] += x.weights[a] * y.weights[b] * node[k];
      }
    }
    CloseSum(&w, dx, dy);
    return w;
  });
  resampled.prefilter = table.prefilter;
  resampled.footprint = table.footprint;
  return resampled;
}

void CloseSum(Weights<double>* w, double dx, double dy) {
  double rest = 1;
  for (const double value : *w) rest -= value;
  const Weights<double> spread = BilinearWeights(dx, dy);
  for (int k = 0; k < kWeights; ++k) (*w)[k] += rest * spread[k];
}

bool IsContractZero(bool prefiltered, int intervals, int ix, int jy, int k) {
  const auto zero = [=](int node, int tap) {
    if (prefiltered) return (node == 0 && tap == 2) || (node == intervals && tap == -1);
    return (node == 0 && tap != 0) || (node == intervals && tap != 1);
  };
  return zero(ix, TapX(k)) || zero(jy, TapY(k));
}

int MirroredTap(bool prefiltered, int intervals, int i, int tap) {
  if (!prefiltered) return tap;
  if (i == 0 && tap >= -1 && tap <= 1) return -tap;
  if (i == intervals && tap >= 0 && tap <= 2) return 2 - tap;
  return tap;
}

double Asymmetry(const RealTable& table) {
  double worst = 0;
  for (int jy = 0; jy <= table.intervals; ++jy) {
    for (int ix = 0; ix <= table.intervals; ++ix) {
      const Weights<double>& row = table.Row(ix, jy);
      for (int g = 1; g < kSymmetries; ++g) {
        const auto [gx, gy] = MapOffset<int>(g, ix, jy, table.intervals);
        const Weights<double>& image = table.Row(gx, gy);
        for (int k = 0; k < kWeights; ++k) {
          worst = std::max(worst, std::abs(image[MapWeight(g, k)] - row[k]));
        }
      }
    }
  }
  return worst;
}

}  // namespace warplut
