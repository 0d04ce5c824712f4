#include "train/sample_grid.h"

#include <algorithm>
#include <cmath>

#include "runtime/gates.h"

namespace warplut {
namespace {

int SampleCount(int pixels, double scale) { return static_cast<int>(std::ceil(pixels / scale)); }

// Taps of the positions at(0) .. at(count - 1), in units of the `size` values read, the first of
// which is at 0.
template <class At>
LinearTaps MakeTaps(int count, int size, const At& at) {
  LinearTaps taps;
  for (int i = 0; i < count; ++i) {
    const double position = std::clamp(at(i), 0.0, size - 1.0);
    const int first = std::min(static_cast<int>(position), size - 2);
    taps.first.push_back(first);
    taps.fraction.push_back(static_cast<float>(position - first));
  }
  return taps;
}

float Lerp(const float* values, int first, float fraction) {
  return values[first] + fraction * (values[first + 1] - values[first]);
}

void Spread(float value, int first, float fraction, float* values) {
  values[first] += (1 - fraction) * value;
  values[first + 1] += fraction * value;
}

void AddScaled(float factor, const float* from, int count, float* to) {
  for (int i = 0; i < count; ++i) to[i] += factor * from[i];
}

}  // namespace

SampleGrid::SampleGrid(const SampleGridOptions& options, const Vec2& jitter)
    : options_(options), jitter_(jitter) {
  const double scale = options.scale;
  const int columns = SampleCount(options.width, scale);
  const int rows = SampleCount(options.height, scale);
  const auto in_samples = [scale](int pixel, double offset) {
    return (pixel + 0.5) / scale - 0.5 - offset;
  };
  pixel_x_ = MakeTaps(options.width, columns, [&](int x) { return in_samples(x, jitter.x); });
  pixel_y_ = MakeTaps(options.height, rows, [&](int y) { return in_samples(y, jitter.y); });
  sample_x_ = MakeTaps(columns, options.width, [&](int i) { return PositionX(i) - 0.5; });
  sample_y_ = MakeTaps(rows, options.height, [&](int j) { return PositionY(j) - 0.5; });
  const auto to_nearest = [](double position, int count) {
    return position - std::clamp(std::round(position), 0.0, count - 1.0);
  };
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const double distance = std::hypot(to_nearest(in_samples(x, jitter.x), columns),
                                         to_nearest(in_samples(y, jitter.y), rows));
      share_.push_back(
          static_cast<float>(BlendShare(options.blend_a, SampleWeight(options.blend_b, distance))));
    }
  }
}

void SampleGrid::Interpolate(std::span<const float> samples, BorderedPlane& out) const {
  const int width = options_.width;
  std::vector<float> wide(static_cast<std::size_t>(rows()) * width);
  for (int j = 0; j < rows(); ++j) {
    const float* from = samples.data() + static_cast<std::size_t>(j) * columns();
    float* to = wide.data() + static_cast<std::size_t>(j) * width;
    for (int x = 0; x < width; ++x) to[x] = Lerp(from, pixel_x_.first[x], pixel_x_.fraction[x]);
  }
  for (int y = 0; y < options_.height; ++y) {
    const float* above = wide.data() + static_cast<std::size_t>(pixel_y_.first[y]) * width;
    const float* below = above + width;
    const float fraction = pixel_y_.fraction[y];
    float* to = out.row(y);
    for (int x = 0; x < width; ++x) to[x] = above[x] + fraction * (below[x] - above[x]);
  }
}

void SampleGrid::Read(const BorderedPlane& image, std::span<float> samples) const {
  const int width = options_.width;
  std::vector<float> line(width);
  for (int j = 0; j < rows(); ++j) {
    const float* above = image.row(sample_y_.first[j]);
    const float* below = image.row(sample_y_.first[j] + 1);
    const float fraction = sample_y_.fraction[j];
    for (int x = 0; x < width; ++x) line[x] = above[x] + fraction * (below[x] - above[x]);
    float* to = samples.data() + static_cast<std::size_t>(j) * columns();
    for (int i = 0; i < columns(); ++i) {
      to[i] = Lerp(line.data(), sample_x_.first[i], sample_x_.fraction[i]);
    }
  }
}

void SampleGrid::Refresh(std::span<const float> samples, const BorderedPlane& history,
                         BorderedPlane& out) const {
  std::vector<float> residual(samples.size());
  Read(history, residual);
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = samples[i] - residual[i];
  Interpolate(residual, out);
  for (int y = 0; y < options_.height; ++y) {
    const float* share = &share_[static_cast<std::size_t>(y) * options_.width];
    const float* from = history.row(y);
    float* to = out.row(y);
    for (int x = 0; x < options_.width; ++x) to[x] = from[x] + share[x] * to[x];
  }
}

void SampleGrid::AdjointRefresh(BorderedPlane& gradient) const {
  const int width = options_.width;
  // I' (share gradient): rows first, then columns.
  std::vector<float> wide(static_cast<std::size_t>(rows()) * width, 0.0f);
  std::vector<float> line(width);
  for (int y = 0; y < options_.height; ++y) {
    const float* share = &share_[static_cast<std::size_t>(y) * width];
    const float* from = gradient.row(y);
    for (int x = 0; x < width; ++x) line[x] = share[x] * from[x];
    float* above = wide.data() + static_cast<std::size_t>(pixel_y_.first[y]) * width;
    const float fraction = pixel_y_.fraction[y];
    AddScaled(1 - fraction, line.data(), width, above);
    AddScaled(fraction, line.data(), width, above + width);
  }
  std::vector<float> samples(columns());
  for (int j = 0; j < rows(); ++j) {
    std::fill(samples.begin(), samples.end(), 0.0f);
    const float* from = wide.data() + static_cast<std::size_t>(j) * width;
    for (int x = 0; x < width; ++x) {
      Spread(from[x], pixel_x_.first[x], pixel_x_.fraction[x], samples.data());
    }
    // B' of this row of samples.
    std::fill(line.begin(), line.end(), 0.0f);
    for (int i = 0; i < columns(); ++i) {
      Spread(samples[i], sample_x_.first[i], sample_x_.fraction[i], line.data());
    }
    const int above = sample_y_.first[j];
    const float fraction = sample_y_.fraction[j];
    AddScaled(fraction - 1, line.data(), width, gradient.row(above));
    AddScaled(-fraction, line.data(), width, gradient.row(above + 1));
  }
}

}  // namespace warplut
