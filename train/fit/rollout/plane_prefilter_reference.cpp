#include "train/fit/rollout/plane_prefilter.h"

namespace warplut {
namespace {

// Along one line, in double.
void ReferenceLine(const RealPrefilter& p, std::vector<double>& x) {
  const int n = static_cast<int>(x.size());
  if (p.kind == PrefilterKind::kFir) {
    std::vector<double> out(x.size());
    for (int i = 0; i < n; ++i) {
      out[i] = p.taps[0] * x[i];
      for (int j = 1; j <= p.reach; ++j) {
        out[i] += p.taps[j] * (x[ContinuedPixel(i - j, n, Border::kMirrored)] +
                               x[ContinuedPixel(i + j, n, Border::kMirrored)]);
      }
    }
    x = out;
    return;
  }
  // Elimination with the matrix [m + s, s; s, m, s; ...; s, m + s].
  const double s = p.side;
  std::vector<double> upper(x.size());
  double below = 0;  // the entry left of the diagonal that is eliminated, times the row above
  for (int i = 0; i < n; ++i) {
    const double diagonal = 1 - 2 * s + (i == 0 ? s : 0) + (i == n - 1 ? s : 0);
    const double pivot = diagonal - (i > 0 ? s * upper[i - 1] : 0);
    upper[i] = s / pivot;
    x[i] = (x[i] - s * below) / pivot;
    below = x[i];
  }
  for (int i = n - 2; i >= 0; --i) x[i] -= upper[i] * x[i + 1];
}

}  // namespace

std::vector<double> PlanePrefilter::Reference(const RealPrefilter& prefilter, int width, int height,
                                              std::vector<double> samples) {
  const auto at = [&](int x, int y) -> double& {
    return samples[static_cast<std::size_t>(y) * width + x];
  };
  std::vector<double> line(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) line[x] = at(x, y);
    ReferenceLine(prefilter, line);
    for (int x = 0; x < width; ++x) at(x, y) = line[x];
  }
  line.resize(static_cast<std::size_t>(height));
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < height; ++y) line[y] = at(x, y);
    ReferenceLine(prefilter, line);
    for (int y = 0; y < height; ++y) at(x, y) = line[y];
  }
  return samples;
}

}  // namespace warplut
