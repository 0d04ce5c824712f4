#include "train/metrics/jitter_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace warplut {
namespace {

constexpr int kLatticeCells = 8;  // render pixels of a window, in each axis

// The window's weights, over their sum, times a wave at each frequency.
struct Wave {
  std::vector<double> real, imaginary;
};

Wave MakeWave(int length, double frequency) {
  Wave wave;
  double sum = 0;
  for (int i = 0; i < length; ++i) {
    const double turn = (i + 0.5) / length;
    const double weight = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * turn);
    const double angle = 2 * std::numbers::pi * frequency * i;
    wave.real.push_back(weight * std::cos(angle));
    wave.imaginary.push_back(-weight * std::sin(angle));
    sum += weight;
  }
  for (int i = 0; i < length; ++i) {
    wave.real[static_cast<std::size_t>(i)] /= sum;
    wave.imaginary[static_cast<std::size_t>(i)] /= sum;
  }
  return wave;
}

// Frequencies along one axis: 0, that of the grid, and those beside both.
enum AxisFrequency { kZero, kAboveZero, kGrid, kBelowGrid, kAboveGrid, kAxisFrequencies };

struct Axis {
  Axis(double scale, int size, int border)
      : length(std::max(2, static_cast<int>(std::lround(kLatticeCells * scale)))),
        has_lattice(scale > 1) {
    const double beside = 2.0 / length, grid = 1 / scale;
    for (const double frequency : {0.0, beside, grid, grid - beside, grid + beside}) {
      waves.push_back(MakeWave(length, frequency));
    }
    for (int at = border; at + length <= size - border; at += length / 2) windows.push_back(at);
    is_own_mirror = std::abs(std::remainder(2 * grid, 1.0)) < 1e-9;
  }

  int length;
  bool has_lattice;
  bool is_own_mirror;  // the grid's frequency is that of its negative, as 1/2 is
  std::vector<Wave> waves;
  std::vector<int> windows;
};

using Amplitudes = std::array<std::complex<double>, kAxisFrequencies>;

// One frequency of the lattice: along x, along y, and those that replace them beside it.
struct Line {
  AxisFrequency x, y;
  std::array<AxisFrequency, 2> beside_x, beside_y;
  bool mirrored_y = false;
  double weight = 2;  // with that of its negative
};

std::vector<Line> LinesOf(const Axis& x, const Axis& y) {
  constexpr std::array<AxisFrequency, 2> kBesideZero = {kAboveZero, kAboveZero};
  constexpr std::array<AxisFrequency, 2> kBesideGrid = {kBelowGrid, kAboveGrid};
  std::vector<Line> lines;
  if (x.has_lattice) {
    lines.push_back({kGrid, kZero, kBesideGrid, kBesideZero, false, x.is_own_mirror ? 1.0 : 2.0});
  }
  if (y.has_lattice) {
    lines.push_back({kZero, kGrid, kBesideZero, kBesideGrid, false, y.is_own_mirror ? 1.0 : 2.0});
  }
  if (x.has_lattice && y.has_lattice) {
    const bool both = x.is_own_mirror && y.is_own_mirror;
    lines.push_back({kGrid, kGrid, kBesideGrid, kBesideGrid, false, both ? 1.0 : 2.0});
    if (!x.is_own_mirror && !y.is_own_mirror) {
      lines.push_back({kGrid, kGrid, kBesideGrid, kBesideGrid, true, 2.0});
    }
  }
  return lines;
}

// The energy of one window.
class Window {
 public:
  Window(const Image& error, const Axis& x, const Axis& y, int left, int top) : x_(x), y_(y) {
    rows_.reserve(static_cast<std::size_t>(y.length));
    for (int j = 0; j < y.length; ++j) {
      const float* row = error.data.data() + error.Index(left, top + j);
      Amplitudes& sums = rows_.emplace_back();
      for (int k = 0; k < kAxisFrequencies; ++k) {
        const Wave& wave = x.waves[static_cast<std::size_t>(k)];
        double real = 0, imaginary = 0;
        for (std::size_t i = 0; i < wave.real.size(); ++i) {
          real += wave.real[i] * static_cast<double>(row[i]);
          imaginary += wave.imaginary[i] * static_cast<double>(row[i]);
        }
        sums[static_cast<std::size_t>(k)] = {real, imaginary};
      }
    }
  }

  double Energy(const Line& line) const {
    double beside = 0;
    for (const AxisFrequency x : line.beside_x) beside += Power(x, line.y, line.mirrored_y);
    for (const AxisFrequency y : line.beside_y) beside += Power(line.x, y, line.mirrored_y);
    return line.weight * (Power(line.x, line.y, line.mirrored_y) - beside / 4);
  }

