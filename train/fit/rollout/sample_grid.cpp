#include "train/fit/rollout/sample_grid.h"

#include <algorithm>
#include <cmath>

#include "luts/filters.h"
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

template <class At>
CubicTaps MakeCubicTaps(int count, int size, const At& at) {
  CubicTaps taps;
  for (int i = 0; i < count; ++i) {
    const double position = std::clamp(at(i), 0.0, size - 1.0);
    const int texel = static_cast<int>(position);
    std::array<int, kTaps>& index = taps.index.emplace_back();
    for (int k = 0; k < kTaps; ++k) index[k] = std::clamp(texel + kFirstTap + k, 0, size - 1);
    taps.weight.push_back(
        KeysTaps(static_cast<float>(kCatmullRomA), static_cast<float>(position - texel)));
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
  sample_x_ = MakeCubicTaps(columns, options.width, [&](int i) { return PositionX(i) - 0.5; });
  sample_y_ = MakeCubicTaps(rows, options.height, [&](int j) { return PositionY(j) - 0.5; });
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
    std::fill(line.begin(), line.end(), 0.0f);
    for (int k = 0; k < kTaps; ++k) {
      AddScaled(sample_y_.weight[j][k], image.row(sample_y_.index[j][k]), width, line.data());
    }
    float* to = samples.data() + static_cast<std::size_t>(j) * columns();
    for (int i = 0; i < columns(); ++i) {
      const std::array<int, kTaps>& index = sample_x_.index[i];
      const std::array<float, kTaps>& weight = sample_x_.weight[i];
      to[i] = weight[0] * line[index[0]] + weight[1] * line[index[1]] + weight[2] * line[index[2]] +
              weight[3] * line[index[3]];
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
      for (int k = 0; k < kTaps; ++k) {
        line[sample_x_.index[i][k]] += sample_x_.weight[i][k] * samples[i];
      }
    }
    for (int k = 0; k < kTaps; ++k) {
      AddScaled(-sample_y_.weight[j][k], line.data(), width, gradient.row(sample_y_.index[j][k]));
    }
  }
}

}  // namespace warplut