 private:
  double Power(AxisFrequency x, AxisFrequency y, bool mirrored) const {
    const Wave& wave = y_.waves[static_cast<std::size_t>(y)];
    std::complex<double> sum = 0;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      const double imaginary = mirrored ? -wave.imaginary[j] : wave.imaginary[j];
      sum += std::complex<double>(wave.real[j], imaginary) * rows_[j][static_cast<std::size_t>(x)];
    }
    return std::norm(sum);
  }

  const Axis& x_;
  const Axis& y_;
  std::vector<Amplitudes> rows_;
};

}  // namespace

std::optional<int> JitterPeriod(std::span<const Vec2> offsets) {
  const auto same = [](const Vec2& a, const Vec2& b) { return a.x == b.x && a.y == b.y; };
  for (std::size_t period = 1; period < offsets.size(); ++period) {
    if (!std::equal(offsets.begin() + static_cast<std::ptrdiff_t>(period), offsets.end(),
                    offsets.begin(), same)) {
      continue;
    }
    if (period == 1) return std::nullopt;
    return static_cast<int>(period);
  }
  return std::nullopt;
}

ErrorEnergy& ErrorEnergy::operator+=(const ErrorEnergy& other) {
  sum += other.sum;
  values += other.values;
  return *this;
}

double ErrorEnergy::Mean() const {
  if (values == 0) return std::numeric_limits<double>::quiet_NaN();
  return sum / static_cast<double>(values);
}

double ErrorEnergy::Rms() const { return values == 0 ? Mean() : std::sqrt(std::max(Mean(), 0.0)); }

JitterErrorSum::JitterErrorSum(int period, int border)
    : period_(period),
      border_(border),
      errors_(static_cast<std::size_t>(period)),
      detrended_(static_cast<std::size_t>(period) + 1) {}

void JitterErrorSum::Add(const Image& error) {
  const std::size_t pixels = error.pixels();
  if (window_.empty()) {
    window_.assign(pixels, 0);
    for (auto* ring : {&errors_, &detrended_}) {
      for (std::vector<float>& slot : *ring) slot.assign(pixels, 0);
    }
  }
  const std::int64_t frame = count_++;
  std::vector<float>& newest = Slot(errors_, frame);  // holds the oldest, which leaves the window
  // The window's frames are [f - floor(P / 2), f + P - floor(P / 2)), its last one is `frame`.
  const std::int64_t middle = frame - (period_ - 1 - period_ / 2);
  const bool detrends = frame >= period_ - 1;
  const bool multiplies = detrends && middle - period_ >= period_ / 2;
  const std::vector<float>& centre = Slot(errors_, std::max<std::int64_t>(middle, 0));
  std::vector<float>& now = Slot(detrended_, std::max<std::int64_t>(middle, 0));
  const std::vector<float>& before = Slot(detrended_, std::max<std::int64_t>(middle - period_, 0));
  std::vector<ErrorEnergy> rows(static_cast<std::size_t>(error.height));
  tbb::parallel_for(border_, std::max(border_, error.height - border_), [&](int y) {
    ErrorEnergy& row = rows[static_cast<std::size_t>(y)];
    for (int x = border_; x < error.width - border_; ++x) {
      const std::size_t i = error.Index(x, y);
      window_[i] += static_cast<double>(error.data[i]) - static_cast<double>(newest[i]);
      newest[i] = error.data[i];
      if (!detrends) continue;
      now[i] = static_cast<float>(static_cast<double>(centre[i]) - window_[i] / period_);
      if (!multiplies) continue;
      row.sum += static_cast<double>(now[i]) * static_cast<double>(before[i]);
      ++row.values;
    }
  });
  if (!multiplies) return;
  ErrorEnergy& total = products_.emplace_back();
  for (const ErrorEnergy& row : rows) total += row;
}

void JitterErrorSum::Restart() {
  finished_ = Energy();
  products_.clear();
  window_.clear();
  count_ = 0;
}

ErrorEnergy JitterErrorSum::Energy() const {
  ErrorEnergy energy = finished_;
  const std::size_t whole =
      products_.size() / static_cast<std::size_t>(period_) * static_cast<std::size_t>(period_);
  for (std::size_t i = products_.size() - whole; i < products_.size(); ++i) energy += products_[i];
  return energy;
}

ErrorEnergy LatticeEnergy(const Image& error, double scale_x, double scale_y, int border) {
  const Axis x(scale_x, error.width, border), y(scale_y, error.height, border);
  const std::vector<Line> lines = LinesOf(x, y);
  if (lines.empty()) return {};
  std::vector<ErrorEnergy> rows(y.windows.size());
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t j) {
    for (const int left : x.windows) {
      const Window window(error, x, y, left, y.windows[j]);
      for (const Line& line : lines) rows[j].sum += window.Energy(line);
      ++rows[j].values;
    }
  });
  ErrorEnergy total;
  for (const ErrorEnergy& row : rows) total += row;
  return total;
}

}  // namespace warplut
